// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace slipbench::law {

/// A belt over a ring (docs/theory, section 4.1): the criterion of SLIPRING. The slip is the flow
/// Psi_b of material over the ring, the force y = CSF2 = f_bc - f_ab the change of tension there.
struct Capstan {
  double wrap_angle = 0.0;  ///< alpha [1], radians, >= 0; may exceed a full turn
};

/// Sense of the flow over the ring, or of the force that resists it.
enum class FlowSense { kForward, kBackward };

/// Half-width of the stick band on one side, as a part of the tension T of segment ab [1]:
/// exp(A) - 1 where material flows from a over the ring to c, 1 - exp(-A) in the other sense, with
/// A = mu alpha >= 0. Accurate for any A, however small. Source: Euler 1769, Eytelwein 1808
/// (docs/theory, section 4.1).
inline double capstan_limit(double mu_alpha, FlowSense sense) {
  return sense == FlowSense::kForward ? std::expm1(mu_alpha) : -std::expm1(-mu_alpha);
}

/// Its slope to A: exp(A) or exp(-A), which is also the ratio f_bc / f_ab in slip.
inline double capstan_ratio(double mu_alpha, FlowSense sense) {
  return std::exp(sense == FlowSense::kForward ? mu_alpha : -mu_alpha);
}

}  // namespace slipbench::law
