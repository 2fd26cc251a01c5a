// SPDX-License-Identifier: Apache-2.0
#include "law/update/connector_tangent.hpp"

#include <variant>

#include "law/update/penalty_tangent.hpp"
#include "law/update/potential_return.hpp"

namespace slipbench::law {

Eigen::Matrix<double, kComponents, kComponents> kinetic_slopes(
    const KineticBehavior& behavior, const ConnectorIncrement& increment) noexcept {
  Eigen::Matrix<double, kComponents, kComponents> slopes =
      Eigen::Matrix<double, kComponents, kComponents>::Zero();
  for (int c = 0; c < kComponents; ++c) {
    if (!behavior.pressing.contains(c)) continue;
    const ElasticForce elastic = elastic_force(behavior, c, increment.end);
    for (int j = 0; j < kComponents; ++j) slopes(c, j) = elastic.slope[static_cast<std::size_t>(j)];
    if (!(increment.duration > 0.0)) continue;
    slopes(c, c) += viscous_force(behavior, c, mean_velocity(increment, c), increment.end).slope /
                    increment.duration;
  }
  return slopes;
}

ConnectorTangent connector_tangent(const FrictionDefinition& definition,
                                   const ConnectorIncrement& increment,
                                   const FrictionUpdate& update) {
  ConnectorTangent tangent;
  tangent.to_motion.setZero();
  tangent.to_force.setZero();
  if (update.state.regime == Regime::kOpen) return tangent;

  ConnectorForce contact_to_force;
  RelativePosition contact_to_position;
  add_gradient(definition.contact_force, increment.force, increment.end, &contact_to_force,
               &contact_to_position);
  if (const auto* f = std::get_if<TableFunction>(&definition.internal_contact_force)) {
    // At the accumulated slip that the increment's internal contact force was taken at, but for the
    // rounding that the sum has made up for since.
    const bool at_end =
        !definition.formulation && definition.accumulated_slip == AccumulatedSlipTiming::kEnd;
    const double slip = update.state.accumulated_slip - (at_end ? 0.0 : update.slip_increment);
    if (f->value(increment.end, {.accumulated_slip = slip}) >= 0.0) {
      f->add_motion_slopes(increment.end, {.accumulated_slip = slip}, 1.0, &contact_to_position);
    }
  }

  const SlipSpace& space = definition.slip;
  const auto add = [&](const auto& slip_tangent) {
    for (int i = 0; i < space.dimension; ++i) {
      const auto a = static_cast<std::size_t>(i);
      const int ci = space.component[a];
      for (int j = 0; j < space.dimension; ++j) {
        const auto b = static_cast<std::size_t>(j);
        tangent.to_motion(ci, space.component[b]) +=
            space.scale[a] * slip_tangent.to_slip(i, j) * space.scale[b];
      }
      for (int c = 0; c < kComponents; ++c) {
        const double to_contact = space.scale[a] * slip_tangent.to_contact[i];
        tangent.to_motion(ci, c) += to_contact * contact_to_position[c];
        tangent.to_force(ci, c) += to_contact * contact_to_force[c];
      }
    }
  };
  if (definition.formulation) {
    const PenaltyTangent penalty = penalty_tangent(definition, increment, update);
    add(penalty);
    for (int i = 0; i < space.dimension; ++i) {
      const auto a = static_cast<std::size_t>(i);
      tangent.to_motion.row(space.component[a]) += space.scale[a] * penalty.to_position.row(i);
    }
    return tangent;
  }
  if (std::holds_alternative<Potential>(definition.criterion)) {
    add(potential_tangent(definition, update));
    return tangent;
  }
  const SlipTangent& t = update.tangent;
  for (int i = 0; i < space.dimension; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const int ci = space.component[a];
    const double n = update.direction[a];
    for (int j = 0; j < space.dimension; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const double slip_tangent = (i == j ? t.transverse : 0.0) +
                                  (t.radial - t.transverse) * n * update.direction[b] +
                                  t.rate * n * update.motion_direction[b];
      tangent.to_motion(ci, space.component[b]) += space.scale[a] * slip_tangent * space.scale[b];
    }
    for (int c = 0; c < kComponents; ++c) {
      const double to_contact = space.scale[a] * n * t.contact;
      tangent.to_motion(ci, c) += to_contact * contact_to_position[c];
      tangent.to_force(ci, c) += to_contact * contact_to_force[c];
    }
  }
  return tangent;
}

}  // namespace slipbench::law
