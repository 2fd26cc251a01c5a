// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/friction/coefficient_point.hpp"

namespace slipbench::law {

/// A change of friction in progress (docs/theory, section 9.2):
///   mu = start + weight (law - start),
/// with `start` [1] the coefficient in force when the change began and `weight` in [0, 1]. The
/// default is the law alone.
struct CoefficientBlend {
  double start = 0.0;
  double weight = 1.0;
};

/// The blended coefficient and its slopes.
inline CoefficientPoint blended(const CoefficientBlend& blend, const CoefficientPoint& law) {
  if (blend.weight == 1.0) return law;
  return {blend.start + blend.weight * (law.mu - blend.start), blend.weight * law.to_slip_rate,
          blend.weight * law.to_contact_force};
}

}  // namespace slipbench::law
