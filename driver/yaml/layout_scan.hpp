// SPDX-License-Identifier: Apache-2.0
// A first look at a YAML text, line by line, for slips that a YAML library reports late, at a
// misleading place, or not at all. yaml-cpp 0.7
//   reads without a word: a quote that is never closed, as a text up to the end of the file;
//     a no-break space in the indentation, as a part of the key; directives; "? key";
//   names a later place, where going on is no longer possible: a bracket that is not closed (the
//     next ':'), a line without its ':' (the next key's), a key indented below a value (its ':');
//   names a place but not the slip: a tab in the indentation ("illegal map value" at the next
//     ':'), text after a closing quote ("end of map not found").
// Tags, a second document and an expression cut in two do show in its events, but only up to its
// first complaint.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::yaml {

/// One slip: a range of bytes, what is wrong with it and what may help.
struct LayoutSlip {
  std::size_t offset = 0;
  std::size_t length = 1;
  std::string message{};
  std::string hint{};
};

/// A list of plain numbers within one line, "[1, 2.5, -3e4]": offsets of its brackets.
struct NumberRow {
  std::size_t open = 0;
  std::size_t close = 0;
};

struct Layout {
  std::vector<LayoutSlip> slips{};
  /// From this byte on the structure is broken: what a parser says about it is a consequence.
  std::size_t first_break = std::string_view::npos;
  /// The rows that can be read without a YAML parser, in order.
  std::vector<NumberRow> rows{};
};

/// Scans a valid UTF-8 text with LF line ends. Slips found: tabs or no-break spaces in the
/// indentation, quotes and brackets that are not closed or do not match, text after a closing
/// quote, a missing ':', explicit tags, directives, explicit '?' keys, a second document,
/// brackets nested deeper than `deepest`, an expression in a flow list that a ',' cuts in two.
[[nodiscard]] Layout scan_layout(std::string_view text, int deepest);

/// The numbers of a row, from left to right, as ranges of bytes {begin, length}.
struct NumberRange {
  std::size_t begin = 0;
  std::size_t length = 0;
};

/// Finds the next number of a row at or after `offset`; its length is 0 after the last.
[[nodiscard]] NumberRange next_number(std::string_view text, const NumberRow& row,
                                      std::size_t offset);

}  // namespace slipbench::driver::yaml
