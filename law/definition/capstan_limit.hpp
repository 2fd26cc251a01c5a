// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "law/base/capstan.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {

/// One side of the stick band of a belt on a ring as a function of the slip increment dL, all else
/// of the increment given; the same shape as LimitFunction, so that the same search finds its first
/// root. The contact force is the tension T of segment ab; a slack belt (T <= 0) has no limit.
/// References are kept: it must not outlive its arguments.
class CapstanLimit {
 public:
  /// \param motion |dPsi_b| of the increment
  CapstanLimit(const FrictionDefinition& definition, const ConnectorIncrement& increment,
               double motion, FlowSense sense)
      : definition_(definition),
        increment_(increment),
        tension_(evaluate(definition.contact_force, increment.force, increment.end)),
        wrap_angle_(std::get_if<Capstan>(&definition.criterion)->wrap_angle),
        sense_(sense),
        inverse_duration_(increment.duration > 0.0 ? 1.0 / increment.duration : 0.0),
        slip_in_rate_(definition.slip_rate == SlipRateMeasure::kSlip ? inverse_duration_ : 0.0),
        motion_rate_(definition.slip_rate == SlipRateMeasure::kRelativeMotion
                         ? motion * inverse_duration_
                         : 0.0) {}

  Limit operator()(double slip) const noexcept { return at(slip, rate(slip)); }

  /// The rate the coefficient sees.
  double rate(double slip) const { return motion_rate_ + slip * slip_in_rate_; }
  /// The force limit; infinity if there is none.
  double cap() const { return definition_.force_limit; }
  /// Tells whether the limit changes with the slip of this increment at all.
  bool depends_on_slip() const {
    return slip_in_rate_ > 0.0 && depends_on_slip_rate(definition_.law);
  }

  /// The limit at a rate; the slip itself does not matter, since a belt has no wear.
  Limit at(double /*slip*/, double rate) const noexcept {
    return at(rate, definition_.blend, wrap_angle_);
  }
  /// The same in the middle of a change of friction, or of the ring's place.
  Limit at(double rate, const CoefficientBlend& blend, double wrap_angle) const noexcept {
    Limit limit;
    limit.contact_force = tension_;
    limit.normal_force = std::max(tension_, 0.0);
    limit.slip_rate = rate;
    const CoefficientPoint c =
        blended(blend, evaluate(definition_.law, increment_.end,
                                {.slip_rate = rate, .contact_force = limit.normal_force}));
    limit.mu = c.mu;
    if (!(tension_ > 0.0)) return limit;
    const double mu_alpha = c.mu * wrap_angle;
    const double part = capstan_limit(mu_alpha, sense_);
    limit.force = tension_ * part;
    if (limit.force >= definition_.force_limit) {
      limit.force = definition_.force_limit;  // the cap is a plateau: all slopes vanish
      return limit;
    }
    const double to_mu = tension_ * wrap_angle * capstan_ratio(mu_alpha, sense_);
    limit.to_contact = part + to_mu * c.to_contact_force;
    limit.to_rate = to_mu * c.to_slip_rate;
    return limit;
  }

  /// d(limit)/d(dL).
  double slope(const Limit& limit) const { return limit.to_rate * slip_in_rate_; }
  /// d(rate)/d|dPsi_b|.
  double motion_in_rate() const {
    return definition_.slip_rate == SlipRateMeasure::kRelativeMotion ? inverse_duration_ : 0.0;
  }
  double motion_rate(double motion) const { return motion * inverse_duration_; }

  /// The next slip after `slip`, up to `end`, at which the limit has a kink or changes its
  /// curvature, as the law says; infinity, or something behind `end`, if there is none.
  double next_knot(double slip, double end) const noexcept {
    if (!(slip_in_rate_ > 0.0)) return kNoBend;
    return next_belt_bend(definition_.law,
                          {.slip = slip,
                           .end = end,
                           .rate_at_zero = motion_rate_,
                           .rate_per_slip = slip_in_rate_,
                           .force = std::max(tension_, 0.0),
                           .ambient = &increment_.end},
                          definition_.blend.weight * wrap_angle_, sense_);
  }
  /// Tells whether the limit is cubic between knots.
  static constexpr bool is_cubic() { return false; }
  static constexpr double begin_slip() { return 0.0; }  ///< a belt does not wear

 private:
  const FrictionDefinition& definition_;
  const ConnectorIncrement& increment_;
  double tension_;
  double wrap_angle_;
  FlowSense sense_;
  double inverse_duration_;
  double slip_in_rate_;
  double motion_rate_;
};

}  // namespace slipbench::law
