// SPDX-License-Identifier: Apache-2.0
#include "driver/results/provenance.hpp"

#include <filesystem>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"

namespace slipbench::driver {
namespace {

struct NamedUnit {
  const char* name;
  const std::string UnitSystem::*unit;
};

constexpr NamedUnit kUnits[] = {{"length", &UnitSystem::length},
                                {"force", &UnitSystem::force},
                                {"time", &UnitSystem::time},
                                {"temperature", &UnitSystem::temperature}};

}  // namespace

std::string_view program_version() { return SLIPBENCH_VERSION; }

std::string case_name(const Case& problem) {
  return std::filesystem::path(problem.file).filename().string();
}

std::string case_stem(const Case& problem) {
  return std::filesystem::path(problem.file).stem().string();
}

std::string provenance_lines(const Case& problem) {
  std::string text = "# slipbench " + std::string(program_version()) + "\n";
  text += "# case: " + printable(case_name(problem)) + "\n";
  if (!problem.title.empty()) text += "# title: " + printable(problem.title) + "\n";
  std::string units;
  for (const auto& [name, unit] : kUnits) {
    if ((problem.units.*unit).empty()) continue;
    units += (units.empty() ? "" : ", ") + std::string(name) + " " + problem.units.*unit;
  }
  if (!units.empty()) text += "# units: " + printable(units) + "\n";
  std::string parameters;
  for (const auto& [name, value] : problem.parameters) {
    parameters += (parameters.empty() ? "" : ", ") + name + " = " + format_number(value);
  }
  if (!parameters.empty()) text += "# parameters: " + parameters + "\n";
  return text;
}

json::Value provenance(const Case& problem) {
  json::Value origin;
  origin["program"] = "slipbench";
  origin["version"] = program_version();
  origin["case"] = case_name(problem);
  origin["title"] = problem.title;
  json::Value units = json::Object{};
  for (const auto& [name, unit] : kUnits) {
    if (!(problem.units.*unit).empty()) units[name] = problem.units.*unit;
  }
  origin["units"] = units;
  json::Value parameters = json::Object{};
  for (const auto& [name, value] : problem.parameters) parameters[name] = value;
  origin["parameters"] = parameters;
  return origin;
}

FileMark result_mark(const Case& problem, bool is_json) {
  const std::string name = case_name(problem);
  const std::string owner = "a result of " + name;
  if (!is_json) {
    // The origin of a golden curve is told behind a first line of its own.
    return {owner, "# slipbench ", "\n# case: " + printable(name) + "\n", true};
  }
  return {owner, "{\n  \"provenance\": {\n    \"program\": \"slipbench\",",
          "\"case\": " + json::Value(name).dump() + ","};
}

}  // namespace slipbench::driver
