// SPDX-License-Identifier: Apache-2.0
// One backward Euler step inside a straight segment, with what has to be the same along a stretch
// for its results to be smooth functions of time.
#pragma once

#include <cstdint>
#include <optional>

#include "law/definition/potential.hpp"
#include "law/exact/path_segment.hpp"
#include "law/exact/regime_change.hpp"
#include "law/exact/smooth_piece.hpp"

namespace slipbench::law {

/// Traits that sub-increments of one smooth piece share, apart from the piece of the limit
/// (smooth_piece.hpp): the regime, and where the leaves of a potential end.
struct Signature {
  enum Leaf : std::uint8_t { kNotPulled, kAtZero, kAbove, kBelow };

  Regime regime = Regime::kOpen;
  bool worn = false;   ///< open because the slip takes the limit as fast as it grows
  bool grips = false;  ///< the limit holds a force
  std::array<Leaf, kComponents> leaf{};
  friend bool operator==(const Signature&, const Signature&) = default;
};

/// The state that steps carry on.
struct SlipPoint {
  SlipVector held{};              ///< y [F] with a constant stiffness, else s_el [L]
  double accumulated_slip = 0.0;  ///< [L]
};

struct SubIncrement {
  SlipPoint end;
  SlipVector force{};   ///< y [F]
  SlipVector normal{};  ///< m = dP/dy [1]
  Limit limit;
  double slip = 0.0;       ///< of the step [L]
  double slip_rate = 0.0;  ///< of the slip, in units of the segment [L]
  /// Steepness with which wear lets the limit fall, as a part of the spring's slope.
  double snap_back = 0.0;
  LimitPoint point;       ///< where the limit was asked for
  bool negative = false;  ///< F_C + F_int there
  Signature signature;
};

/// A slip that no motion accompanies.
struct SlipAtOnce {
  double work = 0.0;      ///< integral of F_lim over it [F L]
  double steepest = 0.0;  ///< largest -dF_lim/d(slip) on its way [F/L], or 0
};

/// Backward Euler steps of a definition along a segment, to any fraction of it. Refers to its
/// arguments.
class SubIncrements {
 public:
  SubIncrements(const FrictionDefinition& definition, const PathSegment& segment,
                const FrictionState& old) noexcept;

  SubIncrement step(const SlipPoint& begin, double from, double to) noexcept;
  double next_knot(double tau, double slip, double end) noexcept {
    ++work_;
    return points_.next_knot(tau, slip, end);
  }
  /// Counts a distance to the limit.
  void count_distance() noexcept { work_ += per_distance_; }
  /// Work of all steps so far, in distances to a limit that is constant: 50 ns to half a
  /// microsecond each.
  long work() const { return work_; }
  double cap() const { return definition_.force_limit; }
  /// Returns the force [F] in whose last digits a limit `mu` F_N is known, however small it is.
  double limit_size(double mu) const { return std::min(mu * contact_size_, cap()); }

  /// F_lim at the fraction tau, after the accumulated slip of `at` and at the slip per segment
  /// given [L]; of a belt that of the side which `at` holds a force on.
  Limit limit(double tau, const SlipPoint& at, double slip_rate) noexcept;
  /// The same without slip or, where P is homogeneous and it is larger, with all motion as slip: a
  /// coefficient that vanishes only at rest still grips.
  double strength(double tau, double accumulated_slip) noexcept;
  /// By how much that exceeds P(0), which it has to; infinity for a coefficient on its floor, which
  /// grips however small it is.
  double reserve(double tau, double accumulated_slip) noexcept;
  /// Tells whether the limit holds a force, at rest or with a slip per segment [L].
  bool grips(double tau, double accumulated_slip, double slip_rate) noexcept;
  /// Tells whether nothing is there to hold a force: no limit above `rounding` [F] at any rate up
  /// to that of the motion, or, as a viscous force has any rate, no contact.
  bool is_free(double tau, double accumulated_slip, double rounding) noexcept;
  /// Goes to the smooth piece of the limit that holds `here`, or begins there towards `ahead`.
  void enter(const LimitPoint& here, const LimitPoint& ahead) noexcept;
  /// Tells whether the point is in that piece.
  bool stays(const LimitPoint& point) noexcept;
  /// Returns where a point leaves that piece whose slip [L], if any, is proportionate to tau: it is
  /// looked for in so many parts of the way. `to` if it stays.
  double end_of_piece(const SlipPoint& at, double from, double to, double slip, int parts) noexcept;
  /// Tells whether it is, as far as the rate of the slip at the end of a piece is known.
  bool keeps_rate(const LimitPoint& end) noexcept;
  LimitPoint point(double tau, const SlipPoint& at, double slip_rate) const {
    return {tau, at.accumulated_slip, slip_rate * inverse_duration_, at.held.front()};
  }
  /// Tells whether a step with this signature can begin here: on the limit where it slips, its
  /// leaves where the signature has them.
  bool can_begin(const Signature& signature, const SlipPoint& at, double tau) noexcept;
  /// Returns what the limit leaves to the force, as a part of the limit.
  double holds(const SlipPoint& at, double tau) noexcept;
  /// Returns what is left of stick or an open state that lasts from one tau to another: of the
  /// limit as a part, or up to one [F]; below -0.5 where it is another regime then.
  double lasts(Regime regime, const SlipPoint& at, double from, double to) noexcept;
  /// Tells whether the force is beyond the limit, as after a jump of it.
  bool beyond(const SlipPoint& at, double tau) noexcept;
  /// Goes over a slip from an accumulated slip on, at tau, without motion.
  SlipAtOnce slip_at_once(double tau, double accumulated_slip, double slip) noexcept;
  /// Tells the steps that follow where they begin: a viscous force nears its limit at rest for
  /// ever, and one as near to it as rounding stays there until something else than that moves it.
  void begin(const SlipPoint& at, double tau) noexcept;
  /// Takes rounding away: on the limit where it slips, not beyond it elsewhere.
  void settle(Regime regime, double tau, double slip_rate, SlipPoint* point) noexcept;

  /// y [F] of a state.
  SlipVector force(const SlipPoint& at, double tau, double slip_rate) noexcept;
  const Potential& potential() const { return *potential_; }
  /// Tells whether slip that takes F_C + F_int through 0 ends there: an elastic slip is lost with
  /// the limit and sticks first behind it, and a shifted potential holds no force. The force of a
  /// constant stiffness comes to 0 with the limit and slips on.
  bool ends_where_contact_turns() const { return !fixed_ || !potential_->homogeneous; }
  bool fixed() const { return fixed_; }
  /// Tells whether the limit follows the rate of the slip, and if the slip follows that limit.
  bool by_rate() const { return by_rate_; }
  bool viscous() const { return viscous_; }
  /// kappa [F/L] or g_c [L].
  double stick(double tau) const { return points_.stick(tau); }
  const SlipVector& motion() const { return motion_; }  ///< ds of the segment [L]
  double length() const { return length_; }             ///< |ds| [L]

 private:
  /// Tells whether P is smooth where the leaf passes 0.
  bool is_smooth_at_zero(const PotentialLeaf& leaf) const {
    return smooth_ && leaf.kind != PotentialLeaf::Kind::kHalfLine;
  }
  /// The potential's own measure of what is held, and its bound.
  double measure(const SlipPoint& at, double tau, double limit) const noexcept;
  double bound(double tau, double limit) const noexcept;

  const FrictionDefinition& definition_;
  Potential norm_;  ///< of a Euclidean criterion
  const Potential* potential_;
  SlipVector motion_;
  double length_;
  SegmentPoints points_;
  double inverse_duration_;
  double least_;               ///< P(0): a limit has to exceed it
  double contact_size_ = 0.0;  ///< F_C and a table of F_int at their largest [F]
  double no_contact_ = 0.0;    ///< F_N up to here is the rounding of F_C + F_int [F]
  bool fixed_;
  bool closed_;
  bool smooth_;  ///< P is a sum of even powers of its leaves
  bool varies_with_slip_;
  bool may_jump_;  ///< wear against a constant stick stiffness, and not viscous
  bool by_rate_;
  bool viscous_;  ///< the limit follows the rate of the slip, and the spring does not the limit
  bool at_rest_ = false;    ///< of a viscous force: as near to the limit as rounding
  double last_rate_ = 0.0;  ///< of the last step that slipped
  long work_ = 0;
  int per_distance_ = 1;  ///< work of one
  std::optional<SmoothPiece> piece_;
};

}  // namespace slipbench::law
