// SPDX-License-Identifier: Apache-2.0
#include "law/exact/extrapolated_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "law/exact/neville_table.hpp"
#include "law/exact/sub_increment.hpp"
#include "law/update/six_steps.hpp"

namespace slipbench::law {
namespace {

/// An event is located to this part of the segment.
constexpr double kSameFraction = 1e-13;
/// A step that goes over more of the segment at once is not exact.
constexpr double kLongestCrossing = 1e-8;
/// A change so near behind the begin of the segment is at its begin.
constexpr double kSoon = 1e-9;
/// Distance behind the begin of a piece at which its common traits are taken.
constexpr double kAhead = 1e-11;
/// Distance behind the begin of a piece at which the rate of a viscous slip is taken.
constexpr double kNearRate = 1e-9;
/// Distance behind the begin of a piece at which terms that still pull on the limit are found.
constexpr double kNearLetGo = 1e-6;
/// Distance behind the end of a piece at which it is seen to go on alike; what lets go within is
/// the square of that.
constexpr double kBeyond = 1e-7;
/// A slip of this part of the elastic slip is seen; a slow one takes longer for it.
constexpr double kSeen = 1e-13;
/// A limit below this part of the segment's is that of an instant without one.
constexpr double kNoLimit = 1e-11;
/// Places at which the segment's limit is looked at for its size.
constexpr std::array kSamples{0.0, 0.25, 0.5, 0.75, 1.0};
/// First piece of slip, in parts of the motion that turns a force: the elastic slip.
constexpr double kFirst = 1e-4;
/// An error below this one that so many halvings of a piece do not lessen is rounding; that of a
/// piece much longer than a fast turn inside falls with its length, or not at first.
constexpr double kRounding = 1e-10;
constexpr int kHalvings = 4;
/// Rounding of a limit as a part of its largest term, as extrapolation enlarges it.
constexpr double kRoundedLimit = 100.0 * std::numeric_limits<double>::epsilon();
/// Rows of a table before its error is known.
constexpr int kLeastRows = 3;
/// Work after which a segment is given up: some thousand corners, in some two seconds.
constexpr long kMostWork = 8000000;

/// A piece of the segment, as its sub-increments have it.
struct Run {
  enum class Outcome {
    kSettled,
    kUnsettled,  ///< too long for the tolerance
    kMixed       ///< something changes inside
  };
  Outcome outcome = Outcome::kUnsettled;
  int rows = 0;
  double error = 0.0;  ///< as a part of limit and elastic slip
  PieceSums end;
  SubIncrement last;
  double snap_back = 0.0;
};

class Pieces {
 public:
  Pieces(const FrictionDefinition& definition, const PathSegment& segment, double tolerance,
         const FrictionState& old, RegimeChanges* changes)
      : definition_(definition),
        steps_(definition, segment, old),
        tolerance_(std::max(0.02 * tolerance, 1e-13)),
        begin_slip_(old.accumulated_slip),
        regime_(old.regime),
        changes_(changes) {
    at_ = {steps_.fixed() ? old.force : old.elastic_slip, old.accumulated_slip};
    double mu = 0.0;
    for (const double tau : kSamples) {
      Limit l = steps_.limit(tau, {{}, begin_slip_}, 0.0);
      scale_ = std::max(scale_, l.force);
      mu = std::max(mu, l.mu);
      // At rest a coefficient that follows the rate may be next to nothing.
      if (!steps_.by_rate()) continue;
      l = steps_.step(at_, 0.0, tau).limit;
      scale_ = std::max(scale_, l.force);
      mu = std::max(mu, l.mu);
    }
    // And a viscous force may outlive a limit that goes at once.
    if (steps_.viscous()) scale_ = std::max(scale_, value(steps_.potential(), at_.held));
    negative_ = steps_.limit(0.0, at_, 0.0).contact_force < 0.0;
    // The digits of a limit are those of its terms, also where F_C + F_int comes to 0.
    if (scale_ > 0.0) tolerance_ += kRoundedLimit * steps_.limit_size(mu) / scale_;
    elastic_ = steps_.fixed() ? scale_ / steps_.stick(1.0) : steps_.stick(1.0);
    const double length = steps_.length();
    // A viscous force turns by itself, however little moves.
    const double most = steps_.viscous() ? 1e-2 : 1.0;
    first_ = length > 0.0 ? std::clamp(kFirst * elastic_ / length, 1e-9, most) : 1e-4;
  }

  void run() noexcept {
    double step = 1.0;
    double event = 2.0;              // something changes before it; none is known beyond 1
    bool again = false;              // the way to the event is to be tried as a whole
    int flickers = 0, halvings = 0;  // of the piece first tried here
    bool fresh = true;               // nothing is known yet of how fast the force turns
    double error = 0.0;              // of that piece, or of the one kHalvings before
    let_go_without_limit();
    if (steps_.beyond(at_, 0.0)) cross(kSameFraction);  // the limit has jumped below the force
    while (tau_ < 1.0) {
      if (steps_.work() > kMostWork) {
        converged_ = false;
        return cross(1.0);
      }
      // Rounding that flickers about an event must not hold the walk up.
      const double shortest = kSameFraction * std::pow(4.0, std::clamp(flickers - 2, 0, 18));
      if (event <= 1.0 && event - tau_ <= shortest) {
        converged_ = converged_ && event - tau_ <= kLongestCrossing;
        cross(event);
        event = 2.0;
        step = 1.0;
        halvings = 0;
        fresh = true;
        ++flickers;
        continue;
      }
      double to = tau_ + step;
      if (event <= 1.0) to = std::min(to, again ? event : 0.5 * (tau_ + event));
      again = false;
      if (event > 1.0 && 1.0 - to < kSameFraction) to = 1.0;
      const Run run = extrapolate(tau_, to);
      const bool is_due = halvings % kHalvings == 0;
      if (run.outcome == Run::Outcome::kMixed) {
        event = to;
      } else if (const double change = first_change(run, to); change < to) {
        event = change;
      } else if (fresh && run.last.signature.regime == Regime::kSlip && to - tau_ > first_) {
        // A turn that is over within the first step of every row would not be seen.
        step = first_;
        fresh = false;
      } else if (run.outcome == Run::Outcome::kUnsettled && to - tau_ > shortest &&
                 !(is_due && halvings > 0 && run.error < kRounding && run.error > 0.25 * error)) {
        step = 0.5 * (to - tau_);
        if (is_due) error = run.error;
        ++halvings;
      } else {
        // What settles late only would not at twice the length; what is rounded is so at any.
        const int doublings = run.outcome == Run::Outcome::kUnsettled
                                  ? std::min(halvings, kHalvings)
                              : run.rows < NevilleTable::kMostRows - 1 ? 1
                                                                       : 0;
        step = std::ldexp(to - tau_, doublings);
        halvings = 0;
        const bool long_enough = to - tau_ > 1e3 * shortest;
        if (long_enough) flickers = 0;
        take(run, to);
        // Long sub-increments may have seen what is not there.
        if (to == event) {
          event = 2.0;
          step = 1.0;
          if (!long_enough) ++flickers;
        }
        again = true;
      }
    }
  }

  FrictionUpdate result(FrictionUpdate update) noexcept {
    const bool slips = regime_ == Regime::kSlip;
    const double rate = slips ? std::max(rate_, 0.0) : 0.0;
    const Limit l = steps_.limit(1.0, at_, rate);
    update.state.force = steps_.force(at_, 1.0, rate);
    update.state.elastic_slip = at_.held;
    if (steps_.fixed()) {
      for (double& s : update.state.elastic_slip) s /= steps_.stick(1.0);
    }
    update.state.accumulated_slip = at_.accumulated_slip;
    update.state.regime = regime_;
    report(l, &update);
    update.slip_increment = at_.accumulated_slip - begin_slip_;
    update.dissipation = std::max(dissipation_, 0.0);
    update.work = work_;
    update.stored_energy = 0.5 * dot(update.state.force, update.state.elastic_slip);
    update.phi = value(steps_.potential(), update.state.force) - l.force;
    update.onset = slips ? onset_ : 0.0;
    update.snap_back = snap_back_;
    update.multiple_roots = snap_back_ >= 1.0;
    update.lost = lost_;
    update.jump_onset = jump_onset_;
    update.jumps = jumps_;
    update.converged = converged_;
    update.direction = {};
    if (std::holds_alternative<Potential>(definition_.criterion)) {
      const double square = dot(normal_, normal_);
      for (std::size_t i = 0; i < kComponents && square > 0.0; ++i) {
        update.direction[i] = normal_[i] / square;
      }
    } else {
      const double p = std::sqrt(dot(update.state.force, update.state.force));
      for (std::size_t i = 0; i < kComponents && p > 0.0; ++i) {
        update.direction[i] = update.state.force[i] / p;
      }
    }
    return update;
  }

 private:
  /// Lets go of what is held where the increment begins without a limit, whether one returns or
  /// not: no slip takes its energy. A force that slip brings to 0 with its limit is none.
  void let_go_without_limit() noexcept {
    const double least = steps_.fixed() ? kNoLimit * scale_ : 0.0;
    if (!(std::sqrt(dot(at_.held, at_.held)) > least)) return;
    if (!steps_.is_free(0.0, begin_slip_, kNoLimit * scale_)) return;
    if (steps_.fixed()) lost_ += stored(0.0, at_.held);
    at_.held = {};
    note(Regime::kOpen, {});
  }

  /// Work and dissipation of a step, by the force at its end throughout: their errors are smooth in
  /// the length of steps. y.m is F_lim without shifts.
  void add(const SubIncrement& step, double length, PieceSums* sums) const noexcept {
    sums->work += length * dot(step.force, steps_.motion());
    sums->dissipation += dot(step.force, step.normal) * step.slip;
  }

  /// Goes over a piece in 1, 2, 3, ... sub-increments, until what they are extrapolated to settles.
  Run extrapolate(double from, double to) noexcept {
    Run result;
    Signature common;
    steps_.begin(at_, from);
    NevilleTable table;
    for (int count = 1; count <= NevilleTable::kMostRows; ++count) {
      PieceSums sums;
      SlipPoint point = at_;
      double tau = from;
      for (int i = 1; i <= count; ++i) {
        const double next = i == count ? to : from + (to - from) * i / count;
        result.last = steps_.step(point, tau, next);
        if (i == 1 && count == 1) {
          common = result.last.signature;
          if (!begins(result.last, from, to)) {
            result.outcome = Run::Outcome::kMixed;
            return result;
          }
        } else if (result.last.signature != common || !steps_.stays(result.last.point)) {
          result.outcome = Run::Outcome::kMixed;
          return result;
        }
        result.snap_back = std::max(result.snap_back, result.last.snap_back);
        add(result.last, next - tau, &sums);
        sums.slip += result.last.slip;
        point = result.last.end;
        tau = next;
      }
      sums.held = point.held;
      sums.slip_rate = result.last.slip_rate;
      table.add(sums);
      result.end = table.corner();
      result.rows = count;
      if (count < kLeastRows) continue;
      result.error =
          std::max(difference(result.end, table.beside()), difference(result.end, table.above()));
      if (common.regime == Regime::kOpen || result.error <= tolerance_) {
        result.outcome = goes_on(result, from, to) ? Run::Outcome::kSettled : Run::Outcome::kMixed;
        return result;
      }
    }
    return result;
  }

  /// Tells whether what holds the force on its limit still does so where the piece ends: the last
  /// sub-increment of every row may have passed the place where it lets go.
  bool goes_on(const Run& run, double from, double to) noexcept {
    const Signature& common = run.last.signature;
    if (common.regime != Regime::kSlip || to - from <= 10.0 * kBeyond) return true;
    SlipPoint end{run.end.held, at_.accumulated_slip + run.end.slip};
    steps_.settle(common.regime, to, run.end.slip_rate, &end);
    if (!steps_.keeps_rate(steps_.point(to, end, run.end.slip_rate))) return false;
    // A shift may leave a limit far below the force.
    const double held =
        std::sqrt(dot(end.held, end.held)) / (steps_.fixed() ? steps_.stick(to) : 1.0);
    const double seen = kSeen * std::max(elastic_, held);
    if (run.end.slip < 10.0 * seen) return true;  // next to nothing, wherever it ends
    const double rate = run.end.slip_rate;
    const double longest = 0.1 * (to - from);
    const double ahead = rate * longest > seen ? seen / rate : longest;
    const Signature beyond = steps_.step(end, to, to + std::max(ahead, kBeyond)).signature;
    return beyond.regime == Regime::kSlip && !lets_go(common, beyond);
  }

  /// Tells whether a step lets go of a term that the one before it pulls on, or holds at 0.
  static bool lets_go(const Signature& before, const Signature& after) noexcept {
    for (std::size_t g = 0; g < kComponents; ++g) {
      const auto was = before.leaf[g], is = after.leaf[g];
      if (was == Signature::kNotPulled) continue;
      if (is == Signature::kNotPulled || (was == Signature::kAtZero && is != was)) return true;
    }
    return false;
  }

  /// Tells whether a piece that this step goes through can begin at `from`.
  bool begins(const SubIncrement& first, double from, double to) noexcept {
    const Signature& signature = first.signature;
    const double ahead = std::min(from + kAhead, from + 0.5 * (to - from));
    const bool slips = signature.regime == Regime::kSlip;
    double slip_rate = 0.0;
    if (slips && steps_.by_rate()) {
      // The rate here, and not where the first step of the piece ends: by a step so short that it
      // does not change, and so long that it has digits.
      const double near =
          std::min(from + (steps_.viscous() ? kNearRate : 1e-7), from + 0.5 * (to - from));
      const SubIncrement close = steps_.step(at_, from, near);
      slip_rate = close.signature.regime == Regime::kSlip ? close.slip_rate : first.slip_rate;
    }
    if (!lets_go_at_once(signature, from, to)) return false;
    // Slip that has come through 0 with the limit need not find one before it moves.
    const bool anywhere = slips && !steps_.ends_where_contact_turns();
    if (signature.worn ||
        (!anywhere && steps_.grips(ahead, at_.accumulated_slip, slip_rate) != signature.grips)) {
      return false;
    }
    steps_.enter(steps_.point(from, {first.end.held, at_.accumulated_slip}, slip_rate),
                 first.point);
    return steps_.stays(first.point) &&
           (signature.regime != Regime::kOpen || regime_ == Regime::kOpen) &&
           steps_.can_begin(signature, at_, from);
  }

  /// Tells whether what a step from here to `to` no longer holds is left alone from the begin: a
  /// limit may rise slowly first, pulled along, and fast enough to let go of the force later.
  bool lets_go_at_once(const Signature& signature, double from, double to) noexcept {
    const bool slips = signature.regime == Regime::kSlip;
    const bool sticks = signature.regime == Regime::kStick && steps_.holds(at_, from) < kAhead;
    if (!slips && !sticks) return true;
    // A viscous force may still be beyond its limit at rest.
    const double far = steps_.viscous() ? kNearRate : kNearLetGo;
    const double near = std::min(from + far, from + 0.5 * (to - from));
    const Signature here = steps_.step(at_, from, near).signature;
    return sticks ? here.regime == Regime::kStick : !lets_go(here, signature);
  }

  /// The larger of the differences, as a part of limit and elastic slip, beyond their rounding.
  double difference(const PieceSums& a, const PieceSums& b) const noexcept {
    const auto apart = [](double x, double y, double whole) {
      constexpr double kRounded = 1000.0 * std::numeric_limits<double>::epsilon();
      const double beyond = std::abs(x - y) - kRounded * std::abs(x);
      return beyond > 0.0 ? beyond / whole : 0.0;
    };
    const double held = steps_.fixed() ? scale_ : elastic_;
    const double slip = elastic_ + steps_.length();
    double worst = std::max({apart(a.slip, b.slip, slip), apart(a.work, b.work, scale_ * slip),
                             apart(a.dissipation, b.dissipation, scale_ * slip)});
    for (std::size_t i = 0; i < kComponents; ++i) {
      worst = std::max(worst, apart(a.held[i], b.held[i], held));
    }
    return worst;
  }

  /// A place at which a piece changes between the samples of the rows; `to` if there is none: the
  /// smooth piece of the limit ends there, or the limit dips below the force, or comes up to it.
  double first_change(const Run& run, double to) noexcept {
    const Regime regime = run.last.signature.regime;
    const bool slips = regime == Regime::kSlip;
    if (run.outcome != Run::Outcome::kSettled || (slips && steps_.by_rate())) return to;
    if (to - tau_ < 1e-6) return to;
    const double corner = steps_.end_of_piece(at_, tau_, to, run.end.slip, slips ? 4 : 16);
    if (corner < to || slips) return corner;
    const auto lasts = [&](double tau) { return steps_.lasts(regime, at_, tau_, tau); };
    return first_dip(lasts, tau_, to, 16, -0.5);
  }

  /// Goes on to `to` with what a piece has come to.
  void take(const Run& run, double to) noexcept {
    const Regime regime = run.last.signature.regime;
    const bool pauses = regime == Regime::kStick && regime_ == Regime::kSlip;
    if (!pauses) slipped_until_ = to;
    if (!pauses || to - slipped_until_ > kLastingStick) note(regime, run.last);
    if (regime != Regime::kStick) dissipation_ += run.end.dissipation;
    at_.held = run.end.held;
    at_.accumulated_slip += std::max(run.end.slip, 0.0);
    rate_ = run.end.slip_rate;
    normal_ = run.last.normal;
    negative_ = run.last.negative;
    work_ += run.end.work;
    snap_back_ = std::max(snap_back_, run.snap_back);
    tau_ = to;
    scale_ = std::max(scale_, run.last.limit.force);
    steps_.settle(regime, to, regime == Regime::kSlip ? rate_ : 0.0, &at_);
  }

  /// Steps across an event, in one step of next to no length.
  void cross(double to) noexcept {
    Run run;
    run.last = steps_.step(at_, tau_, to);
    const bool at_once =
        run.last.slip > 1e-6 * elastic_ && run.last.slip > 1e3 * (to - tau_) * steps_.length();
    // Slip far beyond the motion has no rate: the limit is that at rest.
    if (at_once && steps_.by_rate() && !steps_.fixed()) run.last = steps_.step(at_, to, to);
    if (run.last.signature.regime == Regime::kOpen && regime_ == Regime::kSlip &&
        !steps_.ends_where_contact_turns()) {
      // F_C + F_int may vanish here to the last digit, and slip goes on behind it.
      at_.accumulated_slip *= 1.0 + 4.0 * std::numeric_limits<double>::epsilon();
      to = std::min(to + kSameFraction, 1.0);
      run.last = steps_.step(at_, tau_, to);
    }
    const double before = steps_.reserve(tau_, at_.accumulated_slip);
    const double after = steps_.reserve(to, run.last.end.accumulated_slip);
    // Next to a coefficient on its floor a limit is small, and does not vanish.
    const double least = std::isfinite(before + after) ? std::min(before, after) : scale_;
    // A limit that vanishes for an instant loses the grip, too.
    const bool lost = regime_ != Regime::kOpen && steps_.ends_where_contact_turns() &&
                      (negative_ != run.last.negative ||
                       (run.last.signature.grips && !(least > kNoLimit * scale_)));
    add(run.last, to - tau_, &run.end);
    if (lost) {
      run.last.signature.regime = Regime::kOpen;
      run.last.end.held = {};
    }
    run.end.held = run.last.end.held;
    run.end.slip = run.last.slip;
    if (steps_.fixed()) {
      // What the spring loses in no time.
      run.end.dissipation = run.end.work - stored(to, run.end.held) + stored(tau_, at_.held);
      // Slip far beyond the motion: wear has let the force jump over a steep part of the limit, and
      // friction takes of the spring's energy what it can.
      if (tau_ > 0.0 && at_once) {
        const SlipAtOnce way = steps_.slip_at_once(to, at_.accumulated_slip, run.last.slip);
        lost_ += run.end.dissipation - way.work;
        run.end.dissipation = way.work;
        // The normal of where it jumps from; a jump needs 1, whatever its rounding.
        const SlipVector& from = dot(normal_, normal_) > 0.0 ? normal_ : run.last.normal;
        const double along = steps_.stick(to) * dot(from, from);
        snap_back_ = std::max({snap_back_, along > 0.0 ? way.steepest / along : 0.0, 1.0});
        if (jumps_++ == 0) jump_onset_ = tau_;
      } else if (tau_ > 0.0 && run.last.signature.regime == Regime::kOpen) {
        // No slip takes the energy that a term without pull has held: it goes with the limit.
        lost_ += std::max(std::exchange(run.end.dissipation, 0.0), 0.0);
      }
    }
    run.end.slip_rate = run.last.slip_rate;
    take(run, to);
  }

  double stored(double tau, const SlipVector& held) const noexcept {
    return 0.5 * dot(held, held) / steps_.stick(tau);
  }

  void note(Regime to, const SubIncrement& last) noexcept {
    if (to == regime_) return;
    regime_ = to;
    if (to == Regime::kSlip) onset_ = tau_;
    if (changes_ == nullptr) return;
    if (changes_->count == static_cast<int>(changes_->at.size())) {
      changes_->overflow = true;
      return;
    }
    const SlipVector y = to == Regime::kOpen ? SlipVector{} : steps_.force(at_, tau_, 0.0);
    double force = value(steps_.potential(), y);
    if (definition_.slip.dimension == 1) force = std::copysign(force, last.force[0]);
    changes_->at[static_cast<std::size_t>(changes_->count++)] = {
        tau_ > kSoon ? tau_ : 0.0, to, force, steps_.limit(tau_, at_, 0.0).force,
        at_.accumulated_slip};
  }

  const FrictionDefinition& definition_;
  SubIncrements steps_;
  double tolerance_;
  double begin_slip_;
  double scale_ = 0.0;    ///< of the limit [F]
  double elastic_ = 0.0;  ///< of the elastic slip [L]
  double first_ = 0.0;    ///< length of a first piece of slip
  SlipPoint at_;
  double tau_ = 0.0;
  double rate_ = 0.0;
  double work_ = 0.0;
  double dissipation_ = 0.0;
  double onset_ = 0.0;
  double slipped_until_ = 0.0;
  SlipVector normal_{};
  double snap_back_ = 0.0;
  double lost_ = 0.0;
  double jump_onset_ = 0.0;
  int jumps_ = 0;
  bool converged_ = true;
  bool negative_ = false;  ///< F_C + F_int
  Regime regime_;
  RegimeChanges* changes_;
};

}  // namespace

FrictionUpdate extrapolated_update(const FrictionDefinition& definition, const PathSegment& segment,
                                   const FrictionState& old, double tolerance,
                                   RegimeChanges* changes) noexcept {
  Pieces pieces(definition, segment, tolerance, old, changes);
  pieces.run();
  return pieces.result(update(definition, segment.increment, old));
}

}  // namespace slipbench::law
