// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::law {

/// A coefficient of friction at one state, with the slopes the return mapping and its tangent use.
struct CoefficientPoint {
  double mu = 0.0;                ///< [1]
  double to_slip_rate = 0.0;      ///< dmu/d(slip rate) [T/L]; right-hand at a knot
  double to_contact_force = 0.0;  ///< dmu/dF_N [1/F]
};

}  // namespace slipbench::law
