// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "law/component/kinetic_force.hpp"
#include "law/definition/capstan_limit.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/increment.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {

/// One increment as a straight piece of the history: motion, constraint forces, temperature, fields
/// and whatever changes in the friction itself go linearly from its begin to its end.
struct PathSegment {
  ConnectorIncrement increment;   ///< the end, the duration, and the position at the begin
  Ambient begin;                  ///< CP, CCU, temperature, fields at the begin
  ConnectorForce begin_force;     ///< constraint forces at the begin, after a jump there
  CoefficientBlend begin_blend;   ///< of the definition, at the begin
  double begin_stick = 1.0;       ///< allowable elastic slip at the begin [L], if there is one
  double begin_wrap_angle = 0.0;  ///< of a Capstan, at the begin
  /// Of a definition whose contact force names free components (`kinetic->pressing`), or an elastic
  /// belt, else null: what presses there. Their forces do not go straight: `begin_force` and
  /// `increment.force` are but those of the ends. The velocity is that of the segment; tables over
  /// the displacement turn at their knots.
  const KineticBehavior* kinetic = nullptr;
  /// Reference lengths of a belt at both ends, 0 where none is known [L]. They and the distance CP1
  /// go straight; their strain, the constitutive motion of component 1, is a quotient and does not.
  double begin_length = 0.0;
  double end_length = 0.0;
};

/// A segment on which nothing of the definition changes: begin_* are those of `definition`.
inline PathSegment path_segment(const FrictionDefinition& definition,
                                const ConnectorIncrement& increment, const Ambient& begin,
                                const ConnectorForce& begin_force) {
  const auto* belt = std::get_if<Capstan>(&definition.criterion);
  return {increment,
          begin,
          begin_force,
          definition.blend,
          definition.stick.value,
          belt != nullptr ? belt->wrap_angle : 0.0,
          nullptr};
}

/// The points of a segment at the fraction tau in [0, 1]; refers to `definition` and `segment`, and
/// keeps the fields of the last point asked for.
class SegmentPoints {
 public:
  SegmentPoints(const FrictionDefinition& definition, const PathSegment& segment, double motion)
      : definition_(definition), segment_(segment), motion_(motion), here_(segment.increment) {
    here_.end.fields = std::span(fields_).first(segment.increment.end.fields.size());
    if (const auto* belt = std::get_if<Capstan>(&definition.criterion)) {
      end_wrap_angle_ = belt->wrap_angle;
    }
  }
  SegmentPoints(const SegmentPoints&) = delete;
  SegmentPoints& operator=(const SegmentPoints&) = delete;

  /// Returns what is prescribed at tau, as the end of an increment from the begin; its duration is
  /// the whole segment's.
  const ConnectorIncrement& increment(double tau) noexcept {
    const ConnectorIncrement& to = segment_.increment;
    if (tau == tau_) return here_;
    tau_ = tau;
    const auto mix = [tau](double a, double b) { return a == b ? b : (1.0 - tau) * a + tau * b; };
    for (int c = 0; c < kComponents; ++c) {
      here_.end.position[c] = mix(segment_.begin.position[c], to.end.position[c]);
      here_.end.motion[c] = mix(segment_.begin.motion[c], to.end.motion[c]);
      here_.force[c] = mix(segment_.begin_force[c], to.force[c]);
    }
    here_.end.temperature = mix(segment_.begin.temperature, to.end.temperature);
    for (std::size_t i = 0; i < to.end.fields.size(); ++i) {
      fields_[i] = mix(segment_.begin.fields[i], to.end.fields[i]);
    }
    if (segment_.end_length > 0.0) {
      // From the elongations of the ends: a small strain keeps its digits.
      here_.end.motion[0] = mix(segment_.begin.position[0] - segment_.begin_length,
                                to.end.position[0] - segment_.end_length) /
                            mix(segment_.begin_length, segment_.end_length);
    }
    if (segment_.kinetic != nullptr) press();
    return here_;
  }

  /// The limit at tau, with a total accumulated slip [L] and a slip rate [L/T] that counts where
  /// the coefficient sees the slip. A belt's is that of the side `sense` (the sign of s_el).
  Limit limit(double tau, double accumulated_slip, double slip_rate, double sense) noexcept {
    // A change that ends here has forgotten what it set out from; it does not matter at its end.
    const CoefficientBlend& from = segment_.begin_blend;
    const CoefficientBlend blend{from.weight == 1.0 ? definition_.blend.start : from.start,
                                 mix(tau, from.weight, definition_.blend.weight)};
    const ConnectorIncrement& at = increment(tau);
    if (std::holds_alternative<Capstan>(definition_.criterion)) {
      const CapstanLimit limit(definition_, at, motion_, flow_sense(sense));
      return limit.at(rate(limit.rate(0.0), slip_rate), blend,
                      mix(tau, segment_.begin_wrap_angle, end_wrap_angle_));
    }
    FrictionState state;
    state.accumulated_slip = accumulated_slip;
    const LimitFunction limit(definition_, at, state, motion_);
    return limit.at(0.0, rate(limit.rate(0.0), slip_rate), blend);
  }

  /// Returns the next total accumulated slip behind `slip`, up to `end`, at which the limit over
  /// the slip at tau has a kink or changes its curvature, its cap apart (LimitFunction::next_knot);
  /// infinity, or something behind `end`, if there is none [L]. A knot within rounding of `slip` is
  /// a rounding behind it, so that a walk from knot to knot goes on.
  double next_knot(double tau, double slip, double end) noexcept {
    FrictionState state;
    state.accumulated_slip = slip;
    const double ahead =
        LimitFunction(definition_, increment(tau), state, motion_).next_knot(0.0, end - slip);
    return slip + std::max(ahead, std::numeric_limits<double>::epsilon() * end);
  }

  /// Returns the force of `limit` before the cap [F].
  double uncapped(const Limit& limit, double tau, double sense) const {
    if (!std::holds_alternative<Capstan>(definition_.criterion)) {
      return limit.mu * limit.normal_force;
    }
    const double wrap_angle = mix(tau, segment_.begin_wrap_angle, end_wrap_angle_);
    return limit.normal_force * capstan_limit(limit.mu * wrap_angle, flow_sense(sense));
  }

  /// The tau asked for last.
  double at() const { return tau_; }
  /// StickStiffness::value at tau: a stiffness is that of the whole segment.
  double stick(double tau) const {
    if (definition_.stick.mode == StickStiffness::Mode::kStiffness) return definition_.stick.value;
    return mix(tau, segment_.begin_stick, definition_.stick.value);
  }

 private:
  /// The forces of the free components that press, at the point: CEF of its displacements, and CVF
  /// of the velocity of the whole segment.
  void press() noexcept {
    for (int c = 0; c < kComponents; ++c) {
      if (!segment_.kinetic->pressing.contains(c)) continue;
      const double velocity = mean_velocity(segment_.increment, c);
      here_.force[c] = kinetic_force(*segment_.kinetic, c, velocity, here_.end);
    }
  }
  static FlowSense flow_sense(double sense) {
    return sense < 0.0 ? FlowSense::kBackward : FlowSense::kForward;
  }
  static double mix(double tau, double a, double b) {
    return a == b ? b : (1.0 - tau) * a + tau * b;
  }
  double rate(double of_motion, double of_slip) const {
    return definition_.slip_rate == SlipRateMeasure::kSlip ? of_slip : of_motion;
  }

  const FrictionDefinition& definition_;
  const PathSegment& segment_;
  double motion_;
  ConnectorIncrement here_;
  std::array<double, kMaxFields> fields_{};
  double end_wrap_angle_ = 0.0;
  double tau_ = -1.0;
};

}  // namespace slipbench::law
