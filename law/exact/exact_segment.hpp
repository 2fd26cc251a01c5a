// SPDX-License-Identifier: Apache-2.0
// Elastic stick and slip along one straight segment, in the plane that the elastic slip and the
// motion span: the continuous solution for a constant slip radius (theory 14.4).
#pragma once

namespace slipbench::law {

/// The elastic slip s_el [L] of a straight motion in the direction e, as seen from e:
///   s_el = along e + across e_perp.
/// All motion along e leaves the plane of e and s_el alone, whatever the dimension of slip space.
struct PlaneSlip {
  double along = 0.0;
  double across = 0.0;  ///< >= 0 by the choice of e_perp

  double square() const { return along * along + across * across; }
};

/// The angle psi from the motion to s_el, 0..pi, by its half: accurate at both ends.
struct HalfAngle {
  double cosine = 1.0;  ///< cos(psi/2)
  double sine = 0.0;    ///< sin(psi/2)

  double cosine_of_angle() const { return (cosine - sine) * (cosine + sine); }
  double sine_of_angle() const { return 2.0 * cosine * sine; }
};
/// psi of an elastic slip; 0 where there is none.
HalfAngle half_angle(const PlaneSlip& slip) noexcept;
/// psi after slip in which tan(psi/2) has fallen by the factor exp(-turn); turn >= 0 is the
/// integral of |du|/R over the slip.
HalfAngle turned(const HalfAngle& from, double turn) noexcept;
/// s_el of the length R [L] at psi.
PlaneSlip on_radius(const HalfAngle& angle, double radius) noexcept;

/// The motion w [L] >= 0 along e after which |s_el| = R, given |s_el| <= R: the stick length. Both
/// forms of the root of |s_el + w e| = R are used, each where it does not cancel.
double stick_length(const PlaneSlip& slip, double radius) noexcept;

/// Slip over the motion r [L] at constant R [L] from psi on:
///   slip = integral of cos(psi) dr = r + R ln[cos^2(psi/2) + sin^2(psi/2) exp(-2 r/R)].
/// Never negative for psi <= pi/2, which is where slip is possible at constant R.
double segment_slip(const HalfAngle& from, double travel, double radius) noexcept;

/// A whole segment at constant R.
struct SegmentEnd {
  PlaneSlip elastic_slip;
  double stick = 0.0;  ///< motion w [L] before the slip; all of it if nothing slips
  double slip = 0.0;   ///< slip over the segment [L]
};
/// Stick up to w, slip over the rest of `travel` [L] (docs/theory, section 14.4). A state outside
/// the radius by its rounding counts as on it. \pre radius > 0, |s_el| <= radius
SegmentEnd exact_segment(const PlaneSlip& begin, double travel, double radius) noexcept;

}  // namespace slipbench::law
