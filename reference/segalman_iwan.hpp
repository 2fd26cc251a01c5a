// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// Segalman's four-parameter Iwan model of a joint.
///
/// Formula   Sliders of unit stiffness with the density rho(phi) = R phi^chi on [0, phi_max] and a
///           delta of strength S at phi_max:
///           F_b(u) = R u^(chi+2)/(chi+2) + u [R (phi_max^(chi+1) - u^(chi+1))/(chi+1) + S],
///           E(A) = 4 R A^(chi+3)/((chi+2)(chi+3)).
/// Symbols   u motion and phi yield motion [L], R [F/L^(2+chi)], S [F/L], chi exponent [1].
/// Sign      forces have the sign of the slip they resist.
/// Source    Segalman 2005; branches after a reversal: Masing 1926.
/// Range     -1 < chi, R >= 0, S >= 0, phi_max > 0; E for A <= phi_max only.
namespace slipbench::reference::segalman_iwan {

struct Joint {
  double density;         ///< R [F/L^(2+chi)]
  double exponent;        ///< chi [1], > -1
  double maximum_motion;  ///< phi_max [L], the motion at which everything slips
  double end_stiffness;   ///< S [F/L]
};

/// Stiffness while nothing slips, R phi_max^(chi+1)/(chi+1) + S [F/L].
inline double initial_stiffness(const Joint& joint) {
  const double order = joint.exponent + 1.0;
  return joint.density * std::pow(joint.maximum_motion, order) / order + joint.end_stiffness;
}

/// Force on first loading [F]; odd in the motion [L] and constant beyond phi_max.
inline double backbone(const Joint& joint, double motion) {
  const double u = std::min(std::abs(motion), joint.maximum_motion);
  const double order = joint.exponent + 1.0;
  const double slipping = joint.density * std::pow(u, order + 1.0) / (order + 1.0);
  const double sticking =
      joint.density * (std::pow(joint.maximum_motion, order) - std::pow(u, order)) / order;
  return std::copysign(slipping + u * (sticking + joint.end_stiffness), motion);
}

/// Force once everything slips [F].
inline double slip_force(const Joint& joint) { return backbone(joint, joint.maximum_motion); }

/// Energy of one closed loop of amplitude 0 <= A <= phi_max [F L].
inline double loop_energy(const Joint& joint, double amplitude) {
  const double chi = joint.exponent;
  return 4.0 * joint.density * std::pow(amplitude, chi + 3.0) / ((chi + 2.0) * (chi + 3.0));
}

}  // namespace slipbench::reference::segalman_iwan
