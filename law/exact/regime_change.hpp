// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "law/definition/friction_state.hpp"

namespace slipbench::law {

/// A stick shorter than this part of an increment is the rounding of the limit, and no change.
inline constexpr double kLastingStick = 1e-9;

/// One change of regime within an increment, where the integration knows it.
struct RegimeChange {
  double fraction = 0.0;  ///< of the increment that is over, 0..1
  Regime to = Regime::kStick;
  double force = 0.0;             ///< P, in one dimension with the sign of the force [F]
  double limit = 0.0;             ///< F_lim [F]
  double accumulated_slip = 0.0;  ///< [L]
};

/// The first changes of an increment, in the order of their fractions.
struct RegimeChanges {
  std::array<RegimeChange, 8> at;
  int count = 0;
  bool overflow = false;  ///< there were more
};

}  // namespace slipbench::law
