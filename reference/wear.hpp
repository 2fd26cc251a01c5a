// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/lambert_w.hpp"

/// One spring in series with one Coulomb slider whose internal contact force falls with the
/// accumulated slip: a press fit that wears. The accumulated slip is that of the present instant.
///
/// Formula   While slipping |f| = mu F_int(s). Linear: F_int = F_0 - c s, so on the first loading,
///           up to u = F_0/c, f = mu (F_0 - c u)/(1 - b), s = u - f/k, b = mu c/k. Exponential:
///           F_int = F_i + (F_z - F_i) e^(-s/l), so s = a + l W0(-(h/l) e^(-a/l)) with a = u - mu
///           F_i/k, h = mu (F_z - F_i)/k and f = k (u - s).
/// Symbols   u motion [L], f friction force [F], k stick stiffness [F/L], mu [1], s accumulated
///           slip [L], c wear rate [F/L], l wear length [L], F_0, F_z, F_i internal contact force
///           new and worn [F].
/// Sign      f has the sign of the slip it resists.
/// Source    derived in docs/theory; W0: Corless, Gonnet, Hare, Jeffrey and Knuth 1996.
/// Range     b < 1 and h < l, else the force snaps back at the onset of slip; F_int >= 0.
namespace slipbench::reference::wear {

struct Slip {
  double force;             ///< f [F]
  double accumulated_slip;  ///< s [L]
};

inline constexpr Slip kSnapBack{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};

struct LinearWear {
  double mu;               ///< [1]
  double stick_stiffness;  ///< k [F/L]
  double initial_force;    ///< F_0 [F]
  double wear_rate;        ///< c [F/L]
};

/// b = mu c/k [1]; b >= 1 is a snap-back, for which there is no quasi-static answer.
inline double snap_back_number(const LinearWear& wear) {
  return wear.mu * wear.wear_rate / wear.stick_stiffness;
}

/// First loading to the motion u >= 0 [L], linear wear; sticks up to u = mu F_0/k. NaN if b >= 1.
inline Slip monotone(const LinearWear& wear, double motion) {
  const double k = wear.stick_stiffness;
  if (snap_back_number(wear) >= 1.0) return kSnapBack;
  if (k * motion <= wear.mu * wear.initial_force) return {k * motion, 0.0};
  const double force =
      wear.mu * (wear.initial_force - wear.wear_rate * motion) / (1.0 - snap_back_number(wear));
  return {force, motion - force / k};
}

/// Magnitude of the force [F] at the n-th reversal after the one with magnitude F [F], full slip
/// between -A and A [L]: k A + (F - k A) ((1 + b)/(1 - b))^n. Holds while every half cycle slips
/// and wears, that is while the result is positive and below k A.
inline double cyclic_force(const LinearWear& wear, double amplitude, double first_force, int n) {
  // ((1 + b)/(1 - b))^n - 1, so that the large k A does not swallow digits
  const double growth = std::expm1(2.0 * n * std::atanh(snap_back_number(wear)));
  return first_force - (wear.stick_stiffness * amplitude - first_force) * growth;
}

/// Accumulated slip [L] that has worn the limit down to the force [F]: (F_0 - f/mu)/c.
inline double slip_at_force(const LinearWear& wear, double force) {
  return (wear.initial_force - force / wear.mu) / wear.wear_rate;
}

struct ExponentialWear {
  double mu;               ///< [1]
  double stick_stiffness;  ///< k [F/L]
  double final_force;      ///< F_i [F], fully worn
  double initial_force;    ///< F_z [F], new
  double wear_length;      ///< l [L]
};

/// h/l = mu (F_z - F_i)/(k l) [1], the steepest fall of the limit over the stick stiffness; from 1
/// on the force snaps back at the onset of slip.
inline double snap_back_number(const ExponentialWear& wear) {
  return wear.mu * (wear.initial_force - wear.final_force) /
         (wear.stick_stiffness * wear.wear_length);
}

/// First loading to the motion u >= 0 [L], exponential wear; sticks up to u = mu F_z/k. NaN if h >=
/// l.
inline Slip monotone(const ExponentialWear& wear, double motion) {
  const double k = wear.stick_stiffness;
  const double fall = snap_back_number(wear);
  if (fall >= 1.0) return kSnapBack;
  if (k * motion <= wear.mu * wear.initial_force) return {k * motion, 0.0};
  const double a = motion - wear.mu * wear.final_force / k;
  const double l = wear.wear_length;
  const double slip = a + l * lambert_w0(-fall * std::exp(-a / l));
  // k (u - s) is the same, but it cancels once u is large.
  const double worn = (wear.initial_force - wear.final_force) * std::exp(-slip / l);
  return {wear.mu * (wear.final_force + worn), slip};
}

/// Dissipation after the accumulated slip s [L]: mu [F_i s + (F_z - F_i) l (1 - e^(-s/l))] [F L].
inline double dissipation(const ExponentialWear& wear, double slip) {
  return wear.mu *
         (wear.final_force * slip - (wear.initial_force - wear.final_force) * wear.wear_length *
                                        std::expm1(-slip / wear.wear_length));
}

/// Internal contact force after the accumulated slip s [F], never negative.
inline double internal_contact_force(const LinearWear& wear, double slip) {
  return std::max(wear.initial_force - wear.wear_rate * slip, 0.0);
}

/// Internal contact force after the accumulated slip s [F].
inline double internal_contact_force(const ExponentialWear& wear, double slip) {
  return wear.final_force +
         (wear.initial_force - wear.final_force) * std::exp(-slip / wear.wear_length);
}

/// Slip [L] over the travel x >= 0 [L] in slip that begins with the accumulated slip s: x/(1 - b),
/// but not beyond F_0/c, where nothing is left.
inline double slip_over(const LinearWear& wear, double slip, double travel) {
  const double left = internal_contact_force(wear, slip) / wear.wear_rate;
  return std::min(travel / (1.0 - snap_back_number(wear)), left);
}

/// Slip [L] over the travel x >= 0 [L] in slip that begins with the accumulated slip s: as on first
/// loading with h e^(-s/l) for h, a = x + h e^(-s/l).
inline double slip_over(const ExponentialWear& wear, double slip, double travel) {
  const double l = wear.wear_length;
  const double fall = snap_back_number(wear) * std::exp(-slip / l);
  const double a = travel / l + fall;
  return l * std::max(a + lambert_w0(-fall * std::exp(-a)), 0.0);
}

/// Energy of the slip from s to s + ds [F L].
inline double slip_energy(const LinearWear& wear, double slip, double increment) {
  return 0.5 * wear.mu *
         (internal_contact_force(wear, slip) + internal_contact_force(wear, slip + increment)) *
         increment;
}

/// Energy of the slip from s to s + ds [F L].
inline double slip_energy(const ExponentialWear& wear, double slip, double increment) {
  const double excess = internal_contact_force(wear, slip) - wear.final_force;
  return wear.mu * (wear.final_force * increment -
                    excess * wear.wear_length * std::expm1(-increment / wear.wear_length));
}

struct State {
  double motion = 0.0;            ///< u [L]
  double origin = 0.0;            ///< the motion at which the spring would be relaxed [L]
  double force = 0.0;             ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
  double dissipation = 0.0;       ///< integral of mu F_int ds [F L]
  double work = 0.0;              ///< integral of f du [F L]
};

/// The wearing slider after a straight piece of motion that ends at `motion` [L]; exact. The work
/// in slip follows from du = ds + df/k. Once worn away it neither resists nor slips.
template <typename Wear>
State advance(const Wear& wear, const State& begin, double motion) {
  const double k = wear.stick_stiffness;
  State end = begin;
  end.motion = motion;
  const double onset = wear.mu * internal_contact_force(wear, begin.accumulated_slip);
  const double predictor = k * (motion - begin.origin);
  if (onset > 0.0 && std::abs(predictor) <= onset) {
    end.force = predictor;
    end.work += 0.5 * (begin.force + end.force) * (motion - begin.motion);
    return end;
  }
  if (onset > 0.0) {
    const double sense = std::copysign(1.0, predictor);
    const double slip = slip_over(wear, begin.accumulated_slip, (std::abs(predictor) - onset) / k);
    const double energy = slip_energy(wear, begin.accumulated_slip, slip);
    end.accumulated_slip += slip;
    end.dissipation += energy;
    end.force = sense * wear.mu * internal_contact_force(wear, end.accumulated_slip);
    end.work += energy + 0.5 * (end.force * end.force - begin.force * begin.force) / k;
  }
  end.origin = motion - end.force / k;
  return end;
}

inline constexpr Parameter kMu{
    .name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0};
inline constexpr Parameter kStickStiffness{.name = "stick_stiffness",
                                           .dimension = "F/L",
                                           .text = "stiffness of the sticking contact",
                                           .lower = 0.0,
                                           .lower_open = true};
inline constexpr Parameter kInitialForce{.name = "initial_contact_force",
                                         .dimension = "F",
                                         .text = "internal contact force when new",
                                         .lower = 0.0};
inline constexpr std::array kLinearParameters{
    kMu, kStickStiffness, kInitialForce,
    Parameter{.name = "wear_rate",
              .dimension = "F/L",
              .text = "internal contact force lost per accumulated slip",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kExponentialParameters{
    kMu, kStickStiffness, kInitialForce,
    Parameter{.name = "final_contact_force",
              .dimension = "F",
              .text = "internal contact force when fully worn",
              .lower = 0.0},
    Parameter{.name = "wear_length",
              .dimension = "L",
              .text = "accumulated slip over which the loss falls to 1/e",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"internal_contact_force", "F", "internal contact force after the slip so far"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of the limit over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of force over motion"}};

inline LinearWear linear_from(std::span<const std::vector<double>> values) {
  return {values[0][0], values[1][0], values[2][0], values[3][0]};
}

inline ExponentialWear exponential_from(std::span<const std::vector<double>> values) {
  return {values[0][0], values[1][0], values[3][0], values[2][0], values[4][0]};
}

template <typename Wear>
PathEvaluator evaluator(const Wear& wear) {
  return [wear, state = State{}, started = false](std::span<const double> inputs,
                                                  std::span<double> outputs) mutable {
    if (started) {
      state = advance(wear, state, inputs[0]);
    } else {
      state.motion = state.origin = inputs[0];
    }
    started = true;
    outputs[0] = state.force;
    outputs[1] = internal_contact_force(wear, state.accumulated_slip);
    outputs[2] = state.accumulated_slip;
    outputs[3] = state.dissipation;
    outputs[4] = 0.5 * state.force * state.force / wear.stick_stiffness;
    outputs[5] = state.work;
  };
}

inline PathEvaluator make_linear(std::span<const std::vector<double>> values) {
  return evaluator(linear_from(values));
}

inline PathEvaluator make_exponential(std::span<const std::vector<double>> values) {
  return evaluator(exponential_from(values));
}

inline std::optional<std::string> linear_violation(std::span<const std::vector<double>> values) {
  if (snap_back_number(linear_from(values)) < 1.0) return std::nullopt;
  return "mu wear_rate must be below stick_stiffness, else the force snaps back where slip begins";
}

inline std::optional<std::string> exponential_violation(
    std::span<const std::vector<double>> values) {
  if (snap_back_number(exponential_from(values)) < 1.0) return std::nullopt;
  return "mu (initial_contact_force - final_contact_force) must be below stick_stiffness "
         "wear_length, else the force snaps back where slip begins";
}

inline constexpr ClosedForm kLinearForm{
    .name = "linear_wear",
    .title = "Press fit that wears in proportion to the accumulated slip",
    .formula = "slip: |f| = mu (F_0 - c s), ds = |du|/(1 - b), b = mu c/k",
    .source = "derived in docs/theory",
    .range = "b < 1; any piecewise-linear motion with its turning points on rows",
    .parameters = kLinearParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make_linear,
    .violation = linear_violation};
inline constexpr ClosedForm kExponentialForm{
    .name = "exponential_wear",
    .title = "Press fit that wears towards a remainder",
    .formula = "slip: |f| = mu (F_i + (F_z - F_i) e^(-s/l)), s by Lambert's W0",
    .source = "derived in docs/theory; Corless et al. 1996",
    .range = "mu (F_z - F_i) < k l; any piecewise-linear motion with its turning points on rows",
    .parameters = kExponentialParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make_exponential,
    .violation = exponential_violation};

}  // namespace slipbench::reference::wear
