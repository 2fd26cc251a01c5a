// SPDX-License-Identifier: Apache-2.0
// The motion of an increment in the slip space, and sums of vectors there.
#pragma once

#include "law/definition/friction_definition.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::law {

/// Entry k of ds, the motion of an increment in the scaled slip space [L].
inline double motion_along(const SlipSpace& space, const ConnectorIncrement& increment,
                           std::size_t k) noexcept {
  const int c = space.component[k];
  return space.scale[k] * (increment.end.position[c] - increment.begin_position[c]);
}

/// ds [L]; entries beyond the dimension of the space are 0.
inline SlipVector motion_in(const SlipSpace& space, const ConnectorIncrement& increment) noexcept {
  SlipVector ds{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(space.dimension); ++k) {
    ds[k] = motion_along(space, increment, k);
  }
  return ds;
}

inline SlipVector scaled(const SlipVector& a, double factor) noexcept {
  SlipVector result;
  for (std::size_t k = 0; k < a.size(); ++k) result[k] = factor * a[k];
  return result;
}
inline SlipVector sum_of(const SlipVector& a, double factor, const SlipVector& b) noexcept {
  SlipVector result;
  for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] + factor * b[k];
  return result;
}

}  // namespace slipbench::law
