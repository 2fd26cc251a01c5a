// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// SLOT: node b slides along the local 1-axis of a.
/// Predefined (docs/theory, section 4): g = sqrt(f2^2 + f3^2), in two dimensions abs(f2); P =
/// abs(f1).
struct Slot {
  static constexpr ConnectionInfo kInfo{"SLOT",
                                        "Node b stays on a line through a along its 1-axis.",
                                        "basic", ComponentSet::of(2, 3), ComponentSet::of(1)};
  /// The plane slot of CONN2D2: component 3 does not exist.
  static constexpr ConnectionInfo kPlaneInfo{
      "SLOT", "Node b stays on a line through a along its 1-axis, in the plane.", "basic",
      ComponentSet::of(2), ComponentSet::of(1)};

  InternalContactForce internal_contact_force = 0.0;
  int dimension = 3;  ///< of space, 2 or 3; a property of the connection, not of its friction

  static constexpr auto fields() {
    return std::tuple{Field{"internal_contact_force", &Slot::internal_contact_force,
                            law::dimension::kForce, kNotNegative, false,
                            "Self-equilibrated contact force F_int, a number or a table."}};
  }

  std::vector<PredefinedFriction> predefined() const {
    const DerivedComponent g = {dimension == 2 ? norm_term({2}, 1.0) : norm_term({2, 3}, 1.0)};
    return {{"", slip_space({1}), g, internal_contact_force}};
  }
};

}  // namespace slipbench::law
