// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "driver/base/csv/csv_fields.hpp"

namespace slipbench::driver::base {
namespace {

/// A piece of a foreign file, fit for a message.
std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) {
    shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  shown += text.size() > kLongest ? "...'" : "'";
  return shown;
}

}  // namespace

std::string not_a_number(std::string_view text, char decimal) {
  if (text.empty()) return "is empty";
  if (const std::size_t comma = text.find(','); comma != std::string_view::npos && decimal == '.') {
    if (number_in(text, ',')) {
      return fmt::format("holds {} with a decimal comma; the decimal mark is '.'", quote(text));
    }
  }
  if (decimal == ',' && text.find('.') != std::string_view::npos && number_in(text, '.')) {
    return fmt::format("holds {} with a decimal point; the decimal mark is ','", quote(text));
  }
  const std::string_view unsigned_text = text.substr(text[0] == '-' || text[0] == '+' ? 1 : 0);
  double value = 0.0;
  const auto [stop, error] =
      std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), value);
  const bool whole = stop == unsigned_text.data() + unsigned_text.size();
  if (error == std::errc::result_out_of_range && whole) {
    return fmt::format("holds {}, which is outside the range of a double", quote(text));
  }
  if (error == std::errc{} && whole && !std::isfinite(value)) {
    return fmt::format("holds {}; a finite number is wanted", quote(text));
  }
  return fmt::format("holds {}, which is not a number", quote(text));
}

bool may_be_thousands(std::string_view text, char mark) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.starts_with('0')) return false;
  for (std::size_t groups = 0;; ++groups) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view group = text.substr(0, end);
    const bool digits =
        std::all_of(group.begin(), group.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits || group.empty() || group.size() > 3 || (groups > 0 && group.size() < 3)) {
      return false;
    }
    if (end == text.size()) return groups > 0;
    text.remove_prefix(end + 1);
  }
}

std::string take_away(char separator) {
  return fmt::format("; to take it away: sed 's/{}\\r*$//'",
                     separator == '\t' ? std::string("\\t") : std::string(1, separator));
}

std::string_view separator_name(char separator) {
  if (separator == ' ') return "blank";
  return separator == '\t' ? "tab" : (separator == ';' ? "';'" : "','");
}

std::string in_words(const MissingSamples& missing, MissingSample answer) {
  if (missing.count == 0) return {};
  const bool one = missing.count == 1;
  const std::string_view what = answer == MissingSample::kHold
                                    ? (one ? "missing sample was held at the value before"
                                           : "missing samples were held at the values before")
                                    : (one ? "row was left out, as it lacks a sample"
                                           : "rows were left out, as they lack a sample");
  return fmt::format("{} {} ({} {})", missing.count, what, one ? "line" : "first in line",
                     missing.first_line);
}

}  // namespace slipbench::driver::base
