// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace slipbench::driver::cases {

/// Step of a definition from one row to the next.
enum class IntegrationMethod : std::uint8_t {
  kBackwardEuler,  ///< one implicit increment, as finite element solvers do
  kExact           ///< the continuous solution between rows that are joined by straight lines
};

/// The fate of a force that wear takes away faster than the stick spring follows.
enum class SnapBackAction : std::uint8_t {
  kStop,  ///< the run ends
  kJump   ///< it goes on from the next equilibrium, and the energy lost is booked
};

struct Integration {
  IntegrationMethod method = IntegrationMethod::kBackwardEuler;
  double tolerance = 1e-10;  ///< of the exact method, as a part of the limit
  SnapBackAction snap_back = SnapBackAction::kStop;
};

}  // namespace slipbench::driver::cases
