// SPDX-License-Identifier: Apache-2.0
#include "law/exact/exact_walk.hpp"

#include <cmath>

#include "law/base/quadrature.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {
namespace {

/// R^2 - |s_el|^2 as a part of R^2 that is rounding: the state is on the radius.
constexpr double kOnRadius = 64.0 * std::numeric_limits<double>::epsilon();
/// Distance ahead of an event at which it is judged what comes, as a part of what is left.
constexpr double kAhead = 1e-9;
/// Step of the difference quotients of R as a part of a smooth piece.
constexpr double kDifference = 1e-5;
/// Parts in which a smooth piece is looked at for events.
constexpr int kSamples = 16;
/// More events than a segment has: rounding goes round in circles.
constexpr int kMostEvents = 20000;

/// Tells whether the limit may depend on where the connector is.
bool depends_on_motion(const FrictionDefinition& definition) {
  if (std::holds_alternative<UniversalJointContact>(definition.contact_force)) return true;
  const auto* internal = std::get_if<TableFunction>(&definition.internal_contact_force);
  if (internal != nullptr && internal->depends_on_motion()) return true;
  const auto* derived = std::get_if<DerivedComponent>(&definition.contact_force);
  return derived != nullptr &&
         std::any_of(derived->begin(), derived->end(), [](const DerivedTerm& term) {
           return term.weight_table && term.weight_table->depends_on_motion();
         });
}

/// Tells whether nothing that the limit may depend on changes over the segment, apart from the
/// slip.
bool is_constant(const FrictionDefinition& definition, const PathSegment& segment) {
  const ConnectorIncrement& to = segment.increment;
  const auto* belt = std::get_if<Capstan>(&definition.criterion);
  return segment.begin_force == to.force && segment.begin.temperature == to.end.temperature &&
         std::equal(segment.begin.fields.begin(), segment.begin.fields.end(), to.end.fields.begin(),
                    to.end.fields.end()) &&
         segment.begin_blend.weight == definition.blend.weight &&
         (definition.stick.mode == StickStiffness::Mode::kStiffness ||
          segment.begin_stick == definition.stick.value) &&
         (belt == nullptr || segment.begin_wrap_angle == belt->wrap_angle) &&
         segment.kinetic == nullptr && !depends_on_motion(definition);
}

}  // namespace

ExactWalk::ExactWalk(const FrictionDefinition& definition, const PathSegment& segment,
                     const FrictionState& old, const PlaneSlip& begin, double length, double sign,
                     double tolerance, RegimeChanges* changes) noexcept
    : definition_(definition),
      points_(definition, segment, length),
      length_(length),
      sign_(sign),
      inverse_duration_(segment.increment.duration > 0.0 ? 1.0 / segment.increment.duration : 0.0),
      tolerance_(std::max(0.1 * tolerance, 1e-14)),
      fixed_(definition.stick.mode == StickStiffness::Mode::kStiffness),
      belt_(std::holds_alternative<Capstan>(definition.criterion)),
      wears_(depends_on_accumulated_slip(definition.internal_contact_force)),
      by_rate_(definition.slip_rate == SlipRateMeasure::kSlip &&
               depends_on_slip_rate(definition.law)),
      floored_(has_floor(definition.law)),
      constant_(is_constant(definition, segment)),
      radius_rate_(fixed_ ? 0.0 : definition.stick.value - segment.begin_stick),
      begin_slip_(old.accumulated_slip),
      slip_at_(begin),
      regime_(old.regime),
      changes_(changes) {
  const double held = std::sqrt(begin.square());
  const double most_slip =
      length + held + (fixed_ ? held : std::max(points_.stick(0.0), points_.stick(1.0)));
  largest_slip_ = begin_slip_ + most_slip;
  for (const double tau : {0.0, 0.5, 1.0}) {
    const ConnectorIncrement& at = points_.increment(tau);
    contact_scale_ =
        std::max(contact_scale_, std::abs(evaluate(definition.contact_force, at.force, at.end)));
  }
  // Of all of a fit, not of what wear has left of it.
  const auto* internal = std::get_if<TableFunction>(&definition.internal_contact_force);
  contact_scale_ += internal != nullptr ? internal->table().largest()
                                        : *std::get_if<double>(&definition.internal_contact_force);
  for (const double tau : {0.0, 0.5, 1.0}) {
    const Limit l = strongest(tau);
    if (l.normal_force > 0.0) {
      force_scale_ = std::max(force_scale_, l.force / l.normal_force * contact_scale_);
    }
  }
  if (!constant_ || wears_ || by_rate_) {
    piece_.emplace(definition, segment, points_, begin_slip_, most_slip, contact_scale_);
  }
}

Limit ExactWalk::strongest(double tau) noexcept {
  const Limit at_rest = limit(tau, slip_);
  if (!by_rate_) return at_rest;
  const Limit moving = limit(tau, slip_, length_ * inverse_duration_);
  return moving.force > at_rest.force ? moving : at_rest;
}

bool ExactWalk::grips(double tau) noexcept {
  const Limit l = strongest(tau);
  return l.force > (floored_ ? 0.0 : kNoLimit * force_scale_) &&
         l.normal_force > kNoLimit * contact_scale_;
}

double ExactWalk::largest_limit(double from, double to) noexcept {
  return std::max(
      {strongest(from).force, strongest(from + 0.5 * (to - from)).force, strongest(to).force});
}

Limit ExactWalk::end_limit() noexcept {
  return limit(1.0, slip_,
               regime_ == Regime::kSlip ? slip_rate(half_angle(slip_at_).cosine_of_angle()) : 0.0);
}

void ExactWalk::note(Regime to, double tau) noexcept {
  if (to == regime_) return;
  regime_ = to;
  if (to == Regime::kSlip) onset_ = tau;
  if (changes_ == nullptr) return;
  if (changes_->count == static_cast<int>(changes_->at.size())) {
    changes_->overflow = true;
    return;
  }
  const double lim = limit(tau, slip_).force;
  const double held = std::sqrt(slip_at_.square());
  double force = to == Regime::kSlip ? lim
                 : to == Regime::kOpen
                     ? 0.0
                     : held * (fixed_ ? points_.stick(tau) : lim / points_.stick(tau));
  if (definition_.slip.dimension == 1) force *= sense();
  changes_->at[static_cast<std::size_t>(changes_->count++)] = {tau, to, force, lim,
                                                               begin_slip_ + slip_};
}

void ExactWalk::open(double tau) noexcept {
  slip_at_ = {};
  note(Regime::kOpen, tau);
}

void ExactWalk::put_on(double radius) noexcept {
  const double held = std::sqrt(slip_at_.square());
  if (!(held > 0.0)) return;
  slip_at_ = {slip_at_.along * (radius / held), slip_at_.across * (radius / held)};
}

template <class Visit>
void ExactWalk::for_each_piece(double tau, double low, double high, Visit visit) noexcept {
  while (low < high) {
    // Taken from the begin, a knot one digit ahead may be rounded back to where it is looked from.
    const double next =
        std::max(points_.next_knot(tau, begin_slip_ + low, begin_slip_ + high) - begin_slip_,
                 low + kEpsilon * (begin_slip_ + high));
    const double end = std::min(next, high);
    if (visit(low, end)) return;
    low = end;
  }
}

double ExactWalk::slip_between(double tau, double sum, double low, double high) noexcept {
  const double stick = points_.stick(tau);
  double x = low;
  for (int i = 0; i < 100; ++i) {
    const Limit l = limit(tau, x);
    const double here = x + l.force / stick - sum;
    (here > 0.0 ? high : low) = x;
    const double step = here / (1.0 + l.to_slip / stick);
    double next = x - step;
    const bool inside = next >= low && next <= high;
    if (inside && std::abs(step) <= kEpsilon * sum) return next;
    if (!(next > low && next < high)) next = low + 0.5 * (high - low);
    if (next == x || high - low <= 2.0 * kEpsilon * high) break;
    x = next;
  }
  return x;
}

double ExactWalk::rises_until(double tau, double low, double high) noexcept {
  const double stick = points_.stick(tau);
  const auto rises = [&](double x) { return 1.0 + limit(tau, x).to_slip / stick > 0.0; };
  // Slopes just inside: at its ends a piece may have those of its neighbours.
  const double margin = margin_inside(low, high, begin_slip_);
  if (!rises(low + margin)) return low;
  if (rises(high - margin)) return high;
  for (double falls = high - margin; true;) {
    const double middle = low + 0.5 * (falls - low);
    if (!(middle > low && middle < falls)) return low;
    (rises(middle) ? low : falls) = middle;
  }
}

ExactWalk::Follower ExactWalk::follow(double tau, double sum, double least) noexcept {
  if (!fixed_ || !wears_) return {sum - radius(tau, least)};
  const double stick = points_.stick(tau);
  const Limit here = limit(tau, least);
  const double beyond = least + here.force / stick - sum;
  if (!(beyond < 0.0)) {
    const double rise = 1.0 + here.to_slip / stick;
    return {rise > 0.0 ? least - beyond / rise : least};
  }
  Follower result{sum};
  for_each_piece(tau, least, sum, [&](double low, double high) {
    const double top = rises_until(tau, low, high);
    if (top + limit(tau, top).force / stick >= sum) {
      result = {slip_between(tau, sum, low, top)};
      return true;
    }
    if (top < high) result = {top, true};
    return top < high;
  });
  return result;
}

double ExactWalk::landing(double tau, double sum, double from) noexcept {
  if (!fixed_ || !wears_) return sum - radius(tau, from);
  const double stick = points_.stick(tau);
  double result = sum;
  for_each_piece(tau, from, sum, [&](double low, double high) {
    // Where the limit is gone for good the spring has nothing left to slip on.
    if (!(limit(tau, high).force > 0.0) && !(limit(tau, low + 0.5 * (high - low)).force > 0.0)) {
      result = low;
      return true;
    }
    const double top = rises_until(tau, low, high);
    for (const double end : {top, high}) {
      if (end > low && end + limit(tau, end).force / stick >= sum) {
        result = slip_between(tau, sum, low, end);
        return true;
      }
    }
    return false;
  });
  return result;
}

void ExactWalk::relax(double tau) noexcept {
  const double before = slip_at_.square();
  const double end = landing(tau, slip_ + std::sqrt(before), slip_);
  const double r = radius(tau, end);
  note(Regime::kSlip, tau);
  dissipation_ += fixed_ ? stored(before) - stored(r * r) : limit(tau, end).force * (end - slip_);
  slip_ = end;
  put_on(r);
}

void ExactWalk::jump(double tau) noexcept {
  const double before = slip_at_.square();
  const double end =
      landing(tau, slip_ + std::sqrt(before), slip_ + 2.0 * kNoLimit * largest_slip_);
  const auto force = [&](double slip) { return limit(tau, slip).force; };
  int budget = kMostPieces;
  double spent = 0.0;
  for_each_piece(tau, slip_, end, [&](double low, double high) {
    spent += integral(force, low, high, tolerance_ * force_scale_ * (high - low), &budget);
    const double steepest = largest_inside(low, high, begin_slip_,
                                           [&](double slip) { return -limit(tau, slip).to_slip; });
    snap_back_ = std::max(snap_back_, steepest / points_.stick(tau));
    return false;
  });
  const double r = radius(tau, end);
  note(Regime::kSlip, tau);
  if (jumps_++ == 0) jump_onset_ = tau;
  dissipation_ += spent;
  lost_ += stored(before) - stored(r * r) - spent;
  slip_ = end;
}

double ExactWalk::wear_ratio(double tau, double slip) noexcept {
  if (!fixed_ || !wears_) return 0.0;
  return -limit(tau, slip).to_slip / points_.stick(tau);
}

void ExactWalk::run() noexcept {
  const double held = std::sqrt(slip_at_.square());
  if (held > 0.0 && grips(0.0)) {
    if (const double r = radius(0.0, slip_); held * held - r * r > kOnRadius * r * r) relax(0.0);
  } else if (fixed_) {
    lost_ += stored(held * held);  // no slip takes what is held where there is no limit
  }
  double tau = 0.0;
  int stuck = 0;
  for (int events = 0; tau < 1.0; ++events) {
    if (events > kMostEvents || limits_ > kMostLimits) {
      converged_ = false;
      return;
    }
    const double next = advance(tau);
    // Stick and slip that hand over to each other at one place: rounding decides there.
    stuck = next - tau < kSameFraction ? stuck + 1 : 0;
    tau = stuck > 20 ? std::min(1.0, next + 10.0 * kSameFraction) : next;
  }
  if (!grips(1.0)) open(1.0);
}

double ExactWalk::advance(double tau) noexcept {
  double next = 1.0;
  if (belt_ && slip_at_.along < 0.0 && length_ > 0.0) {
    // The other side of a belt's band begins where its elastic slip passes 0.
    const double crossing = tau - slip_at_.along / length_;
    if (crossing <= tau + kSameFraction) {
      slip_at_.along = 0.0;
    } else {
      next = std::min(next, crossing);
    }
  }
  if (1.0 - next < kSameFraction) next = 1.0;
  const double end = end_at_rest(tau, next);
  const bool opens = !grips(tau);
  if (opens) {
    open(tau);
    // No limit at a corner and in the middle of what follows: none in all of it, unless slip that
    // wears F_C + F_int through 0 finds one behind.
    const auto contact_beside = [&](double part) {
      return limit(tau, slip_ + part * largest_slip_).contact_force / contact_scale_;
    };
    const double beyond = contact_beside(1e-6);
    const bool behind = fixed_ && wears_ && length_ > 0.0 && std::abs(beyond) > kNoLimit &&
                        std::signbit(beyond) != std::signbit(contact_beside(-1e-6));
    if (!behind && !grips(tau + 0.5 * (end - tau))) return end;
  }
  const bool constant = has_constant_radius(tau, end);
  const double r = radius(tau, slip_);
  bool slips = must_slip_;
  if (slips || (opens && fixed_) || r * r - slip_at_.square() <= kOnRadius * r * r) {
    put_on(r);  // where it is but for rounding, or after a jump
    // What comes decides, not what was. Below the rounding of the differences growth is none.
    const double growth = length_ * half_angle(slip_at_).cosine_of_angle() -
                          (constant ? 0.0 : radius_growth(tau, end));
    slips = slips || (!must_stick_ && growth > (constant ? 0.0 : 1e-10 * r / (end - tau)));
  }
  must_slip_ = must_stick_ = false;
  if (!slips) return stick(tau, end);
  return constant ? slip_at_constant_radius(tau, by_rate_ ? end : next)
                  : slip_at_varying_radius(tau, by_rate_ ? next : end);
}

double ExactWalk::end_at_rest(double from, double to) noexcept {
  if (!piece_) return to;
  // A coefficient over the rate: as it is at rest, and as the motion sees it.
  const double fastest = by_rate_ ? length_ * inverse_duration_ : 0.0;
  for (const double rate : {fastest, double{0.0}}) {
    const auto way = [&](double t) { return point(t, slip_, rate); };
    enter_piece(way, from, to);
    to = piece_->end_of(way, from, to, kSamples);
    if (rate == 0.0) break;
  }
  return to;
}

bool ExactWalk::has_constant_radius(double from, double to) noexcept {
  if (!fixed_) return radius_rate_ == 0.0;
  if (constant_ && !wears_) return true;
  const double first = limit(from, slip_).force;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    // Inside: at its ends a piece may have the slopes of its neighbours.
    const double tau = from + (kAhead + part * (1.0 - 2.0 * kAhead)) * (to - from);
    const Limit l = limit(tau, slip_ + kNoLimit * largest_slip_);
    if (l.force != first || l.to_slip != 0.0) return false;
  }
  return true;
}

double ExactWalk::radius_growth(double from, double to) noexcept {
  if (!fixed_) return radius_rate_;
  if (constant_) return 0.0;
  const double step = kDifference * (to - from);
  return (4.0 * radius(from + step, slip_) - 3.0 * radius(from, slip_) -
          radius(from + 2.0 * step, slip_)) /
         (2.0 * step);
}

double ExactWalk::stick(double from, double to) noexcept {
  const double end = stick_end(from, to);
  must_slip_ = end < to;
  if (!(end > from)) {
    // The force turns over in less than the rounding of tau.
    const double chord = length_ > 0.0 ? stick_length(slip_at_, radius(from, slip_)) : 0.0;
    if (chord <= kSameFraction * length_) slip_at_.along += chord;
    return end;
  }
  if (end - from > kLastingStick) note(Regime::kStick, from);
  const double before = slip_at_.along;
  const double travel = length_ * (end - from);
  if (!(travel > 0.0)) return end;
  const auto stiffness = [&](double tau) {
    return fixed_ ? definition_.stick.value : limit(tau, slip_).force / points_.stick(tau);
  };
  const double first = stiffness(from);
  work_ += first * travel * (before + 0.5 * travel);
  if (!fixed_ && !constant_) {
    const auto power = [&](double tau) {
      return (stiffness(tau) - first) * (before + length_ * (tau - from)) * length_;
    };
    int budget = kMostPieces;
    work_ += integral(power, from, end, tolerance_ * largest_limit(from, end) * travel, &budget);
  }
  slip_at_.along += travel;
  return end;
}

double ExactWalk::stick_end(double from, double to) noexcept {
  const PlaneSlip begin = slip_at_;
  if (has_constant_radius(from, to)) {
    const double end = length_ > 0.0 ? from + stick_length(begin, radius(from, slip_)) / length_
                                     : std::numeric_limits<double>::infinity();
    return std::min(end, to);
  }
  const auto reserve = [&](double tau) {
    const double r = radius(tau, slip_);
    const PlaneSlip s{begin.along + length_ * (tau - from), begin.across};
    return r * r - s.square();
  };
  constexpr int kCells = 8;
  std::array<double, kCells + 1> time;
  std::array<double, kCells + 1> value;
  for (int i = 0; i <= kCells; ++i) {
    const auto n = static_cast<std::size_t>(i);
    time[n] = i == kCells ? to : from + (to - from) * i / kCells;
    value[n] = reserve(time[n]);
    if (i == 0) continue;
    if (value[n] < 0.0) {
      double low = time[n - 1];
      if (i == 1 && !(value[0] > 4.0 * kOnRadius * begin.square())) {
        // It begins on the radius: step inside first.
        double step = 0.1 * (time[1] - from);
        while (step > kSameFraction && !(reserve(from + step) > 0.0)) step *= 0.1;
        if (step <= kSameFraction) return from;
        low = from + step;
      }
      return first_negative(reserve, low, time[n]);
    }
    // A reserve that is smallest in between may pass below 0 and come back.
    if (i >= 2 && value[n - 1] < value[n] && value[n - 1] <= value[n - 2]) {
      const double dip = lowest(reserve, time[n - 2], time[n], 0.0);
      if (reserve(dip) < 0.0 && value[n - 2] > 0.0) {
        return first_negative(reserve, time[n - 2], dip);
      }
    }
  }
  return to;
}

double ExactWalk::slip_at_constant_radius(double from, double to) noexcept {
  const double r = radius(from, slip_);
  const HalfAngle begin = half_angle(slip_at_);
  const double slip_before = slip_;
  const auto cosine = [&](double tau) {
    return turned(begin, length_ * (tau - from) / r).cosine_of_angle();
  };
  const auto way = [&](double tau) {
    return point(tau, slip_before + segment_slip(begin, length_ * (tau - from), r),
                 slip_rate(cosine(tau)));
  };
  if (piece_) {
    enter_piece(way, from, to);
    to = piece_->end_of(way, from, to, kSamples);
  }
  if (fixed_ && !(constant_ && !wears_)) {
    // Constant at rest need not be constant on the way: a small slope rounds to 0.
    for (const double part : {0.25, 0.5, 0.75}) {
      const LimitPoint at = way(from + part * (to - from));
      if (limit(at.tau, at.accumulated_slip - begin_slip_).force != limit(from, slip_).force) {
        return slip_at_varying_radius(from, to);
      }
    }
  }
  note(Regime::kSlip, from);
  const double travel = length_ * (to - from);
  const double slip = segment_slip(begin, travel, r);
  const double force = limit(from, slip_, slip_rate(cosine(from))).force;
  double spent = force * slip;
  if (!fixed_ && (!constant_ || wears_ || by_rate_)) {
    const auto power = [&](double tau) {
      const LimitPoint at = way(tau);
      return (limit(tau, at.accumulated_slip - begin_slip_, at.slip_rate).force - force) *
             cosine(tau) * length_;
    };
    const double tolerance = tolerance_ * largest_limit(from, to) * travel;
    int budget = kMostPieces;
    // The force turns within some R of path: that layer by itself, in parts that grow with it.
    double done = from;
    for (double path = r; begin.sine > 0.0 && path < 50.0 * r && from + path / length_ < to;
         path *= 2.0) {
      spent += integral(power, done, from + path / length_, tolerance, &budget);
      done = from + path / length_;
    }
    spent += integral(power, done, to, tolerance, &budget);
  }
  dissipation_ += spent;
  work_ += spent;
  slip_ += slip;
  slip_at_ = on_radius(turned(begin, travel / r), r);
  return to;
}

}  // namespace slipbench::law
