// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/model_description.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::exports {
namespace {

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      escaped += c;
  }
  return escaped;
}

base::UnitSystem si_units() { return {"m", "N", "s", "K"}; }

/// Size of the case's unit in SI units; 1 where it states none.
double si_factor(const std::string& unit, const base::Dimension& dimension) {
  if (unit.empty()) return 1.0;
  const auto conversion = base::conversion_to_case(unit, dimension, si_units());
  return conversion ? conversion->scale : 1.0;
}

double si_offset(const std::string& unit) {
  const auto conversion = base::conversion_to_case(unit, base::kTemperature, si_units());
  return conversion ? conversion->offset : 0.0;
}

/// One unit of the definitions: kg m s^-2 stand for the force.
std::string unit_definition(const std::string& name, const base::Dimension& d,
                            const base::UnitSystem& system) {
  const double factor = std::pow(si_factor(system.length, base::kLength), d.length) *
                        std::pow(si_factor(system.force, base::kForce), d.force) *
                        std::pow(si_factor(system.time, base::kTime), d.time) *
                        std::pow(si_factor(system.temperature, base::kTemperature), d.temperature);
  std::string base;
  const auto exponent = [&](const char* unit, int power) {
    if (power != 0) base += fmt::format(" {}=\"{}\"", unit, power);
  };
  exponent("kg", d.force);
  exponent("m", d.length + d.force);
  exponent("s", d.time - 2 * d.force);
  exponent("K", d.temperature);
  exponent("rad", d.angle);
  if (factor != 1.0) base += fmt::format(" factor=\"{}\"", base::format_number(factor));
  const bool alone = d == base::kTemperature;
  if (alone && si_offset(name) != 0.0)
    base += fmt::format(" offset=\"{}\"", base::format_number(si_offset(name)));
  return fmt::format("    <Unit name=\"{}\"><BaseUnit{}/></Unit>\n", escape_xml(name), base);
}

constexpr std::array<std::string_view, 3> kCausality{"input", "parameter", "output"};
constexpr std::array<std::string_view, 3> kType{"Real", "Integer", "Boolean"};

std::string start_text(const FmuVariable& one) {
  if (one.causality == Causality::kOutput) return {};
  if (one.type == FmuType::kBoolean) return fmt::format(" start=\"{}\"", one.start != 0.0);
  if (one.type == FmuType::kInteger) {
    // The bounds that the unit's library holds it to (c/fmu.cpp).
    const char* bounds = one.role == "increments" ? " min=\"1\" max=\"100000\"" : "";
    return fmt::format("{} start=\"{}\"", bounds, static_cast<long>(one.start));
  }
  return fmt::format(" start=\"{}\"", base::format_number(one.start));
}

std::string variability(const FmuVariable& one) {
  if (one.causality == Causality::kParameter) return "fixed";
  return one.type == FmuType::kReal ? "continuous" : "discrete";
}

}  // namespace

std::string fmu_resource(const cases::Case& problem, const std::vector<FmuVariable>& variables,
                         const ParameterMap& map, const std::vector<double>& numbers) {
  std::string text = "slipbench_fmu 1\n";
  const auto put = [&](double x) {
    text += ' ';
    base::append_number(text, x);
  };
  // A host counts seconds.
  text += "time_unit";
  put(1.0 / si_factor(problem.units.time, base::kTime));
  text += "\ninitial";
  for (int c = 0; c < law::kComponents; ++c) put(problem.initial[c]);
  text += "\nreference";
  for (int c = 0; c < law::kComponents; ++c) put(problem.reference[c]);
  text += fmt::format("\nvariables {}\n", variables.size());
  for (const FmuVariable& one : variables) {
    text += fmt::format("{} {}", one.role, one.index);
    put(one.start);
    text += '\n';
  }
  text += fmt::format("parameters {}\n", map.parameters.size());
  for (const MappedParameter& one : map.parameters) {
    text += fmt::format("{}", one.numbers.size());
    put(one.value);
    text += '\n';
    for (const FollowingNumber& number : one.numbers) {
      text += fmt::format("{} {}", number.index, number.in_proportion ? 1 : 0);
      put(number.factor);
      text += '\n';
    }
  }
  text += fmt::format("numbers {}\n", numbers.size());
  for (const double x : numbers) {
    base::append_number(text, x);
    text += '\n';
  }
  return text;
}

std::string units_fault(const cases::Case& problem) {
  for (const auto& [unit, dimension] :
       {std::pair{problem.units.length, base::kLength},
        std::pair{problem.units.force, base::kForce}, std::pair{problem.units.time, base::kTime},
        std::pair{problem.units.temperature, base::kTemperature}}) {
    if (unit.empty()) continue;
    const auto conversion = base::conversion_to_case(unit, dimension, si_units());
    if (!conversion) return conversion.error().message;
  }
  return {};
}

std::string model_description(const cases::Case& problem, const std::vector<FmuVariable>& variables,
                              const FmuIdentity& identity) {
  std::map<std::string, base::Dimension> units;
  std::string listed;
  std::string outputs;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const FmuVariable& one = variables[i];
    const std::string unit = base::unit_text(one.dimension, problem.units);
    if (!unit.empty()) units.emplace(unit, one.dimension);
    listed += fmt::format(
        "    <ScalarVariable name=\"{}\" valueReference=\"{}\" description=\"{}\" causality=\"{}\" "
        "variability=\"{}\">\n"
        "      <{}{}{}/>\n    </ScalarVariable>\n",
        escape_xml(one.name), i, escape_xml(one.text),
        kCausality[static_cast<std::size_t>(one.causality)], variability(one),
        kType[static_cast<std::size_t>(one.type)], start_text(one),
        unit.empty() || one.type != FmuType::kReal ? ""
                                                   : fmt::format(" unit=\"{}\"", escape_xml(unit)));
    if (one.causality == Causality::kOutput)
      outputs += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
  }
  std::string definitions;
  for (const auto& [name, dimension] : units)
    definitions += unit_definition(name, dimension, problem.units);
  if (!definitions.empty())
    definitions = "  <UnitDefinitions>\n" + definitions + "  </UnitDefinitions>\n";
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\" description=\"{}\"\n"
      "    generationTool=\"slipbench {}\" variableNamingConvention=\"flat\">\n"
      "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\" "
      "canGetAndSetFMUstate=\"true\"\n"
      "    canSerializeFMUstate=\"true\" canNotUseMemoryManagementFunctions=\"true\"/>\n"
      "{}  <LogCategories>\n    <Category name=\"logStatusError\"/>\n  </LogCategories>\n"
      "  <ModelVariables>\n{}  </ModelVariables>\n"
      "  <ModelStructure>\n    <Outputs>\n{}    </Outputs>\n    <InitialUnknowns>\n{}    "
      "</InitialUnknowns>\n  </ModelStructure>\n"
      "</fmiModelDescription>\n",
      escape_xml(identity.identifier), identity.guid, escape_xml(problem.title), SLIPBENCH_VERSION,
      identity.identifier, definitions, listed, outputs, outputs);
}

}  // namespace slipbench::driver::exports
