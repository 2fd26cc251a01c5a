// SPDX-License-Identifier: Apache-2.0
#include "driver/results/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "driver/case/quantity.hpp"
#include "law/base/component.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/penalty_update.hpp"

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
  if (problem.dynamics && problem.dynamics->component == c) {
    add("CV", per_time(dimension),
        (problem.dynamics->driver ? "Velocity of the mass over its driver "
                                  : "Velocity of the mass ") +
            where + " at the end of the increment.",
        ColumnSource::kMassVelocity, 0.0);
    return;
  }
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
  const bool stopped = problem.stop[static_cast<std::size_t>(c)].has_value();
  const bool mass = problem.dynamics && problem.dynamics->component == c;
  const bool loaded = mass || problem.force_driven.contains(c);
  const auto add = [&](const char* prefix, std::string text, ColumnSource from) {
    columns.push_back({force_column(prefix, c), dimension, std::move(text), from, c});
  };
  if (problem.kinetic.is_elastic(c)) {
    add("CEF", std::string("Elastic ") + what + where + ".", ColumnSource::kElasticForce);
  }
  if (problem.kinetic.is_damped(c)) {
    add("CVF", std::string("Viscous ") + what + where + ".", ColumnSource::kViscousForce);
  }
  columns.push_back({force_column("CSF", c), dimension,
                     std::string("Friction ") + what + where + ".", source, owner.entry,
                     owner.definition});
  columns.push_back({force_column("CTF", c), dimension,
                     std::string("Total ") + what + where + ": friction only.", source, owner.entry,
                     owner.definition});
  if (!acts_beside_friction(problem, c) && !loaded) return;
  columns.pop_back();
  if (stopped) {
    add("CRF", std::string("Reaction ") + what + where + " of a stop.", ColumnSource::kReaction);
  }
  if (loaded) {
    add("CCF", std::string("Applied ") + what + where + ": the load.", ColumnSource::kApplied);
  }
  add("CTF",
      std::string("Total ") + what + where +
          (mass ? ", CEF + CVF + CSF - CCF: what accelerates the mass, reversed."
                : ", CEF + CVF + CSF + CRF - CCF."),
      ColumnSource::kTotalForce);
  if (stopped) {
    columns.push_back({"CSLST" + std::to_string(c + 1), kNumber,
                       "1 at the upper stop " + where + ", -1 at the lower one, else 0.",
                       ColumnSource::kStopFlag, c});
  }
}

/// Energies that belong to no friction definition.
void add_energies(const Case& problem, std::vector<Column>& columns) {
  const auto add = [&](const char* name, const char* text, ColumnSource source) {
    columns.push_back({name, kEnergy, text, source});
  };
  bool elastic = false;
  bool damped = false;
  for (int c = 0; c < law::kComponents; ++c) {
    elastic = elastic || problem.kinetic.is_elastic(c);
    damped = damped || problem.kinetic.is_damped(c);
  }
  if (elastic) {
    add("ELASTIC_E", "Energy in the springs of all components.", ColumnSource::kElasticEnergy);
  }
  if (damped) {
    add("VISCOUS_DISS", "Energy dissipated by all dampers since the start.",
        ColumnSource::kViscousDissipation);
  }
  if (!problem.dynamics) return;
  if (problem.dynamics->driver) {
    const int c = problem.dynamics->component;
    const Dimension velocity = per_time(motion_dimension(c));
    columns.push_back({"MASS_V", velocity, "Velocity of the mass.", ColumnSource::kDrivenVelocity});
    columns.push_back(
        {"DRIVER_V", velocity, "Velocity of the driver.", ColumnSource::kDriverVelocity});
    columns.push_back({"DRIVER_LOAD", force_dimension(c), "Load on the driver, as prescribed.",
                       ColumnSource::kQuantity, kDriverLoad});
    add("KINETIC_E", "Kinetic energy of mass and driver.", ColumnSource::kKineticEnergy);
    add("EXTERNAL_WORK", "Work of the loads on mass and driver since the start.",
        ColumnSource::kExternalWork);
    return;
  }
  add("KINETIC_E", "Kinetic energy of the mass.", ColumnSource::kKineticEnergy);
  add("EXTERNAL_WORK", "Work of the belt and the load on the mass since the start.",
      ColumnSource::kExternalWork);
}

/// Motions and tensions of a belt; what it lacks (a length, moving nodes) has no column.
void add_belt(const Case& problem, std::vector<Column>& columns) {
  // Without a case, as for `slipbench list quantities`: everything.
  const bool all = !problem.belt;
  const auto add = [&](std::string name, Dimension dimension, std::string text, ColumnSource source,
                       int index = 0, int definition = -1) {
    columns.push_back({std::move(name), dimension, std::move(text), source, index, definition});
  };
  const bool has_length = all || problem.belt->has_length;
  if (has_length) {
    add("CP1", kLength, "Distance of the nodes a and b of a belt.", ColumnSource::kPosition, 0);
    add("CU1", kNumber, "Strain of the belt between a and b.", ColumnSource::kStrain);
    add("CV1", per_time(kLength), "Mean rate of the distance over the increment.",
        ColumnSource::kVelocity, 0);
  }
  const auto add_flow = [&](int c, const char* text) {
    add("CU" + component_suffix(c), kLength, text, ColumnSource::kPosition, c);
    columns.back().offset = problem.initial[c];
  };
  add("CP2", kLength, "Flow of material over the ring at b.", ColumnSource::kPosition, 1);
  add_flow(1, "Flow of material over the ring at b since the start.");
  add("CV2", per_time(kLength), "Mean rate of the flow at b over the increment.",
      ColumnSource::kVelocity, 1);
  add("CP3", kLength, "Flow of material into the segment at a.", ColumnSource::kPosition, 2);
  add_flow(2, "Flow of material into the segment at a since the start.");
  add("CV3", per_time(kLength), "Mean rate of the flow at a over the increment.",
      ColumnSource::kVelocity, 2);
  if (has_length) {
    add("reference_length", kLength, "Unstrained length of the belt between a and b.",
        ColumnSource::kReferenceLength);
  }
  if (all || (problem.belt->nodes_move && problem.belt->angle_from_nodes)) {
    add("wrap_angle", kAngle, "Angle the belt turns by at b.", ColumnSource::kWrapAngle);
  }
  add("CTF1", kForce, "Tension f_ab of the segment between a and b; 0 of a slack belt.",
      ColumnSource::kBeltTension);
  if (problem.kinetic.elasticity[0]) {
    add("CEF1", kForce, "Tension of the segment from the elasticity of the belt.",
        ColumnSource::kElasticForce);
  }
  if (problem.kinetic.damping[0]) {
    add("CVF1", kForce, "Tension of the segment from the damping of the belt.",
        ColumnSource::kViscousForce);
  }
  if (problem.stop[0]) {
    add("CSLST1", kNumber, "1 at the upper stop of the distance a-b, -1 at the lower one, else 0.",
        ColumnSource::kStopFlag, 0);
  }
  const bool chain = problem.definitions.size() > 1;
  const int last = static_cast<int>(problem.definitions.size()) - 1;
  if (last < 0) return;
  const auto source = chain ? ColumnSource::kChainForce : ColumnSource::kFrictionForce;
  const std::string text =
      chain ? "f_bc - f_ab over all rings." : "Friction force of the ring, f_bc - f_ab.";
  add("CSF2", kForce, text, source, 0, chain ? -1 : 0);
  add("CTF2", kForce, text, source, 0, chain ? -1 : 0);
  add("f_bc", kForce, chain ? "Tension behind the last ring." : "Tension behind the ring.",
      ColumnSource::kRingTension, 0, last);
  if (all || !problem.belt->lengths.empty()) {
    add("flow_c", kLength, "Flow of material out at the end of the belt's last segment.",
        ColumnSource::kFlowBehind, 0, last);
  }
  if (all || problem.belt->both_tensions) {
    add("UTILISATION", kNumber, "Of a belt abs(ln(f_bc/f_ab))/(mu alpha): it sticks below 1.",
        ColumnSource::kUtilisation, 0, last);
  }
}

/// Calls visit(law) for the laws a definition has in the course of the case.
template <class Visit>
void for_each_law(const Case& problem, std::size_t definition, Visit&& visit) {
  const law::FrictionDefinition& own = problem.definitions[definition].law;
  visit(own.law);
  if (own.formulation && own.formulation->orthotropy) visit(own.formulation->orthotropy->second);
  if (problem.definitions[definition].backward) visit(*problem.definitions[definition].backward);
  for (const Step& step : problem.steps) {
    for (const FrictionChange& change : step.friction_changes) {
      if (change.definition == definition) visit(change.law);
    }
  }
}

/// The area that turns the normal force into the pressure a law sees.
std::optional<double> area_of(const law::FrictionLaw& law) {
  return std::visit(
      [](const auto& l) -> std::optional<double> {
        if constexpr (requires { l.area; }) return l.area;
        return std::nullopt;
      },
      law);
}
std::optional<double> area_of(const Case& problem, std::size_t definition) {
  std::optional<double> area;
  for_each_law(problem, definition, [&](const law::FrictionLaw& law) {
    if (!area) area = area_of(law);
  });
  return area;
}

/// What a law that sees pressure and speed saw, and what it gave before its floor.
void add_coefficient(const Case& problem, int d, const std::string& suffix,
                     std::vector<Column>& columns) {
  const auto index = static_cast<std::size_t>(d);
  const law::FrictionDefinition& definition = problem.definitions[index].law;
  const bool angular = is_rotational(definition);
  const Dimension speed = per_time(angular ? kAngle : kLength);
  const auto add = [&](const char* name, Dimension dimension, const char* text, ColumnSource source,
                       int entry = 0) {
    columns.push_back({name + suffix, dimension, text, source, entry, d});
  };
  bool floored = false;
  for_each_law(problem, index,
               [&](const law::FrictionLaw& law) { floored = floored || law::has_floor(law); });
  const bool two = definition.formulation && definition.formulation->orthotropy;
  if (two) {
    add("MU1", kNumber, "Coefficient along direction 1.", ColumnSource::kMuAlong, 0);
    add("MU2", kNumber, "Coefficient along direction 2.", ColumnSource::kMuAlong, 1);
    add("V1", speed, "Speed that the coefficient of direction 1 saw.", ColumnSource::kSpeedAlong,
        0);
    add("V2", speed, "Speed that the coefficient of direction 2 saw.", ColumnSource::kSpeedAlong,
        1);
  }
  if (floored && !two) {
    add("MU_RAW", kNumber, "Coefficient before it is kept at or above 1e-30.",
        ColumnSource::kRawMu);
  }
  if (floored) {
    add("CLAMPED", kNumber, "1 where the coefficient is kept at its floor, else 0.",
        ColumnSource::kClamped);
  }
  if (floored || definition.formulation) {
    add("SPEED", speed, "Speed that the coefficient saw.", ColumnSource::kSpeed);
  }
  if (area_of(problem, index)) {
    // A normal moment over an area is none, and its unit says so.
    add("PRESSURE", {.force = 1, .length = angular ? -1 : -2},
        "Pressure F_N/A that the coefficient saw.", ColumnSource::kPressure);
  }
}

/// The forces on the way through a formulation and its filter.
void add_formulation(const Case& problem, int d, const std::string& suffix,
                     std::vector<Column>& columns) {
  const law::FrictionDefinition& definition = problem.definitions[static_cast<std::size_t>(d)].law;
  const bool filtered = definition.formulation->filter.kind != law::Filter::Kind::kNone;
  for (int k = 0; k < definition.slip.dimension; ++k) {
    const int c = definition.slip.component[static_cast<std::size_t>(k)];
    columns.push_back({force_column("CSF", c) + "_TRIAL", force_dimension(c),
                       "Force of the penalty before the limit.", ColumnSource::kTrialForce, k, d});
    columns.push_back({force_column("CSF", c) + "_RAW", force_dimension(c),
                       "Force within the limit, before the filter.", ColumnSource::kRawForce, k,
                       d});
  }
  if (std::holds_alternative<law::ViscousPenalty>(definition.formulation->penalty)) {
    const bool rotational = is_rotational(definition);
    Dimension viscous = rotational ? kMoment : kForce;
    if (!rotational) --viscous.length;
    ++viscous.time;
    columns.push_back({"VISC_C" + suffix, viscous, "Coefficient C of the viscous penalty.",
                       ColumnSource::kViscousCoefficient, 0, d});
  }
  if (filtered) {
    columns.push_back({"ALPHA" + suffix, kNumber, "Coefficient of the filter.",
                       ColumnSource::kFilterAlpha, 0, d});
  }
  columns.push_back({"UTILISATION" + suffix, kNumber,
                     "Of a formulation abs(F)/(mu N): above 1 only behind a filter, inf without a "
                     "limit.",
                     ColumnSource::kLimitUse, 0, d});
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
    // The rings of a chain share their component, so that its number does not tell them apart.
    const std::string ring = is_belt(problem.connection) ? suffix : "";
    if (is_belt(problem.connection)) {
      add("CSF2_MAX" + ring, force, "Upper end of the stick band of CSF2: flow from a to c.",
          ColumnSource::kLargestForce);
      add("CSF2_MIN" + ring, force, "Lower end of the stick band of CSF2: flow from c to a.",
          ColumnSource::kSmallestForce);
    }
    if (!ring.empty()) {
      add("CSF2" + ring, force, "Friction force of the ring.", ColumnSource::kFrictionForce);
      add("f_bc" + ring, force, "Tension behind the ring.", ColumnSource::kRingTension);
    }
    if (is_belt(problem.connection) && (!problem.belt || !problem.belt->lengths.empty())) {
      if (d > 0) {
        columns.push_back({"CP2" + ring, slip, "Flow of material over the ring.",
                           ColumnSource::kFlowBehind, 0, d - 1});
      }
      add("length_bc" + ring, slip, "Length of the segment behind the ring.",
          ColumnSource::kLengthBehind);
      add("reference_length_bc" + ring, slip, "Unstrained length of the segment behind the ring.",
          ColumnSource::kMaterialBehind);
      add("strain_bc" + ring, kNumber, "Strain of the segment behind the ring.",
          ColumnSource::kStrainBehind);
    }
    add(force_column("CNF", c) + ring, force,
        is_belt(problem.connection) ? "Tension in front of the ring, its contact force."
                                    : "Effective normal force of the definition.",
        ColumnSource::kNormalForce);
    add("CASU" + component_suffix(c) + ring, slip, "Accumulated slip of the definition.",
        ColumnSource::kAccumulatedSlip);
  }
  const bool filtered = definition.law.formulation &&
                        definition.law.formulation->filter.kind != law::Filter::Kind::kNone;
  add("STATUS" + suffix, kNumber, "0 open, 1 stick, 2 slip.", ColumnSource::kStatus);
  add("MU" + suffix, kNumber, "Coefficient of friction used.", ColumnSource::kMu);
  add_coefficient(problem, d, suffix, columns);
  add("FN" + suffix, force, "Effective normal force.", ColumnSource::kNormalForce);
  add("FLIM" + suffix, force, "Limit of the friction force.", ColumnSource::kLimit);
  add("PHI" + suffix, force,
      filtered ? "Friction force before the filter minus limit."
               : "Friction force minus limit, P - FLIM.",
      ColumnSource::kPhi);
  add("SEL" + suffix, slip, "Elastic slip.", ColumnSource::kElasticSlip);
  if (definition.dead_zone) {
    add("PLAY" + component_suffix(definition.law.slip.component[0]), slip,
        "Play of the dead zone, from -width/2 to width/2.", ColumnSource::kPlay);
  }
  add("DISS" + suffix, kEnergy, "Dissipated energy since the start.", ColumnSource::kDissipation);
  add("STRAIN_E" + suffix, kEnergy, "Energy stored in the stick stiffness.",
      ColumnSource::kStoredEnergy);
  add("WORK" + suffix, kEnergy, "Work of the friction force since the start.", ColumnSource::kWork);
  if (problem.integration.snap_back == SnapBackAction::kJump) {
    add("LOST" + suffix, kEnergy,
        "Energy since the start that the stick spring lost in jumps at constant motion.",
        ColumnSource::kLost);
  }
  if (definition.law.formulation) add_formulation(problem, d, suffix, columns);
}

std::optional<Column> by_name(std::span<const Column> columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  if (found == columns.end()) return std::nullopt;
  return *found;
}

/// The wrap angle of a ring in a row.
double ring_angle(const Case& problem, const Row& row, std::size_t definition) {
  if (problem.belt && problem.belt->angle_from_nodes) return row.belt.wrap_angle;
  return std::get<law::Capstan>(problem.definitions[definition].law.criterion).wrap_angle;
}

/// How far CSF2 may go on one side, with the coefficient of the row.
double band_end(const Case& problem, const Row& row, std::size_t definition, law::FlowSense sense) {
  const law::FrictionUpdate& update = row.definitions[definition].update;
  const double mu_alpha = update.mu * ring_angle(problem, row, definition);
  return std::min(update.normal_force * law::capstan_limit(mu_alpha, sense),
                  problem.definitions[definition].law.force_limit);
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

/// CEF + CVF + CSF + CRF - CCF of a component.
double total_force(const Case& problem, const Row& row, int component) {
  const ComponentForces& forces = row.forces.component[static_cast<std::size_t>(component)];
  double friction = 0.0;
  if (const Owner owner = owner_of(problem, component); owner.definition >= 0) {
    const auto d = static_cast<std::size_t>(owner.definition);
    const auto entry = static_cast<std::size_t>(owner.entry);
    friction =
        problem.definitions[d].law.slip.scale[entry] * row.definitions[d].update.state.force[entry];
  }
  return forces.elastic + forces.viscous + friction + forces.reaction - forces.applied;
}

}  // namespace

bool is_rotational(const law::FrictionDefinition& definition) {
  return law::is_rotational(definition.slip);
}

std::vector<Column> result_columns(const Case& problem) {
  std::vector<Column> columns;
  columns.push_back({"t", kTime, "Total time.", ColumnSource::kTotalTime});
  const law::ConnectionInfo& info = problem.connection.info;
  const bool belt = is_belt(problem.connection);
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
    if (quantity < kTemperatureQuantity || quantity >= kTensionBehind) continue;
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
    case ColumnSource::kElasticForce:
      return row.forces.component[index].elastic;
    case ColumnSource::kViscousForce:
      return row.forces.component[index].viscous;
    case ColumnSource::kReaction:
      return row.forces.component[index].reaction;
    case ColumnSource::kApplied:
      return row.forces.component[index].applied;
    case ColumnSource::kTotalForce:
      return total_force(problem, row, column.index);
    case ColumnSource::kStopFlag:
      return problem.stop[index]->flag(row.quantities[kFirstMotion + index]);
    case ColumnSource::kMassVelocity:
      return row.forces.velocity;
    case ColumnSource::kDrivenVelocity:
      return row.forces.velocity + row.forces.driver_velocity;
    case ColumnSource::kDriverVelocity:
      return row.forces.driver_velocity;
    case ColumnSource::kElasticEnergy:
      return row.forces.elastic_energy;
    case ColumnSource::kViscousDissipation:
      return row.forces.viscous_dissipation;
    case ColumnSource::kKineticEnergy:
      return row.forces.kinetic_energy;
    case ColumnSource::kExternalWork:
      return row.forces.external_work;
    case ColumnSource::kStrain:
      return row.belt.strain;
    case ColumnSource::kBeltTension:
      return std::max(row.quantities[kFirstForce], 0.0);
    case ColumnSource::kReferenceLength:
      return row.belt.reference_length;
    case ColumnSource::kWrapAngle:
      return row.belt.wrap_angle;
    case ColumnSource::kChainForce: {
      double sum = 0.0;
      for (const DefinitionRow& ring : row.definitions) sum += ring.update.state.force[0];
      return sum;
    }
    default:
      break;
  }
  const auto d = static_cast<std::size_t>(column.definition);
  const law::SlipSpace& slip = problem.definitions[d].law.slip;
  const DefinitionRow& here = row.definitions[d];
  switch (column.source) {
    case ColumnSource::kFrictionForce:
      return slip.scale[index] * here.update.state.force[index];
    case ColumnSource::kLengthBehind:
      return problem.belt->lengths[d];
    case ColumnSource::kMaterialBehind:
      return here.behind.reference_length;
    case ColumnSource::kStrainBehind:
      return here.behind.strain;
    case ColumnSource::kFlowBehind:
      return here.behind.flow;
    case ColumnSource::kRingTension:
      return law::tension_behind(here.update);
    case ColumnSource::kUtilisation:
      return law::capstan_utilisation(here.update, ring_angle(problem, row, d));
    case ColumnSource::kLargestForce:
      return band_end(problem, row, d, law::FlowSense::kForward);
    case ColumnSource::kSmallestForce:
      return -band_end(problem, row, d, law::FlowSense::kBackward);
    case ColumnSource::kFrictionTotal:
      return law::equivalent_force(problem.definitions[d].law, here.update.state);
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
    case ColumnSource::kPlay:
      return here.play;
    case ColumnSource::kElasticSlip:
      return law::equivalent_elastic_slip(problem.definitions[d].law, here.update.state);
    case ColumnSource::kDissipation:
      return here.dissipation;
    case ColumnSource::kLost:
      return here.lost;
    case ColumnSource::kStoredEnergy:
      return here.update.stored_energy;
    case ColumnSource::kPressure:
      return here.update.normal_force / area_of(problem, d).value_or(1.0);
    case ColumnSource::kSpeed:
      return here.update.slip_rate;
    case ColumnSource::kSpeedAlong:
      return here.penalty.speeds[index];
    case ColumnSource::kMuAlong:
      return here.penalty.mu[index];
    case ColumnSource::kRawMu:
      return here.raw_mu[0];
    case ColumnSource::kClamped:
      return here.clamped ? 1.0 : 0.0;
    case ColumnSource::kFilterAlpha:
      return here.penalty.alpha;
    case ColumnSource::kViscousCoefficient:
      return here.penalty.viscous_coefficient;
    case ColumnSource::kTrialForce:
      return slip.scale[index] * here.penalty.trial[index];
    case ColumnSource::kRawForce:
      return slip.scale[index] * here.penalty.raw[index];
    case ColumnSource::kLimitUse:
      return law::limit_use(problem.definitions[d].law, here.update, here.penalty);
    default:
      return here.work;
  }
}

}  // namespace slipbench::driver
