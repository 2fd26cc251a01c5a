// SPDX-License-Identifier: Apache-2.0
#include "law/contact/universal_joint_contact.hpp"

#include <array>
#include <cmath>

namespace slipbench::law {
namespace {

double sign(double x) { return x > 0.0 ? 1.0 : (x < 0.0 ? -1.0 : 0.0); }

/// The joint's load split into the shares its hinges see, with the directions they come from.
struct Load {
  std::array<double, 3> e3b;      ///< third axis of b seen from a
  std::array<double, 3> e_cross;  ///< normal of the cross, e1a x e3b normalised
  double along_1;                 ///< F . e1a, signed
  double along_3;                 ///< F . e3b, signed
  double across;                  ///< F . e_cross, signed
  double twist;                   ///< abs(m2)
};

double dot(const std::array<double, 3>& e, const ConnectorForce& f) {
  return e[0] * f[0] + e[1] * f[1] + e[2] * f[2];
}

Load split(const ConnectorForce& force, const RelativePosition& position) {
  const double sa = std::sin(position[3]), ca = std::cos(position[3]);
  const double sb = std::sin(position[4]), cb = std::cos(position[4]);
  Load load;
  load.e3b = {sb, -sa * cb, ca * cb};
  load.e_cross = {0.0, -ca, -sa};  // the factor cos(beta) > 0 cancels in the normalisation
  load.along_1 = force[0];
  load.along_3 = dot(load.e3b, force);
  load.across = dot(load.e_cross, force);
  load.twist = std::abs(force[4]);
  return load;
}

}  // namespace

HingeShares hinge_shares(double slenderness) {
  constexpr double kC = 24.0 / 0.9;
  const auto axial = [](double a) { return 0.5 / (1.0 + 12.0 / (a * a + kC)); };
  const auto twist = [](double a) {
    const double q = kC / (a * a);
    return 0.25 * (2.0 - q) / (4.0 + q);
  };
  // Below these slendernesses the fits give way to straight lines through known end values.
  constexpr double kAxialLinearBelow = 2.0;
  constexpr double kTwistLinearBelow = 6.0;
  HingeShares shares;
  const double a = slenderness;
  shares.k_ax = a < kAxialLinearBelow
                    ? 0.25 + (axial(kAxialLinearBelow) - 0.25) * a / kAxialLinearBelow
                    : axial(a);
  shares.t_ax = 0.5 - shares.k_ax;
  shares.k_tw = a < kTwistLinearBelow ? twist(kTwistLinearBelow) * a / kTwistLinearBelow : twist(a);
  shares.t_tw = shares.k_tw + 0.25;
  return shares;
}

UniversalJointTerms terms(const UniversalJointContact& contact, const ConnectorForce& force,
                          const RelativePosition& position) noexcept {
  const Load load = split(force, position);
  const HingeShares& share = contact.shares;
  const double own = std::abs(contact.axis == 1 ? load.along_1 : load.along_3);
  const double other = std::abs(contact.axis == 1 ? load.along_3 : load.along_1);
  const double moment = share.k_tw * load.twist;
  const double shear = share.t_tw * load.twist / contact.L_a;
  const double quarter = 0.25 * load.across;
  const double radial =
      std::sqrt(quarter * quarter + shear * shear + share.t_ax * other * share.t_ax * other);
  double bending = 0.0;
  if (contact.L_s > 0.0) {
    const double arm = load.across * contact.L_a / 8.0;
    bending = 2.0 / contact.L_s * std::sqrt(arm * arm + moment * moment);
  }
  return {share.k_ax * own * contact.R_a, radial, bending};
}

double evaluate(const UniversalJointContact& contact, const ConnectorForce& force,
                const RelativePosition& position) noexcept {
  const UniversalJointTerms t = terms(contact, force, position);
  return 2.0 * (t.face + contact.R_p * (t.radial + t.bending));
}

double pin_force(const UniversalJointContact& contact, const ConnectorForce& force,
                 const RelativePosition& position) noexcept {
  const Load load = split(force, position);
  return contact.axis == 1 ? load.along_1 : load.along_3;
}

void add_gradient(const UniversalJointContact& contact, const ConnectorForce& force,
                  const RelativePosition& position, ConnectorForce* to_force,
                  RelativePosition* to_position) noexcept {
  const Load load = split(force, position);
  const HingeShares& share = contact.shares;
  const double other = contact.axis == 1 ? load.along_3 : load.along_1;
  const double own = contact.axis == 1 ? load.along_1 : load.along_3;
  const double moment = share.k_tw * load.twist;
  const double shear = share.t_tw * load.twist / contact.L_a;
  const double quarter = 0.25 * load.across;
  const double radial =
      std::sqrt(quarter * quarter + shear * shear + share.t_ax * other * share.t_ax * other);

  // Slopes to the four scalars own, other, across, twist.
  const double to_own = 2.0 * share.k_ax * contact.R_a * sign(own);
  double to_other = 0.0, to_across = 0.0, to_twist = 0.0;
  if (radial > 0.0) {
    to_other = 2.0 * contact.R_p * share.t_ax * share.t_ax * other / radial;
    to_across = 2.0 * contact.R_p * quarter * 0.25 / radial;
    to_twist = 2.0 * contact.R_p * shear * (share.t_tw / contact.L_a) / radial;
  }
  if (contact.L_s > 0.0) {
    const double lever = contact.L_a / 8.0;
    const double arm = load.across * lever;
    const double bending = std::sqrt(arm * arm + moment * moment);
    if (bending > 0.0) {
      const double factor = 2.0 * contact.R_p * 2.0 / contact.L_s / bending;
      to_across += factor * arm * lever;
      to_twist += factor * moment * share.k_tw;
    }
  }
  const double to_1 = contact.axis == 1 ? to_own : to_other;
  const double to_3 = contact.axis == 1 ? to_other : to_own;

  (*to_force)[0] += to_1;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    (*to_force)[i] += to_3 * load.e3b[k] + to_across * load.e_cross[k];
  }
  (*to_force)[4] += to_twist * sign(force[4]);

  const double sa = std::sin(position[3]), ca = std::cos(position[3]);
  const double sb = std::sin(position[4]), cb = std::cos(position[4]);
  const std::array<double, 3> e3b_alpha = {0.0, -ca * cb, -sa * cb};
  const std::array<double, 3> e3b_beta = {cb, sa * sb, -ca * sb};
  const std::array<double, 3> cross_alpha = {0.0, sa, -ca};
  (*to_position)[3] += to_3 * dot(e3b_alpha, force) + to_across * dot(cross_alpha, force);
  (*to_position)[4] += to_3 * dot(e3b_beta, force);
}

}  // namespace slipbench::law
