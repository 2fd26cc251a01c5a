// SPDX-License-Identifier: Apache-2.0
// The fields of a line of a CSV file, and the names in its header.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// Counts the digits that these eight characters begin with, the first of them in the lowest byte.
inline unsigned leading_digits(std::uint64_t text) {
  constexpr std::uint64_t kHigh = 0xF0F0F0F0F0F0F0F0;
  // A digit is 0x30 to 0x39: its upper half is 3, and so it is 6 later, without a carry.
  const std::uint64_t others =
      ((text & kHigh) ^ 0x3030303030303030) | (((text & ~kHigh) + 0x0606060606060606) & kHigh);
  return static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// The number that eight digits make, the first of them in the lowest byte: pairs, then fours, then
/// all of them at once. A byte of 0 is a digit 0.
inline std::uint64_t number_of_eight_digits(std::uint64_t text) {
  text = (text & 0x0F0F0F0F0F0F0F0F) * 2561 >> 8U;
  text = (text & 0x00FF00FF00FF00FF) * 6553601 >> 16U;
  return (text & 0x0000FFFF0000FFFF) * 42949672960001 >> 32U;
}

/// digits/10^decimals to the nearest double, for digits that are not 0 and at most 19 decimals.
///
/// Both are shifted until their top bit is set; of the quotient come 62 bits or 63, and the lowest
/// one says whether anything is left behind them. So rounded once, to 53 bits, it is right.
inline double nearest_quotient(std::uint64_t digits, std::size_t decimals) {
  __extension__ using Wide = unsigned __int128;
  static constexpr std::array<std::uint64_t, 20> kPowers = [] {
    std::array<std::uint64_t, 20> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
    return powers;
  }();
  const int up = std::countl_zero(digits);
  const int down = std::countl_zero(kPowers[decimals]);
  const std::uint64_t divisor = kPowers[decimals] << down;
  const Wide dividend = static_cast<Wide>(digits << up) << 62U;
  auto quotient = static_cast<std::uint64_t>(dividend / divisor);
  if (static_cast<Wide>(quotient) * divisor != dividend) quotient |= 1U;
  constexpr int kExponentOfOne = 1023;
  const auto power =
      std::bit_cast<double>(static_cast<std::uint64_t>(kExponentOfOne + down - up - 62) << 52U);
  return static_cast<double>(static_cast<std::int64_t>(quotient)) * power;
}

/// Reads the number at [begin, end) and returns where it stops; null when there is none, or none
/// in the range of a double. The end of the line must lie before `end`.
///
/// Most measured numbers have few digits. These make an integer below 2^53 and their power of ten
/// is exact, so one correctly rounded operation gives the nearest double (Clinger 1990).
/// Printed doubles have up to 17, see nearest_quotient. The rest is left to std::from_chars, with
/// the same result.
inline const char* read_number(const char* begin, const char* end, char decimal, double& value) {
  static constexpr std::array<double, 20> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                                     1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
                                                     1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
  constexpr std::ptrdiff_t kExactDigits = 15;
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
    if constexpr (std::endian::native == std::endian::little) {
      static constexpr std::array<std::uint64_t, 9> kShifts = {
          1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
      for (bool more = is_digit(*p); more && end - p >= 8;) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, p, sizeof eight);
        const unsigned read = leading_digits(eight);
        digits = kShifts[read] * digits + number_of_eight_digits(eight << (64 - 8 * read));
        p += read;
        more = (read == 8) & is_digit(*p);
      }
    }
    while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count > 0 && count <= kDigitsOf64Bits && *p != 'e' && *p != 'E') {
    const auto power = static_cast<std::size_t>(decimals);
    const double magnitude = count <= kExactDigits || digits == 0
                                 ? static_cast<double>(digits) / kPowers[power]
                                 : nearest_quotient(digits, power);
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

/// The names of a header's columns, as UTF-8 whichever of it and Latin-1 the file is in, without
/// the apostrophe that in_cell puts before what begins like a formula. Between
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
