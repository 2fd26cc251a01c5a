// SPDX-License-Identifier: Apache-2.0
// One straight segment walked from event to event (theory 11.9): continuous_update.cpp begins and
// ends it, exact_walk.cpp has stick, open and slip at a constant radius, exact_slip.cpp slip at a
// radius that changes.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "law/exact/exact_segment.hpp"
#include "law/exact/regime_change.hpp"
#include "law/exact/smooth_piece.hpp"

namespace slipbench::law {

/// A segment on its way from tau = 0 to tau = 1 in the plane of motion and elastic slip.
class ExactWalk {
 public:
  /// \param length |ds| [L]
  /// \param sign of ds in one dimension
  /// \param tolerance of forces and energies as a part of the limit
  ExactWalk(const FrictionDefinition& definition, const PathSegment& segment,
            const FrictionState& old, const PlaneSlip& begin, double length, double sign,
            double tolerance, RegimeChanges* changes) noexcept;

  void run() noexcept;

  const PlaneSlip& elastic_slip() const { return slip_at_; }
  double slip() const { return slip_; }  ///< since the begin [L]
  double dissipation() const { return dissipation_; }
  double work() const { return work_; }
  double onset() const { return onset_; }
  double snap_back() const { return snap_back_; }  ///< see FrictionUpdate
  double lost() const { return lost_; }
  double jump_onset() const { return jump_onset_; }
  int jumps() const { return jumps_; }
  Regime regime() const { return regime_; }
  bool converged() const { return converged_; }

  /// The limit at the end, with the rate that the coefficient sees there.
  Limit end_limit() noexcept;

 private:
  static constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  /// A limit below this part of the segment's is 0, up to the rounding of where it vanishes.
  static constexpr double kNoLimit = 1e-12;
  /// Times closer than this part of the segment are one.
  static constexpr double kSameFraction = 1e-13;
  /// Steps or pieces after which an integration takes what it has: rounding is in its way.
  static constexpr int kMostPieces = 2000;
  /// Evaluations of the limit after which a segment is given up, within a second.
  static constexpr long kMostLimits = 10'000'000;

  double sense() const { return slip_at_.along < 0.0 ? -sign_ : sign_; }
  Limit limit(double tau, double slip, double rate = 0.0) noexcept {
    ++limits_;
    return points_.limit(tau, begin_slip_ + slip, rate, sense());
  }
  LimitPoint point(double tau, double slip, double rate) const {
    return {tau, begin_slip_ + slip, rate, sense()};
  }
  /// R at a point.
  double radius(double tau, double slip) noexcept {
    const double stick = points_.stick(tau);
    return fixed_ ? limit(tau, slip).force / stick : stick;
  }
  /// The rate of a slip that moves s_el by `along` and turns as far as `cosine`.
  double slip_rate(double cosine) const {
    return by_rate_ ? std::max(length_ * cosine - radius_rate_, 0.0) * inverse_duration_ : 0.0;
  }
  /// The limit at its strongest: a coefficient that vanishes only at rest still grips.
  Limit strongest(double tau) noexcept;
  bool grips(double tau) noexcept;
  /// Returns the force that errors of energies are measured by [F].
  double largest_limit(double from, double to) noexcept;

  void note(Regime to, double tau) noexcept;
  void open(double tau) noexcept;
  /// Takes the rounding out of an elastic slip that is on the radius.
  void put_on(double radius) noexcept;
  /// Energy of the spring [F L], of a constant stick stiffness.
  double stored(double square) const { return 0.5 * definition_.stick.value * square; }

  /// Search for the slip from `least` on that has moved the spring's end by `sum` - R.
  struct Follower {
    double slip = 0.0;
    bool falls = false;  ///< x + R is below `sum` there, and falls behind it: the force jumps
  };
  /// The smallest slip x >= `least` at which x + R(tau, x) = sum, or the first place before it from
  /// which x + R falls. Before `least` the line is prolonged.
  Follower follow(double tau, double sum, double least) noexcept;
  /// The root of x + R(tau, x) = sum in [low, high], below the sum at `low`.
  double slip_between(double tau, double sum, double low, double high) noexcept;
  /// Returns where a spring that nothing holds meets its limit again: the root behind `from`, or
  /// the place where the limit is worn away.
  double landing(double tau, double sum, double from) noexcept;
  /// Up to where x + R rises in a smooth piece: `low` if it falls at once.
  double rises_until(double tau, double low, double high) noexcept;
  /// Calls visit(low, high) for the smooth pieces of the limit over the slip in [low, high], until
  /// it returns true.
  template <class Visit>
  void for_each_piece(double tau, double low, double high, Visit visit) noexcept;
  /// Lets a spring outside of its limit relax at once: a limit that has jumped down.
  void relax(double tau) noexcept;
  /// Goes through a snap-back at constant motion, to where spring and limit meet again.
  void jump(double tau) noexcept;
  /// Wear against the stick stiffness at a slip: at 1 the force drops by itself.
  double wear_ratio(double tau, double slip) noexcept;

  /// From tau to the next event.
  double advance(double tau) noexcept;
  /// Enters the smooth piece that a way [from, to] begins in.
  template <class Way>
  void enter_piece(Way&& way, double from, double to) noexcept {
    // What stands on a corner is judged by what comes, so far ahead as a part of the way.
    constexpr double kAhead = 1e-9;
    piece_->enter(piece_->values(way(from)), piece_->values(way(from + kAhead * (to - from))));
  }
  /// Returns where the smooth piece ends that begins at `from`, at rest.
  double end_at_rest(double from, double to) noexcept;
  bool has_constant_radius(double from, double to) noexcept;
  /// dR/dtau at the begin of [from, to], wear held.
  double radius_growth(double from, double to) noexcept;

  /// Stick until the radius is met, or `to`; returns where, and nothing moves if that is at once.
  double stick(double from, double to) noexcept;
  double stick_end(double from, double to) noexcept;
  double slip_at_constant_radius(double from, double to) noexcept;
  double slip_at_varying_radius(double from, double to) noexcept;

  const FrictionDefinition& definition_;
  SegmentPoints points_;
  double length_;
  double sign_;
  double inverse_duration_;
  double tolerance_;
  bool fixed_;
  bool belt_;
  bool wears_;
  bool by_rate_;        ///< the coefficient sees the rate of the slip
  bool floored_;        ///< the coefficient has a floor, which is no end of contact
  bool constant_;       ///< nothing that the segment changes can matter
  double radius_rate_;  ///< dg_c/dtau of an allowable elastic slip that changes
  double begin_slip_;
  double largest_slip_ = 0.0;
  std::optional<SmoothPiece> piece_;  ///< where the limit can have corners at all

  PlaneSlip slip_at_;
  double slip_ = 0.0;
  double dissipation_ = 0.0;
  double work_ = 0.0;
  double onset_ = 0.0;
  double snap_back_ = 0.0;
  double lost_ = 0.0;
  double jump_onset_ = 0.0;
  int jumps_ = 0;
  long limits_ = 0;  ///< evaluations so far
  Regime regime_;
  double force_scale_ = 0.0;    ///< of the limit [F]
  double contact_scale_ = 0.0;  ///< of F_N [F]
  bool must_slip_ = false;      ///< stick has met the radius
  bool must_stick_ = false;     ///< slip has come to rest
  bool converged_ = true;
  RegimeChanges* changes_;
};

}  // namespace slipbench::law
