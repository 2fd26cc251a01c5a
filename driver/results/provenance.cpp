// SPDX-License-Identifier: Apache-2.0
#include "driver/results/provenance.hpp"

#include <filesystem>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::results {
namespace {

struct NamedUnit {
  const char* name;
  const std::string base::UnitSystem::*unit;
};

constexpr NamedUnit kUnits[] = {{"length", &base::UnitSystem::length},
                                {"force", &base::UnitSystem::force},
                                {"time", &base::UnitSystem::time},
                                {"temperature", &base::UnitSystem::temperature}};

}  // namespace

std::string_view program_version() { return SLIPBENCH_VERSION; }

std::string case_name(const cases::Case& problem) {
  return std::filesystem::path(problem.file).filename().string();
}

std::string case_stem(const cases::Case& problem) {
  return std::filesystem::path(problem.file).stem().string();
}

std::string provenance_lines(const cases::Case& problem) {
  std::string text = "# slipbench " + std::string(program_version()) + "\n";
  text += "# case: " + base::printable(case_name(problem)) + "\n";
  if (!problem.title.empty()) text += "# title: " + base::printable(problem.title) + "\n";
  std::string units;
  for (const auto& [name, unit] : kUnits) {
    if ((problem.units.*unit).empty()) continue;
    units += (units.empty() ? "" : ", ") + std::string(name) + " " + problem.units.*unit;
  }
  if (!units.empty()) text += "# units: " + base::printable(units) + "\n";
  std::string parameters;
  for (const auto& [name, value] : problem.parameters) {
    parameters += (parameters.empty() ? "" : ", ") + name + " = " + base::format_number(value);
  }
  if (!parameters.empty()) text += "# parameters: " + parameters + "\n";
  return text;
}

base::json::Value provenance(const cases::Case& problem) {
  base::json::Value origin;
  origin["program"] = "slipbench";
  origin["version"] = program_version();
  origin["case"] = case_name(problem);
  origin["title"] = problem.title;
  base::json::Value units = base::json::Object{};
  for (const auto& [name, unit] : kUnits) {
    if (!(problem.units.*unit).empty()) units[name] = problem.units.*unit;
  }
  origin["units"] = units;
  base::json::Value parameters = base::json::Object{};
  for (const auto& [name, value] : problem.parameters) parameters[name] = value;
  origin["parameters"] = parameters;
  return origin;
}

base::FileMark result_mark(const cases::Case& problem, bool is_json) {
  const std::string name = case_name(problem);
  const std::string owner = "a result of " + name;
  if (!is_json) {
    // The origin of a golden curve is told behind a first line of its own.
    return {owner, "# slipbench ", "\n# case: " + base::in_cells(base::printable(name)) + "\n",
            true};
  }
  return {owner, "{\n  \"provenance\": {\n    \"program\": \"slipbench\",",
          "\"case\": " + base::json::Value(name).dump() + ","};
}

}  // namespace slipbench::driver::results
