// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// An elastic belt on a guide, pulled at one end against a constant tension at the other: slip
/// begins at the pulled end and spreads around the guide.
///
/// Formula   From uniform tension: x = C [T - T0 - T0 ln(T/T0)], C = R/(mu EA), sign(x) = sign
///           (T - T0). After a reversal at (x_r, T_r): |x - x_r| = C (sqrt(T_r) - sqrt(T))^2.
///           All of it slips at T = T0 e^(+-mu alpha).
/// Symbols   x travel of the pulled end [L], T its tension [F], T0 tension of the far end [F], R
///           radius [L], EA axial stiffness of the belt [F], mu coefficient [1], alpha wrap angle
///           [1], theta angle from the far end [1].
/// Sign      x grows as the end is pulled out.
/// Source    derived in docs/theory; creep of elastic belts: Reynolds 1874; memory: Masing 1926.
/// Range     mu, alpha, R, EA, T0 > 0; no bending stiffness, no mass, small strain. Exact where the
///           turning points of the travel are rows.
namespace slipbench::reference::elastic_belt {

struct Belt {
  double mu;               ///< [1], > 0
  double wrap_angle;       ///< alpha [1], > 0
  double radius;           ///< R [L], > 0
  double axial_stiffness;  ///< EA [F], > 0
  double far_tension;      ///< T0 [F], > 0
};

/// C = R/(mu EA) [L/F].
inline double compliance(const Belt& belt) {
  return belt.radius / (belt.mu * belt.axial_stiffness);
}

/// T0 e^(mu alpha) [F], the tension at which all of the belt is pulled out.
inline double highest_tension(const Belt& belt) {
  return belt.far_tension * std::exp(belt.mu * belt.wrap_angle);
}

/// T0 e^(-mu alpha) [F], the tension at which all of the belt is drawn in.
inline double lowest_tension(const Belt& belt) {
  return belt.far_tension * std::exp(-belt.mu * belt.wrap_angle);
}

/// Travel [L] back from the reversal out of full slip to the tension T [F] of the pulled end,
/// between the lowest and the highest.
inline double reversal_travel(const Belt& belt, double tension) {
  const double fall = std::sqrt(highest_tension(belt)) - std::sqrt(tension);
  return compliance(belt) * fall * fall;
}

/// Angle theta_s [1] from the far end beyond which the belt has reversed its slip, by then.
inline double reversal_front(const Belt& belt, double tension) {
  return 0.5 * (belt.wrap_angle + std::log(tension / belt.far_tension) / belt.mu);
}

/// Travel [L] from full slip one way to full slip the other way: 4 R T0/(mu EA) sinh^2(mu alpha/2).
inline double full_reversal_travel(const Belt& belt) {
  const double s = std::sinh(0.5 * belt.mu * belt.wrap_angle);
  return 4.0 * compliance(belt) * belt.far_tension * s * s;
}

/// Energy [F L] of the closed loop that only just reverses all of the belt at both ends: (C/3)
/// (sqrt(T_max) + sqrt(T_min)) (sqrt(T_max) - sqrt(T_min))^3.
inline double reversal_loop_energy(const Belt& belt) {
  const double high = std::sqrt(highest_tension(belt));
  const double low = std::sqrt(lowest_tension(belt));
  const double fall = high - low;
  return compliance(belt) / 3.0 * (high + low) * fall * fall * fall;
}

/// Returns how far [F] a ring with one straight stick line over the same reversal lies above the
/// belt, at worst: sqrt(T_max) (sqrt(T_max) - sqrt(T_min))/2, after a quarter of the travel.
inline double straight_line_error(const Belt& belt) {
  const double high = std::sqrt(highest_tension(belt));
  return 0.5 * high * (high - std::sqrt(lowest_tension(belt)));
}

/// e^y - 1 - y >= 0, without cancellation near 0.
inline double exponential_remainder(double y) {
  if (std::abs(y) > 0.3) return std::expm1(y) - y;
  double term = 0.5 * y * y;
  double sum = term;
  for (int n = 3; n <= 16; ++n) {
    term *= y / n;
    sum += term;
  }
  return sum;
}

/// The y of the wanted sign with e^y - 1 - y = c >= 0 (both are branches of Lambert's W).
///
/// Newton on a convex function: from beyond the root it comes down to it without overshooting, from
/// before the root the first step leads beyond. For y > 0 the start is beyond, since e^y - 1 - y is
/// above y^2/2 and, from y = 1.3 on, above (e^y - 1)/2; a start far before could overflow there.
inline double inverse_exponential_remainder(double c, bool positive) {
  if (c == 0.0) return 0.0;
  const double parabola = std::sqrt(2.0 * c);
  double y = positive ? std::min(parabola, std::max(1.3, std::log1p(2.0 * c))) : -parabola;
  for (int i = 0; i < 60; ++i) {
    const double step = (exponential_remainder(y) - c) / std::expm1(y);
    y -= step;
    if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(y)) break;
  }
  return y;
}

/// Any path of the pulled end from uniform tension.
///
/// The square root of the tension plays the part that force plays in Masing's rule: a branch
/// depends on its turning point only, ends at the turning point before, and then both are
/// forgotten. The first branch ends where the virgin curve is met on the other side, at T0^2/T_r.
/// Full slip moves the far end and leaves the state at the end of the virgin curve.
class Path {
 public:
  explicit Path(const Belt& belt) : belt_(belt), tension_(belt.far_tension) {}

  [[nodiscard]] double tension() const { return tension_; }
  [[nodiscard]] double far_motion() const { return far_motion_; }
  [[nodiscard]] double work() const { return work_; }

  /// Straight on to the travel x [L].
  void advance(double travel) {
    const double last = travel_;
    travel_ = travel;
    if (travel == last) return;
    const double sense = travel > last ? 1.0 : -1.0;
    if (sense_ != 0.0 && sense != sense_) turns_.push_back({stretch_, tension_});
    sense_ = sense;
    double stretch = travel - far_motion_;
    while (!turns_.empty() && sense * (stretch - end_of_branch().stretch) >= 0.0) {
      follow(end_of_branch().stretch, end_of_branch().tension);
      turns_.pop_back();
      if (!turns_.empty()) turns_.pop_back();
    }
    const double full = virgin_stretch(sense * belt_.mu * belt_.wrap_angle);
    const double excess = sense * (stretch - full);
    if (turns_.empty() && excess >= 0.0) {
      const double end = belt_.far_tension * std::exp(sense * belt_.mu * belt_.wrap_angle);
      follow(full, end);
      far_motion_ = travel - full;
      work_ += sense * excess * end;
      return;
    }
    follow(stretch, tension_on_branch(stretch));
  }

  /// Angle [1] at the pulled end over which the belt slips in the present direction.
  [[nodiscard]] double slip_angle() const {
    if (turns_.empty()) return std::abs(std::log(tension_ / belt_.far_tension)) / belt_.mu;
    return 0.5 * std::abs(std::log(tension_ / turns_.back().tension)) / belt_.mu;
  }

  /// Elastic energy of the belt on the guide [F L], over that of the uniform tension T0: pieces of
  /// exponential tension, whose ends are the geometric means of successive turning points.
  [[nodiscard]] double stored_energy() const {
    const double t0 = belt_.far_tension;
    double sum = 0.0;
    double near = tension_;
    double outer = tension_;
    for (std::size_t i = turns_.size(); i-- > 0;) {
      const double far = std::sqrt(outer * turns_[i].tension);
      sum += std::abs((near - far) * (near + far));
      near = far;
      outer = turns_[i].tension;
    }
    sum += std::abs((near - t0) * (near + t0));
    const double slipped = std::abs(std::log(outer / t0)) / belt_.mu;
    return 0.25 * compliance(belt_) * sum -
           0.5 * slipped * belt_.radius * t0 * t0 / belt_.axial_stiffness;
  }

  /// Energy turned into heat between belt and guide [F L]: what the two ends put in and the belt
  /// does not hold.
  [[nodiscard]] double dissipation() const {
    return work_ - belt_.far_tension * far_motion_ - stored_energy();
  }

 private:
  struct Turn {
    double stretch;
    double tension;
  };

  /// Stretch [L] of the virgin curve at ln(T/T0) = y.
  [[nodiscard]] double virgin_stretch(double y) const {
    return std::copysign(compliance(belt_) * belt_.far_tension * exponential_remainder(y), y);
  }

  [[nodiscard]] Turn end_of_branch() const {
    if (turns_.size() > 1) return turns_[turns_.size() - 2];
    const double y = -std::log(turns_.front().tension / belt_.far_tension);
    return {virgin_stretch(y), belt_.far_tension * std::exp(y)};
  }

  [[nodiscard]] double tension_on_branch(double stretch) const {
    const double c = compliance(belt_);
    if (turns_.empty()) {
      const double y =
          inverse_exponential_remainder(std::abs(stretch) / (c * belt_.far_tension), stretch > 0.0);
      return belt_.far_tension * std::exp(y);
    }
    const Turn& turn = turns_.back();
    const double step = std::sqrt(std::abs(stretch - turn.stretch) / c);
    const double root = std::sqrt(turn.tension) + sense_ * step;
    return root * root;
  }

  /// Along the present branch to its point (stretch, tension), with the integral of T dx.
  void follow(double stretch, double tension) {
    const double c = compliance(belt_);
    if (turns_.empty()) {
      const double t0 = belt_.far_tension;
      const auto primitive = [&](double t) { return std::abs(t - t0) * (t - t0); };
      // x = +-C (T - T0 - T0 ln(T/T0)), so T dx = +-C (T - T0) dT
      work_ += 0.5 * c * (primitive(tension) - primitive(tension_));
    } else {
      const double root = std::sqrt(turns_.back().tension);
      const auto primitive = [&](double t) {
        const double s = std::abs(std::sqrt(t) - root);
        return s * s * (root * root + s * (sense_ * 4.0 / 3.0 * root + 0.5 * s));
      };
      work_ += sense_ * c * (primitive(tension) - primitive(tension_));
    }
    stretch_ = stretch;
    tension_ = tension;
  }

  Belt belt_;
  double travel_ = 0.0;
  double far_motion_ = 0.0;
  double stretch_ = 0.0;  ///< travel less the far end's motion
  double tension_;
  double work_ = 0.0;
  double sense_ = 0.0;
  std::vector<Turn> turns_;
};

inline constexpr std::array kParameters{Parameter{.name = "mu",
                                                  .dimension = "1",
                                                  .text = "friction coefficient",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "wrap_angle",
                                                  .dimension = "1",
                                                  .text = "angle of contact in radians",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "radius",
                                                  .dimension = "L",
                                                  .text = "radius of the guide",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "axial_stiffness",
                                                  .dimension = "F",
                                                  .text = "EA of the belt",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "far_tension",
                                                  .dimension = "F",
                                                  .text = "constant tension of the far end",
                                                  .lower = 0.0,
                                                  .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"travel", "L", "motion of the pulled end, from uniform tension on the guide"}};
inline constexpr std::array kOutputs{
    Signal{"tension", "F", "tension of the pulled end"},
    Signal{"force", "F", "tension of the pulled end less that of the far end"},
    Signal{"slip_angle", "1", "angle at the pulled end that slips in the present direction"},
    Signal{"far_motion", "L", "motion of the far end, towards the guide"},
    Signal{"work", "F L", "integral of the pulled end's tension over its travel"},
    Signal{"stored_energy", "F L", "elastic energy on the guide over that at the start"},
    Signal{"dissipation", "F L", "energy dissipated between belt and guide"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Belt belt{values[0][0], values[1][0], values[2][0], values[3][0], values[4][0]};
  return [belt, path = Path(belt), origin = 0.0, started = false](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    if (!started) origin = inputs[0];
    started = true;
    path.advance(inputs[0] - origin);
    outputs[0] = path.tension();
    outputs[1] = path.tension() - belt.far_tension;
    outputs[2] = path.slip_angle();
    outputs[3] = path.far_motion();
    outputs[4] = path.work();
    outputs[5] = path.stored_energy();
    outputs[6] = path.dissipation();
  };
}

inline constexpr ClosedForm kForm{
    .name = "elastic_belt",
    .title = "An elastic belt pulled around a guide against a constant tension",
    .formula = "|x - x_r| = (R/(mu EA)) (sqrt(T_r) - sqrt(T))^2; full slip at T0 e^(+-mu alpha)",
    .source = "derived in docs/theory",
    .range = "mu, alpha, R, EA, T0 > 0; turning points of the travel on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::elastic_belt
