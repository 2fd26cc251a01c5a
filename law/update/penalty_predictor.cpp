// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_predictor.hpp"

#include <cmath>

namespace slipbench::law {

ViscousCoefficient viscous_coefficient(const ViscousPenalty& penalty, Convention convention,
                                       const Ambient& end, double normal_force) noexcept {
  ViscousCoefficient c;
  if (penalty.coefficient) {
    c.value = *penalty.coefficient;
    return c;
  }
  const double factor =
      convention == Convention::kDocumented ? penalty.visf : std::sqrt(penalty.visf);
  const auto* table = std::get_if<TableFunction>(&penalty.stiffness);
  if (table == nullptr) {
    const double stiffness = *std::get_if<double>(&penalty.stiffness);
    c.value = factor * std::sqrt(2.0 * stiffness * penalty.mass);
    return c;
  }
  SlipArguments slopes;
  const double stiffness = table->value_and_slopes(end, {.contact_force = normal_force}, &slopes);
  // Linear extrapolation may leave the physical range: K is never negative.
  if (!(stiffness > 0.0)) return c;
  c.value = factor * std::sqrt(2.0 * stiffness * penalty.mass);
  c.to_stiffness = 0.5 * c.value / stiffness;
  c.to_normal_force = c.to_stiffness * slopes.contact_force;
  return c;
}

bool smooths(const Formulation& formulation) noexcept {
  return formulation.filter.kind != Filter::Kind::kNone &&
         (formulation.convention == Convention::kDocumented ||
          std::holds_alternative<ViscousPenalty>(formulation.penalty));
}

bool uses_ratio_return(const Formulation& formulation) noexcept {
  return formulation.convention == Convention::kAsCoded &&
         std::holds_alternative<StiffnessPenalty>(formulation.penalty);
}

double predictor_stiffness(const Formulation& formulation, double viscous, double duration,
                           double alpha, double motion, double widest) noexcept {
  if (const auto* penalty = std::get_if<StiffnessPenalty>(&formulation.penalty)) {
    return formulation.convention == Convention::kAsCoded ? alpha * penalty->stiffness
                                                          : penalty->stiffness;
  }
  if (duration > 0.0 || !(viscous > 0.0)) return viscous * inverse_duration(duration);
  // Motion in no time is so fast that the limit alone decides.
  constexpr double kFarOutside = 1e16;
  return motion > 0.0 ? kFarOutside * widest / motion : 0.0;
}

}  // namespace slipbench::law
