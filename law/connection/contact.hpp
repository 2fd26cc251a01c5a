// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// CONTACT: node b touches a plane fixed to a, normal to its local 1-axis, on one side: the point
/// of a penalty contact. f1 > 0 presses; where f1 <= 0 the contact is open. Predefined: g = max(f1,
/// 0); P = sqrt(f2^2 + f3^2), in two dimensions abs(f2). Source: Altair Radioss reference,
/// /FRICTION (key RADIOSS), for N >= 0.
struct Contact {
  static constexpr ConnectionInfo kInfo{
      "CONTACT", "Node b touches a plane fixed to a, normal to its 1-axis; f1 > 0 presses.",
      "complex", ComponentSet::of(1), ComponentSet::of(2, 3)};
  /// One tangential direction: component 3 does not exist.
  static constexpr ConnectionInfo kPlaneInfo{
      "CONTACT", "Node b touches a line fixed to a, normal to its 1-axis; f1 > 0 presses.",
      "complex", ComponentSet::of(1), ComponentSet::of(2)};

  int dimension = 3;  ///< of space, 2 or 3; a property of the connection, not of its friction

  static constexpr auto fields() { return std::tuple{}; }

  /// g = max(f1, 0): what presses.
  static DerivedComponent pressing() {
    DerivedTerm term;
    term.combine = TermOperator::kMacauleySum;
    term.count = 1;
    term.component[0] = 0;
    term.weight[0] = 1.0;
    return {term};
  }

  std::vector<PredefinedFriction> predefined() const {
    return {{"", dimension == 2 ? slip_space({2}) : slip_space({2, 3}), pressing(), 0.0}};
  }
};

}  // namespace slipbench::law
