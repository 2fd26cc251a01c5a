// SPDX-License-Identifier: Apache-2.0
// Springs, dampers and stops along free components, the mass of a dynamic case, and which
// components are driven by force.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/case/case_codecs.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/resolve.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

std::string component_words(int component) { return "component " + std::to_string(component + 1); }

/// The index of a free component, or nothing after reporting an error.
std::optional<int> free_component(Binder& binder, const At<int>& at, const Case& problem,
                                  std::string_view what) {
  if (!at.sound || is_any_connection(problem.connection)) return std::nullopt;
  const int c = at.value - 1;
  const law::ConnectionInfo& info = problem.connection.info;
  if (info.available.contains(c)) return c;
  binder.error(*at.node, at.path,
               connector_words(problem.connection) +
                   (info.held.contains(c) ? " holds " : " has no ") + component_words(c) + ": " +
                   std::string(what) + " acts along a free component; free are " +
                   motion_names(info.available));
  return std::nullopt;
}

/// A belt is elastic in its segment ab, and nothing else: what slides over its ring is material.
bool refused_by_a_belt(Binder& binder, const Case& problem, const Node& node, const Path& path,
                       std::string_view what) {
  if (!is_belt(problem.connection)) return false;
  binder.error(node, path, "a SLIPRING takes no " + std::string(what));
  return true;
}

/// A list of springs or of dampers: one number or one table each.
/// \param number the linear form's key in words: "stiffness"
/// \param store takes the component and the number or table
template <class Text, class Store>
void read_forces(Binder& binder, const At<std::vector<At<Text>>>& list, const Case& problem,
                 const TableUse& use, std::string_view number_key, At<double> Text::*number,
                 Store store) {
  law::ComponentSet seen;
  for (const At<Text>& at : list.value) {
    if (!at.given() || !at.node->is_map()) continue;
    const Text& text = at.value;
    const auto c = free_component(binder, text.component, problem, use.what);
    if (c && seen.contains(*c)) {
      binder.error(*text.component.node, text.component.path,
                   component_words(*c) + " already has " + std::string(use.what));
    }
    if (c) seen.insert(*c);
    if (c && is_belt(problem.connection)) {
      binder.settle_units(at.path, kForce);  // a tension over a strain
    } else if (c) {
      binder.settle_slip_units(at.path, law::is_rotation(*c));
    }
    const At<double>& linear = text.*number;
    const bool table_given = text.columns.given() || text.rows.given() || text.csv.given();
    if (linear.given() && table_given) {
      binder.error(*linear.node, linear.path,
                   "give '" + std::string(number_key) + "' or a table, not both");
      continue;
    }
    if (linear.given()) {
      if (c && linear.sound) store(*c, at, linear.value);
      continue;
    }
    if (has_unknown_key<Text>(*at.node)) continue;
    if (!text.columns.given() || (!text.rows.given() && !text.csv.given())) {
      binder.error(*at.node, at.path,
                   "needs '" + std::string(number_key) + "', or a table with 'columns' and 'rows'");
      continue;
    }
    if (!text.columns.sound) continue;
    TableText table;
    table.columns = text.columns;
    table.rows = text.rows;
    table.csv = text.csv;
    table.extrapolate = text.extrapolate;
    auto function = table_function(binder, table, *at.node, at.path, use);
    if (c && function) store(*c, at, std::move(*function));
  }
}

/// A spring or damper whose force does not follow what it is there to follow.
bool lacks(Binder& binder, const law::TableFunction& table, law::IndependentKind kind,
           std::string_view column, const TableUse& use, const Node& node, const Path& path) {
  if (table.column_of(kind) >= 0) return false;
  binder.error(*node.find("columns"), path / "columns",
               "the table of " + std::string(use.what) + " needs the column '" +
                   std::string(column) + "' after the force");
  return true;
}

/// A damper takes energy out: its force has the sign of the velocity. The table is linear between
/// its knots, so it is judged there and on both sides of velocity 0.
bool drives_on(const law::TableFunction& table) {
  // Tables over temperature or fields as well are judged at velocity alone if that is all there is.
  if (table.independents().size() != 1) return false;
  const auto force = [&](double v) { return table.value({}, {.slip_rate = v}); };
  if (force(0.0) != 0.0) return true;
  const auto knots = table.table().knots(0);
  return std::any_of(knots.begin(), knots.end(), [&](double v) { return v * force(v) < 0.0; });
}

void read_stops(Binder& binder, const CaseText& text, Case& out) {
  law::ComponentSet seen;
  for (const At<StopText>& at : text.stops.value) {
    if (!at.given() || !at.node->is_map()) continue;
    const StopText& stop = at.value;
    const auto c = free_component(binder, stop.component, out, "a stop");
    if (c && seen.contains(*c)) {
      binder.error(*stop.component.node, stop.component.path,
                   component_words(*c) + " already has stops");
    }
    if (c) seen.insert(*c);
    if (c) binder.settle_slip_units(at.path, law::is_rotation(*c));
    if (!stop.lower.given() && !stop.upper.given()) {
      if (!has_unknown_key<StopText>(*at.node)) {
        binder.error(*at.node, at.path, "needs 'lower', 'upper' or both");
      }
      continue;
    }
    if (stop.lower.faulty() || stop.upper.faulty()) continue;
    law::Stop value;
    if (stop.lower.given()) value.lower = stop.lower.value;
    if (stop.upper.given()) value.upper = stop.upper.value;
    if (!(value.lower < value.upper)) {
      binder.error(*at.node, at.path,
                   "the lower stop " + format_number(value.lower) +
                       " must lie below the upper one, " + format_number(value.upper));
      continue;
    }
    if (!c) continue;
    const double start = out.initial[*c];
    if (start < value.lower || start > value.upper) {
      binder.error(*at.node, at.path,
                   "the initial position " + motion_name(*c) + " = " + format_number(start) +
                       " lies beyond a stop");
    }
    out.behavior[static_cast<std::size_t>(*c)].stop = value;
  }
}

void read_dynamics(Binder& binder, const CaseText& text, Case& out) {
  if (!text.dynamics.given() || !text.dynamics.node->is_map()) return;
  const DynamicsText& dynamics = text.dynamics.value;
  const Node& node = *text.dynamics.node;
  const Path& path = text.dynamics.path;
  if (is_any_connection(out.connection)) return;
  if (refused_by_a_belt(binder, out, node, path, "'dynamics'")) return;
  DynamicsData data;
  const law::ComponentSet free = out.connection.info.available;
  if (dynamics.component.given()) {
    const auto c = free_component(binder, dynamics.component, out, "the mass");
    if (!c) return;
    data.component = *c;
  } else if (free.size() == 1) {
    while (!free.contains(data.component)) ++data.component;
  } else {
    binder.error(node, path,
                 connector_words(out.connection) + " has " + std::to_string(free.size()) +
                     " free components (" + motion_names(free) +
                     "): 'component' must say which one the mass moves along");
    return;
  }
  binder.settle_slip_units(path, law::is_rotation(data.component));
  data.mass = dynamics.mass.value;
  data.belt_velocity = dynamics.belt_velocity.value;
  data.initial_velocity = dynamics.initial_velocity.value;
  if (dynamics.static_coefficient.sound) {
    data.static_coefficient = dynamics.static_coefficient.value;
  }
  for (std::size_t d = 0; d < out.definitions.size(); ++d) {
    const law::FrictionDefinition& law = out.definitions[d].law;
    const auto begin = law.slip.component.begin();
    const auto end = begin + law.slip.dimension;
    if (std::find(begin, end, data.component) == end) continue;
    if (law.slip.dimension > 1) {
      binder.error(
          node, path,
          "friction '" + out.definitions[d].name + "' couples " + component_words(data.component) +
              " with others: a mass slides along one component only",
          "write the friction with 'component: " + std::to_string(data.component + 1) + "'");
    } else if (!std::holds_alternative<law::EuclideanPotential>(law.criterion) ||
               law.slip.scale[0] != 1.0) {
      binder.error(
          node, path,
          "friction '" + out.definitions[d].name +
              "' has a potential: a mass slides along one component only",
          "write the friction with 'component: " + std::to_string(data.component + 1) + "'");
    }
    const bool plain = std::holds_alternative<law::ConstantCoefficient>(law.law) ||
                       law::exponential_decay(law.law).has_value();
    const double at_rest = plain ? law::evaluate(law.law, {}, {}).mu : 0.0;
    if (data.static_coefficient && *data.static_coefficient < at_rest) {
      binder.error(*dynamics.static_coefficient.node, dynamics.static_coefficient.path,
                   "the static coefficient " + format_number(*data.static_coefficient) +
                       " is below the coefficient of slow slip, " + format_number(at_rest) +
                       ": nothing could hold still");
    }
    const auto& frictions = text.friction.value;
    if (d < frictions.size() && frictions[d].value.stick.given()) {
      binder.note(*frictions[d].value.stick.node, frictions[d].value.stick.path,
                  "sticking is rigid in dynamics: the stick stiffness is not used");
    }
  }
  if (out.behavior[static_cast<std::size_t>(data.component)].stop) {
    binder.error(node, path,
                 component_words(data.component) +
                     " has stops: the impact of a mass on a stop is not modelled");
  }
  out.dynamics = data;
}

/// Reports motions and loads that cannot be had together. `motions` and `forces` are the names
/// under one step, or in one measured history.
template <class Motions, class Forces>
void check_drives(Binder& binder, const Case& out, const Motions& motions, const Forces& forces) {
  for (const auto& entry : motions) {
    const auto c = component_of_motion(entry.name);
    if (!c || !out.connection.info.available.contains(*c)) continue;
    if (out.dynamics && out.dynamics->component == *c) {
      binder.error(*entry.key, entry.path,
                   "the mass moves along " + component_words(*c) +
                       " by itself: its motion cannot be prescribed",
                   "a load on it goes under 'force: {" + force_name(*c) + ": ...}'");
    }
    for (const auto& other : forces) {
      if (component_of_force(other.name) != c) continue;
      binder.error(*other.key, other.path,
                   component_words(*c) + " is driven by its motion " + motion_name(*c) +
                       " here: it cannot be driven by force at once",
                   "leave out one of them");
    }
  }
  for (const auto& entry : forces) {
    const auto c = component_of_force(entry.name);
    if (!c || !out.connection.info.available.contains(*c)) continue;
    if (out.dynamics && out.dynamics->component != *c) {
      binder.error(*entry.key, entry.path,
                   "in dynamics only the component of the mass, " +
                       component_words(out.dynamics->component) + ", takes a load");
    }
  }
}

/// Temperature and fields that a spring or damper depends on and the history never gives.
void explain_arguments(Binder& binder, const Case& out, const law::TableFunction* table,
                       const Node& node, const Path& path, std::string_view what) {
  if (table == nullptr) return;
  for (const law::Independent& one : table->independents()) {
    const bool is_field = one.kind == law::IndependentKind::kField;
    if (!is_field && one.kind != law::IndependentKind::kTemperature) continue;
    const int quantity = is_field ? kFirstField + one.index : kTemperatureQuantity;
    bool driven = false;
    for (const Step& step : out.steps) {
      for (const Drive& drive : step.drives) driven = driven || drive.quantity == quantity;
    }
    if (out.measured) {
      for (const MeasuredColumn& column : out.measured->columns) {
        driven = driven || column.quantity == static_cast<std::size_t>(quantity);
      }
    }
    if (!driven) {
      binder.warning(node, path,
                     std::string(what) + " depends on " + quantity_name(quantity) +
                         ", which the history never gives: it is 0");
    }
  }
}

}  // namespace

void resolve_forces(Binder& binder, const CaseText& text, Case& out) {
  read_forces(binder, text.elasticity, out, kElasticityTable, "stiffness",
              &ElasticityText::stiffness, [&](int c, const At<ElasticityText>& at, auto value) {
                if constexpr (std::is_same_v<decltype(value), law::TableFunction>) {
                  if (lacks(binder, value, law::IndependentKind::kConstitutiveMotion,
                            "displacement", kElasticityTable, *at.node, at.path)) {
                    return;
                  }
                }
                if (is_belt(out.connection) && c != 0) {
                  binder.error(*at.node, at.path,
                               "the belt of a SLIPRING is elastic in component 1 only: its tension "
                               "over its strain");
                  return;
                }
                out.behavior[static_cast<std::size_t>(c)].elasticity.emplace(std::move(value));
              });
  read_forces(binder, text.damping, out, kDampingTable, "coefficient", &DampingText::coefficient,
              [&](int c, const At<DampingText>& at, auto value) {
                if (refused_by_a_belt(binder, out, *at.node, at.path, "damping")) return;
                if constexpr (std::is_same_v<decltype(value), law::TableFunction>) {
                  if (lacks(binder, value, law::IndependentKind::kSlipRate, "velocity",
                            kDampingTable, *at.node, at.path)) {
                    return;
                  }
                  if (drives_on(value)) {
                    binder.error(
                        *at.node, at.path,
                        "a damper's force has the sign of the velocity, and is 0 at velocity 0",
                        "tables are not mirrored: give the rows of negative velocities too");
                    return;
                  }
                }
                out.behavior[static_cast<std::size_t>(c)].damping.emplace(std::move(value));
              });
  if (text.stops.given() &&
      !refused_by_a_belt(binder, out, *text.stops.node, text.stops.path, "stops")) {
    read_stops(binder, text, out);
  }
  read_dynamics(binder, text, out);
}

void finish_forces(Binder& binder, const CaseText& text, Case& out) {
  if (is_any_connection(out.connection) || is_belt(out.connection)) return;
  const HistoryText& history = text.history.value;
  for (const At<StepText>& step : history.steps) {
    check_drives(binder, out, step.value.motion, step.value.force);
  }
  if (history.measured) {
    check_drives(binder, out, history.measured->columns.value, history.measured->columns.value);
  }
  const auto drives = [&](int quantity) {
    const int c = quantity - kFirstForce;
    if (c < 0 || c >= law::kComponents || !out.connection.info.available.contains(c)) return;
    if (!out.dynamics) out.force_driven.insert(c);
  };
  for (const Step& step : out.steps) {
    for (const Drive& drive : step.drives) drives(drive.quantity);
  }
  if (out.measured) {
    for (const MeasuredColumn& column : out.measured->columns) {
      drives(static_cast<int>(column.quantity));
    }
  }
  for (const At<ElasticityText>& at : text.elasticity.value) {
    if (!at.value.component.sound) continue;
    const auto& spring = out.behavior[static_cast<std::size_t>(at.value.component.value - 1)];
    explain_arguments(binder, out, spring.elasticity ? spring.elasticity->table() : nullptr,
                      *at.node, at.path, kElasticityTable.what);
  }
  for (const At<DampingText>& at : text.damping.value) {
    if (!at.value.component.sound) continue;
    const auto& damper = out.behavior[static_cast<std::size_t>(at.value.component.value - 1)];
    explain_arguments(binder, out, damper.damping ? damper.damping->table() : nullptr, *at.node,
                      at.path, kDampingTable.what);
  }
}

}  // namespace slipbench::driver
