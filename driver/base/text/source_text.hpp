// SPDX-License-Identifier: Apache-2.0
// A text that came from a file, with its name and its lines.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::base {

/// An immutable text with a line index; copies share the bytes. CRLF is read as LF and a UTF-8 byte
/// order mark is dropped, so that a file means the same whichever editor saved it.
class SourceText {
 public:
  /// Takes over the bytes of a file, less than 4 GiB. `name` is the path as the user typed it. Any
  /// bytes are taken; check_text says what is wrong with them.
  SourceText(std::string name, std::string bytes);

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::string_view text() const;
  /// Returns how many lines there are; a text without a line feed has one.
  [[nodiscard]] int line_count() const;
  /// Line `number` (from 1) without its line feed; empty if there is no such line.
  [[nodiscard]] std::string_view line(int number) const;
  /// The place of a range of bytes. Offset and length are in bytes; an offset past the end is
  /// taken as the end, and the length is cut at the end of the line (but is at least 1).
  [[nodiscard]] SourcePosition position(std::size_t offset, std::size_t length = 1) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Side at fault for a file that could not be read: the file itself (exit 2) or the owner of the
/// machine (exit 4).
enum class ReadFailure { kBadInput, kEnvironment };

struct ReadError {
  ReadFailure failure = ReadFailure::kEnvironment;
  Diagnostic diagnostic{};
};

inline constexpr std::size_t kDefaultSizeLimit = std::size_t{64} << 20U;

/// Reads a regular file, or standard input (the path "-"), of at most `size_limit` bytes; a file's
/// size is compared before anything is read. A directory, a missing or unreadable file, a pipe or a
/// device is an environment error at once: only "-" is waited for. Too much of it is bad input.
[[nodiscard]] tl::expected<SourceText, ReadError> read_source(
    const std::string& path, std::size_t size_limit = kDefaultSizeLimit);

/// Returns what makes bytes no text: UTF-16 or UTF-32, invalid UTF-8, NUL and other control
/// characters, a carriage return without a line feed. The first of each kind is reported, with its
/// place.
[[nodiscard]] Diagnostics check_text(const SourceText& source);

}  // namespace slipbench::driver::base
