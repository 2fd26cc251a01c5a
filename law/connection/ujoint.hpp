// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// UJOINT: a universal joint, two stick-slip checks about e1a and e3b. The contact moments are
/// those of UniversalJointContact (docs/theory, section 5); beta is the held angle CPR2.
struct UJoint {
  static constexpr ConnectionInfo kInfo{
      "UJOINT", "Node b sits on a; it turns about the 1-axis of a and its own 3-axis.",
      "JOIN + UNIVERSAL", ComponentSet::of(1, 2, 3, 5), ComponentSet::of(4, 6)};

  double R_p = 0.0;
  double R_a = 0.0;
  double L_s = 0.0;
  double L_a = 0.0;
  InternalContactForce internal_contact_moment_1 = 0.0;
  InternalContactForce internal_contact_moment_3 = 0.0;
  /// k_ax, t_ax, k_tw, t_tw over the slenderness L_a / R_p, in place of the built-in fit.
  std::optional<Table> hinge_factors;

  static constexpr auto fields() {
    return std::tuple{
        Field{"R_p", &UJoint::R_p, dimension::kLength, kPositive, true, "Radius of the pins."},
        Field{"R_a", &UJoint::R_a, dimension::kLength, kNotNegative, false,
              "Effective friction radius of the axial faces; 0 drops the axial term."},
        Field{"L_s", &UJoint::L_s, dimension::kLength, kNotNegative, false,
              "Overlap of pin and hinge; 0 drops the bending term."},
        Field{"L_a", &UJoint::L_a, dimension::kLength, kPositive, true,
              "Length of an arm of the cross."},
        Field{"internal_contact_moment_1", &UJoint::internal_contact_moment_1, dimension::kMoment,
              kNotNegative, false, "M_int of the axis e1a, a number or a table."},
        Field{"internal_contact_moment_3", &UJoint::internal_contact_moment_3, dimension::kMoment,
              kNotNegative, false, "M_int of the axis e3b, a number or a table."},
        Field{"hinge_factors", &UJoint::hinge_factors, dimension::kNone, kNotNegative, false,
              "Table [k_ax, t_ax, k_tw, t_tw, slenderness] in place of the built-in fit."}};
  }

  HingeShares shares() const {
    const double slenderness = L_a / R_p;
    if (!hinge_factors) return hinge_shares(slenderness);
    const auto factor = [&](int column) {
      return hinge_factors->value(std::span(&slenderness, 1), column);
    };
    return {factor(0), factor(1), factor(2), factor(3)};
  }

  std::vector<PredefinedFriction> predefined() const {
    const HingeShares share = shares();
    return {{"axis1", slip_space({4}), UniversalJointContact{1, R_p, R_a, L_s, L_a, share},
             internal_contact_moment_1},
            {"axis3", slip_space({6}), UniversalJointContact{3, R_p, R_a, L_s, L_a, share},
             internal_contact_moment_3}};
  }
};

}  // namespace slipbench::law
