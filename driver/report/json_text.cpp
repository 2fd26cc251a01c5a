// SPDX-License-Identifier: Apache-2.0
#include "driver/report/json_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "driver/base/text/json.hpp"
#include "driver/report/series_digits.hpp"

namespace slipbench::driver::report {
namespace {

/// A quoted JSON text in which nothing means anything to HTML.
void append_for_page(std::string& text, std::string_view quoted) {
  constexpr std::string_view kLineSeparator = "\xE2\x80\xA8";
  constexpr std::string_view kParagraphSeparator = "\xE2\x80\xA9";
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    if (quoted[i] == '<') {
      text += "\\u003c";
    } else if (quoted.substr(i, 3) == kLineSeparator ||
               quoted.substr(i, 3) == kParagraphSeparator) {
      text += quoted.substr(i, 3) == kLineSeparator ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      text += quoted[i];
    }
  }
}

}  // namespace

void JsonText::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

void JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
}

void JsonText::close(char bracket) {
  text_ += bracket;
  first_ = false;
}

void JsonText::key(std::string_view name) {
  value(name);
  text_ += ':';
  first_ = true;
}

void JsonText::value(std::string_view text) {
  separate();
  append_for_page(text_, base::json::Value(text).dump());
}

void JsonText::value(double number, int digits) {
  separate();
  if (std::isfinite(number)) {
    fmt::format_to(std::back_inserter(text_), "{:.{}g}", number, digits);
  } else {
    text_ += "null";
  }
}

void JsonText::exact(double number) {
  separate();
  if (std::isfinite(number)) {
    fmt::format_to(std::back_inserter(text_), "{}", number);
  } else {
    text_ += "null";
  }
}

void JsonText::value(std::int64_t number_value) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number_value);
}

void JsonText::value(bool flag) {
  separate();
  text_ += flag ? "true" : "false";
}

void JsonText::null() {
  separate();
  text_ += "null";
}

void JsonText::series(std::span<const double> numbers) {
  const SeriesDigits digits(numbers);
  begin_array();
  for (std::size_t i = 0; i < numbers.size(); ++i) value(numbers[i], digits[i]);
  end_array();
}

}  // namespace slipbench::driver::report
