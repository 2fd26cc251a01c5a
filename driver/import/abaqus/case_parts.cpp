// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/case_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "driver/base/text/json.hpp"
#include "driver/case/quantity.hpp"
#include "driver/import/abaqus/profile_text.hpp"

namespace slipbench::driver::abaqus {

std::string quoted(const std::string& text) { return base::json::Value(text).dump(); }

/// A name that YAML and expressions take: "CONTACT-FORCE" is contact_force.
std::string name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const auto u = static_cast<unsigned char>(c);
    name += std::isalnum(u) != 0 ? static_cast<char>(std::tolower(u)) : '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
    name = "component_" + name;
  }
  return name;
}

std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string motion_column(int component, bool constitutive) {
  return (constitutive ? "CU" : "CP") + cases::component_suffix(component - 1);
}

std::string CaseParts::ask(const std::string& name, const std::string& why) {
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
    asked_.push_back(name);
    asked_why_.push_back(why);
  }
  return "= " + name;
}

std::string CaseParts::table(const std::vector<std::string>& dependents,
                             const std::vector<std::string>& independents,
                             const std::vector<Row>& rows, const std::string& extrapolate) {
  const std::size_t width = dependents.size();
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < independents.size(); ++i) {
    const bool given = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      return row.size() > width + i && row[width + i].has_value();
    });
    if (given) used.push_back(i);
  }
  // A single row depends on nothing, whatever else stands in it.
  if (rows.size() == 1) used.clear();
  const auto item = [](const Row& row, std::size_t i) {
    return number_text(i < row.size() ? row[i].value_or(0.0) : 0.0);
  };
  if (used.empty()) {
    if (rows.size() > 1) pass("a table has several rows that depend on nothing");
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < width; ++k) numbers.push_back(item(rows[0], k));
    return width == 1 ? numbers[0] : "[" + join(numbers) + "]";
  }
  std::vector<std::string> columns = dependents;
  for (const std::size_t i : used) {
    columns.push_back(independents[i]);
    if (independents[i] == "temperature" || independents[i].starts_with("field")) {
      ambient_.insert(independents[i]);
    }
  }
  std::vector<std::string> lines;
  for (const Row& row : rows) {
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < width; ++k) numbers.push_back(item(row, k));
    for (const std::size_t i : used) numbers.push_back(item(row, width + i));
    lines.push_back("[" + join(numbers) + "]");
  }
  return fmt::format("{{columns: [{}], rows: [{}]{}}}", join(columns), join(lines),
                     extrapolate.empty() ? "" : ", extrapolate: " + extrapolate);
}

std::vector<std::string> CaseParts::ambient_columns(std::vector<std::string> first, int fields) {
  first.emplace_back("temperature");
  for (int i = 1; i <= fields; ++i) first.push_back("field" + std::to_string(i));
  return first;
}

std::string CaseParts::line_of(std::string_view where) const {
  const std::string place = deck_.place(where);
  return place.substr(place.rfind(':') + 1);
}

void CaseParts::pass(const std::string& reason) const { throw PassedOver{reason}; }

}  // namespace slipbench::driver::abaqus
