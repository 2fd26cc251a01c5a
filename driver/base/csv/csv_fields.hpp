// SPDX-License-Identifier: Apache-2.0
// The fields of a line of a CSV file, and the names in its header.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/letters.hpp"

namespace slipbench::driver::base {

/// Reads a number as std::from_chars does, with another decimal mark than the point.
const char* read_number_with_comma(const char* begin, const char* end, double& value);

/// Reads the number at [begin, end) and returns where it stops; null when there is none, or none
/// in the range of a double. The end of the line must lie before `end`.
///
/// Most measured numbers have few digits. Their digits make an integer below 2^53 and their power
/// of ten is exact, so one correctly rounded operation gives the nearest double (Clinger 1990); the
/// rest is left to std::from_chars, with the same result.
inline const char* read_number(const char* begin, const char* end, char decimal, double& value) {
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
  constexpr std::ptrdiff_t kDigitsOf64Bits = 19;

  const char* p = begin;
  const bool negative = *p == '-';
  if (negative || *p == '+') ++p;
  const char* const number = p;
  std::uint64_t digits = 0;
  while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
  std::ptrdiff_t count = p - number;
  std::ptrdiff_t decimals = 0;
  if (*p == decimal) {
    const char* const fraction = ++p;
    while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count > 0 && count <= kDigitsOf64Bits && digits <= kExactIntegers && decimals <= 22 &&
      *p != 'e' && *p != 'E') {
    const double magnitude =
        static_cast<double>(digits) / kPowers[static_cast<std::size_t>(decimals)];
    value = negative ? -magnitude : magnitude;
    return p;
  }
  // from_chars has no leading '+', and reads "nan" and "inf" as well.
  if (*number == '-' || *number == '+') return nullptr;
  const char* stop = nullptr;
  if (decimal == '.') {
    const auto [end_of_number, error] = std::from_chars(number, end, value);
    stop = error == std::errc{} ? end_of_number : nullptr;
  } else {
    stop = read_number_with_comma(number, end, value);
  }
  if (stop == nullptr || !std::isfinite(value)) return nullptr;
  if (negative) value = -value;
  return stop;
}

/// The number that `text` is, all of it; nothing if it is none in the range of a double.
std::optional<double> number_in(std::string_view text, char decimal);

/// Tells whether a text stands where a sample is missing: nothing at all, nan, na, n/a, \#n/a,
/// null, none (in any case), 1.\#QNAN, and dashes alone.
bool is_missing(std::string_view text);

struct Field {
  std::string_view text;   ///< Without blanks around it and without quotes.
  std::size_t offset = 0;  ///< Of `text` in the line.
};

/// The fields of a line. Between blanks (separator ' ') a run of them is one separator.
std::vector<Field> split(std::string_view line, char separator);

/// The most frequent of the separators in a header, outside quotes; a decimal comma separates
/// nothing.
char detect_separator(std::string_view header, char decimal);

/// The names of a header's columns, as UTF-8 whichever of it and Latin-1 the file is in. Between
/// blanks, a unit in brackets belongs to the name before it.
std::vector<std::string> header_names(std::string_view header, char separator);

/// The text itself if it is UTF-8, else as one of Latin-1.
std::string as_utf8(std::string_view text);

/// A column's name without the unit that stands behind it: "Force (N)", "Force [N]", "Force / N".
struct NameAndUnit {
  std::string_view name;
  std::string_view unit;  ///< empty if there is none; whether it is a unit is not judged
};
NameAndUnit split_column_name(std::string_view column);

/// Tells whether a text is a unit, or the dash that says there is none.
bool is_unit_or_dash(std::string_view text);

/// The column of the header that is meant by `name`: the one of this name, or else the only one
/// that is called so but for a unit behind it. Nothing if there is none.
/// Errors: two of them, in a sentence.
tl::expected<std::optional<std::size_t>, std::string> match_column(
    std::span<const std::string> header, std::string_view name);

}  // namespace slipbench::driver::base
