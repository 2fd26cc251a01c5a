// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Shares of the four hinges of a universal joint in its load, all dimensionless.
struct HingeShares {
  double k_ax = 0.0;  ///< axial force taken by a hinge along its pin
  double t_ax = 0.0;  ///< axial force of one pin taken across the other; k_ax + t_ax = 1/2
  double k_tw = 0.0;  ///< twist taken as a moment in a hinge
  double t_tw = 0.0;  ///< twist taken as a force pair over the arm; t_tw - k_tw = 1/4
};

/// Shares over the slenderness a = L_a / R_p > 0 of the cross's arms: docs/theory, section 5,
/// step 3. They are a fit to curves published only as a plot, within 0.0022 of it.
HingeShares hinge_shares(double slenderness);

/// Contact moment of one axis of a universal joint (docs/theory, section 5).
struct UniversalJointContact {
  int axis = 1;      ///< 1: about e1a, 3: about e3b
  double R_p = 0.0;  ///< pin radius [L]
  double R_a = 0.0;  ///< effective radius of the axial face [L], 0 drops the term
  double L_s = 0.0;  ///< overlap of pin and hinge [L], 0 drops the bending term
  double L_a = 0.0;  ///< length of an arm of the cross [L]
  HingeShares shares;
};

/// The contact moment of one axis taken apart: 2 (face + R_p (radial + bending)).
struct UniversalJointTerms {
  double face = 0.0;     ///< k_ax R_a times the axial force of the pin [F L]
  double radial = 0.0;   ///< radial force on a hinge [F]
  double bending = 0.0;  ///< the reaction to its bending moment [F]
};
UniversalJointTerms terms(const UniversalJointContact& contact, const ConnectorForce& force,
                          const RelativePosition& position) noexcept;

/// 2 M_C of the axis (two hinges sit on each) [F L], from f1..f3, m2 and the angles
/// alpha = CPR1, beta = CPR2 of `position`. Never negative.
double evaluate(const UniversalJointContact& contact, const ConnectorForce& force,
                const RelativePosition& position) noexcept;

/// The axial force of the pin [F], whose magnitude counts.
double pin_force(const UniversalJointContact& contact, const ConnectorForce& force,
                 const RelativePosition& position) noexcept;

/// Adds the slopes of evaluate() to forces and angles; at corners the slope taken is 0.
void add_gradient(const UniversalJointContact& contact, const ConnectorForce& force,
                  const RelativePosition& position, ConnectorForce* to_force,
                  RelativePosition* to_position) noexcept;

}  // namespace slipbench::law
