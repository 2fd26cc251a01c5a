// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reference/closed_form.hpp"

/// One spring in series with one Coulomb slider whose normal force varies with the motion.
///
/// Formula   Stick: df = k du while |f| < mu N. Slip in the sense z = +-1: f = z mu N and ds = z du
///           - mu dN/k. Stick turns to slip when |f| meets mu N; slip turns to stick when ds would
///           become negative; N = 0 is separation: f = 0 and nothing is remembered.
/// Symbols   u motion [L], N >= 0 normal force [F], f friction force [F], k stick stiffness [F/L],
///           mu coefficient [1], s accumulated slip [L], p phase [1].
/// Sign      f has the sign of the slip it resists.
/// Source    Griffin 1980; Menq, Griffin and Bielak 1986; Yang and Menq 1998.
/// Range     k > 0, mu >= 0, N >= 0. Where u and N are both linear between rows `advance` is exact.
namespace slipbench::reference::varying_normal_force {

struct Slider {
  double mu;               ///< [1], >= 0
  double stick_stiffness;  ///< k [F/L], > 0
};

struct State {
  double motion = 0.0;            ///< u [L]
  double normal_force = 0.0;      ///< N [F]
  double force = 0.0;             ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
  double dissipation = 0.0;       ///< integral of mu N ds [F L]
  double work = 0.0;              ///< integral of f du [F L]
};

/// The slider after a piece on which motion [L] and normal force [F] both go linearly to the given
/// ends; exact. Slip, once begun, lasts to the end of the piece, for its rate is constant there.
///
/// A piece without limit at both ends is separation: no force, no slip. A negative normal force has
/// no meaning and makes the state NaN.
inline State advance(const Slider& slider, const State& begin, double motion, double normal_force) {
  State end = begin;
  end.motion = motion;
  end.normal_force = normal_force;
  if (!(normal_force >= 0.0 && begin.normal_force >= 0.0)) {
    end.force = end.accumulated_slip = end.dissipation = end.work =
        std::numeric_limits<double>::quiet_NaN();
    return end;
  }
  const double k = slider.stick_stiffness;
  const double limit0 = slider.mu * begin.normal_force;
  const double limit1 = slider.mu * normal_force;
  if (limit0 == 0.0 && limit1 == 0.0) {
    end.force = 0.0;
    return end;
  }
  const double travel = motion - begin.motion;
  const double growth = limit1 - limit0;
  // Share of the piece after which the gap to the limit in the sense z is used up.
  const auto stick_share = [&](double z) {
    const double gap = std::max(limit0 - z * begin.force, 0.0);
    const double closing = z * k * travel - growth;
    return closing > 0.0 ? gap / closing : std::numeric_limits<double>::infinity();
  };
  const double forward = stick_share(1.0);
  const double backward = stick_share(-1.0);
  const double share = std::min(forward, backward);
  if (share >= 1.0) {
    end.force = begin.force + k * travel;
    end.work += 0.5 * (begin.force + end.force) * travel;
    return end;
  }
  const double z = forward < backward ? 1.0 : -1.0;
  const double rest = 1.0 - share;
  const double onset_limit = limit0 + share * growth;
  const double slip = (z * travel - growth / k) * rest;
  end.force = z * limit1;
  end.accumulated_slip += slip;
  end.dissipation += 0.5 * (onset_limit + limit1) * slip;
  end.work += 0.5 * (begin.force + z * onset_limit) * travel * share +
              0.5 * z * (onset_limit + limit1) * travel * rest;
  return end;
}

/// Steady loop with the normal force in phase with the motion, N = N0 + g u, between -A and A.
struct InPhaseLoop {
  double top_force;       ///< at u = A: mu (N0 + g A) [F]
  double backward_onset;  ///< motion where backward slip begins [L]
  double backward_force;  ///< force there [F]
  double bottom_force;    ///< at u = -A: -mu (N0 - g A) [F]
  double forward_onset;   ///< motion where forward slip begins [L]
  double forward_force;   ///< force there [F]
  double energy;          ///< area of the quadrilateral [F L]
};

/// The loop's corners and energy (Menq, Griffin and Bielak 1986). `mean` N0 [F], `gradient` g
/// [F/L], `amplitude` A [L]. None if the loop does not slip both ways and stay in contact: wedging
/// (k <= mu |g|), A <= mu N0/k, or lift-off (N0 <= |g| A).
inline std::optional<InPhaseLoop> in_phase_loop(const Slider& slider, double mean, double gradient,
                                                double amplitude) {
  const double k = slider.stick_stiffness;
  const double mu = slider.mu;
  const double slope = mu * gradient;
  if (k <= std::abs(slope) || k * amplitude <= mu * mean ||
      mean <= std::abs(gradient) * amplitude) {
    return std::nullopt;
  }
  InPhaseLoop loop{};
  loop.top_force = mu * mean + slope * amplitude;
  loop.backward_onset = (k * amplitude - 2.0 * mu * mean - slope * amplitude) / (k + slope);
  loop.backward_force = -(mu * mean + slope * loop.backward_onset);
  loop.bottom_force = -(mu * mean - slope * amplitude);
  loop.forward_onset = (2.0 * mu * mean - slope * amplitude - k * amplitude) / (k - slope);
  loop.forward_force = mu * mean + slope * loop.forward_onset;
  const std::array<double, 4> u{amplitude, loop.backward_onset, -amplitude, loop.forward_onset};
  const std::array<double, 4> f{loop.top_force, loop.backward_force, loop.bottom_force,
                                loop.forward_force};
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t next = (i + 1) % u.size();
    loop.energy += 0.5 * (f[i] * u[next] - f[next] * u[i]);  // the loop runs clockwise
  }
  return loop;
}

/// Motion u = A sin p with the normal force a quarter period off, N = N0 (1 - h cos p).
struct Quadrature {
  double amplitude;   ///< A [L], > 0
  double mean;        ///< N0 [F], > 0
  double modulation;  ///< h [1], 0 < h < 1
};

enum class EventKind { kForwardSlip, kBackwardSlip, kStick };

struct Event {
  EventKind kind;
  double phase;   ///< p [1]
  double motion;  ///< u [L]
  double force;   ///< f [F]
};

/// The first `count` changes between stick and slip from rest at p = 0 (Yang and Menq 1998).
///
/// With r = sqrt((kA)^2 + (mu N0 h)^2) and d = atan(mu N0 h/(kA)): the first slip begins at asin(mu
/// N0/r) - d. Slip ends where du = +-mu dN/k: at pi/2 - d forwards and at 3 pi/2 + d backwards.
/// Stick from (u_s, f_s) ends where r sin(p - d) = k u_s - f_s - mu N0 on the way down and where r
/// sin(p + d) = k u_s - f_s + mu N0 on the way up. The list is shorter if slip never begins.
inline std::vector<Event> quadrature_events(const Slider& slider, const Quadrature& path,
                                            std::size_t count) {
  using std::numbers::pi;
  const double k = slider.stick_stiffness;
  const double limit = slider.mu * path.mean;
  const double r = std::hypot(k * path.amplitude, limit * path.modulation);
  const double d = std::atan2(limit * path.modulation, k * path.amplitude);
  std::vector<Event> events;
  const auto add = [&](EventKind kind, double sense, double phase) {
    const double force = sense * limit * (1.0 - path.modulation * std::cos(phase));
    events.push_back({kind, phase, path.amplitude * std::sin(phase), force});
  };
  if (limit >= r) return events;
  add(EventKind::kForwardSlip, 1.0, std::asin(limit / r) - d);
  for (double period = 0.0; events.size() < count; period += 2.0 * pi) {
    add(EventKind::kStick, 1.0, period + 0.5 * pi - d);
    const double down = (k * events.back().motion - events.back().force - limit) / r;
    if (down <= -1.0) break;
    add(EventKind::kBackwardSlip, -1.0, period + pi - std::asin(down) + d);
    add(EventKind::kStick, -1.0, period + 1.5 * pi + d);
    const double up = (k * events.back().motion - events.back().force + limit) / r;
    if (up >= 1.0) break;
    add(EventKind::kForwardSlip, 1.0, period + 2.0 * pi + std::asin(up) - d);
  }
  if (events.size() > count) events.resize(count);
  return events;
}

/// Energy dissipated in one slip phase in the sense z = +-1 between two phases [F L]: the integral
/// of mu N (z du - mu dN/k).
inline double quadrature_slip_energy(const Slider& slider, const Quadrature& path, double sense,
                                     double from, double to) {
  const double limit = slider.mu * path.mean;
  const double h = path.modulation;
  const double shift = limit * h / slider.stick_stiffness;
  const auto primitive = [&](double p) {
    const double s = std::sin(p);
    return sense * path.amplitude * (s - h * (0.5 * p + 0.25 * std::sin(2.0 * p))) +
           shift * (std::cos(p) + 0.5 * h * s * s);
  };
  return limit * (primitive(to) - primitive(from));
}

/// A normal force that falls at constant motion.
struct Unloading {
  double force;        ///< f at the end [F]
  double slip;         ///< [L]
  double dissipation;  ///< [F L]
};

/// From the sticking force f [F] with the normal force falling to N [F] at fixed motion: nothing
/// happens until mu N = |f|; then f follows mu N, slip = (|f| - mu N)/k and dissipation = (f^2 -
/// (mu N)^2)/(2k). A later rise of N changes nothing.
inline Unloading unload_normal_force(const Slider& slider, double force, double normal_force) {
  const double limit = slider.mu * normal_force;
  if (std::abs(force) <= limit) return {force, 0.0, 0.0};
  const double drop = std::abs(force) - limit;
  return {std::copysign(limit, force), drop / slider.stick_stiffness,
          0.5 * drop * (std::abs(force) + limit) / slider.stick_stiffness};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction"},
    Signal{"normal_force", "F", "normal force, never negative"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of mu N over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Slider slider{values[0][0], values[1][0]};
  return [slider, state = State{}, started = false](std::span<const double> inputs,
                                                    std::span<double> outputs) mutable {
    if (started) {
      state = advance(slider, state, inputs[0], inputs[1]);
    } else {
      state.motion = inputs[0];
      state.normal_force = inputs[1];
    }
    started = true;
    outputs[0] = state.force;
    outputs[1] = state.accumulated_slip;
    outputs[2] = state.dissipation;
    outputs[3] = 0.5 * state.force * state.force / slider.stick_stiffness;
    outputs[4] = state.work;
  };
}

inline constexpr ClosedForm kForm{
    .name = "varying_normal_force",
    .title = "Elastic stick and Coulomb slip in one dimension, varying normal force and lift-off",
    .formula = "stick: df = k du; slip: f = z mu N, ds = z du - mu dN/k; N = 0: f = 0",
    .source = "Menq, Griffin and Bielak 1986; Yang and Menq 1998",
    .range = "k > 0, N >= 0; motion and normal force both linear between rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

inline constexpr std::array kQuadratureParameters{
    Parameter{.name = "mu",
              .dimension = "1",
              .text = "friction coefficient",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "amplitude",
              .dimension = "L",
              .text = "amplitude A of the motion A sin p",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "mean_normal_force",
              .dimension = "F",
              .text = "mean N0 of the normal force N0 (1 - h cos p)",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "modulation",
              .dimension = "1",
              .text = "modulation h of the normal force, below 1",
              .lower = 0.0,
              .upper = 1.0,
              .lower_open = true},
    kPeriod,
    kStartTime};
inline constexpr std::array kQuadratureInputs{
    Signal{"time", "T", "time; before the start the slider is at rest"}};
inline constexpr std::array kQuadratureOutputs{
    Signal{"force", "F", "friction force"}, Signal{"motion", "L", "motion A sin p"},
    Signal{"normal_force", "F", "normal force N0 (1 - h cos p)"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of mu N over slip"}};

inline std::optional<std::string> quadrature_violation(
    std::span<const std::vector<double>> values) {
  if (values[4][0] < 1.0) return std::nullopt;
  return "modulation is 1; the normal force must stay above 0";
}

/// From its first stick on the slider goes through the same changes in every period, where a slip
/// follows each stick: whole periods are counted, not walked through.
inline PathEvaluator make_quadrature(std::span<const std::vector<double>> values) {
  const Slider slider{values[0][0], values[1][0]};
  const Quadrature path{values[2][0], values[3][0], values[4][0]};
  // The first slip; stick, backward slip, stick and forward slip of every period.
  constexpr std::size_t kOfOnePeriod = 5;
  return [slider, path, period = values[5][0], start_time = values[6][0],
          events = quadrature_events(slider, path, kOfOnePeriod)](std::span<const double> inputs,
                                                                  std::span<double> outputs) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double phase = std::max(phase_at(inputs[0], start_time, period), 0.0);
    const auto motion = [&](double p) { return path.amplitude * std::sin(p); };
    const auto normal_force = [&](double p) {
      return path.mean * (1.0 - path.modulation * std::cos(p));
    };
    const double k = slider.stick_stiffness;
    double force = k * motion(phase);
    double slip = 0.0;
    double dissipation = 0.0;
    const auto add = [&](const Event& event, double end, double times) {
      const double sense = event.kind == EventKind::kForwardSlip ? 1.0 : -1.0;
      slip += times * (sense * (motion(end) - event.motion) -
                       slider.mu / k * (normal_force(end) - normal_force(event.phase)));
      dissipation += times * quadrature_slip_energy(slider, path, sense, event.phase, end);
    };
    double periods = 0.0;
    if (events.size() == kOfOnePeriod && phase >= events[1].phase) {
      periods = std::floor((phase - events[1].phase) / kTurn);
      add(events[2], events[3].phase, periods);
      add(events[4], events[1].phase + kTurn, periods);
    }
    const double here = phase - kTurn * periods;
    for (std::size_t i = 0; i < events.size() && events[i].phase <= here; ++i) {
      const Event& event = events[i];
      if (event.kind == EventKind::kStick) {
        force = event.force + k * (motion(phase) - event.motion);
        continue;
      }
      const double sense = event.kind == EventKind::kForwardSlip ? 1.0 : -1.0;
      force = sense * slider.mu * normal_force(phase);
      add(event, i + 1 < events.size() ? std::min(events[i + 1].phase, here) : here, 1.0);
    }
    outputs[0] = force;
    outputs[1] = motion(phase);
    outputs[2] = normal_force(phase);
    outputs[3] = slip;
    outputs[4] = dissipation;
  };
}

inline constexpr ClosedForm kQuadratureForm{
    .name = "quadrature_normal_force",
    .title = "Elastic Coulomb slider, motion and normal force a quarter period apart",
    .formula = "u = A sin p, N = N0 (1 - h cos p); slip ends where tan p = +-k A/(mu N0 h)",
    .source = "Yang and Menq 1998; Menq, Griffin and Bielak 1986",
    .range = "0 < h < 1; from rest at p = 0; exact at every phase, also between changes",
    .parameters = kQuadratureParameters,
    .inputs = kQuadratureInputs,
    .outputs = kQuadratureOutputs,
    .make = make_quadrature,
    .violation = quadrature_violation};

}  // namespace slipbench::reference::varying_normal_force
