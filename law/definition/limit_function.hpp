// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::law {

/// Slack of the comparison |y| <= F_lim, so that a force returned to the limit and left alone does
/// not slip again by its own rounding: a state may flip at >, never at =.
inline constexpr double kLimitSlack = 1.0 + 8.0 * std::numeric_limits<double>::epsilon();

/// The limit F_lim = min(mu F_N, force_limit) at one slip of the increment, with its slopes.
struct Limit {
  double force = 0.0;          ///< F_lim [F]
  double mu = 0.0;             ///< coefficient used [1]
  double normal_force = 0.0;   ///< F_N
  double contact_force = 0.0;  ///< F_C + F_int, signed
  double slip_rate = 0.0;      ///< the rate the coefficient saw [L/T]
  double to_contact = 0.0;     ///< dF_lim/d(F_C + F_int)
  double to_rate = 0.0;        ///< dF_lim/d(slip rate)
  double to_slip = 0.0;        ///< dF_lim/d(dL) through the accumulated slip
  double wear = 0.0;           ///< dF_int/d(accumulated slip) [F/L]
};

/// Distance from the ends of a piece at which its slopes are taken: at a knot itself they may
/// belong to the neighbours. More than the rounding of its place, and less than its half.
/// \param before slip from which the places of knots count [L]
inline double margin_inside(double low, double high, double before) noexcept {
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (before + high);
  return std::min(std::max(1e-9 * (high - low), rounding), 0.25 * (high - low));
}

/// Largest value of f in a piece [low, high]: at both ends, just inside, and in the middle.
/// \param before slip from which the places of knots count [L]
template <class Function>
double largest_inside(double low, double high, double before, Function&& f) noexcept {
  const double margin = margin_inside(low, high, before);
  return std::max({f(low + margin), f(low + 0.5 * (high - low)), f(high - margin)});
}

/// F_lim as a function of the slip increment dL, all else of the increment given (theory 11.4):
/// through the slip rate, and through the internal contact force where it wears.
/// \p motion is |ds| of the increment. References are kept: it must not outlive its arguments.
class LimitFunction {
 public:
  LimitFunction(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                const FrictionState& old, double motion)
      : definition_(definition),
        increment_(increment),
        accumulated_(old.accumulated_slip),
        contact_(evaluate(definition.contact_force, increment.force, increment.end)),
        inverse_duration_(increment.duration > 0.0 ? 1.0 / increment.duration : 0.0),
        slip_in_rate_(definition.slip_rate == SlipRateMeasure::kSlip ? inverse_duration_ : 0.0),
        motion_rate_(definition.slip_rate == SlipRateMeasure::kRelativeMotion
                         ? motion * inverse_duration_
                         : 0.0),
        slip_in_wear_(definition.accumulated_slip == AccumulatedSlipTiming::kEnd ? 1.0 : 0.0) {
    // Where the slip is found by a search, a coefficient that does not see it is asked for once.
    if (slip_in_wear_ > 0.0 && depends_on_accumulated_slip(definition.internal_contact_force) &&
        !depends_on_contact_force(definition.law)) {
      sees_rate_ = depends_on_slip_rate(definition.law);
      is_steady_ = !sees_rate_ || slip_in_rate_ == 0.0;
      if (is_steady_)
        steady_ = evaluate(definition.law, increment.end, {.slip_rate = motion_rate_});
    }
  }

  Limit operator()(double slip) const noexcept { return at(slip, rate(slip)); }

  /// The rate the coefficient sees.
  double rate(double slip) const { return motion_rate_ + slip * slip_in_rate_; }

  /// The force limit; infinity if there is none.
  double cap() const { return definition_.force_limit; }

  /// Accumulated slip before the increment [L].
  double begin_slip() const { return accumulated_; }

  /// Tells whether F_lim changes with the slip of this increment at all.
  bool depends_on_slip() const {
    return (slip_in_rate_ > 0.0 && depends_on_slip_rate(definition_.law)) ||
           (slip_in_wear_ > 0.0 && depends_on_accumulated_slip(definition_.internal_contact_force));
  }

  /// The limit at any pair of slip and rate.
  Limit at(double slip, double rate) const noexcept { return at(slip, rate, definition_.blend); }
  /// The same in the middle of a change of friction.
  Limit at(double slip, double rate, const CoefficientBlend& blend) const noexcept {
    Limit limit;
    const auto internal = evaluate(definition_.internal_contact_force, increment_.end,
                                   accumulated_ + slip_in_wear_ * slip);
    limit.contact_force = contact_ + internal.value;
    limit.normal_force = std::abs(limit.contact_force);
    limit.slip_rate = rate;
    limit.wear = internal.to_accumulated_slip;
    const CoefficientPoint c = blended(blend, law_at(rate, limit.normal_force));
    limit.mu = c.mu;
    limit.force = c.mu * limit.normal_force;
    if (limit.force >= definition_.force_limit) {
      limit.force = definition_.force_limit;  // the cap is a plateau: all slopes vanish
      return limit;
    }
    const double sign = limit.contact_force < 0.0 ? -1.0 : 1.0;
    limit.to_contact = sign * (c.mu + limit.normal_force * c.to_contact_force);
    limit.to_rate = limit.normal_force * c.to_slip_rate;
    limit.to_slip = limit.to_contact * internal.to_accumulated_slip * slip_in_wear_;
    return limit;
  }

  /// dF_lim/d(dL), rate and wear together.
  double slope(const Limit& limit) const { return limit.to_rate * slip_in_rate_ + limit.to_slip; }
  /// d(rate)/d|ds|.
  double motion_in_rate() const {
    return definition_.slip_rate == SlipRateMeasure::kRelativeMotion ? inverse_duration_ : 0.0;
  }
  double motion_rate(double motion) const { return motion * inverse_duration_; }

  /// The next slip after `slip`, up to `end`, at which F_lim has a kink or changes its curvature:
  /// knots of tables over rate, accumulated slip and contact force, a change of sign of
  /// F_C + F_int, and what the law says of itself (next_bend). Between two of them F_lim is convex
  /// or concave, apart from the cubic of a table over both rate and contact force. Infinity, or
  /// something behind `end`, if there is none.
  double next_knot(double slip, double end) const noexcept {
    SlipLine line{.slip = slip,
                  .end = end,
                  .rate_at_zero = motion_rate_,
                  .rate_per_slip = slip_in_rate_,
                  .ambient = &increment_.end};
    double next = std::numeric_limits<double>::infinity();
    const auto* wear = std::get_if<TableFunction>(&definition_.internal_contact_force);
    const int s = slip_in_wear_ == 0.0 || wear == nullptr
                      ? -1
                      : wear->column_of(IndependentKind::kAccumulatedSlip);
    if (s >= 0) {
      next = first_above(wear->table().knots(s), slip, accumulated_, next);
      const auto internal =
          evaluate(definition_.internal_contact_force, increment_.end, accumulated_ + slip);
      const double force = contact_ + internal.value;
      double change = internal.to_accumulated_slip;
      // Tells whether a value moves away from 0, or stands on it but for rounding.
      const auto leaves_zero = [&](double value) {
        const double x = slip - value / change;
        if (!(value * change < 0.0) || !is_ahead(line, x)) return true;
        next = std::min(next, x);
        return false;
      };
      // A table that is prolonged below 0 stops there.
      if (leaves_zero(internal.value) && change < 0.0) change = 0.0;
      const bool grows = leaves_zero(force);
      // F_N moves one way within a piece of the wear table.
      line.force = std::abs(force);
      line.force_per_slip = grows ? std::abs(change) : -std::abs(change);
      line.end = std::min(next, end);
    } else if (slip_in_rate_ > 0.0) {
      // A constant F_N matters to the coefficient alone.
      line.force = depends_on_contact_force(definition_.law) ? contact_force_at_rest() : 1.0;
    } else {
      return next;
    }
    return std::min(next, next_bend(definition_.law, line));
  }

  /// Tells whether F_lim is cubic between knots: mu linear in the rate and in F_N, times F_N.
  bool is_cubic() const {
    const auto* law = std::get_if<TabularCoefficient>(&definition_.law);
    return law != nullptr && slip_in_rate_ > 0.0 && slip_in_wear_ > 0.0 &&
           depends_on_accumulated_slip(definition_.internal_contact_force) &&
           law->depends_on_slip_rate() && law->depends_on_contact_force();
  }

 private:
  /// The coefficient of the law at a rate and F_N.
  CoefficientPoint law_at(double rate, double normal_force) const noexcept {
    if (is_steady_ && (rate == motion_rate_ || !sees_rate_)) return steady_;
    return evaluate(definition_.law, increment_.end,
                    {.slip_rate = rate, .contact_force = normal_force});
  }

  /// F_N of an increment whose slip does not change it.
  double contact_force_at_rest() const noexcept {
    return std::abs(
        contact_ +
        evaluate(definition_.internal_contact_force, increment_.end, accumulated_).value);
  }

  /// Smallest slip > `slip` with offset + slip on a knot, at most `best`.
  static double first_above(std::span<const double> knots, double slip, double offset,
                            double best) noexcept {
    auto knot = std::upper_bound(knots.begin(), knots.end(), offset + slip);
    // A slip that stands on a knot may be rounded back before it: that knot is past.
    while (knot != knots.end() && *knot - offset <= slip) ++knot;
    return knot == knots.end() ? best : std::min(*knot - offset, best);
  }

  const FrictionDefinition& definition_;
  const ConnectorIncrement& increment_;
  double accumulated_;
  double contact_;
  double inverse_duration_;
  double slip_in_rate_;
  double motion_rate_;
  double slip_in_wear_;
  bool is_steady_ = false;  ///< whether the coefficient is the same for all slips, and known
  bool sees_rate_ = false;  ///< whether it then is of `motion_rate_` only
  CoefficientPoint steady_;
};

}  // namespace slipbench::law
