// SPDX-License-Identifier: Apache-2.0
// The kinematics of a belt that runs from node a over a ring at node b to node c (SLIPRING;
// connector-friction specification, section 2.2). The ring has no radius.
#pragma once

#include <array>
#include <cmath>

namespace slipbench::law {

using Point = std::array<double, 3>;  ///< x, y, z [L]

/// |q - p| [L]. Neither overflows nor underflows before its result does.
inline double distance(const Point& p, const Point& q) {
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

/// The material in segment ab before anything flows: l_ref(0) = d_ab(0) / (1 + initial strain) [L].
inline double initial_reference_length(double initial_distance, double initial_strain) {
  return initial_distance / (1.0 + initial_strain);
}

/// The material in segment ab after flows, l_ref += dPsi_a - dPsi_b [L]: Psi_a counts what enters
/// at a, Psi_b what leaves at b, each since the start.
inline double reference_length(double initial_length, double flow_in, double flow_out) {
  return initial_length + (flow_in - flow_out);
}

/// Strain of segment ab, d_ab / l_ref - 1 [1]. Not finite or meaningless without material, that is
/// for a reference length that is not positive.
inline double strain(double distance, double reference_length) {
  return (distance - reference_length) / reference_length;
}

/// Wrap angle alpha at b: the angle between the prolonged segment ab and the segment bc, 0..pi [1].
/// Both the straight belt (0) and the one that turns back (pi) come out to full accuracy, from
/// alpha = 2 atan2(|u - v|, |u + v|) of the unit directions u, v (after Kahan 2006). NaN where two
/// neighbouring nodes coincide.
inline double wrap_angle(const Point& a, const Point& b, const Point& c) {
  const double ab = distance(a, b);
  const double bc = distance(b, c);
  Point difference{};
  Point sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double u = (b[i] - a[i]) / ab;
    const double v = (c[i] - b[i]) / bc;
    difference[i] = u - v;
    sum[i] = u + v;
  }
  return 2.0 * std::atan2(std::hypot(difference[0], difference[1], difference[2]),
                          std::hypot(sum[0], sum[1], sum[2]));
}

/// A belt segment at one instant.
struct BeltSegment {
  double reference_length = 0.0;  ///< l_ref [L]
  double strain = 0.0;            ///< [1]
  double wrap_angle = 0.0;        ///< alpha of the first ring [1]
};

}  // namespace slipbench::law
