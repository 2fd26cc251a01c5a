// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// HINGE: a pin turning about the local 1-axis of a.
/// Predefined (docs/theory, section 4), all moments: g = R_a abs(f1) + R_p sqrt(f2^2 + f3^2)
/// + (2 R_p / L_s) sqrt(m2^2 + m3^2); P = abs(m1).
struct Hinge {
  static constexpr ConnectionInfo kInfo{"HINGE", "Node b sits on a and turns about its 1-axis.",
                                        "JOIN + REVOLUTE", ComponentSet::of(1, 2, 3, 5, 6),
                                        ComponentSet::of(4)};

  double R_p = 0.0;
  double R_a = 0.0;
  double L_s = 0.0;
  InternalContactForce internal_contact_moment = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        Field{"R_p", &Hinge::R_p, dimension::kLength, kPositive, true, "Radius of the pin."},
        Field{"R_a", &Hinge::R_a, dimension::kLength, kNotNegative, false,
              "Effective friction radius of the axial face; 0 drops the axial term."},
        Field{"L_s", &Hinge::L_s, dimension::kLength, kNotNegative, false,
              "Overlap of pin and sleeve; 0 drops the bending term."},
        Field{"internal_contact_moment", &Hinge::internal_contact_moment, dimension::kMoment,
              kNotNegative, false, "Self-equilibrated contact moment M_int, a number or a table."}};
  }

  std::vector<PredefinedFriction> predefined() const {
    DerivedComponent g = {norm_term({2, 3}, R_p)};
    if (R_a > 0.0) g.push_back(norm_term({1}, R_a));
    if (L_s > 0.0) g.push_back(norm_term({5, 6}, 2.0 * R_p / L_s));
    return {{"", slip_space({4}), g, internal_contact_moment}};
  }
};

}  // namespace slipbench::law
