// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace slipbench::law {

/// Two entries along the axes of an ellipse.
using PlaneVector = std::array<double, 2>;

/// Tells whether (F1/a1)^2 + (F2/a2)^2 <= 1, up to the rounding of a force that was returned there.
/// With a_i = 0 the entry i has to vanish and the other one is bounded alone.
/// \param force F [F]
/// \param bounds a1, a2 >= 0 [F]
bool within_ellipse(const PlaneVector& force, const PlaneVector& bounds) noexcept;

/// The point of the ellipse with half axes a1, a2 that is closest to a trial force outside of it:
///   F_i = a_i^2 F*_i / (a_i^2 + L),   L >= 0 from sum (a_i F*_i / (a_i^2 + L))^2 = 1.
/// A trial within the ellipse is returned as it is; a_i = 0 leaves F_i = 0. The result lies on the
/// ellipse to rounding, whatever the size of the numbers; equal axes give the radial return.
/// Found by Newton's method for 1/|h| = 1, h_i = a_i F*_i / (a_i^2 + L), a concave function of L
/// whose iterates rise to the root from any lower bound. Source: closest-point projection; theory
/// of orthotropic friction, docs/theory.
/// \param trial F* [F]
/// \param bounds a1, a2 >= 0 [F]
PlaneVector closest_on_ellipse(const PlaneVector& trial, const PlaneVector& bounds) noexcept;

/// The return OpenRadioss (2026) computes: with q_i = F*_i/a_i^2 and e = q . F* the point
/// G = F* - q (e - sqrt e)/|q|^2 gives the angle atan |G2/G1| at which the force lies on the
/// ellipse, with the signs of the trial. Equal axes give the radial return. Far outside it is not
/// the closest point and may even differ from it in which entry is the larger.
PlaneVector ratio_on_ellipse(const PlaneVector& trial, const PlaneVector& bounds) noexcept;

/// The force that dissipates most in steady sliding along `motion`,
///   F_i = a_i^2 v_i / sqrt(sum (a_j v_j)^2),
/// the limit of the closest point for a trial far outside; 0 without motion or bounds.
/// \param motion v, in any unit
PlaneVector steady_on_ellipse(const PlaneVector& motion, const PlaneVector& bounds) noexcept;

/// Returns how far the ellipse is from the origin [F] along a direction of length 1; 0 without one.
double ellipse_radius(const PlaneVector& direction, const PlaneVector& bounds) noexcept;

/// Returns how the closest point and the ratio point change with trial and bounds, by implicit
/// differentiation.
/// \param trial_change dF*
/// \param bounds_change da
/// \return dF
PlaneVector closest_on_ellipse_change(const PlaneVector& trial, const PlaneVector& bounds,
                                      const PlaneVector& trial_change,
                                      const PlaneVector& bounds_change) noexcept;
PlaneVector ratio_on_ellipse_change(const PlaneVector& trial, const PlaneVector& bounds,
                                    const PlaneVector& trial_change,
                                    const PlaneVector& bounds_change) noexcept;

}  // namespace slipbench::law
