// SPDX-License-Identifier: Apache-2.0
#include "driver/results/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "driver/case/quantity.hpp"
#include "law/component.hpp"

namespace slipbench::driver {
namespace {

constexpr Dimension kNumber{};
constexpr Dimension kEnergy{.force = 1, .length = 1};

Dimension per_time(Dimension dimension) {
  --dimension.time;
  return dimension;
}

Dimension motion_dimension(int component) { return law::is_rotation(component) ? kAngle : kLength; }
Dimension force_dimension(int component) { return law::is_rotation(component) ? kMoment : kForce; }

std::string of_component(int component) {
  return law::is_rotation(component) ? fmt::format("about the {}-axis", component - 2)
                                     : fmt::format("along the {}-axis", component + 1);
}

/// The definition that acts in a component, and the entry of its slip space.
struct Owner {
  int definition = -1;
  int entry = 0;
};

Owner owner_of(const Case& problem, int component) {
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    const law::SlipSpace& slip = problem.definitions[d].law.slip;
    for (int k = 0; k < slip.dimension; ++k) {
      if (slip.component[static_cast<std::size_t>(k)] == component) {
        return {static_cast<int>(d), k};
      }
    }
  }
  return {};
}

/// The quantities a case drives.
std::set<int> driven_quantities(const Case& problem) {
  std::set<int> driven;
  for (const Step& step : problem.steps) {
    for (const Drive& drive : step.drives) driven.insert(drive.quantity);
  }
  if (problem.measured) {
    for (const MeasuredColumn& column : problem.measured->columns) {
      driven.insert(static_cast<int>(column.quantity));
    }
  }
  return driven;
}

void add_motion(const Case& problem, int c, std::vector<Column>& columns) {
  const Dimension dimension = motion_dimension(c);
  const std::string where = of_component(c);
  const std::string suffix = component_suffix(c);
  const Owner owner = owner_of(problem, c);
  const auto add = [&](const char* prefix, Dimension of, std::string text, ColumnSource source,
                       double offset) {
    columns.push_back({prefix + suffix, of, std::move(text), source, c, owner.definition, offset});
  };
  add("CP", dimension, "Relative position " + where + ".", ColumnSource::kPosition, 0.0);
  add("CU", dimension, "Displacement from the initial position " + where + ".",
      ColumnSource::kPosition, problem.initial[c]);
  add("CCU", dimension, "Constitutive displacement from the reference position " + where + ".",
      ColumnSource::kPosition, problem.reference[c]);
  add("CV", per_time(dimension), "Mean relative velocity of the increment " + where + ".",
      ColumnSource::kVelocity, 0.0);
}

void add_forces(const Case& problem, int c, std::vector<Column>& columns) {
  const Dimension dimension = force_dimension(c);
  const std::string where = of_component(c);
  const char* what = law::is_rotation(c) ? "moment " : "force ";
  if (problem.connection.info.held.contains(c)) {
    columns.push_back({force_column("CRF", c), dimension,
                       std::string("Constraint ") + what + where + ", as prescribed.",
                       ColumnSource::kConstraintForce, c});
    columns.push_back({force_column("CTF", c), dimension,
                       std::string("Total ") + what + where + ": the constraint's.",
                       ColumnSource::kConstraintForce, c});
    return;
  }
  const Owner owner = owner_of(problem, c);
  const ColumnSource source =
      owner.definition < 0 ? ColumnSource::kNoFriction : ColumnSource::kFrictionForce;
  columns.push_back({force_column("CSF", c), dimension,
                     std::string("Friction ") + what + where + ".", source, owner.entry,
                     owner.definition});
  columns.push_back({force_column("CTF", c), dimension,
                     std::string("Total ") + what + where + ": friction only.", source, owner.entry,
                     owner.definition});
}

void add_definition(const Case& problem, int d, std::vector<Column>& columns) {
  const CaseDefinition& definition = problem.definitions[static_cast<std::size_t>(d)];
  const bool rotational = is_rotational(definition.law);
  const Dimension force = rotational ? kMoment : kForce;
  const Dimension slip = rotational ? kAngle : kLength;
  const std::string suffix = problem.definitions.size() > 1 ? "." + definition.name : "";
  const auto add = [&](std::string name, Dimension dimension, std::string text,
                       ColumnSource source) {
    columns.push_back({std::move(name), dimension, std::move(text), source, 0, d});
  };
  if (definition.coupled) {
    add("CSFC", force, "Equivalent friction force P(f) of the coupled definition.",
        ColumnSource::kFrictionTotal);
    add("CNFC", force, "Effective normal force of the coupled definition.",
        ColumnSource::kNormalForce);
    add("CASUC", slip, "Accumulated equivalent slip of the coupled definition.",
        ColumnSource::kAccumulatedSlip);
    add("CIVC", per_time(slip), "Velocity along the slip direction of the coupled definition.",
        ColumnSource::kSlipVelocity);
  } else {
    const int c = definition.law.slip.component[0];
    add(force_column("CNF", c), force, "Effective normal force of the definition.",
        ColumnSource::kNormalForce);
    add("CASU" + component_suffix(c), slip, "Accumulated slip of the definition.",
        ColumnSource::kAccumulatedSlip);
  }
  add("STATUS" + suffix, kNumber, "0 open, 1 stick, 2 slip.", ColumnSource::kStatus);
  add("MU" + suffix, kNumber, "Coefficient of friction used.", ColumnSource::kMu);
  add("FN" + suffix, force, "Effective normal force.", ColumnSource::kNormalForce);
  add("FLIM" + suffix, force, "Limit of the friction force.", ColumnSource::kLimit);
  add("PHI" + suffix, force, "Friction force minus limit, P - FLIM.", ColumnSource::kPhi);
  add("SEL" + suffix, slip, "Elastic slip.", ColumnSource::kElasticSlip);
  add("DISS" + suffix, kEnergy, "Dissipated energy since the start.", ColumnSource::kDissipation);
  add("STRAIN_E" + suffix, kEnergy, "Energy stored in the stick stiffness.",
      ColumnSource::kStoredEnergy);
  add("WORK" + suffix, kEnergy, "Work of the friction force since the start.", ColumnSource::kWork);
}

std::optional<Column> by_name(std::span<const Column> columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  if (found == columns.end()) return std::nullopt;
  return *found;
}

double norm(const std::array<double, law::kComponents>& entries, int dimension) {
  if (dimension == 1) return std::abs(entries[0]);
  double sum = 0.0;
  for (int k = 0; k < dimension; ++k) {
    sum += entries[static_cast<std::size_t>(k)] * entries[static_cast<std::size_t>(k)];
  }
  return std::sqrt(sum);
}

double slip_velocity(const law::SlipSpace& slip, const DefinitionRow& here, const Row& row) {
  if (!(row.duration > 0.0)) return 0.0;
  double sum = 0.0;
  for (int k = 0; k < slip.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto c = static_cast<std::size_t>(slip.component[i]);
    sum += here.update.direction[i] * slip.scale[i] *
           (row.quantities[kFirstMotion + c] - row.begin.values[c]);
  }
  return sum / row.duration;
}

}  // namespace

bool is_rotational(const law::FrictionDefinition& definition) {
  for (int k = 0; k < definition.slip.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!law::is_rotation(definition.slip.component[i]) || definition.slip.scale[i] != 1.0) {
      return false;
    }
  }
  return true;
}

std::vector<Column> result_columns(const Case& problem) {
  std::vector<Column> columns;
  columns.push_back({"t", kTime, "Total time.", ColumnSource::kTotalTime});
  const law::ConnectionInfo& info = problem.connection.info;
  for (int c = 0; c < law::kComponents; ++c) {
    if (info.available.contains(c)) add_motion(problem, c, columns);
  }
  for (int c = 0; c < law::kComponents; ++c) {
    if (info.available.contains(c) || info.held.contains(c)) add_forces(problem, c, columns);
  }
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    add_definition(problem, static_cast<int>(d), columns);
  }
  for (const int quantity : driven_quantities(problem)) {
    if (quantity < kTemperatureQuantity) continue;
    const bool temperature = quantity == kTemperatureQuantity;
    columns.push_back({quantity_name(quantity), temperature ? kTemperature : kNumber,
                       temperature ? "Temperature." : "Field variable.", ColumnSource::kQuantity,
                       quantity});
  }
  return columns;
}

std::vector<Column> output_columns(const Case& problem) {
  std::vector<Column> all = result_columns(problem);
  if (problem.output_columns.empty()) return all;
  std::vector<Column> selected = {all.front()};
  for (const std::string& name : problem.output_columns) {
    auto column = find_column(problem, all, name);
    if (!column || name == all.front().name) continue;
    column->name = name;
    selected.push_back(std::move(*column));
  }
  return selected;
}

std::optional<Column> find_column(const Case& problem, std::span<const Column> columns,
                                  std::string_view name) {
  if (auto column = by_name(columns, name)) return column;
  if (const auto held = component_of_motion(name);
      held && problem.connection.info.held.contains(*held)) {
    return Column{std::string(name), law::is_rotation(*held) ? kAngle : kLength,
                  "Held position, constant.", ColumnSource::kPosition, *held};
  }
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  auto column = by_name(columns, name.substr(0, dot));
  if (!column || column->definition < 0) return std::nullopt;
  const auto owner = static_cast<std::size_t>(column->definition);
  if (problem.definitions[owner].name != name.substr(dot + 1)) return std::nullopt;
  return column;
}

std::vector<std::string> column_names(const Case& problem) {
  std::vector<std::string> names;
  const std::vector<Column> columns = result_columns(problem);
  for (const Column& column : columns) names.push_back(column.name);
  for (const Column& column : columns) {
    if (column.definition < 0 || column.name.find('.') != std::string::npos) continue;
    const auto owner = static_cast<std::size_t>(column.definition);
    names.push_back(column.name + "." + problem.definitions[owner].name);
  }
  for (int c = 0; c < law::kComponents; ++c) {
    if (problem.connection.info.held.contains(c)) names.push_back(motion_name(c));
  }
  return names;
}

double column_value(const Column& column, const Case& problem, const Row& row) {
  const auto index = static_cast<std::size_t>(column.index);
  switch (column.source) {
    case ColumnSource::kTotalTime:
      return row.time;
    case ColumnSource::kPosition:
      return row.quantities[kFirstMotion + index] - column.offset;
    case ColumnSource::kVelocity:
      return row.duration > 0.0
                 ? (row.quantities[kFirstMotion + index] - row.begin.values[index]) / row.duration
                 : 0.0;
    case ColumnSource::kConstraintForce:
      return row.quantities[kFirstForce + index];
    case ColumnSource::kQuantity:
      return row.quantities[index];
    case ColumnSource::kNoFriction:
      return 0.0;
    default:
      break;
  }
  const auto d = static_cast<std::size_t>(column.definition);
  const law::SlipSpace& slip = problem.definitions[d].law.slip;
  const DefinitionRow& here = row.definitions[d];
  switch (column.source) {
    case ColumnSource::kFrictionForce:
      return slip.scale[index] * here.update.state.force[index];
    case ColumnSource::kFrictionTotal:
      return norm(here.update.state.force, slip.dimension);
    case ColumnSource::kSlipVelocity:
      return slip_velocity(slip, here, row);
    case ColumnSource::kAccumulatedSlip:
      return here.update.state.accumulated_slip;
    case ColumnSource::kNormalForce:
      return here.update.normal_force;
    case ColumnSource::kStatus:
      return static_cast<double>(here.update.state.regime);
    case ColumnSource::kMu:
      return here.update.mu;
    case ColumnSource::kLimit:
      return here.update.limit;
    case ColumnSource::kPhi:
      return here.update.phi;
    case ColumnSource::kElasticSlip:
      return norm(here.update.state.elastic_slip, slip.dimension);
    case ColumnSource::kDissipation:
      return here.dissipation;
    case ColumnSource::kStoredEnergy:
      return here.update.stored_energy;
    default:
      return here.work;
  }
}

}  // namespace slipbench::driver
