// SPDX-License-Identifier: Apache-2.0
#include "law/exact/continuous_update.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "law/exact/exact_walk.hpp"
#include "law/exact/extrapolated_update.hpp"
#include "law/update/six_steps.hpp"

namespace slipbench::law {

std::optional<NoContinuousSolution> no_continuous_solution(const FrictionDefinition& definition) {
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  if (fixed && definition.slip_rate == SlipRateMeasure::kSlip &&
      steepest_weakening(definition.law) > 0.0) {
    return NoContinuousSolution::kWeakening;
  }
  if (definition.accumulated_slip == AccumulatedSlipTiming::kStart &&
      depends_on_accumulated_slip(definition.internal_contact_force)) {
    return NoContinuousSolution::kWearAtStart;
  }
  const auto* potential = std::get_if<Potential>(&definition.criterion);
  const bool by_slip =
      depends_on_accumulated_slip(definition.internal_contact_force) ||
      (definition.slip_rate == SlipRateMeasure::kSlip && depends_on_slip_rate(definition.law));
  if (!fixed && by_slip && potential != nullptr && !potential->homogeneous) {
    return NoContinuousSolution::kShiftWithElasticSlip;
  }
  return std::nullopt;
}

ContinuousMethod continuous_method(const FrictionDefinition& definition) {
  const bool viscous = definition.stick.mode == StickStiffness::Mode::kStiffness &&
                       definition.slip_rate == SlipRateMeasure::kSlip &&
                       depends_on_slip_rate(definition.law);
  return viscous || std::holds_alternative<Potential>(definition.criterion)
             ? ContinuousMethod::kExtrapolation
             : ContinuousMethod::kEvents;
}

FrictionUpdate continuous_update(const FrictionDefinition& definition, const PathSegment& segment,
                                 const FrictionState& old, double tolerance,
                                 RegimeChanges* changes) noexcept {
  if (changes != nullptr) {
    changes->count = 0;
    changes->overflow = false;
  }
  if (continuous_method(definition) == ContinuousMethod::kExtrapolation) {
    return extrapolated_update(definition, segment, old, tolerance, changes);
  }
  const ConnectorIncrement& increment = segment.increment;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  const auto dimension = static_cast<std::size_t>(definition.slip.dimension);

  // The motion, and the plane it spans with the elastic slip.
  SlipVector direction = motion_in(definition.slip, increment);
  SlipVector begin{};
  double square = 0.0;
  double held = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) {
    begin[i] = fixed ? old.force[i] / definition.stick.value : old.elastic_slip[i];
    square += direction[i] * direction[i];
    held += begin[i] * begin[i];
  }
  const double length = dimension == 1 ? std::abs(direction[0]) : std::sqrt(square);
  // Without motion the elastic slip itself is the direction.
  const bool moves = length > 0.0;
  const double unit = moves ? length : std::sqrt(held);
  PlaneSlip slip;
  std::array<double, kComponents> across{};
  if (unit > 0.0) {
    for (std::size_t i = 0; i < dimension; ++i) {
      direction[i] = moves ? direction[i] / unit : begin[i] / unit;
      slip.along += begin[i] * direction[i];
    }
    if (dimension > 1 && moves) {
      double rest = 0.0;
      for (std::size_t i = 0; i < dimension; ++i) {
        across[i] = begin[i] - slip.along * direction[i];
        rest += across[i] * across[i];
      }
      slip.across = std::sqrt(rest);
      // What is left of a parallel one is the rounding of the projection.
      if (slip.across <= 4.0 * std::numeric_limits<double>::epsilon() * std::sqrt(held))
        slip.across = 0.0;
    }
  } else {
    direction[0] = 1.0;
  }

  ExactWalk walk(definition, segment, old, slip, length, direction[0] < 0.0 ? -1.0 : 1.0, tolerance,
                 changes);
  walk.run();

  FrictionUpdate result;
  const Limit l = walk.end_limit();
  report(l, &result);
  const PlaneSlip& end = walk.elastic_slip();
  const double stiffness = fixed ? definition.stick.value : l.force / definition.stick.value;
  const double share = slip.across > 0.0 ? end.across / slip.across : 0.0;
  double p = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) {
    const double s = end.along * direction[i] + share * across[i];
    result.state.elastic_slip[i] = s;
    result.state.force[i] = stiffness * s;
    p += result.state.force[i] * result.state.force[i];
    result.stored_energy += 0.5 * result.state.force[i] * s;
    if (moves) result.motion_direction[i] = direction[i];
  }
  p = std::sqrt(p);
  if (p > 0.0) {
    for (std::size_t i = 0; i < dimension; ++i) result.direction[i] = result.state.force[i] / p;
  }
  result.state.regime = walk.regime();
  result.state.accumulated_slip = old.accumulated_slip;
  result.state.accumulated_slip += walk.slip();
  result.slip_increment = walk.slip();
  result.dissipation = walk.dissipation();
  result.work = walk.work();
  result.phi = p - l.force;
  result.onset = walk.regime() == Regime::kSlip ? walk.onset() : 0.0;
  result.snap_back = walk.snap_back();
  result.lost = walk.lost();
  result.jump_onset = walk.jump_onset();
  result.jumps = walk.jumps();
  result.converged = walk.converged();
  result.tangent = update(definition, increment, old).tangent;
  return result;
}

}  // namespace slipbench::law
