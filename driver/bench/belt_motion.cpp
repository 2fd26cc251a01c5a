// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/belt_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/bracketed_root.hpp"
#include "driver/bench/component_forces.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/case/quantity.hpp"
#include "law/update/capstan_update.hpp"

namespace slipbench::driver::bench {
namespace {

law::Point node(const Quantities& quantities, std::size_t index) {
  law::Point point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = quantities[static_cast<std::size_t>(cases::kFirstNode) + 3 * index + i];
  }
  return point;
}

/// Pull of the spring and of the damper of a belt [F].
struct Pull {
  double elastic = 0.0;
  double viscous = 0.0;
  double tension() const { return elastic + viscous; }
};

/// Returns the pull at a strain that was `before` when the increment began. A slack belt is not
/// strained: its damper sees the change of the positive strain, and may take away what the spring
/// pulls, but does not push. A negative pull of the spring is kept: exact integration finds by it
/// where the belt goes slack.
Pull pull(const cases::Case& problem, const law::Ambient& ambient, double strain, double before,
          double duration) {
  const law::KineticBehavior& belt = problem.kinetic;
  Pull result;
  result.elastic = belt.elasticity[0]->value(strain, ambient).force;
  if (!belt.damping[0] || !(duration > 0.0) || !(result.elastic > 0.0)) return result;
  const double rate = (std::max(strain, 0.0) - std::max(before, 0.0)) / duration;
  result.viscous = std::max(belt.damping[0]->value(rate, ambient).force, -result.elastic);
  return result;
}

/// Returns the strain at which spring and damper pull with a tension; nothing if no strain does.
std::optional<double> strain_under(const cases::Case& problem, const law::Ambient& ambient,
                                   double tension, double before, double duration) {
  const law::KineticBehavior& belt = problem.kinetic;
  if (!belt.elasticity[0]) return problem.belt->initial_strain;
  const bool damped = belt.damping[0] && duration > 0.0;
  if (belt.elasticity[0]->table() == nullptr && (!damped || belt.damping[0]->table() == nullptr)) {
    const double k = belt.elasticity[0]->value(0.0, ambient).slope;
    const double c = damped ? belt.damping[0]->value(0.0, ambient).slope / duration : 0.0;
    return (tension + c * before) / (k + c);
  }
  const auto missing = [&](double strain) {
    const Pull there = pull(problem, ambient, strain, before, duration);
    return std::max(there.tension(), 0.0) - tension;
  };
  double low = 0.0;
  double at_low = missing(low);
  // A slack segment is straight; one whose spring pulls at strain 0 already is not shorter.
  if (!(at_low < 0.0)) return low;
  for (double high = std::max(2.0 * before, 1e-6); high < 1e6; high *= 2.0) {
    const double at_high = missing(high);
    if (at_high >= 0.0) return narrow({low, high}, at_low, at_high, 0.0, missing).b;
    low = high;
    at_low = at_high;
  }
  return std::nullopt;
}

/// Returns "the distance CP1 = 0.1 of the nodes is below 1, a hundredth of the initial one", or a
/// stop that it is beyond.
std::optional<std::string> out_of_reach(const cases::Case& problem, const Quantities& quantities) {
  law::RelativePosition position;
  position[0] = quantities[cases::kFirstMotion];
  if (auto fault = beyond_stop(problem, {}, position)) return fault;
  const double shortest = law::kShortestPart * problem.initial[0];
  if (position[0] >= shortest) return std::nullopt;
  return fmt::format(
      "the distance CP1 = {} of the nodes is below {}, a hundredth of the initial one: the belt "
      "locks there, and nothing says with what force",
      base::format_number(position[0]), base::format_number(shortest));
}

}  // namespace

double reference_length(const cases::Case& problem, const law::RelativePosition& position) {
  return law::reference_length(
      law::initial_reference_length(problem.initial[0], problem.belt->initial_strain),
      position[2] - problem.initial[2], position[1] - problem.initial[1]);
}

std::optional<std::string> move_belt(const cases::Case& problem, Row& row) {
  const cases::Belt& belt = *problem.belt;
  Quantities& q = row.quantities;
  double& distance = q[cases::kFirstMotion];
  if (belt.nodes) {
    const law::Point a = node(q, 0), b = node(q, 1), c = node(q, 2);
    distance = law::distance(a, b);
    if (belt.angle_from_nodes) {
      row.belt.wrap_angle = law::wrap_angle(a, b, c);
      if (!std::isfinite(row.belt.wrap_angle)) {
        return fmt::format("node {} lies on node b: the wrap angle is not defined",
                           distance > 0.0 ? "c" : "a");
      }
    }
    if (belt.half_turns) {
      row.turn = row.index == 0 ? law::begin_turn(*belt.half_turns, a, b, c)
                                : law::follow_turn(row.turn, a, b, c);
      row.belt.wrap_angle = std::abs(row.turn.angle);
    }
  }
  if (belt.has_length) {
    if (!(distance > 0.0)) {
      return fmt::format("the distance CP1 of the nodes is {}: it must be greater than 0",
                         base::format_number(distance));
    }
    if (auto fault = out_of_reach(problem, q)) return fault;
    const law::Ambient ambient = ambient_of(q, problem.reference);
    const double length = reference_length(problem, ambient.position);
    if (!(length > 0.0)) {
      return fmt::format(
          "no material is left in segment ab: its reference length is {}, more has flowed out at b "
          "(CP2) than there was and came in at a (CP3)",
          base::format_number(length));
    }
    row.belt.reference_length = length;
    const double before = std::exchange(row.belt.strain, law::strain(distance, length));
    if (problem.kinetic.elasticity[0]) {
      const Pull here = pull(problem, ambient, row.belt.strain, before, row.duration);
      q[cases::kFirstForce] = here.tension();
      row.forces.component[0].elastic = std::max(here.elastic, 0.0);
      row.forces.component[0].viscous = here.viscous;
    }
  }
  if (belt.both_tensions && q[cases::kTensionBehind] < 0.0) {
    return fmt::format("the tension f_bc is {}: a belt pulls, it does not push",
                       base::format_number(q[cases::kTensionBehind]));
  }
  return std::nullopt;
}

void prepare_belt(const cases::Case& problem, const Row& row, law::ConnectorIncrement& increment,
                  std::span<law::FrictionDefinition> definitions) {
  increment.end.motion[0] = row.belt.strain;
  if (!problem.belt->angle_from_nodes) return;
  for (law::FrictionDefinition& definition : definitions) {
    if (auto* capstan = std::get_if<law::Capstan>(&definition.criterion)) {
      capstan->wrap_angle = row.belt.wrap_angle;
    }
  }
}

std::optional<std::string> move_behind(const cases::Case& problem, std::size_t ring, Row& row) {
  if (problem.belt->lengths.empty()) return std::nullopt;
  law::SegmentBehind& segment = row.definitions[ring].behind;
  const double tension = law::tension_behind(row.definitions[ring].update);
  const auto strain = strain_under(problem, ambient_of(row.quantities, problem.reference), tension,
                                   segment.strain, row.duration);
  if (!strain) {
    return fmt::format("the elasticity of the belt never reaches the tension {} behind ring {}",
                       base::format_number(tension), ring + 1);
  }
  segment.strain = *strain;
  const double length = problem.belt->lengths[ring] / (1.0 + segment.strain);
  const double before = std::exchange(segment.reference_length, length);
  segment.flow_before = segment.flow;
  if (row.index == 0) return std::nullopt;
  // What came in and did not stay has left at the end.
  const double in = ring == 0 ? row.quantities[cases::kFirstMotion + 1] - row.begin[1]
                              : row.definitions[ring - 1].behind.flow -
                                    row.definitions[ring - 1].behind.flow_before;
  segment.flow += in - (length - before);
  return std::nullopt;
}

void meet_next_ring(const cases::Case& problem, std::size_t ring, const Row& row,
                    law::ConnectorIncrement& increment) {
  const DefinitionRow& here = row.definitions[ring];
  increment.force[0] = law::tension_behind(here.update);
  if (problem.belt->lengths.empty()) return;
  increment.begin_position[1] = here.behind.flow_before;
  increment.end.position[1] = here.behind.flow;
}

}  // namespace slipbench::driver::bench
