// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/data_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/base/text/standard_input.hpp"

namespace slipbench::driver::base {
namespace {

/// Plain where YAML takes it so in any place, else in quotes.
std::string scalar(std::string_view text) {
  const bool plain =
      !text.empty() && text.front() != '-' && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '.' || c == '_' || c == '-' || c == '/';
      });
  if (plain) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string_view of_held_time(const CsvFormat& format, double time, double before) {
  if (format.missing != MissingSample::kHold || time != before) return "";
  return " (is it missing? 'missing: skip' leaves out its row)";
}

std::string in_words(std::string_view name, const CsvFormat& format) {
  std::string text = "{file: " + scalar(name == kStandardInputName ? kStandardInput : name);
  if (format.decimal != '.') text += fmt::format(", decimal: \"{}\"", format.decimal);
  if (format.separator == '\t' || format.separator == ' ') {
    text += format.separator == ' ' ? ", separator: space" : ", separator: tab";
  } else if (format.separator != '\0') {
    text += fmt::format(", separator: \"{}\"", format.separator);
  }
  if (format.skip > 0) text += fmt::format(", skip: {}", format.skip);
  if (format.units_row) text += ", units_row: true";
  if (format.missing == MissingSample::kSkip) text += ", missing: skip";
  if (format.missing == MissingSample::kHold) text += ", missing: hold";
  return text + "}";
}

}  // namespace slipbench::driver::base
