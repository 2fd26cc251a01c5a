// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/slip_direction.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::driver::bench {

bool loads_backward(double elastic_slip, double left, double motion) noexcept {
  const double trial = elastic_slip + left;
  return trial < 0.0 || (trial == 0.0 && motion < 0.0);
}

void split_at_zero_force(const law::FrictionDefinition& definition, const law::FrictionState& old,
                         double left, law::FrictionUpdate& update) noexcept {
  const double given_back = 0.5 * old.force[0] * old.elastic_slip[0];
  if (update.state.regime == law::Regime::kOpen) {
    // A limit that the slip wore away, or that went with the normal force, is the law's own matter.
    const bool turned = old.force[0] * (old.elastic_slip[0] + left) < 0.0;
    if (turned && update.slip_increment == 0.0 && update.normal_force > 0.0) {
      update.work = -given_back;
    }
    return;
  }
  if (definition.stick.mode != law::StickStiffness::Mode::kElasticSlip) return;
  if (!(old.force[0] * update.state.force[0] < 0.0)) return;
  update.work = update.dissipation + update.stored_energy - given_back;
  if (update.state.regime == law::Regime::kSlip && left != 0.0) {
    const double before = std::abs(old.elastic_slip[0]) + definition.stick.value;
    update.onset = std::clamp(before / std::abs(left), 0.0, 1.0);
  }
}

}  // namespace slipbench::driver::bench
