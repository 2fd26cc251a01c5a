// SPDX-License-Identifier: Apache-2.0
// The kinematics of a belt that runs from node a over a ring at node b to node c (SLIPRING;
// docs/theory, section 4.1). The ring has no radius.
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

/// Least part of its initial length that the segment between the nodes may shrink to [1].
inline constexpr double kShortestPart = 0.01;

/// A turn of the belt about its ring that is followed through whole turns: by `angle` [1], with its
/// sign, about a unit axis; the axis is 0 while the belt is straight or turns right back.
struct BeltTurn {
  double angle = 0.0;
  Point axis{};
};

/// Returns the turn that three nodes and a number of whole half turns make: the angle lies between
/// `half_turns` pi and (half_turns + 1) pi.
BeltTurn begin_turn(int half_turns, const Point& a, const Point& b, const Point& c);

/// Returns the turn after the nodes have moved: of all that nodes in these places may stand for,
/// the one next to `before`. Through a straight line it goes on, since the axis keeps its direction
/// there; a motion around the line turns the axis instead, and the angle comes back. Between two
/// calls the turn must change by less than half a turn, its axis by less than a right angle.
BeltTurn follow_turn(const BeltTurn& before, const Point& a, const Point& b, const Point& c);

/// A belt segment at one instant.
struct BeltSegment {
  double reference_length = 0.0;  ///< l_ref [L]
  double strain = 0.0;            ///< [1]
  double wrap_angle = 0.0;        ///< alpha of the first ring [1]
};

/// The segment behind a ring, of a length that stays.
struct SegmentBehind {
  double reference_length = 0.0;  ///< [L]
  double strain = 0.0;            ///< [1]
  double flow = 0.0;              ///< out at its end, which is into the next segment [L]
  double flow_before = 0.0;       ///< the same where the increment began
};

}  // namespace slipbench::law
