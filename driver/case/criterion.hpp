// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace slipbench::driver::cases {

/// Way in which a check compares its quantity with a reference; all there is to say of each is in
/// driver/check/criteria/criteria.hpp.
enum class Criterion : std::uint8_t {
  kPointwise,
  kPeak,
  kArea,
  kLoopEnergy,
  kBreakaway,
  kPlateau,
  kReversals,
  kArcLength,
  kSpragueGeers,
  kIso18571
};

}  // namespace slipbench::driver::cases
