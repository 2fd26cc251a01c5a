// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// SLIDE-PLANE: node b slides on a plane normal to the local 1-axis of a.
/// Predefined (docs/theory, section 4): g = abs(f1); P = sqrt(f2^2 + f3^2).
struct SlidePlane {
  static constexpr ConnectionInfo kInfo{"SLIDE-PLANE",
                                        "Node b stays on a plane fixed to a, normal to its 1-axis.",
                                        "basic", ComponentSet::of(1), ComponentSet::of(2, 3)};

  InternalContactForce internal_contact_force = 0.0;

  static constexpr auto fields() {
    return std::tuple{Field{"internal_contact_force", &SlidePlane::internal_contact_force,
                            dimension::kForce, kNotNegative, false,
                            "Self-equilibrated contact force F_int, a number or a table."}};
  }

  std::vector<PredefinedFriction> predefined() const {
    return {
        {"", slip_space({2, 3}), DerivedComponent{norm_term({1}, 1.0)}, internal_contact_force}};
  }
};

}  // namespace slipbench::law
