// SPDX-License-Identifier: Apache-2.0
#include "driver/case/quantity_dimension.hpp"

#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "law/base/component.hpp"

namespace slipbench::driver {

Dimension dimension_of(const Case& problem, int quantity) {
  if (quantity != kDriverLoad) return dimension_of(quantity);
  return dimension_of(kFirstForce + (problem.dynamics ? problem.dynamics->component : 0));
}

Dimension dimension_of(int quantity) {
  if (quantity < kFirstForce) return law::is_rotation(quantity) ? kAngle : kLength;
  if (quantity < kTemperatureQuantity) {
    return law::is_rotation(quantity - kFirstForce) ? kMoment : kForce;
  }
  if (quantity == kTemperatureQuantity) return kTemperature;
  if (quantity == kTensionBehind) return kForce;
  if (quantity >= kFirstNode) return kLength;
  return {};
}

}  // namespace slipbench::driver
