// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace slipbench::law {

/// Rigid stops of one component: lower <= CP <= upper [L], [1]. A side without a number has no
/// stop.
struct Stop {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  /// The flag CSLST: 1 at (or beyond) the upper stop, -1 at the lower one, 0 between them.
  int flag(double position) const noexcept {
    if (position >= upper) return 1;
    return position <= lower ? -1 : 0;
  }
};

}  // namespace slipbench::law
