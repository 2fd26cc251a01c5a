// SPDX-License-Identifier: Apache-2.0
#include "driver/results/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "driver/case/quantity.hpp"
#include "driver/results/column_numbers.hpp"
#include "law/base/component.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/penalty_update.hpp"

namespace slipbench::driver::results {
namespace {

constexpr base::Dimension kNumber{};
constexpr base::Dimension kEnergy{.force = 1, .length = 1};

base::Dimension per_time(base::Dimension dimension) {
  --dimension.time;
  return dimension;
}

base::Dimension motion_dimension(int component) {
  return law::is_rotation(component) ? base::kAngle : base::kLength;
}
base::Dimension force_dimension(int component) {
  return law::is_rotation(component) ? base::kMoment : base::kForce;
}

std::string of_component(int component) {
  return law::is_rotation(component) ? fmt::format("about the {}-axis", component - 2)
                                     : fmt::format("along the {}-axis", component + 1);
}

/// The quantities a case drives.
std::set<int> driven_quantities(const cases::Case& problem) {
  std::set<int> driven;
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives) driven.insert(drive.quantity);
  }
  if (problem.measured) {
    for (const history::MeasuredColumn& column : problem.measured->columns) {
      driven.insert(static_cast<int>(column.quantity));
    }
  }
  return driven;
}

void add_motion(const cases::Case& problem, int c, std::vector<Column>& columns) {
  const base::Dimension dimension = motion_dimension(c);
  const std::string where = of_component(c);
  const std::string suffix = cases::component_suffix(c);
  const Owner owner = owner_of(problem, c);
  const auto add = [&](const char* prefix, base::Dimension of, std::string text, ColumnValue value,
                       double offset) {
    columns.push_back({prefix + suffix, of, std::move(text), value, c, owner.definition, offset});
  };
  add("CP", dimension, "Relative position " + where + ".", number::kPosition, 0.0);
  add("CU", dimension, "Displacement from the initial position " + where + ".", number::kPosition,
      problem.initial[c]);
  add("CCU", dimension, "Constitutive displacement from the reference position " + where + ".",
      number::kPosition, problem.reference[c]);
  if (problem.dynamics && problem.dynamics->component == c) {
    add(
        "CV", per_time(dimension),
        (problem.dynamics->driver ? "Velocity of the mass over its driver "
                                  : "Velocity of the mass ") +
            where + " at the end of the increment.",
        [](const Cell& at) { return at.row.forces.velocity; }, 0.0);
    return;
  }
  add("CV", per_time(dimension), "Mean relative velocity of the increment " + where + ".",
      number::kMeanVelocity, 0.0);
}

void add_forces(const cases::Case& problem, int c, std::vector<Column>& columns) {
  const base::Dimension dimension = force_dimension(c);
  const std::string where = of_component(c);
  const char* what = law::is_rotation(c) ? "moment " : "force ";
  if (problem.connection.info.held.contains(c)) {
    columns.push_back({cases::force_column("CRF", c), dimension,
                       std::string("Constraint ") + what + where + ", as prescribed.",
                       number::kPrescribedForce, c});
    columns.push_back({cases::force_column("CTF", c), dimension,
                       std::string("Total ") + what + where + ": the constraint's.",
                       number::kPrescribedForce, c});
    return;
  }
  const Owner owner = owner_of(problem, c);
  const ColumnValue value =
      owner.definition < 0 ? ColumnValue(number::kNoFriction) : number::kFrictionForce;
  const bool stopped = problem.stop[static_cast<std::size_t>(c)].has_value();
  const bool mass = problem.dynamics && problem.dynamics->component == c;
  const bool loaded = mass || problem.force_driven.contains(c);
  const auto add = [&](const char* prefix, std::string text, ColumnValue of) {
    columns.push_back({cases::force_column(prefix, c), dimension, std::move(text), of, c});
  };
  if (problem.kinetic.is_elastic(c)) {
    add("CEF", std::string("Elastic ") + what + where + ".", number::kElasticForce);
  }
  if (problem.kinetic.is_damped(c)) {
    add("CVF", std::string("Viscous ") + what + where + ".", number::kViscousForce);
  }
  columns.push_back({cases::force_column("CSF", c), dimension,
                     std::string("Friction ") + what + where + ".", value, owner.entry,
                     owner.definition});
  columns.push_back({cases::force_column("CTF", c), dimension,
                     std::string("Total ") + what + where + ": friction only.", value, owner.entry,
                     owner.definition});
  if (!cases::acts_beside_friction(problem, c) && !loaded) return;
  columns.pop_back();
  if (stopped) {
    add("CRF", std::string("Reaction ") + what + where + " of a stop.",
        [](const Cell& at) { return at.forces().reaction; });
  }
  if (loaded) {
    add("CCF", std::string("Applied ") + what + where + ": the load.",
        [](const Cell& at) { return at.forces().applied; });
  }
  add("CTF",
      std::string("Total ") + what + where +
          (mass ? ", CEF + CVF + CSF - CCF: what accelerates the mass, reversed."
                : ", CEF + CVF + CSF + CRF - CCF."),
      number::kTotalForce);
  if (stopped) {
    columns.push_back({"CSLST" + std::to_string(c + 1), kNumber,
                       "1 at the upper stop " + where + ", -1 at the lower one, else 0.",
                       number::kStopFlag, c});
  }
}

/// Energies that belong to no friction definition.
void add_energies(const cases::Case& problem, std::vector<Column>& columns) {
  const auto add = [&](const char* name, const char* text, ColumnValue value) {
    columns.push_back({name, kEnergy, text, value});
  };
  bool elastic = false;
  bool damped = false;
  for (int c = 0; c < law::kComponents; ++c) {
    elastic = elastic || problem.kinetic.is_elastic(c);
    damped = damped || problem.kinetic.is_damped(c);
  }
  if (elastic) {
    add("ELASTIC_E", "Energy in the springs of all components.",
        [](const Cell& at) { return at.row.forces.elastic_energy; });
  }
  if (damped) {
    add("VISCOUS_DISS", "Energy dissipated by all dampers since the start.",
        [](const Cell& at) { return at.row.forces.viscous_dissipation; });
  }
  if (!problem.dynamics) return;
  if (problem.dynamics->driver) {
    const int c = problem.dynamics->component;
    const base::Dimension velocity = per_time(motion_dimension(c));
    columns.push_back({"MASS_V", velocity, "Velocity of the mass.", [](const Cell& at) {
                         return at.row.forces.velocity + at.row.forces.driver_velocity;
                       }});
    columns.push_back({"DRIVER_V", velocity, "Velocity of the driver.",
                       [](const Cell& at) { return at.row.forces.driver_velocity; }});
    columns.push_back({"DRIVER_LOAD", force_dimension(c), "Load on the driver, as prescribed.",
                       number::kQuantity, cases::kDriverLoad});
    add("KINETIC_E", "Kinetic energy of mass and driver.", number::kKineticEnergy);
    add("EXTERNAL_WORK", "Work of the loads on mass and driver since the start.",
        number::kExternalWork);
    return;
  }
  add("KINETIC_E", "Kinetic energy of the mass.", number::kKineticEnergy);
  add("EXTERNAL_WORK", "Work of the belt and the load on the mass since the start.",
      number::kExternalWork);
}

/// Motions and tensions of a belt; what it lacks (a length, moving nodes) has no column.
void add_belt(const cases::Case& problem, std::vector<Column>& columns) {
  // Without a case, as for `slipbench list quantities`: everything.
  const bool all = !problem.belt;
  const auto add = [&](std::string name, base::Dimension dimension, std::string text,
                       ColumnValue value, int index = 0, int definition = -1) {
    columns.push_back({std::move(name), dimension, std::move(text), value, index, definition});
  };
  const bool has_length = all || problem.belt->has_length;
  if (has_length) {
    add("CP1", base::kLength, "Distance of the nodes a and b of a belt.", number::kPosition, 0);
    add("CU1", kNumber, "Strain of the belt between a and b.",
        [](const Cell& at) { return at.row.belt.strain; });
    add("CV1", per_time(base::kLength), "Mean rate of the distance over the increment.",
        number::kMeanVelocity, 0);
  }
  const auto add_flow = [&](int c, const char* text) {
    add("CU" + cases::component_suffix(c), base::kLength, text, number::kPosition, c);
    columns.back().offset = problem.initial[c];
  };
  add("CP2", base::kLength, "Flow of material over the ring at b.", number::kPosition, 1);
  add_flow(1, "Flow of material over the ring at b since the start.");
  add("CV2", per_time(base::kLength), "Mean rate of the flow at b over the increment.",
      number::kMeanVelocity, 1);
  add("CP3", base::kLength, "Flow of material into the segment at a.", number::kPosition, 2);
  add_flow(2, "Flow of material into the segment at a since the start.");
  add("CV3", per_time(base::kLength), "Mean rate of the flow at a over the increment.",
      number::kMeanVelocity, 2);
  if (has_length) {
    add("reference_length", base::kLength, "Unstrained length of the belt between a and b.",
        [](const Cell& at) { return at.row.belt.reference_length; });
  }
  if (all || (problem.belt->nodes_move && problem.belt->angle_from_nodes)) {
    add("wrap_angle", base::kAngle, "Angle the belt turns by at b.",
        [](const Cell& at) { return at.row.belt.wrap_angle; });
  }
  add("CTF1", base::kForce, "Tension f_ab of the segment between a and b; 0 of a slack belt.",
      [](const Cell& at) { return std::max(at.row.quantities[cases::kFirstForce], 0.0); });
  if (problem.kinetic.elasticity[0]) {
    add("CEF1", base::kForce, "Tension of the segment from the elasticity of the belt.",
        number::kElasticForce);
  }
  if (problem.kinetic.damping[0]) {
    add("CVF1", base::kForce, "Tension of the segment from the damping of the belt.",
        number::kViscousForce);
  }
  if (problem.stop[0]) {
    add("CSLST1", kNumber, "1 at the upper stop of the distance a-b, -1 at the lower one, else 0.",
        number::kStopFlag, 0);
  }
  const bool chain = problem.definitions.size() > 1;
  const int last = static_cast<int>(problem.definitions.size()) - 1;
  if (last < 0) return;
  const ColumnValue value = chain ? ColumnValue(number::kChainForce) : number::kFrictionForce;
  const std::string text =
      chain ? "f_bc - f_ab over all rings." : "Friction force of the ring, f_bc - f_ab.";
  add("CSF2", base::kForce, text, value, 0, chain ? -1 : 0);
  add("CTF2", base::kForce, text, value, 0, chain ? -1 : 0);
  add(
      "f_bc", base::kForce, chain ? "Tension behind the last ring." : "Tension behind the ring.",
      [](const Cell& at) { return law::tension_behind(at.own().update); }, 0, last);
  if (all || !problem.belt->lengths.empty()) {
    add("flow_c", base::kLength, "Flow of material out at the end of the belt's last segment.",
        number::kFlowBehind, 0, last);
  }
  if (all || problem.belt->both_tensions) {
    add(
        "UTILISATION", kNumber, "Of a belt abs(ln(f_bc/f_ab))/(mu alpha): it sticks below 1.",
        [](const Cell& at) {
          return law::capstan_utilisation(at.own().update, number::ring_angle(at));
        },
        0, last);
  }
}

/// Adds what a law that sees pressure and speed saw, and what it gave before its floor.
void add_coefficient(const cases::Case& problem, int d, const std::string& suffix,
                     std::vector<Column>& columns) {
  const auto index = static_cast<std::size_t>(d);
  const law::FrictionDefinition& definition = problem.definitions[index].law;
  const bool angular = is_rotational(definition);
  const base::Dimension speed = per_time(angular ? base::kAngle : base::kLength);
  const auto add = [&](const char* name, base::Dimension dimension, const char* text,
                       ColumnValue value, int entry = 0) {
    columns.push_back({name + suffix, dimension, text, value, entry, d});
  };
  bool floored = false;
  for_each_law(problem, index,
               [&](const law::FrictionLaw& law) { floored = floored || law::has_floor(law); });
  const bool two = definition.formulation && definition.formulation->orthotropy;
  if (two) {
    add("MU1", kNumber, "Coefficient along direction 1.", number::kMuAlong, 0);
    add("MU2", kNumber, "Coefficient along direction 2.", number::kMuAlong, 1);
    add("V1", speed, "Speed that the coefficient of direction 1 saw.", number::kSpeedAlong, 0);
    add("V2", speed, "Speed that the coefficient of direction 2 saw.", number::kSpeedAlong, 1);
  }
  if (floored && !two) {
    add("MU_RAW", kNumber, "Coefficient before it is kept at or above 1e-30.",
        [](const Cell& at) { return at.own().raw_mu[0]; });
  }
  if (floored) {
    add("CLAMPED", kNumber, "1 where the coefficient is kept at its floor, else 0.",
        [](const Cell& at) { return at.own().clamped ? 1.0 : 0.0; });
  }
  if (floored || definition.formulation) {
    add("SPEED", speed, "Speed that the coefficient saw.",
        [](const Cell& at) { return at.own().update.slip_rate; });
  }
  if (area_of(problem, index)) {
    // A normal moment over an area is none, and its unit says so.
    add("PRESSURE", {.force = 1, .length = angular ? -1 : -2},
        "Pressure F_N/A that the coefficient saw.", [](const Cell& at) {
          return at.own().update.normal_force / area_of(at.problem, at.definition()).value_or(1.0);
        });
  }
}

/// The forces on the way through a formulation and its filter.
void add_formulation(const cases::Case& problem, int d, const std::string& suffix,
                     std::vector<Column>& columns) {
  const law::FrictionDefinition& definition = problem.definitions[static_cast<std::size_t>(d)].law;
  const bool filtered = definition.formulation->filter.kind != law::Filter::Kind::kNone;
  for (int k = 0; k < definition.slip.dimension; ++k) {
    const int c = definition.slip.component[static_cast<std::size_t>(k)];
    columns.push_back(
        {cases::force_column("CSF", c) + "_TRIAL", force_dimension(c),
         "Force of the penalty before the limit.",
         [](const Cell& at) { return at.scale() * at.own().penalty.trial[at.index()]; }, k, d});
    columns.push_back({cases::force_column("CSF", c) + "_RAW", force_dimension(c),
                       "Force within the limit, before the filter.",
                       [](const Cell& at) { return at.scale() * at.own().penalty.raw[at.index()]; },
                       k, d});
  }
  if (std::holds_alternative<law::ViscousPenalty>(definition.formulation->penalty)) {
    const bool rotational = is_rotational(definition);
    base::Dimension viscous = rotational ? base::kMoment : base::kForce;
    if (!rotational) --viscous.length;
    ++viscous.time;
    columns.push_back({"VISC_C" + suffix, viscous, "Coefficient C of the viscous penalty.",
                       [](const Cell& at) { return at.own().penalty.viscous_coefficient; }, 0, d});
  }
  if (filtered) {
    columns.push_back({"ALPHA" + suffix, kNumber, "Coefficient of the filter.",
                       [](const Cell& at) { return at.own().penalty.alpha; }, 0, d});
  }
  columns.push_back(
      {"UTILISATION" + suffix, kNumber,
       "Of a formulation abs(F)/(mu N): above 1 only behind a filter, inf without a "
       "limit.",
       [](const Cell& at) { return law::limit_use(at.law(), at.own().update, at.own().penalty); },
       0, d});
}

void add_definition(const cases::Case& problem, int d, std::vector<Column>& columns) {
  const cases::CaseDefinition& definition = problem.definitions[static_cast<std::size_t>(d)];
  const bool rotational = is_rotational(definition.law);
  const base::Dimension force = rotational ? base::kMoment : base::kForce;
  const base::Dimension slip = rotational ? base::kAngle : base::kLength;
  const std::string suffix = problem.definitions.size() > 1 ? "." + definition.name : "";
  const auto add = [&](std::string name, base::Dimension dimension, std::string text,
                       ColumnValue value) {
    columns.push_back({std::move(name), dimension, std::move(text), value, 0, d});
  };
  if (definition.coupled) {
    add("CSFC", force, "Equivalent friction force P(f) of the coupled definition.",
        [](const Cell& at) { return law::equivalent_force(at.law(), at.own().update.state); });
    add("CNFC", force, "Effective normal force of the coupled definition.", number::kNormalForce);
    add("CASUC", slip, "Accumulated equivalent slip of the coupled definition.",
        number::kAccumulatedSlip);
    add("CIVC", per_time(slip), "Velocity along the slip direction of the coupled definition.",
        number::kSlipVelocity);
  } else {
    const int c = definition.law.slip.component[0];
    // The rings of a chain share their component, so that its number does not tell them apart.
    const std::string ring = cases::is_belt(problem.connection) ? suffix : "";
    if (cases::is_belt(problem.connection)) {
      add("CSF2_MAX" + ring, force, "Upper end of the stick band of CSF2: flow from a to c.",
          [](const Cell& at) { return number::band_end(at, law::FlowSense::kForward); });
      add("CSF2_MIN" + ring, force, "Lower end of the stick band of CSF2: flow from c to a.",
          [](const Cell& at) { return -number::band_end(at, law::FlowSense::kBackward); });
    }
    if (!ring.empty()) {
      add("CSF2" + ring, force, "Friction force of the ring.", number::kFrictionForce);
      add("f_bc" + ring, force, "Tension behind the ring.",
          [](const Cell& at) { return law::tension_behind(at.own().update); });
    }
    if (cases::is_belt(problem.connection) && (!problem.belt || !problem.belt->lengths.empty())) {
      if (d > 0) {
        columns.push_back(
            {"CP2" + ring, slip, "Flow of material over the ring.", number::kFlowBehind, 0, d - 1});
      }
      add("length_bc" + ring, slip, "Length of the segment behind the ring.",
          [](const Cell& at) { return at.problem.belt->lengths[at.definition()]; });
      add("reference_length_bc" + ring, slip, "Unstrained length of the segment behind the ring.",
          [](const Cell& at) { return at.own().behind.reference_length; });
      add("strain_bc" + ring, kNumber, "Strain of the segment behind the ring.",
          [](const Cell& at) { return at.own().behind.strain; });
    }
    add(cases::force_column("CNF", c) + ring, force,
        cases::is_belt(problem.connection) ? "Tension in front of the ring, its contact force."
                                           : "Effective normal force of the definition.",
        number::kNormalForce);
    add("CASU" + cases::component_suffix(c) + ring, slip, "Accumulated slip of the definition.",
        number::kAccumulatedSlip);
  }
  const bool filtered = definition.law.formulation &&
                        definition.law.formulation->filter.kind != law::Filter::Kind::kNone;
  add("STATUS" + suffix, kNumber, "0 open, 1 stick, 2 slip.",
      [](const Cell& at) { return static_cast<double>(at.own().update.state.regime); });
  add("MU" + suffix, kNumber, "Coefficient of friction used.",
      [](const Cell& at) { return at.own().update.mu; });
  add_coefficient(problem, d, suffix, columns);
  add("FN" + suffix, force, "Effective normal force.", number::kNormalForce);
  add("FLIM" + suffix, force, "Limit of the friction force.",
      [](const Cell& at) { return at.own().update.limit; });
  add("PHI" + suffix, force,
      filtered ? "Friction force before the filter minus limit."
               : "Friction force minus limit, P - FLIM.",
      [](const Cell& at) { return at.own().update.phi; });
  add("SEL" + suffix, slip, "Elastic slip.",
      [](const Cell& at) { return law::equivalent_elastic_slip(at.law(), at.own().update.state); });
  if (definition.dead_zone) {
    add("PLAY" + cases::component_suffix(definition.law.slip.component[0]), slip,
        "Play of the dead zone, from -width/2 to width/2.",
        [](const Cell& at) { return at.own().play; });
  }
  add("DISS" + suffix, kEnergy, "Dissipated energy since the start.",
      [](const Cell& at) { return at.own().dissipation; });
  add("STRAIN_E" + suffix, kEnergy, "Energy stored in the stick stiffness.",
      [](const Cell& at) { return at.own().update.stored_energy; });
  add("WORK" + suffix, kEnergy, "Work of the friction force since the start.",
      [](const Cell& at) { return at.own().work; });
  if (problem.integration.snap_back == cases::SnapBackAction::kJump) {
    add("LOST" + suffix, kEnergy,
        "Energy since the start that the stick spring lost in jumps at constant motion, and with "
        "the contact.",
        [](const Cell& at) { return at.own().lost; });
  }
  if (definition.law.formulation) add_formulation(problem, d, suffix, columns);
}

std::optional<Column> by_name(std::span<const Column> columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  if (found == columns.end()) return std::nullopt;
  return *found;
}

}  // namespace

double column_value(const Column& column, const cases::Case& problem, const bench::Row& row) {
  return column.value({column, problem, row});
}
void column_values(const Column& column, const cases::Case& problem,
                   std::span<const bench::Row* const> rows, double* to) {
  column.value(column, problem, rows, to);
}

bool is_position(const Column& column) { return column.value == number::kPosition; }
bool is_friction_force(const Column& column) { return column.value == number::kFrictionForce; }
bool is_accumulated_slip(const Column& column) { return column.value == number::kAccumulatedSlip; }

bool is_rotational(const law::FrictionDefinition& definition) {
  return law::is_rotational(definition.slip);
}

std::vector<Column> result_columns(const cases::Case& problem) {
  std::vector<Column> columns;
  columns.push_back({"t", base::kTime, "Total time.", [](const Cell& at) { return at.row.time; }});
  const law::ConnectionInfo& info = problem.connection.info;
  const bool belt = cases::is_belt(problem.connection);
  if (belt) add_belt(problem, columns);
  for (int c = 0; c < law::kComponents && !belt; ++c) {
    if (info.available.contains(c)) add_motion(problem, c, columns);
  }
  for (int c = 0; c < law::kComponents && !belt; ++c) {
    if (info.available.contains(c) || info.held.contains(c)) add_forces(problem, c, columns);
  }
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    add_definition(problem, static_cast<int>(d), columns);
  }
  if (!belt) add_energies(problem, columns);
  for (const int quantity : driven_quantities(problem)) {
    if (quantity < cases::kTemperatureQuantity || quantity >= cases::kTensionBehind) continue;
    const bool temperature = quantity == cases::kTemperatureQuantity;
    columns.push_back({cases::quantity_name(quantity), temperature ? base::kTemperature : kNumber,
                       temperature ? "Temperature." : "Field variable.", number::kQuantity,
                       quantity});
  }
  return columns;
}

std::vector<Column> output_columns(const cases::Case& problem) {
  return chosen_columns(problem, problem.output_columns);
}

std::vector<Column> chosen_columns(const cases::Case& problem, std::span<const std::string> names) {
  std::vector<Column> all = result_columns(problem);
  if (names.empty()) return all;
  std::vector<Column> selected = {all.front()};
  for (const std::string& name : names) {
    auto column = find_column(problem, all, name);
    if (!column || name == all.front().name) continue;
    column->name = name;
    selected.push_back(std::move(*column));
  }
  return selected;
}

std::optional<Column> find_column(const cases::Case& problem, std::span<const Column> columns,
                                  std::string_view name) {
  if (auto column = by_name(columns, name)) return column;
  if (const auto held = cases::component_of_motion(name);
      held && problem.connection.info.held.contains(*held)) {
    return Column{std::string(name), law::is_rotation(*held) ? base::kAngle : base::kLength,
                  "Held position, constant.", number::kPosition, *held};
  }
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  auto column = by_name(columns, name.substr(0, dot));
  if (!column || column->definition < 0) return std::nullopt;
  const auto owner = static_cast<std::size_t>(column->definition);
  if (problem.definitions[owner].name != name.substr(dot + 1)) return std::nullopt;
  return column;
}

std::vector<std::string> column_names(const cases::Case& problem) {
  const std::vector<Column> columns = result_columns(problem);
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const Column& column : columns) names.push_back(column.name);
  for (const Column& column : columns) {
    if (column.definition < 0 || column.name.find('.') != std::string::npos) continue;
    const auto owner = static_cast<std::size_t>(column.definition);
    names.push_back(column.name + "." + problem.definitions[owner].name);
  }
  for (int c = 0; c < law::kComponents; ++c) {
    if (problem.connection.info.held.contains(c)) names.push_back(cases::motion_name(c));
  }
  return names;
}

}  // namespace slipbench::driver::results
