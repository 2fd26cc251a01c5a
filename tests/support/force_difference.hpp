// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/definition/increment.hpp"
#include "tests/support/finite_difference.hpp"

namespace slipbench::test {

/// One-sided derivatives of a force of component `i`, as `force_at(increment, i)` gives it (nothing
/// outside of its regime), to the motion of component `j` at the end of an increment...
template <class ForceAt>
auto force_by_motion(const ForceAt& force_at, const law::ConnectorIncrement& increment, int i,
                     int j, double step) {
  return one_sided_derivative(
      [&](double h) {
        law::ConnectorIncrement moved = increment;
        moved.end.position[j] += h;
        moved.end.motion[j] += h;
        return force_at(moved, i);
      },
      step);
}

/// ... and to the constraint force of component `j`.
template <class ForceAt>
auto force_by_force(const ForceAt& force_at, const law::ConnectorIncrement& increment, int i, int j,
                    double step) {
  return one_sided_derivative(
      [&](double h) {
        law::ConnectorIncrement moved = increment;
        moved.force[j] += h;
        return force_at(moved, i);
      },
      step);
}

}  // namespace slipbench::test
