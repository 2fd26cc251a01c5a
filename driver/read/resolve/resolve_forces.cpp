// SPDX-License-Identifier: Apache-2.0
// Springs, dampers and stops along free components, the mass of a dynamic case, and which
// components are driven by force.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

/// The index of a free component, or nothing after reporting an error.
std::optional<int> free_component(yaml::Binder& binder, const yaml::At<int>& at,
                                  const cases::Case& problem, std::string_view what) {
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
bool refused_by_a_belt(yaml::Binder& binder, const cases::Case& problem, const yaml::Node& node,
                       const yaml::Path& path, std::string_view what) {
  if (!cases::is_belt(problem.connection)) return false;
  binder.error(node, path, "a SLIPRING takes no " + std::string(what));
  return true;
}

/// Returns the index of a free component that an entry of a list names, unless it is faulty or
/// another entry has named it, which is reported.
std::optional<int> new_component(yaml::Binder& binder, const yaml::At<int>& at,
                                 const cases::Case& problem, std::string_view what,
                                 law::ComponentSet& seen) {
  const auto c = free_component(binder, at, problem, what);
  if (c && seen.contains(*c)) {
    binder.error(*at.node, at.path, component_words(*c) + " already has " + std::string(what));
    return std::nullopt;
  }
  if (c) seen.insert(*c);
  return c;
}

const yaml::At<double>& linear_form(const yaml::At<double>& number) { return number; }
/// Returns the number of a spring along one component; a matrix is none, which is reported.
yaml::At<double> linear_form(const yaml::At<NumberOrMatrix>& text) {
  const double* number = std::get_if<double>(&text.value);
  return {number != nullptr ? *number : 0.0, text.node, text.path, text.sound && number != nullptr};
}

/// Reports what keeps a matrix from being the stiffness of springs between `count` components.
bool is_stiffness(yaml::Binder& binder, const yaml::At<NumberOrMatrix>& at, std::size_t count) {
  const auto* rows = std::get_if<std::vector<std::vector<double>>>(&at.value);
  const std::string size = std::to_string(count);
  if (rows == nullptr || rows->size() != count ||
      std::any_of(rows->begin(), rows->end(),
                  [&](const auto& row) { return row.size() != count; })) {
    binder.error(*at.node, at.path,
                 "wanted a matrix of " + size + " rows of " + size +
                     " numbers, one for each of the 'components'");
    return false;
  }
  const auto n = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd scaled(n, n);  // to the size 1 of its diagonal, so that units do not matter
  const auto entry = [&](Eigen::Index i, Eigen::Index j) {
    return (*rows)[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j < i && entry(i, j) != entry(j, i)) {
        binder.error(*at.node, at.path / static_cast<std::size_t>(i) / static_cast<std::size_t>(j),
                     "a stiffness matrix is symmetric: " + base::format_number(entry(i, j)) +
                         " here and " + base::format_number(entry(j, i)) + " across the diagonal");
        return false;
      }
      const double size_i = entry(i, i) > 0.0 ? std::sqrt(entry(i, i)) : 1.0;
      const double size_j = entry(j, j) > 0.0 ? std::sqrt(entry(j, j)) : 1.0;
      scaled(i, j) = entry(i, j) / size_i / size_j;
    }
  }
  constexpr double kRounding = 1e-12;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled, Eigen::EigenvaluesOnly);
  if (eigen.info() == Eigen::Success && eigen.eigenvalues()[0] >= -kRounding) return true;
  binder.error(*at.node, at.path,
               "a stiffness matrix is positive semidefinite: along some displacement these springs "
               "would give away energy that nothing has put in",
               "for two components, stiffness[0][1]^2 must not be above stiffness[0][0] times "
               "stiffness[1][1]");
  return false;
}

/// Reads springs that join several components.
void read_coupled(yaml::Binder& binder, const yaml::At<ElasticityText>& at, law::ComponentSet& seen,
                  cases::Case& out) {
  const ElasticityText& text = at.value;
  const auto& list = text.components;
  if (refused_by_a_belt(binder, out, *list.node, list.path, "coupled springs")) return;
  for (const auto& [given, node, path] :
       {std::tuple{text.component.given(), text.component.node, text.component.path},
        std::tuple{text.columns.given(), text.columns.node, text.columns.path}}) {
    if (!given) continue;
    binder.error(*node, path, "several components take a 'stiffness' matrix, and nothing beside it",
                 "leave out 'components', or this");
    return;
  }
  if (!list.sound || text.stiffness.faulty()) return;
  if (list.value.size() < 2) {
    binder.error(*list.node, list.path, "joins two or more components",
                 "a spring along one component is '{component: .., stiffness: ..}'");
    return;
  }
  std::vector<int> components;
  law::ComponentSet rotations;
  for (const yaml::At<int>& one : list.value) {
    const auto c = new_component(binder, one, out, kElasticityTable.what, seen);
    if (!c) continue;
    components.push_back(*c);
    if (law::is_rotation(*c)) rotations.insert(*c);
  }
  if (!text.stiffness.given()) {
    if (yaml::has_unknown_key<ElasticityText>(*at.node)) return;
    binder.error(*at.node, at.path, "needs 'stiffness', the matrix of these components");
    return;
  }
  if (!is_stiffness(binder, text.stiffness, list.value.size())) return;
  if (components.size() < list.value.size()) return;
  // Where lengths and angles are mixed, the entries have several units: none may be carried.
  const bool mixed = !rotations.empty() && rotations.size() < static_cast<int>(components.size());
  if (!mixed) binder.settle_slip_units(at.path, !rotations.empty());
  const auto& rows = std::get<std::vector<std::vector<double>>>(text.stiffness.value);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto row = static_cast<std::size_t>(components[i]);
    out.kinetic.coupled.components.insert(components[i]);
    for (std::size_t j = 0; j < components.size(); ++j) {
      out.kinetic.coupled.stiffness[row][static_cast<std::size_t>(components[j])] = rows[i][j];
    }
  }
}

/// A list of springs or of dampers: one number or one table each.
/// \param number the linear form's key in words: "stiffness"
/// \param store takes the component and the number or table
template <class Text, class Number, class Store>
void read_forces(yaml::Binder& binder, const yaml::At<std::vector<yaml::At<Text>>>& list,
                 cases::Case& problem, const TableUse& use, std::string_view number_key,
                 Number Text::*number, Store store) {
  law::ComponentSet seen;
  for (const yaml::At<Text>& at : list.value) {
    if (!at.given() || !at.node->is_map()) continue;
    const Text& text = at.value;
    if constexpr (std::is_same_v<Text, ElasticityText>) {
      if (text.components.given()) {
        read_coupled(binder, at, seen, problem);
        continue;
      }
      if (text.stiffness.sound && text.stiffness.value.index() == 1) {
        binder.error(*text.stiffness.node, text.stiffness.path,
                     "a matrix is the stiffness of several components",
                     "name them with 'components: [..]', or write one number");
        continue;
      }
      if (!text.component.given() && !yaml::has_unknown_key<Text>(*at.node)) {
        binder.error(*at.node, at.path, "needs 'component', or 'components' and their matrix");
      }
    }
    const auto c = new_component(binder, text.component, problem, use.what, seen);
    if (c && cases::is_belt(problem.connection)) {
      // A tension over a strain or its rate, where others have a length.
      binder.settle_units(at.path, [](base::Dimension over_length) {
        ++over_length.length;
        return over_length;
      });
    } else if (c) {
      binder.settle_slip_units(at.path, law::is_rotation(*c));
    }
    const auto& linear = linear_form(text.*number);
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
    if (yaml::has_unknown_key<Text>(*at.node)) continue;
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
bool lacks(yaml::Binder& binder, const law::TableFunction& table, law::IndependentKind kind,
           std::string_view column, const TableUse& use, const yaml::Node& node,
           const yaml::Path& path) {
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

void read_stops(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  law::ComponentSet seen;
  for (const yaml::At<StopText>& at : text.stops.value) {
    if (!at.given() || !at.node->is_map()) continue;
    const StopText& stop = at.value;
    const auto c = free_component(binder, stop.component, out, "a stop");
    if (c && seen.contains(*c)) {
      binder.error(*stop.component.node, stop.component.path,
                   component_words(*c) + " already has stops");
    }
    if (c) seen.insert(*c);
    if (c && *c != 0 && cases::is_belt(out.connection)) {
      binder.error(*stop.component.node, stop.component.path,
                   "the stops of a SLIPRING bound the distance of its nodes a and b, component 1");
      continue;
    }
    if (c) binder.settle_slip_units(at.path, law::is_rotation(*c));
    if (!stop.lower.given() && !stop.upper.given()) {
      if (!yaml::has_unknown_key<StopText>(*at.node)) {
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
                   "the lower stop " + base::format_number(value.lower) +
                       " must lie below the upper one, " + base::format_number(value.upper));
      continue;
    }
    if (!c) continue;
    const double start = out.initial[*c];
    const bool known = !cases::is_belt(out.connection) || start > 0.0;
    if ((known && start < value.lower) || start > value.upper) {
      binder.error(*at.node, at.path,
                   "the initial position " + cases::motion_name(*c) + " = " +
                       base::format_number(start) + " lies beyond a stop");
    }
    out.stop[static_cast<std::size_t>(*c)] = value;
  }
}

void read_dynamics(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  if (!text.dynamics.given() || !text.dynamics.node->is_map()) return;
  const DynamicsText& dynamics = text.dynamics.value;
  const yaml::Node& node = *text.dynamics.node;
  const yaml::Path& path = text.dynamics.path;
  if (is_any_connection(out.connection)) return;
  if (refused_by_a_belt(binder, out, node, path, "'dynamics'")) return;
  cases::DynamicsData data;
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
  if (dynamics.driver.given() && dynamics.driver.sound) {
    data.driver =
        cases::DriverData{dynamics.driver.value.mass.value, dynamics.driver.value.velocity.value};
    if (dynamics.belt_velocity.given()) {
      binder.error(*dynamics.belt_velocity.node, dynamics.belt_velocity.path,
                   "a mass rubs on a belt or on a driver, not on both",
                   "the driver's velocity at the start is 'driver: {velocity: ..}'");
    }
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
                   "the static coefficient " + base::format_number(*data.static_coefficient) +
                       " is below the coefficient of slow slip, " + base::format_number(at_rest) +
                       ": nothing could hold still");
    }
    const auto& frictions = text.friction.value;
    if (d < frictions.size() && frictions[d].value.stick.given()) {
      binder.note(*frictions[d].value.stick.node, frictions[d].value.stick.path,
                  "sticking is rigid in dynamics: the stick stiffness is not used");
    }
  }
  if (out.stop[static_cast<std::size_t>(data.component)]) {
    binder.error(node, path,
                 component_words(data.component) +
                     " has stops: the impact of a mass on a stop is not modelled");
  }
  out.dynamics = data;
}

/// Reports motions and loads that cannot be had together. `motions` and `forces` are the names
/// under one step, or in one measured history.
template <class Motions, class Forces>
void check_drives(yaml::Binder& binder, const cases::Case& out, const Motions& motions,
                  const Forces& forces) {
  for (const auto& entry : motions) {
    const auto c = cases::component_of_motion(entry.name);
    if (!c || !out.connection.info.available.contains(*c)) continue;
    if (out.dynamics && out.dynamics->component == *c) {
      binder.error(*entry.key, entry.path,
                   "the mass moves along " + component_words(*c) +
                       " by itself: its motion cannot be prescribed",
                   "a load on it goes under 'force: {" + cases::force_name(*c) + ": ...}'");
    }
    for (const auto& other : forces) {
      if (cases::component_of_force(other.name) != c) continue;
      binder.error(*other.key, other.path,
                   component_words(*c) + " is driven by its motion " + cases::motion_name(*c) +
                       " here: it cannot be driven by force at once",
                   "leave out one of them");
    }
  }
  for (const auto& entry : forces) {
    const auto c = cases::component_of_force(entry.name);
    if (!c || !out.connection.info.available.contains(*c)) continue;
    if (out.dynamics && out.dynamics->component != *c) {
      binder.error(*entry.key, entry.path,
                   "in dynamics only the component of the mass, " +
                       component_words(out.dynamics->component) + ", takes a load");
    }
  }
}

/// Temperature and fields that a spring or damper depends on and the history never gives.
void explain_arguments(yaml::Binder& binder, const cases::Case& out,
                       const law::TableFunction* table, const yaml::Node& node,
                       const yaml::Path& path, std::string_view what) {
  if (table == nullptr) return;
  for (const law::Independent& one : table->independents()) {
    const bool is_field = one.kind == law::IndependentKind::kField;
    if (!is_field && one.kind != law::IndependentKind::kTemperature) continue;
    const int quantity = is_field ? cases::kFirstField + one.index : cases::kTemperatureQuantity;
    if (!cases::is_driven(out, quantity)) {
      binder.warning(node, path,
                     std::string(what) + " depends on " + cases::quantity_name(quantity) +
                         ", which the history never gives: it is 0");
    }
  }
}

}  // namespace

void resolve_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  read_forces(binder, text.elasticity, out, kElasticityTable, "stiffness",
              &ElasticityText::stiffness,
              [&](int c, const yaml::At<ElasticityText>& at, auto value) {
                if constexpr (std::is_same_v<decltype(value), law::TableFunction>) {
                  if (lacks(binder, value, law::IndependentKind::kConstitutiveMotion,
                            "displacement", kElasticityTable, *at.node, at.path)) {
                    return;
                  }
                }
                if (cases::is_belt(out.connection) && c != 0) {
                  binder.error(*at.node, at.path,
                               "the belt of a SLIPRING is elastic in component 1 only: its tension "
                               "over its strain");
                  return;
                }
                out.kinetic.elasticity[static_cast<std::size_t>(c)].emplace(std::move(value));
              });
  read_forces(binder, text.damping, out, kDampingTable, "coefficient", &DampingText::coefficient,
              [&](int c, const yaml::At<DampingText>& at, auto value) {
                if (cases::is_belt(out.connection) && c != 0) {
                  binder.error(*at.node, at.path,
                               "the belt of a SLIPRING is damped in component 1 only: its tension "
                               "over the rate of its strain");
                  return;
                }
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
                out.kinetic.damping[static_cast<std::size_t>(c)].emplace(std::move(value));
              });
  read_stops(binder, text, out);
  read_dynamics(binder, text, out);
}

void finish_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  if (is_any_connection(out.connection) || cases::is_belt(out.connection)) return;
  const HistoryText& history = text.history.value;
  for (const yaml::At<StepText>& step : history.steps) {
    check_drives(binder, out, step.value.motion, step.value.force);
  }
  if (history.measured) {
    check_drives(binder, out, history.measured->columns.value, history.measured->columns.value);
  }
  for (int c = 0; c < law::kComponents && !out.dynamics; ++c) {
    if (out.connection.info.available.contains(c) &&
        cases::is_driven(out, cases::kFirstForce + c)) {
      out.force_driven.insert(c);
    }
  }
  for (const yaml::At<ElasticityText>& at : text.elasticity.value) {
    if (!at.value.component.sound) continue;
    const auto& spring =
        out.kinetic.elasticity[static_cast<std::size_t>(at.value.component.value - 1)];
    explain_arguments(binder, out, spring ? spring->table() : nullptr, *at.node, at.path,
                      kElasticityTable.what);
  }
  for (const yaml::At<DampingText>& at : text.damping.value) {
    if (!at.value.component.sound) continue;
    const auto& damper =
        out.kinetic.damping[static_cast<std::size_t>(at.value.component.value - 1)];
    explain_arguments(binder, out, damper ? damper->table() : nullptr, *at.node, at.path,
                      kDampingTable.what);
  }
}

}  // namespace slipbench::driver::read
