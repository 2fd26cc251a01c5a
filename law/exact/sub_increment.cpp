// SPDX-License-Identifier: Apache-2.0
#include "law/exact/sub_increment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/base/quadrature.hpp"
#include "law/update/potential_search.hpp"

namespace slipbench::law {
namespace {

/// A length of a leaf below this part of the limit is 0, and a contribution as near to it on it.
constexpr double kTouching = 1e-11;
/// A step leaves a leaf at 0 up to this part of the limit, the rounding of its search. What lets go
/// slowly shows by no more.
constexpr double kLeftAtZero = 1e-13;

/// A viscous force at rest this part of the limit beyond it has been moved there.
constexpr double kMoved = 1e-10;
/// So near behind the begin of a piece nothing is looked for.
constexpr double kSoonest = 1e-13;

/// The rate of the slip at the begin of a piece is known to this part: a piece that begins so near
/// to a corner begins on it.
constexpr double kRateSlack = 1e-6;

/// F_N below this part of F_C and F_int is the rounding of their sum, and of where it vanishes.
constexpr double kNoContact = 1e-13;

/// The norm of a slip space as a potential of one leaf.
Potential euclidean(const SlipSpace& space) {
  Potential norm;
  norm.exponent = 1.0;
  norm.parts = norm.leaves = 1;
  norm.leaf[0].kind =
      space.dimension == 1 ? PotentialLeaf::Kind::kLine : PotentialLeaf::Kind::kNorm;
  for (int i = 0; i < space.dimension; ++i) {
    norm.leaf[0].direction[static_cast<std::size_t>(i)] = 1.0;
  }
  return norm;
}

/// Work of a limit, in distances to a constant one.
constexpr long kLimit = 2;

/// The limit over the slip of one step, for the search.
struct StepLimit {
  SubIncrements& steps;
  double tau;
  const SlipPoint& begin;  ///< without the slip
  double length;           ///< of the step, as a part of the segment
  double per_rate;         ///< rate [L/T] per slip of the step [L]; 0 where the slip does not count
  const Limit* constant;

  Limit operator()(double slip) const noexcept {
    steps.count_distance();
    return constant != nullptr ? *constant
                               : steps.limit(tau, {begin.held, begin.accumulated_slip + slip},
                                             length > 0.0 ? slip / length : 0.0);
  }
  double slope(const Limit& limit) const { return limit.to_slip + limit.to_rate * per_rate; }
  double next_knot(double slip, double end) const noexcept {
    const double before = begin.accumulated_slip;
    // Taken from the begin, a knot one digit ahead may be rounded back to where it is looked from.
    return std::max(steps.next_knot(tau, before + slip, before + end) - before,
                    slip + std::numeric_limits<double>::epsilon() * (before + end));
  }
  double begin_slip() const { return begin.accumulated_slip; }
  double cap() const { return steps.cap(); }
  bool depends_on_slip() const { return constant == nullptr; }
};

}  // namespace

SubIncrements::SubIncrements(const FrictionDefinition& definition, const PathSegment& segment,
                             const FrictionState& old) noexcept
    : definition_(definition),
      norm_(euclidean(definition.slip)),
      potential_(std::get_if<Potential>(&definition.criterion)),
      motion_(motion_in(definition.slip, segment.increment)),
      length_(std::sqrt(dot(motion_, motion_))),
      points_(definition, segment, length_),
      inverse_duration_(segment.increment.duration > 0.0 ? 1.0 / segment.increment.duration : 0.0),
      fixed_(definition.stick.mode == StickStiffness::Mode::kStiffness) {
  if (potential_ == nullptr) potential_ = &norm_;
  for (const double tau : {0.0, 0.5, 1.0}) {
    const ConnectorIncrement& here = points_.increment(tau);
    contact_size_ =
        std::max(contact_size_, std::abs(evaluate(definition.contact_force, here.force, here.end)));
  }
  if (const auto* f = std::get_if<TableFunction>(&definition.internal_contact_force)) {
    contact_size_ += f->table().largest();
  }
  const double held =
      std::sqrt(dot(fixed_ ? old.force : old.elastic_slip, fixed_ ? old.force : old.elastic_slip)) /
      (fixed_ ? definition.stick.value : 1.0);
  piece_.emplace(definition, segment, points_, old.accumulated_slip,
                 2.0 * (length_ + held + (fixed_ ? 0.0 : points_.stick(1.0))), contact_size_);
  if (ends_where_contact_turns()) no_contact_ = kNoContact * contact_size_;
  least_ = value(*potential_, SlipVector{});
  // The parts of a sum of powers are searched for, and long where its exponent is near 1.
  if (potential_->combine == PotentialOperator::kSum && potential_->parts > 1 &&
      potential_->exponent != 1.0 && potential_->exponent != 2.0) {
    per_distance_ = static_cast<int>(std::clamp(4.0 / (potential_->exponent - 1.0), 8.0, 400.0));
  }
  closed_ = !fixed_ && potential_->homogeneous;
  const double half = 0.5 * potential_->exponent;
  smooth_ = potential_->combine == PotentialOperator::kSum && half == std::floor(half) &&
            potential_->leaves == potential_->parts && potential_->homogeneous;
  by_rate_ = definition.slip_rate == SlipRateMeasure::kSlip && depends_on_slip_rate(definition.law);
  viscous_ = fixed_ && by_rate_;
  const bool wears = depends_on_accumulated_slip(definition.internal_contact_force);
  may_jump_ = wears && fixed_ && !viscous_;
  varies_with_slip_ = by_rate_ || wears;
}

Limit SubIncrements::limit(double tau, const SlipPoint& at, double slip_rate) noexcept {
  work_ += kLimit;
  Limit l = points_.limit(tau, at.accumulated_slip, slip_rate * inverse_duration_, at.held.front());
  if (l.normal_force <= no_contact_) {
    l.force = l.to_contact = l.to_rate = l.to_slip = 0.0;
  }
  return l;
}

double SubIncrements::strength(double tau, double accumulated_slip) noexcept {
  const Limit rest = limit(tau, {{}, accumulated_slip}, 0.0);
  if (!by_rate_ || !potential_->homogeneous || !(rest.normal_force > 0.0)) return rest.force;
  return std::max(rest.force, limit(tau, {{}, accumulated_slip}, length_).force);
}

double SubIncrements::reserve(double tau, double accumulated_slip) noexcept {
  const Limit rest = limit(tau, {{}, accumulated_slip}, 0.0);
  const bool on_floor = rest.force > least_ && rest.mu <= kCoefficientFloor;
  return on_floor ? std::numeric_limits<double>::infinity()
                  : strength(tau, accumulated_slip) - least_;
}

bool SubIncrements::grips(double tau, double accumulated_slip, double slip_rate) noexcept {
  return limit(tau, {{}, accumulated_slip}, slip_rate).force > least_ ||
         strength(tau, accumulated_slip) > least_;
}

bool SubIncrements::is_free(double tau, double accumulated_slip, double rounding) noexcept {
  const SlipPoint here{{}, accumulated_slip};
  if (viscous_) return !(limit(tau, here, 0.0).normal_force > kTouching * contact_size_);
  return !(limit(tau, here, length_).force - least_ > rounding ||
           reserve(tau, accumulated_slip) > rounding);
}

void SubIncrements::enter(const LimitPoint& here, const LimitPoint& ahead) noexcept {
  piece_->enter(piece_->values(here), piece_->values(ahead), by_rate_ ? kRateSlack : 0.0);
}

bool SubIncrements::stays(const LimitPoint& point) noexcept {
  return piece_->reserve(piece_->values(point)) >= 0.0;
}

double SubIncrements::end_of_piece(const SlipPoint& at, double from, double to, double slip,
                                   int parts) noexcept {
  const auto way = [&](double tau) {
    SlipPoint there = at;
    there.accumulated_slip += std::max(slip, 0.0) * (tau - from) / (to - from);
    return point(tau, there, 0.0);
  };
  return piece_->end_of(way, from, to, parts);
}

bool SubIncrements::keeps_rate(const LimitPoint& end) noexcept {
  return !by_rate_ || piece_->keeps(piece_->values(end), kRateSlack);
}

SlipVector SubIncrements::force(const SlipPoint& at, double tau, double slip_rate) noexcept {
  if (fixed_) return at.held;
  return scaled(at.held, limit(tau, at, slip_rate).force / stick(tau));
}

double SubIncrements::bound(double tau, double limit) const noexcept {
  return closed_ ? stick(tau) : limit;
}
double SubIncrements::measure(const SlipPoint& at, double tau, double limit) const noexcept {
  return value(*potential_, fixed_ || closed_ ? at.held : scaled(at.held, limit / stick(tau)));
}

double SubIncrements::holds(const SlipPoint& at, double tau) noexcept {
  const double f = limit(tau, at, 0.0).force;
  const double edge = bound(tau, f);
  return edge > 0.0 ? 1.0 - measure(at, tau, f) / edge : 0.0;
}

double SubIncrements::lasts(Regime regime, const SlipPoint& at, double from, double to) noexcept {
  const SubIncrement there = step(at, from, to);
  if (there.signature.regime != regime) return -1.0;
  if (regime == Regime::kOpen) return -reserve(to, at.accumulated_slip);
  return holds(there.end, to);
}

SlipAtOnce SubIncrements::slip_at_once(double tau, double accumulated_slip, double slip) noexcept {
  const auto limit_at = [&](double at) { return limit(tau, {{}, at}, 0.0); };
  const auto force = [&](double at) { return limit_at(at).force; };
  const double end = accumulated_slip + slip;
  SlipAtOnce result;
  int budget = 1000;
  for (double low = accumulated_slip; low < end;) {
    const double high = std::min(points_.next_knot(tau, low, end), end);
    result.work += integral(force, low, high, 1e-12 * force(low) * (high - low), &budget);
    const double steepest =
        largest_inside(low, high, 0.0, [&](double at) { return -limit_at(at).to_slip; });
    result.steepest = std::max(result.steepest, steepest);
    low = high;
  }
  return result;
}

void SubIncrements::begin(const SlipPoint& at, double tau) noexcept {
  if (!viscous_) return;
  const auto is_within = [&](double to, double slack) {
    const SlipVector trial = sum_of(at.held, stick(to) * (to - tau), motion_);
    return value(*potential_, trial) <=
           limit(to, {trial, at.accumulated_slip}, 0.0).force * (1.0 + slack);
  };
  at_rest_ = is_within(tau, kTouching);
  // Something may push it on, however slowly, and for a short time only.
  for (double ahead = 0.125 * (1.0 - tau); at_rest_ && ahead > kSoonest; ahead *= 0.125) {
    at_rest_ = is_within(tau + ahead, kMoved);
  }
}

bool SubIncrements::beyond(const SlipPoint& at, double tau) noexcept {
  // A viscous force falls at once only from what no rate of such a fall holds.
  const double rate = viscous_ ? std::sqrt(dot(at.held, at.held)) / stick(tau) / kSoonest : 0.0;
  const double f = limit(tau, at, rate).force;
  return measure(at, tau, f) > bound(tau, f) * (1.0 + kTouching);
}

bool SubIncrements::can_begin(const Signature& signature, const SlipPoint& at,
                              double tau) noexcept {
  if (signature.regime != Regime::kSlip) return true;
  const double f = limit(tau, at, 0.0).force;
  const double edge = bound(tau, f);
  if (measure(at, tau, f) < edge * (1.0 - kTouching)) return false;
  const SlipVector y = fixed_ || closed_ ? at.held : scaled(at.held, f / stick(tau));
  const auto parts = contributions(*potential_, y);
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_->leaves); ++g) {
    const PotentialLeaf& leaf = potential_->leaf[g];
    const double v = coordinate(leaf, y);
    const double slack = kTouching * edge;
    switch (signature.leaf[g]) {
      case Signature::kNotPulled:
        // Of a maximum it may be any that is not the largest; of a sum, one that is 0, or whose
        // contribution is.
        if (potential_->combine == PotentialOperator::kSum &&
            parts[static_cast<std::size_t>(leaf.part)] > slack &&
            slipbench::law::length(leaf, y) > slack) {
          return false;
        }
        break;
      case Signature::kAtZero:
        // A Macauley leaf has no length below 0, and is not on it there.
        if (std::max(slipbench::law::length(leaf, y), -v) > slack) return false;
        continue;
      case Signature::kAbove:
        if (!is_smooth_at_zero(leaf) && v < -slack) return false;
        break;
      case Signature::kBelow:
        if (v > slack) return false;
        break;
    }
    if (potential_->combine == PotentialOperator::kMax &&
        signature.leaf[g] != Signature::kNotPulled &&
        parts[static_cast<std::size_t>(leaf.part)] < edge - slack) {
      return false;
    }
  }
  return true;
}

void SubIncrements::settle(Regime regime, double tau, double slip_rate, SlipPoint* point) noexcept {
  if (regime == Regime::kOpen) {
    point->held = {};
    return;
  }
  const double f = limit(tau, *point, slip_rate).force;
  const double edge = bound(tau, f);
  // A viscous force lies where the rate puts it, not the other way round.
  if (viscous_) return;
  const bool on_edge = regime == Regime::kSlip;
  if (!on_edge && measure(*point, tau, f) <= edge) return;
  if (fixed_ || closed_) {
    point->held = put_on_limit(*potential_, point->held, edge);
  } else {
    const double kappa = f / stick(tau);
    point->held = scaled(put_on_limit(*potential_, scaled(point->held, kappa), edge), 1.0 / kappa);
  }
}

SubIncrement SubIncrements::step(const SlipPoint& begin, double from, double to) noexcept {
  SubIncrement result;
  const double length = to - from;
  const double stick = points_.stick(to);
  const SlipPoint trial{sum_of(begin.held, (fixed_ ? stick : 1.0) * length, motion_),
                        begin.accumulated_slip};
  const Limit rest = limit(to, trial, 0.0);
  const bool grips = rest.force > least_ || strength(to, begin.accumulated_slip) > least_;
  result.end.accumulated_slip = begin.accumulated_slip;
  result.limit = rest;
  result.point = point(to, trial, 0.0);
  result.negative = rest.contact_force < 0.0;
  if (!grips) {
    return result;
  }
  result.signature.grips = true;
  const StepLimit limit_of{*this,
                           to,
                           trial,
                           length,
                           definition_.slip_rate == SlipRateMeasure::kSlip && length > 0.0
                               ? inverse_duration_ / length
                               : 0.0,
                           varies_with_slip_ ? nullptr : &rest};
  const Start<StepLimit> start{*potential_, limit_of, trial.held, stick, least_, fixed_, closed_};
  Scale scale = scale_at(start, rest.force);
  result.signature.regime = Regime::kStick;
  result.end.held = start.trial;
  const double slack = at_rest_ ? 1.0 + kMoved : 1.0;
  if (within(*potential_, scale.trial, slack * scale.limit)) {
    result.force = fixed_ ? start.trial : scaled(start.trial, rest.force / stick);
    result.normal = gradient(*potential_, result.force);
    return result;
  }

  const double kappa = scale.kappa > 0.0 ? scale.kappa : 1.0;
  // No force is left there; a limit that comes back behind is out of reach.
  const double end = Projection(*potential_, scale.trial).longest() / kappa;
  const SlipVector steepest = gradient(*potential_, scale.trial);
  const double radial = (value(*potential_, scale.trial) - scale.limit) /
                        (kappa * std::max(dot(steepest, steepest), 1e-300));
  // Steps that follow each other slip alike.
  const double guess = last_rate_ > 0.0 ? last_rate_ * length : radial;
  // Beyond the next knot the equilibrium is that of a jump, and there may be several.
  double slip = 0.0;
  const double knot = may_jump_ ? std::min(limit_of.next_knot(0.0, end), end) : end;
  if (knot < end && distance(start, knot).value > 0.0) {
    first_slip(start, &slip);
  } else {
    slip = bracketed(start, 0.0, knot, guess, 1e-15);
  }
  result.limit = limit_of(slip);
  result.signature.regime = Regime::kSlip;
  const auto holds = [&](const Limit& l) {
    const bool turned = (l.contact_force < 0.0) != (rest.contact_force < 0.0);
    // A coefficient that vanishes at the rate of the slip takes the force, not the contact: the
    // slip goes on without it.
    const bool touches = closed_ && by_rate_ && l.normal_force > no_contact_;
    return (l.force > least_ || touches) && !(turned && ends_where_contact_turns());
  };
  if (rest.force > least_ && !holds(result.limit)) {
    // The slip takes the limit away: where that happens.
    double low = 0.0;
    for (int i = 0; i < 200 && slip - low > 1e-16 * slip; ++i) {
      const double middle = 0.5 * (low + slip);
      (holds(limit_of(middle)) ? low : slip) = middle;
    }
    result.slip = slip;
    result.end = {{}, begin.accumulated_slip + slip};
    result.limit = limit_of(slip);
    result.signature.regime = Regime::kOpen;
    result.signature.worn = true;
    result.signature.grips = false;
    return result;
  }
  scale = scale_at(start, result.limit.force);
  const Projection projection(*potential_, scale.trial);
  const double x = scale.kappa * slip;
  const auto parts = projection.parts_on_limit(x, scale.limit);
  const SlipVector returned = put_on_limit(*potential_, projection.returned(parts), scale.limit);
  result.normal = projection.normal(parts, x);
  result.force = closed_ ? scaled(returned, result.limit.force / stick) : returned;
  result.end.held = fixed_ || closed_ ? returned : scaled(returned, stick / result.limit.force);
  result.slip = slip;
  result.end.accumulated_slip = begin.accumulated_slip + slip;
  result.slip_rate = last_rate_ = length > 0.0 ? slip / length : 0.0;
  if (fixed_) {
    const double along = stick * dot(result.normal, result.normal);
    result.snap_back = std::max(-result.limit.to_slip, 0.0) / along;
  }
  result.point = point(to, result.end, result.slip_rate);
  result.negative = result.limit.contact_force < 0.0;
  const auto left = projection.lengths_left(parts);
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_->leaves); ++g) {
    const PotentialLeaf& leaf = potential_->leaf[g];
    const double pull = parts[static_cast<std::size_t>(leaf.part)].pull;
    const double zero = kLeftAtZero * scale.limit;
    const double v = coordinate(leaf, scale.trial);
    const bool free = leaf.kind == PotentialLeaf::Kind::kHalfLine && v < -zero;
    Signature::Leaf& where = result.signature.leaf[g];
    // A leaf that nothing pulls may yet be at zero, so the order of the questions counts.
    // NOLINTNEXTLINE(bugprone-branch-clone)
    if (free || (potential_->combine == PotentialOperator::kMax && !(pull > 0.0))) {
      where = Signature::kNotPulled;
    } else if (is_smooth_at_zero(leaf)) {
      where = Signature::kAbove;
    } else if (projection.lengths()[g] - leaf.factor * pull <= zero &&
               left[g] <= kTouching * scale.limit) {
      where = Signature::kAtZero;
    } else if (!(pull > 0.0)) {
      where = Signature::kNotPulled;
    } else {
      where = v > 0.0 ? Signature::kAbove : Signature::kBelow;
    }
  }
  return result;
}

}  // namespace slipbench::law
