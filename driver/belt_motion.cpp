// SPDX-License-Identifier: Apache-2.0
#include "driver/belt_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "driver/case/quantity.hpp"
#include "driver/connector_increment.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

law::Point node(const Quantities& quantities, std::size_t index) {
  law::Point point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = quantities[static_cast<std::size_t>(kFirstNode) + 3 * index + i];
  }
  return point;
}

}  // namespace

std::optional<std::string> move_belt(const Case& problem, Row& row) {
  const Belt& belt = *problem.belt;
  Quantities& q = row.quantities;
  double& distance = q[kFirstMotion];
  if (belt.nodes) {
    const law::Point a = node(q, 0), b = node(q, 1), c = node(q, 2);
    distance = law::distance(a, b);
    row.belt.wrap_angle = law::wrap_angle(a, b, c);
    if (!std::isfinite(row.belt.wrap_angle)) {
      return fmt::format("node {} lies on node b: the wrap angle is not defined",
                         distance > 0.0 ? "c" : "a");
    }
  }
  if (belt.has_length) {
    if (!(distance > 0.0)) {
      return fmt::format("the distance CP1 of the nodes is {}: it must be greater than 0",
                         format_number(distance));
    }
    const double length = law::reference_length(
        law::initial_reference_length(problem.initial[0], belt.initial_strain),
        q[kFirstMotion + 2] - problem.initial[2], q[kFirstMotion + 1] - problem.initial[1]);
    if (!(length > 0.0)) {
      return fmt::format(
          "no material is left in segment ab: its reference length is {}, more has flowed out at b "
          "(CP2) than there was and came in at a (CP3)",
          format_number(length));
    }
    row.belt.reference_length = length;
    row.belt.strain = law::strain(distance, length);
    if (const auto& elasticity = problem.kinetic.elasticity[0]) {
      q[kFirstForce] = elasticity->value(row.belt.strain, ambient_of(q, problem.reference)).force;
    }
  }
  if (belt.both_tensions && q[kTensionBehind] < 0.0) {
    return fmt::format("the tension f_bc is {}: a belt pulls, it does not push",
                       format_number(q[kTensionBehind]));
  }
  return std::nullopt;
}

void prepare_belt(const Case& problem, const Row& row, law::ConnectorIncrement& increment,
                  std::span<law::FrictionDefinition> definitions) {
  increment.end.motion[0] = row.belt.strain;
  if (!problem.belt->nodes) return;
  for (law::FrictionDefinition& definition : definitions) {
    if (auto* capstan = std::get_if<law::Capstan>(&definition.criterion)) {
      capstan->wrap_angle = row.belt.wrap_angle;
    }
  }
}

}  // namespace slipbench::driver
