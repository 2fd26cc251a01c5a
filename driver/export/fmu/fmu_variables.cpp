// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/fmu_variables.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "driver/bench/simulation.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/quantity_dimension.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::exports {
namespace {

/// A result column of a definition, and the role that fills it.
struct Told {
  std::string_view column;  ///< begins its name
  std::string_view role;
  FmuType type = FmuType::kReal;
};
constexpr std::array kTold{Told{"FLIM", "limit"},
                           Told{"FN", "normal_force"},
                           Told{"MU", "mu"},
                           Told{"STATUS", "regime", FmuType::kInteger},
                           Told{"CASU", "accumulated_slip"},
                           Told{"DISS", "dissipation"},
                           Told{"STRAIN_E", "stored_energy"},
                           Told{"WORK", "work"}};

/// Gives parameters of the case that are called as another variable is a name of their own.
void tell_apart(std::vector<FmuVariable>& all) {
  for (FmuVariable& one : all) {
    if (one.role != "parameter") continue;
    const auto taken = [&] {
      return std::any_of(all.begin(), all.end(), [&](const FmuVariable& other) {
        return &other != &one && other.name == one.name;
      });
    };
    while (taken()) one.name.insert(0, "parameter_");
  }
}

}  // namespace

tl::expected<std::vector<FmuVariable>, std::string> fmu_variables(const cases::Case& problem,
                                                                  const ParameterMap& map) {
  const auto begun = bench::Simulation::start(problem);
  if (!begun) return tl::unexpected(begun.error().message);
  const bench::Quantities& first = begun->row().quantities;
  std::vector<FmuVariable> all;
  const auto input = [&](int quantity, const char* role, int index, std::string text) {
    all.push_back({cases::quantity_name(quantity), Causality::kInput, FmuType::kReal,
                   cases::dimension_of(problem, quantity), std::move(text),
                   first[static_cast<std::size_t>(quantity)], role, index});
  };
  const law::ConnectionInfo& info = problem.connection.info;
  for (int c = 0; c < law::kComponents; ++c) {
    if (!info.available.contains(c)) continue;
    input(cases::kFirstMotion + c, "position", c, "Relative position at the end of the step.");
    base::Dimension rate = all.back().dimension;
    rate.time = -1;
    all.push_back({"CV" + cases::component_suffix(c), Causality::kInput, FmuType::kReal, rate,
                   "Its rate over the step, where by_rate is true.", 0.0, "rate", c});
  }
  for (int c = 0; c < law::kComponents; ++c) {
    const int quantity = cases::kFirstForce + c;
    const bool driven = cases::is_driven(problem, quantity) && !problem.force_driven.contains(c);
    if (!info.held.contains(c) && !driven) continue;
    input(quantity, "force", c, "Constraint force at the end of the step.");
  }
  input(cases::kTemperatureQuantity, "temperature", 0, "Temperature at the end of the step.");
  for (int f = 0; f < law::kMaxFields; ++f) {
    if (!cases::is_driven(problem, cases::kFirstField + f)) continue;
    input(cases::kFirstField + f, "field", f, "Field at the end of the step.");
  }
  const auto parameter = [&](std::string name, FmuType type, double start, const char* role,
                             int index, std::string text) {
    all.push_back(
        {std::move(name), Causality::kParameter, type, {}, std::move(text), start, role, index});
  };
  for (std::size_t i = 0; i < map.parameters.size(); ++i) {
    parameter(map.parameters[i].name, FmuType::kReal, map.parameters[i].value, "parameter",
              static_cast<int>(i), "Parameter of the case, as a number in its units.");
  }
  parameter("by_rate", FmuType::kBoolean, 0.0, "by_rate", 0,
            "Whether rates move the connector, not positions.");
  parameter("increments", FmuType::kInteger, 1.0, "increments", 0,
            "Increments of a step; positions and forces go linearly from its begin to its end.");
  const std::vector<results::Column> columns = results::result_columns(problem);
  const auto output = [&](const results::Column& column, FmuType type, std::string_view role,
                          int index) {
    all.push_back({column.name, Causality::kOutput, type, column.dimension, column.text, 0.0,
                   std::string(role), index});
  };
  for (int c = 0; c < law::kComponents; ++c) {
    for (const results::Column& column : columns) {
      if (column.name == cases::force_column("CSF", c))
        output(column, FmuType::kReal, "friction_force", c);
    }
  }
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    for (const Told& told : kTold) {
      const auto column =
          std::find_if(columns.begin(), columns.end(), [&](const results::Column& one) {
            const std::string_view stem = std::string_view(one.name).substr(0, one.name.find('.'));
            const bool named =
                told.column == "CASU" ? stem.starts_with(told.column) : stem == told.column;
            return one.definition == static_cast<int>(d) && named;
          });
      if (column != columns.end()) output(*column, told.type, told.role, static_cast<int>(d));
    }
  }
  tell_apart(all);
  return all;
}

}  // namespace slipbench::driver::exports
