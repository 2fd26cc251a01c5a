// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// TRANSLATOR: a slot that also holds all rotations.
/// Predefined (docs/theory, section 4): g = abs(m1)/R_r + sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 +
/// m3^2); P = abs(f1).
struct Translator {
  static constexpr ConnectionInfo kInfo{
      "TRANSLATOR", "Node b slides along the 1-axis of a without turning.", "SLOT + ALIGN",
      ComponentSet::of(2, 3, 4, 5, 6), ComponentSet::of(1)};

  double R_r = 0.0;
  double L = 0.0;
  InternalContactForce internal_contact_force = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        Field{"R_r", &Translator::R_r, dimension::kLength, kNotNegative, false,
              "Effective radius of the section against twist; 0 drops the twist term."},
        Field{"L", &Translator::L, dimension::kLength, kNotNegative, false,
              "Overlap of the sliding parts; 0 drops the bending term."},
        Field{"internal_contact_force", &Translator::internal_contact_force, dimension::kForce,
              kNotNegative, false, "Self-equilibrated contact force F_int, a number or a table."}};
  }

  std::vector<PredefinedFriction> predefined() const {
    DerivedComponent g = {norm_term({2, 3}, 1.0)};
    if (R_r > 0.0) g.push_back(norm_term({4}, 1.0 / R_r));
    if (L > 0.0) g.push_back(norm_term({5, 6}, 2.0 / L));
    return {{"", slip_space({1}), g, internal_contact_force}};
  }
};

}  // namespace slipbench::law
