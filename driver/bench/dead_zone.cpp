// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/dead_zone.hpp"

#include <algorithm>

namespace slipbench::driver::bench {

PlayStep move_play(const cases::DeadZone& zone, double play, double elastic_slip,
                   double motion) noexcept {
  const double half = 0.5 * zone.width;
  const double extension = elastic_slip + play + motion;
  PlayStep step;
  step.play = std::clamp(extension, -half, half);
  // A play that stays at its end leaves the motion as it is, to the last bit.
  step.travel = step.play - play;
  step.motion = step.travel == 0.0 ? motion : (extension - step.play) - elastic_slip;
  return step;
}

double elastic_extension(const law::FrictionDefinition& definition,
                         const law::FrictionState& state) noexcept {
  const bool fixed = definition.stick.mode == law::StickStiffness::Mode::kStiffness;
  const double slip = fixed ? state.force[0] / definition.stick.value : state.elastic_slip[0];
  return slip / definition.slip.scale[0];
}

void relax(law::FrictionUpdate& update) noexcept {
  update.state.force[0] = update.state.elastic_slip[0] = 0.0;
  update.direction[0] = 0.0;
  update.stored_energy = 0.0;
  update.phi = -update.limit;
}

void place_onset(const PlayStep& step, law::FrictionUpdate& update) noexcept {
  const double whole = step.motion + step.travel;
  if (step.travel == 0.0 || whole == 0.0 || update.state.regime != law::Regime::kSlip) return;
  update.onset = std::clamp((update.onset * step.motion + step.travel) / whole, 0.0, 1.0);
}

}  // namespace slipbench::driver::bench
