// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_fields.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/base/units/units.hpp"

namespace slipbench::driver::base {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    if (!point.valid) return false;
    text.remove_prefix(point.length);
  }
  return true;
}

}  // namespace

const char* read_number_with_comma(const char* begin, const char* end, double& value) {
  // No double needs more digits than these to be told from its neighbours.
  constexpr std::size_t kLongest = 1100;
  std::string text;
  for (const char* p = begin; p != end && text.size() < kLongest; ++p) {
    const bool sign = (*p == '-' || *p == '+') && !text.empty() && text.back() == 'e';
    if (!is_digit(*p) && *p != ',' && *p != 'e' && *p != 'E' && !sign) break;
    text += *p == ',' ? '.' : (*p == 'E' ? 'e' : *p);
  }
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? begin + (stop - text.data()) : nullptr;
}

std::optional<double> number_in(std::string_view text, char decimal) {
  const std::string line = std::string(text) + '\n';
  double value = 0.0;
  const char* const stop = read_number(line.data(), line.data() + line.size(), decimal, value);
  return stop == line.data() + text.size() ? std::optional(value) : std::nullopt;
}

bool is_missing(std::string_view text) {
  constexpr std::array<std::string_view, 8> kWords{"nan",  "na",       "n/a",     "#n/a",
                                                   "null", "nan(ind)", "1.#qnan", "1.#ind"};
  if (text.find_first_not_of('-') == std::string_view::npos) return true;
  if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

std::vector<Field> split(std::string_view line, char separator) {
  std::vector<Field> fields;
  const auto add = [&](std::size_t begin, std::size_t end) {
    while (begin < end && is_blank(line[begin])) ++begin;
    while (begin < end && is_blank(line[end - 1])) --end;
    if (end - begin >= 2 && line[begin] == '"' && line[end - 1] == '"') {
      ++begin;
      --end;
    }
    fields.push_back({line.substr(begin, end - begin), begin});
  };
  const bool by_blanks = separator == ' ';
  std::size_t begin = 0;
  if (by_blanks) {
    begin = std::min(line.find_first_not_of(" \t"), line.size());
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  }
  bool is_quoted_field = false;
  bool quoted = false;
  for (std::size_t i = begin; i < line.size(); ++i) {
    // A quote inside a plain field is a character like any other (an inch mark).
    if (line[i] == '"') {
      is_quoted_field |=
          line.substr(begin, i - begin).find_first_not_of(" \t") == std::string_view::npos;
      quoted ^= is_quoted_field;
    } else if (!quoted && (line[i] == separator || (by_blanks && line[i] == '\t'))) {
      add(begin, i);
      while (by_blanks && is_blank(line[i + 1])) ++i;
      begin = i + 1;
      is_quoted_field = false;
    }
  }
  add(begin, line.size());
  return fields;
}

char detect_separator(std::string_view header, char decimal) {
  constexpr std::string_view kSeparators = "\t;,";
  std::array<int, kSeparators.size()> counts{};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    const std::size_t which = kSeparators.find(c);
    if (!quoted && which != std::string_view::npos && c != decimal) ++counts[which];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  if (*most == 0) return decimal == ',' ? ';' : ',';
  return kSeparators[static_cast<std::size_t>(most - counts.begin())];
}

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0U | (byte >> 6U));
      utf8 += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return utf8;
}

std::vector<std::string> header_names(std::string_view header, char separator) {
  std::vector<std::string> names;
  for (const Field& field : split(header, separator)) {
    const bool unit_alone = separator == ' ' && !names.empty() && field.text.size() > 2 &&
                            split_column_name("x " + std::string(field.text)).unit.size() > 0 &&
                            (field.text.front() == '(' || field.text.front() == '[');
    if (unit_alone) {
      names.back() += ' ' + as_utf8(field.text);
    } else {
      names.push_back(out_of_cell(as_utf8(field.text)));
    }
  }
  return names;
}

NameAndUnit split_column_name(std::string_view column) {
  const std::string_view text = trimmed(column);
  if (text.empty()) return {text, {}};
  if (text.back() == ')' || text.back() == ']') {
    const std::size_t open = text.rfind(text.back() == ')' ? '(' : '[');
    if (open == std::string_view::npos || open == 0) return {text, {}};
    return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, text.size() - open - 2))};
  }
  // With blanks around it: "mm/s" alone is a name.
  const std::size_t stroke = text.rfind(" / ");
  if (stroke == std::string_view::npos || stroke == 0) return {text, {}};
  return {trimmed(text.substr(0, stroke)), trimmed(text.substr(stroke + 3))};
}

bool is_unit_or_dash(std::string_view text) { return text == "-" || is_unit(text); }

tl::expected<std::optional<std::size_t>, std::string> match_column(
    std::span<const std::string> header, std::string_view name) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found != header.end()) {
    if (std::find(found + 1, header.end(), name) != header.end()) {
      return tl::unexpected(fmt::format("two columns are named '{}'", name));
    }
    return static_cast<std::size_t>(found - header.begin());
  }
  std::optional<std::size_t> match;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const NameAndUnit parts = split_column_name(header[i]);
    if (parts.name != name || !is_unit_or_dash(parts.unit)) continue;
    if (match) {
      return tl::unexpected(fmt::format("'{}' may be '{}' or '{}': write one of them", name,
                                        header[*match], header[i]));
    }
    match = i;
  }
  return match;
}

}  // namespace slipbench::driver::base
