// SPDX-License-Identifier: Apache-2.0
// The one syntax of numbers in files and on the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace slipbench::driver::base {

/// Reads a decimal number: sign, digits with at most one '.', exponent with e or E; the whole text,
/// whatever the locale. The error says what was found and, where it can be guessed, what to write
/// instead: no nan or inf, nothing too large or too small for a double, no digits that a denormal
/// would lose, no leading zeros, no other base, no ',' '_' '%' '/', no Fortran D, no unit.
[[nodiscard]] tl::expected<double, std::string> parse_number(std::string_view text);

/// A text that begins with a number and goes on with what may be the name of a unit: "12 mm".
struct NumberAndUnit {
  std::string_view number;
  std::string_view unit;
};

/// Takes a number and its unit apart; nothing if the text is no number followed by a name. Neither
/// is judged.
[[nodiscard]] std::optional<NumberAndUnit> split_unit(std::string_view text);

/// Reads an integer written in digits with an optional sign; errors as parse_number, and for a
/// number that is no integer ("2.5 where an integer is wanted").
[[nodiscard]] tl::expected<long long, std::string> parse_integer(std::string_view text);

}  // namespace slipbench::driver::base
