// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// PLANAR: a puck that slides on a plane and spins about its normal, two stick-slip checks.
/// Predefined (docs/theory, section 4):
///   sliding   g = abs(f1) + (1/R) sqrt(m2^2 + m3^2),     P = sqrt(f2^2 + f3^2);
///   spinning  g = a abs(f1) + sqrt(m2^2 + m3^2),         P = abs(m1).
/// A puck of radius R carries a tilting moment M as M/(2R) on either side of its rim, whatever is
/// cut out of its middle; a is the mean arm of friction under a uniformly pressed ring, 2R/3 of a
/// disc.
struct Planar {
  static constexpr ConnectionInfo kInfo{
      "PLANAR", "Node b slides on a plane normal to the 1-axis of a and spins about it.",
      "SLIDE-PLANE + REVOLUTE", ComponentSet::of(1, 5, 6), ComponentSet::of(2, 3, 4)};

  double R = 0.0;
  InternalContactForce internal_contact_force = 0.0;
  InternalContactForce internal_contact_moment = 0.0;
  double R_i = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        Field{"R", &Planar::R, dimension::kLength, kNotNegative, false,
              "Radius of the puck; 0 drops the terms it multiplies or divides."},
        Field{"internal_contact_force", &Planar::internal_contact_force, dimension::kForce,
              kNotNegative, false, "F_int of sliding, a number or a table."},
        Field{"internal_contact_moment", &Planar::internal_contact_moment, dimension::kMoment,
              kNotNegative, false, "M_int of spinning, a number or a table."},
        Field{"R_i", &Planar::R_i, dimension::kLength, kNotNegative, false,
              "Inner radius of a ring, less than R; 0 is a full disc."}};
  }

  /// (2/3)(R^3 - R_i^3)/(R^2 - R_i^2) without its differences: R of a thin ring. \pre R > 0
  double mean_arm() const { return 2.0 / 3.0 * (R + R_i * R_i / (R + R_i)); }

  std::vector<PredefinedFriction> predefined() const {
    DerivedComponent sliding = {norm_term({1}, 1.0)};
    DerivedComponent spinning = {norm_term({5, 6}, 1.0)};
    if (R > 0.0) {
      sliding.push_back(norm_term({5, 6}, 1.0 / R));
      spinning.push_back(norm_term({1}, mean_arm()));
    }
    return {{"sliding", slip_space({2, 3}), sliding, internal_contact_force},
            {"spinning", slip_space({4}), spinning, internal_contact_moment}};
  }
};

}  // namespace slipbench::law
