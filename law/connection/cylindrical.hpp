// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// CYLINDRICAL: a shaft in a sleeve, sliding along and turning about the local 1-axis of a.
/// Predefined (docs/theory, section 4): g = sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2), the end
/// reactions of a shaft of overlap L under bending being M/L each; P = sqrt(f1^2 + (m1/R)^2).
struct Cylindrical {
  static constexpr ConnectionInfo kInfo{
      "CYLINDRICAL", "Node b slides along the 1-axis of a and turns about it.", "SLOT + REVOLUTE",
      ComponentSet::of(2, 3, 5, 6), ComponentSet::of(1, 4)};

  double R = 0.0;
  double L = 0.0;
  InternalContactForce internal_contact_force = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        Field{"R", &Cylindrical::R, dimension::kLength, kPositive, true, "Radius of the shaft."},
        Field{"L", &Cylindrical::L, dimension::kLength, kNotNegative, false,
              "Overlap of shaft and sleeve; 0 drops the bending term."},
        Field{"internal_contact_force", &Cylindrical::internal_contact_force, dimension::kForce,
              kNotNegative, false, "Self-equilibrated contact force F_int, a number or a table."}};
  }

  std::vector<PredefinedFriction> predefined() const {
    DerivedComponent g = {norm_term({2, 3}, 1.0)};
    if (L > 0.0) g.push_back(norm_term({5, 6}, 2.0 / L));
    SlipSpace space = slip_space({1, 4});
    space.scale[1] = R;
    return {{"", space, g, internal_contact_force}};
  }
};

}  // namespace slipbench::law
