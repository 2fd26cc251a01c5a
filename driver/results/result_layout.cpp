// SPDX-License-Identifier: Apache-2.0
#include "driver/results/result_layout.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/number.hpp"
#include "driver/case/quantity.hpp"

namespace slipbench::driver::results {
namespace {

/// Cuts the text before `separator` off the front of `text`.
std::string_view take(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view front = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return front;
}

/// "name<between>value, name<between>value".
std::vector<std::pair<std::string, std::string>> read_pairs(std::string_view text,
                                                            std::string_view between) {
  std::vector<std::pair<std::string, std::string>> pairs;
  while (!text.empty()) {
    std::string_view entry = take(text, ", ");
    const std::string name(take(entry, between));
    pairs.emplace_back(name, std::string(entry));
  }
  return pairs;
}

/// "sliding = CSFC(CSF2 CSF3), spinning = CSM1".
std::vector<FrictionColumns> read_friction(std::string_view text) {
  std::vector<FrictionColumns> friction;
  for (const auto& [name, columns] : read_pairs(text, " = ")) {
    FrictionColumns one{name, false, {}};
    std::string_view list = columns;
    if (list.find('(') != std::string_view::npos) {
      one.coupled = true;
      take(list, "(");
      if (list.ends_with(')')) list.remove_suffix(1);
    }
    while (!list.empty()) one.forces.emplace_back(take(list, " "));
    friction.push_back(std::move(one));
  }
  return friction;
}

}  // namespace

std::vector<FrictionColumns> friction_columns(const cases::Case& problem) {
  std::vector<FrictionColumns> all;
  // The rings of a chain share their component: their columns carry their names.
  const bool chain = cases::is_belt(problem.connection) && problem.definitions.size() > 1;
  for (const cases::CaseDefinition& definition : problem.definitions) {
    FrictionColumns one{definition.name, definition.coupled, {}};
    const law::SlipSpace& slip = definition.law.slip;
    for (int k = 0; k < slip.dimension; ++k) {
      one.forces.push_back(cases::force_column("CSF", slip.component[static_cast<std::size_t>(k)]) +
                           (chain ? "." + definition.name : ""));
    }
    all.push_back(std::move(one));
  }
  return all;
}

ResultLayout layout_of(const cases::Case& problem, std::span<const Column> columns) {
  ResultLayout layout;
  layout.title = problem.title;
  for (const auto& [name, unit] :
       {std::pair{"length", &problem.units.length}, std::pair{"force", &problem.units.force},
        std::pair{"time", &problem.units.time},
        std::pair{"temperature", &problem.units.temperature}}) {
    if (!unit->empty()) layout.units.emplace_back(name, *unit);
  }
  for (const auto& [name, value] : problem.parameters) {
    layout.parameters.emplace_back(name, base::format_number(value));
  }
  for (const Column& column : columns) {
    layout.columns.push_back(column.name);
    layout.column_units[column.name] = base::unit_text(column.dimension, problem.units);
  }
  layout.friction = friction_columns(problem);
  for (const cases::CaseDefinition& definition : problem.definitions) {
    if (!definition.law.formulation || !definition.law.formulation->orthotropy) continue;
    layout.directions[definition.name] = definition.law.formulation->orthotropy->first;
  }
  return layout;
}

ResultLayout read_layout(const std::filesystem::path& file, std::span<const std::string> header) {
  ResultLayout layout;
  layout.columns.assign(header.begin(), header.end());
  for (std::string line : base::comment_lines(file)) {
    line = base::printable(base::out_of_cells(line));
    std::string_view text = line;
    const std::string_view key = take(text, ": ");
    if (key == "# title") layout.title = std::string(text);
    if (key == "# units") layout.units = read_pairs(text, " ");
    if (key == "# parameters") layout.parameters = read_pairs(text, " = ");
    if (key == "# friction") layout.friction = read_friction(text);
    if (line.starts_with(base::kColumnsMark)) {
      for (auto& [name, unit] : base::column_units(line)) {
        layout.column_units[std::move(name)] = std::move(unit);
      }
    }
    if (key == "# direction1") {
      for (const auto& [name, numbers] : read_pairs(text, " = ")) {
        std::string_view rest = numbers;
        const auto x = base::parse_number(take(rest, " "));
        const auto y = base::parse_number(rest);
        if (x && y) layout.directions[name] = {*x, *y};
      }
    }
  }
  return layout;
}

std::string result_fault(const ResultLayout& layout, const std::filesystem::path& file) {
  if (layout.friction.size() > base::kMostColumns) {
    return fmt::format("its line '# friction:' names {} definitions, at most {} are read",
                       layout.friction.size(), base::kMostColumns);
  }
  std::set<std::string_view> names;
  for (const FrictionColumns& one : layout.friction) {
    if (names.insert(one.name).second) continue;
    return fmt::format("its line '# friction:' names '{}' twice: run the case again", one.name);
  }
  std::error_code ignored;
  if (layout.friction.empty() || !std::filesystem::is_regular_file(file, ignored)) return {};
  std::ifstream in(file, std::ios::binary);
  if (!in.seekg(-1, std::ios::end) || in.get() == '\n') return {};
  return "its last line has no end: the result is cut off; run the case again";
}

}  // namespace slipbench::driver::results
