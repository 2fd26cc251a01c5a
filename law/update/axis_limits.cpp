// SPDX-License-Identifier: Apache-2.0
#include "law/update/axis_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/update/penalty_predictor.hpp"

namespace slipbench::law {

PlaneVector along_axes(const PlaneVector& d, double x, double y) noexcept {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double rounding = kRounding * std::max(std::abs(x), std::abs(y));
  PlaneVector v{d[0] * x + d[1] * y, -d[1] * x + d[0] * y};
  for (double& entry : v) {
    if (std::abs(entry) <= rounding) entry = 0.0;
  }
  return v;
}
PlaneVector from_axes(const PlaneVector& d, const PlaneVector& v) noexcept {
  return {d[0] * v[0] - d[1] * v[1], d[1] * v[0] + d[0] * v[1]};
}

AxisLimits axis_limits(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                       double ds0, double ds1, double contact_force) noexcept {
  const Formulation& formulation = *definition.formulation;
  const Orthotropy& orthotropy = *formulation.orthotropy;
  const double per_time = inverse_duration(increment.duration);
  const double normal_force = std::abs(contact_force);
  const double sign = contact_force < 0.0 ? -1.0 : 1.0;

  AxisLimits axes;
  axes.motion = along_axes(orthotropy.first, ds0, ds1);
  const double motion = std::sqrt(ds0 * ds0 + ds1 * ds1);
  for (std::size_t i = 0; i < 2; ++i) {
    const double velocity = axes.motion[i] * per_time;
    if (orthotropy.speed == Orthotropy::Speed::kTotal) {
      axes.speed[i] = motion * per_time;
      for (std::size_t j = 0; j < 2; ++j) {
        if (motion > 0.0) axes.speed_to_motion[i][j] = axes.motion[j] / motion * per_time;
      }
    } else if (formulation.convention == Convention::kDocumented) {
      axes.speed[i] = std::abs(velocity);
      axes.speed_to_motion[i][i] = velocity < 0.0 ? -per_time : per_time;
    } else {
      constexpr double kLeastSpeed = 1e-30;  // in whatever unit the case has
      axes.speed[i] = std::max(kLeastSpeed, velocity);
      axes.speed_to_motion[i][i] = velocity > kLeastSpeed ? per_time : 0.0;
    }
    const CoefficientPoint c = blended(
        definition.blend, evaluate(i == 0 ? definition.law : orthotropy.second, increment.end,
                                   {.slip_rate = axes.speed[i], .contact_force = normal_force}));
    axes.mu[i] = c.mu;
    axes.bound[i] = c.mu * normal_force;
    if (axes.bound[i] >= definition.force_limit) {
      axes.bound[i] = definition.force_limit;
      continue;
    }
    axes.to_contact[i] = sign * (c.mu + normal_force * c.to_contact_force);
    axes.to_speed[i] = normal_force * c.to_slip_rate;
  }
  return axes;
}

}  // namespace slipbench::law
