// SPDX-License-Identifier: Apache-2.0
#include "driver/case/quantity_dimension.hpp"

#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "law/base/component.hpp"

namespace slipbench::driver::cases {

base::Dimension dimension_of(const Case& problem, int quantity) {
  if (quantity != kDriverLoad) return dimension_of(quantity);
  return dimension_of(kFirstForce + (problem.dynamics ? problem.dynamics->component : 0));
}

base::Dimension dimension_of(int quantity) {
  if (quantity < kFirstForce) return law::is_rotation(quantity) ? base::kAngle : base::kLength;
  if (quantity < kTemperatureQuantity) {
    return law::is_rotation(quantity - kFirstForce) ? base::kMoment : base::kForce;
  }
  if (quantity == kTemperatureQuantity) return base::kTemperature;
  if (quantity == kTensionBehind) return base::kForce;
  if (quantity >= kFirstNode) return base::kLength;
  return {};
}

}  // namespace slipbench::driver::cases
