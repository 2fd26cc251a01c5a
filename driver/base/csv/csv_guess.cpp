// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_guess.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "driver/base/csv/csv_fields.hpp"

namespace slipbench::driver::base {
namespace {

constexpr std::size_t kMostSkipped = 200;
constexpr std::size_t kRowsTried = 5;

std::vector<std::string_view> lines_of(std::string_view head) {
  std::vector<std::string_view> lines;
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  while (!head.empty() && lines.size() < kMostSkipped + 2 * kRowsTried) {
    const std::size_t end = head.find('\n');
    std::string_view line = head.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    if (end == std::string_view::npos) break;
    head.remove_prefix(end + 1);
  }
  return lines;
}

/// A line that every reader passes over.
bool is_passed_over(std::string_view line) {
  const std::size_t text = line.find_first_not_of(" \t");
  return text == std::string_view::npos || line[text] == '#';
}

/// The lines from `first` on, held against one format.
class Trial {
 public:
  Trial(std::span<const std::string_view> lines, const CsvFormat& format,
        std::span<const std::string> wanted)
      : lines_(lines), format_(format), wanted_(wanted) {}

  bool fits() {
    const std::vector<std::string> names = header_names(lines_[0], format_.separator);
    const auto is_name = [&](const std::string& name) {
      return !name.empty() && !number_in(name, format_.decimal);
    };
    if (!std::all_of(names.begin(), names.end(), is_name)) return false;
    if (wanted_.empty() && names.size() < 2) return false;
    for (const std::string& name : wanted_) {
      const auto column = match_column(names, name);
      if (!column || !*column) return false;
      columns_.push_back(**column);
    }
    columns_in_all_ = names.size();
    std::size_t rows = 0;
    bool units_due = format_.units_row;
    for (const std::string_view line : lines_.subspan(1)) {
      if (is_passed_over(line)) continue;
      const std::vector<Field> fields = split(line, format_.separator);
      if (fields.size() != columns_in_all_) return false;
      if (!(units_due ? holds_units(fields) : holds_numbers(fields))) return false;
      rows += units_due ? 0 : 1;
      units_due = false;
      if (rows == kRowsTried) break;
    }
    return rows > 0;
  }

 private:
  [[nodiscard]] bool is_number(const Field& field) const {
    return number_in(field.text, format_.decimal).has_value();
  }
  [[nodiscard]] bool holds_units(const std::vector<Field>& fields) const {
    return std::none_of(fields.begin(), fields.end(), [&](const Field& f) { return is_number(f); });
  }
  [[nodiscard]] bool holds_numbers(const std::vector<Field>& fields) const {
    const auto may_be_sample = [&](const Field& f) { return is_number(f) || is_missing(f.text); };
    const auto numbers =
        std::count_if(fields.begin(), fields.end(), [&](const Field& f) { return is_number(f); });
    if (columns_.empty()) return 2 * numbers >= std::ssize(fields);
    return numbers > 0 && std::all_of(columns_.begin(), columns_.end(), [&](std::size_t column) {
             return may_be_sample(fields[column]);
           });
  }

  std::span<const std::string_view> lines_;
  const CsvFormat& format_;
  std::span<const std::string> wanted_;
  std::vector<std::size_t> columns_;
  std::size_t columns_in_all_ = 0;
};

}  // namespace

std::optional<CsvFormat> guess_format(std::string_view head, const CsvFormat& now,
                                      std::span<const std::string> wanted) {
  const std::vector<std::string_view> lines = lines_of(head);
  const auto stated = static_cast<std::size_t>(std::max(now.skip, 0));
  for (std::size_t first = 0; first < std::min(lines.size(), kMostSkipped); ++first) {
    if (is_passed_over(lines[first])) continue;
    CsvFormat format = now;
    // Lines that are passed over anyway need not be skipped.
    const bool reached =
        first >= stated && std::all_of(lines.begin() + now.skip,
                                       lines.begin() + std::ptrdiff_t(first), is_passed_over);
    // Nor are comments right above the header to be skipped: they may state units.
    std::size_t begin = first;
    while (begin > 0 && is_passed_over(lines[begin - 1])) --begin;
    if (!reached) format.skip = static_cast<int>(begin);
    for (const char decimal : {now.decimal, now.decimal == '.' ? ',' : '.'}) {
      const char detected = detect_separator(lines[first], decimal);
      for (const char separator : {now.separator, detected, '\t', ';', ',', ' '}) {
        if (separator == '\0' || separator == decimal) continue;
        for (const bool units_row : {now.units_row, !now.units_row}) {
          format.decimal = decimal;
          format.separator = separator;
          format.units_row = units_row;
          if (!Trial(std::span(lines).subspan(first), format, wanted).fits()) continue;
          if (separator == detected && now.separator == '\0') format.separator = '\0';
          if (format == now) return std::nullopt;
          return format;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::base
