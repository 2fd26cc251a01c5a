// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Belt friction: a thin flexible belt wrapped around a guide, and the slip ring built on it.
///
/// Formula   Flow a -> b -> c: f_bc = f_ab e^A; opposite flow: f_bc = f_ab e^(-A), A = mu alpha. So
///           the friction force f = f_bc - f_ab lies in [T (e^(-A) - 1), T (e^A - 1)], T = f_ab.
///           Elastic stick: df = k dPsi inside that band.
/// Symbols   f_ab, f_bc tensions before and behind the guide b [F], f friction force [F], mu
///           coefficient [1], alpha wrap angle [1], any size, Psi material flow at b [L], k stick
///           stiffness [F/L], D dissipation [F L].
/// Sign      Psi grows with flow from a to c; f has the sign of the slip it resists.
/// Source    Euler 1769; Eytelwein 1808; docs/theory, section 4.1.
/// Range     mu, alpha >= 0. A slack belt (T <= 0) has no friction. Exact where flow and tension
///           are linear between rows; while the band is empty no slip is accumulated.
namespace slipbench::reference::capstan {

/// The friction forces [F] at which a belt of tension T [F] on its a-side slips.
struct Band {
  double lower;  ///< flow from c to a, -T (1 - e^(-A)) <= 0
  double upper;  ///< flow from a to c, T (e^A - 1) >= 0
};

/// The band for the exponent A = mu alpha [1]; both ends are 0 for a slack belt. expm1 keeps the
/// digits of a small A.
inline Band band(double exponent, double tension) {
  if (!(tension > 0.0)) return {0.0, 0.0};
  return {tension * std::expm1(-exponent), tension * std::expm1(exponent)};
}

/// The tension f_ab [F] that a given f_bc >= 0 [F] needs for slip with the flow a -> b -> c
/// (sense > 0) or against it (sense < 0).
inline double tension_before(double exponent, double tension_bc, double sense) {
  return tension_bc * std::exp(sense > 0.0 ? -exponent : exponent);
}

/// ln(f_bc/f_ab) [1] of two positive tensions [F]; log1p keeps the digits of a small difference.
inline double mobilised_exponent(double tension_ab, double tension_bc) {
  return std::log1p((tension_bc - tension_ab) / tension_ab);
}

/// Tells whether two given tensions [F] stick on a guide of exponent A: |ln(f_bc/f_ab)| < A. A belt
/// slack on either side never does.
inline bool sticks(double exponent, double tension_ab, double tension_bc) {
  if (!(tension_ab > 0.0) || !(tension_bc > 0.0)) return false;
  return std::abs(mobilised_exponent(tension_ab, tension_bc)) < exponent;
}

using Position = std::array<double, 3>;

/// The wrap angle [1] between the prolonged segment ab and the segment bc, 0 .. pi, from three node
/// positions [L] of which neighbours must differ. atan2 is accurate at both ends of the range.
inline double wrap_angle(const Position& a, const Position& b, const Position& c) {
  const Position before{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Position behind{c[0] - b[0], c[1] - b[1], c[2] - b[2]};
  const double dot = before[0] * behind[0] + before[1] * behind[1] + before[2] * behind[2];
  const double cross = std::hypot(before[1] * behind[2] - before[2] * behind[1],
                                  before[2] * behind[0] - before[0] * behind[2],
                                  before[0] * behind[1] - before[1] * behind[0]);
  return std::atan2(cross, dot);
}

struct Ring {
  double exponent;         ///< A = mu alpha [1], >= 0
  double stick_stiffness;  ///< k [F/L], > 0
};

struct State {
  double flow = 0.0;              ///< Psi [L]
  double tension = 0.0;           ///< T = f_ab [F]
  double force = 0.0;             ///< f = f_bc - f_ab [F]
  double accumulated_slip = 0.0;  ///< [L]
  double dissipation = 0.0;       ///< integral of |limit| over slip [F L]
  double work = 0.0;              ///< integral of f dPsi [F L]
};

/// The ring after a piece over which flow and tension are linear and the tension is never negative.
///
/// Where the force begins to follow an end of the band it follows it to the end of the piece, for
/// predictor and limit both go on straight.
inline State advance_taut(const Ring& ring, const State& begin, double flow, double tension) {
  State end = begin;
  end.flow = flow;
  end.tension = tension;
  if (ring.exponent == 0.0) return end;
  const double k = ring.stick_stiffness;
  const double travel = flow - begin.flow;
  const double predictor = begin.force + k * travel;
  const Band old_band = band(ring.exponent, begin.tension);
  const Band new_band = band(ring.exponent, tension);
  const bool forward = predictor > new_band.upper;
  if (!forward && predictor >= new_band.lower) {
    end.force = predictor;
    end.work += 0.5 * (begin.force + end.force) * travel;
    return end;
  }
  const double old_limit = forward ? old_band.upper : old_band.lower;
  end.force = forward ? new_band.upper : new_band.lower;
  const double onset = (old_limit - begin.force) / (k * travel - (end.force - old_limit));
  const double onset_force = old_limit + onset * (end.force - old_limit);
  const double slip = std::abs(predictor - end.force) / k;
  end.accumulated_slip += slip;
  end.dissipation += 0.5 * std::abs(onset_force + end.force) * slip;
  end.work += 0.5 * (begin.force + onset_force) * onset * travel +
              0.5 * (onset_force + end.force) * (1.0 - onset) * travel;
  return end;
}

/// The ring after a piece over which flow and tension are linear; it may go slack or taut on the
/// way, and where it goes taut it sticks anew, without force.
inline State advance(const Ring& ring, const State& begin, double flow, double tension) {
  State state = begin;
  const bool was_taut = begin.tension > 0.0;
  const bool is_taut = tension > 0.0;
  if (was_taut != is_taut) {
    const double crossing = begin.tension / (begin.tension - tension);
    const double crossing_flow = begin.flow + crossing * (flow - begin.flow);
    if (was_taut) state = advance_taut(ring, state, crossing_flow, 0.0);
    state.flow = crossing_flow;
    state.tension = 0.0;
  }
  if (is_taut) return advance_taut(ring, state, flow, tension);
  state.flow = flow;
  state.tension = tension;
  return state;  // with no force: the band closed on the way
}

inline constexpr Parameter kMu{
    .name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0};
inline constexpr Parameter kWrapAngle{.name = "wrap_angle",
                                      .dimension = "1",
                                      .text = "angle of contact in radians, of any size",
                                      .lower = 0.0};
inline constexpr Signal kTension{"tension", "F", "tension on the a-side; none or less is slack"};

inline constexpr std::array kParameters{
    kMu, kWrapAngle,
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking belt against material flow",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{Signal{"flow", "L", "material flow at the guide, a to c"},
                                    kTension};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force f_bc - f_ab"},
    Signal{"tension_bc", "F", "tension on the c-side"},
    Signal{"upper_limit", "F", "friction force at which the belt slips from a to c"},
    Signal{"lower_limit", "F", "friction force at which it slips from c to a, not positive"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of the limit's magnitude over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of the friction force over flow"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Ring ring{values[0][0] * values[1][0], values[2][0]};
  return [ring, state = State{}, started = false](std::span<const double> inputs,
                                                  std::span<double> outputs) mutable {
    if (started) {
      state = advance(ring, state, inputs[0], inputs[1]);
    } else {
      state.flow = inputs[0];
      state.tension = inputs[1];
    }
    started = true;
    const Band limits = band(ring.exponent, state.tension);
    outputs[0] = state.force;
    outputs[1] = state.tension + state.force;
    outputs[2] = limits.upper;
    outputs[3] = limits.lower;
    outputs[4] = state.accumulated_slip;
    outputs[5] = state.dissipation;
    outputs[6] = 0.5 * state.force * state.force / ring.stick_stiffness;
    outputs[7] = state.work;
  };
}

inline constexpr ClosedForm kForm{
    .name = "capstan",
    .title = "Slip ring: elastic stick and capstan friction in both directions of flow",
    .formula = "df = k dPsi within T (e^(-mu alpha) - 1) <= f <= T (e^(mu alpha) - 1); T <= 0: 0",
    .source = "Euler 1769; Eytelwein 1808",
    .range = "mu, alpha >= 0; k > 0; flow and tension linear between rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

/// Outputs of every steady belt law of this family for one tension.
inline constexpr std::array kBandOutputs{
    Signal{"upper_limit", "F", "friction force f_bc - f_ab of slip from a to c"},
    Signal{"lower_limit", "F", "friction force of slip from c to a, not positive"},
    Signal{"rising_tension", "F", "tension on the c-side in slip from a to c"},
    Signal{"falling_tension", "F", "tension on the c-side in slip from c to a"},
    Signal{"exponent", "1", "logarithm of the ratio of the tensions that friction bears"}};

/// Fills kBandOutputs for the exponent A [1] and a tension [F] of which `carried` [F] does not
/// press on the guide.
inline void write_band(double exponent, double tension, double carried, std::span<double> outputs) {
  const Band limits = band(exponent, tension - carried);
  outputs[0] = limits.upper;
  outputs[1] = limits.lower;
  outputs[2] = tension + limits.upper;
  outputs[3] = tension + limits.lower;
  outputs[4] = exponent;
}

inline constexpr std::array kBandInputs{
    kTension, Signal{"mu", "1", "friction coefficient, such as a coefficient law's result"},
    Signal{"wrap_angle", "1", "angle of contact in radians, of any size"}};

inline PathEvaluator make_band(std::span<const std::vector<double>>) {
  return [](std::span<const double> inputs, std::span<double> outputs) {
    write_band(inputs[1] * inputs[2], inputs[0], 0.0, outputs);
  };
}

inline constexpr ClosedForm kBandForm{
    .name = "capstan_band",
    .title = "Limits of capstan friction where coefficient, wrap angle and tension vary",
    .formula = "f = T (e^(mu alpha) - 1) or T (e^(-mu alpha) - 1); T <= 0: 0",
    .source = "Euler 1769; Eytelwein 1808",
    .range = "mu, alpha >= 0; each row by itself, steady slip",
    .parameters = {},
    .inputs = kBandInputs,
    .outputs = kBandOutputs,
    .make = make_band,
    .violation = no_violation};

inline constexpr std::array kStatusParameters{kMu, kWrapAngle};
inline constexpr std::array kStatusInputs{Signal{"tension_ab", "F", "tension on the a-side"},
                                          Signal{"tension_bc", "F", "tension on the c-side"}};
inline constexpr std::array kStatusOutputs{
    Signal{"sticks", "1", "1 if friction can hold the two tensions, else 0"},
    Signal{"exponent", "1", "ln(f_bc/f_ab), of the sign of the slip; 0 if either side is slack"}};

inline PathEvaluator make_status(std::span<const std::vector<double>> values) {
  const double exponent = values[0][0] * values[1][0];
  return [exponent](std::span<const double> inputs, std::span<double> outputs) {
    const bool taut = inputs[0] > 0.0 && inputs[1] > 0.0;
    outputs[0] = sticks(exponent, inputs[0], inputs[1]) ? 1.0 : 0.0;
    outputs[1] = taut ? mobilised_exponent(inputs[0], inputs[1]) : 0.0;
  };
}

inline constexpr ClosedForm kStatusForm{
    .name = "capstan_status",
    .title = "Whether two given tensions stick on a guide",
    .formula = "stick if |ln(f_bc/f_ab)| < mu alpha",
    .source = "Euler 1769; Eytelwein 1808",
    .range = "mu, alpha >= 0; a belt slack on either side does not stick",
    .parameters = kStatusParameters,
    .inputs = kStatusInputs,
    .outputs = kStatusOutputs,
    .make = make_status,
    .violation = no_violation};

inline constexpr std::array kWrapAngleInputs{Signal{"xa", "L", "position of node a along x"},
                                             Signal{"ya", "L", "along y"},
                                             Signal{"za", "L", "along z"},
                                             Signal{"xb", "L", "position of the guide b"},
                                             Signal{"yb", "L", "along y"},
                                             Signal{"zb", "L", "along z"},
                                             Signal{"xc", "L", "position of node c along x"},
                                             Signal{"yc", "L", "along y"},
                                             Signal{"zc", "L", "along z"}};
inline constexpr std::array kWrapAngleOutputs{
    Signal{"wrap_angle", "1", "angle between the prolonged segment ab and the segment bc"}};

inline PathEvaluator make_wrap_angle(std::span<const std::vector<double>>) {
  return [](std::span<const double> x, std::span<double> outputs) {
    outputs[0] = wrap_angle({x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]});
  };
}

inline constexpr ClosedForm kWrapAngleForm{
    .name = "wrap_angle",
    .title = "Wrap angle of a slip ring from the positions of its three nodes",
    .formula = "alpha = atan2(|ab x bc|, ab . bc)",
    .source = "docs/theory, section 4.1",
    .range = "0 .. pi; each row by itself",
    .parameters = {},
    .inputs = kWrapAngleInputs,
    .outputs = kWrapAngleOutputs,
    .make = make_wrap_angle,
    .violation = no_violation};

}  // namespace slipbench::reference::capstan
