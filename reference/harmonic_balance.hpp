// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/coulomb_slider.hpp"

/// First harmonic of a friction loop: equivalent stiffness and damping, as a closed form for the
/// elastic Coulomb slider and as a Fourier post-processor for any sampled loop.
///
/// Formula   K = k_eq + i c_eq omega = (oint f e^-ip dp)/(oint u e^-ip dp) over one cycle. For the
///           slider theta = acos(1 - 2 s_c/A), k_eq = (k/pi)(theta - sin(2 theta)/2), c_eq omega =
///           4 lim/(pi A) (1 - s_c/A); pi c_eq omega A^2 is the loop energy.
/// Symbols   p phase [1], 2 pi (t - start)/period for rows, u motion [L], f force [F], A amplitude
///           [L], s_c = lim/k [L], k_eq equivalent and c_eq omega loss stiffness [F/L].
/// Sign      f has the sign of the slip it resists, so that a loop that dissipates has c_eq > 0.
/// Source    Griffin 1980.
/// Range     steady cycles; whole cycles end on rows. The integrals are trapezoids between rows:
///           the error is second order in the rows' spacing.
namespace slipbench::reference::harmonic_balance {

/// oint x e^-ip dp by trapezoids over the samples (p, x), in the order of p.
class Harmonic {
 public:
  void add(double phase, double value) {
    const std::complex<double> term = value * std::polar(1.0, -phase);
    if (started_) sum_ += 0.5 * (term + last_) * (phase - phase_);
    started_ = true;
    phase_ = phase;
    last_ = term;
  }

  [[nodiscard]] std::complex<double> sum() const { return sum_; }

 private:
  std::complex<double> sum_;
  std::complex<double> last_;
  double phase_ = 0.0;
  bool started_ = false;
};

struct Stiffness {
  double equivalent;  ///< k_eq [F/L]
  double loss;        ///< c_eq omega [F/L]
};

/// First-harmonic stiffness of one cycle, sampled from any phase p to p + 2 pi, both included.
/// NaN if the motion has no first harmonic. Any mean value and the origin of p are without effect.
inline Stiffness first_harmonic(std::span<const double> phases, std::span<const double> motions,
                                std::span<const double> forces) {
  Harmonic motion;
  Harmonic force;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    motion.add(phases[i], motions[i]);
    force.add(phases[i], forces[i]);
  }
  const std::complex<double> ratio = force.sum() / motion.sum();
  return {ratio.real(), ratio.imag()};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "amplitude",
              .dimension = "L",
              .text = "amplitude of the motion A cos p",
              .lower = 0.0,
              .lower_open = true},
    kPeriod,
    kStartTime};
inline constexpr std::array kInputs{Signal{"time", "T", "time"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "first harmonic of the steady friction force"},
    Signal{"motion", "L", "motion A cos p"},
    Signal{"equivalent_stiffness", "F/L", "in-phase part of force over motion"},
    Signal{"loss_stiffness", "F/L", "equivalent damping times the circular frequency"},
    Signal{"loop_energy", "F L", "energy of one cycle"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const coulomb_slider::Slider slider{values[2][0],
                                      coulomb_slider::limit(values[0][0], values[1][0])};
  const double amplitude = values[3][0];
  const auto balance = coulomb_slider::harmonic_balance(slider, amplitude);
  const double energy = coulomb_slider::loop_energy(slider, amplitude);
  const double period = values[4][0];
  const double start_time = values[5][0];
  return [=](std::span<const double> inputs, std::span<double> outputs) {
    const double phase = phase_at(inputs[0], start_time, period);
    const double c = std::cos(phase);
    const double s = std::sin(phase);
    outputs[0] = amplitude * (balance.equivalent_stiffness * c - balance.loss_stiffness * s);
    outputs[1] = amplitude * c;
    outputs[2] = balance.equivalent_stiffness;
    outputs[3] = balance.loss_stiffness;
    outputs[4] = energy;
  };
}

inline constexpr ClosedForm kForm{
    .name = "harmonic_balance",
    .title = "First harmonic of the elastic Coulomb slider",
    .formula = "k_eq = (k/pi)(theta - sin(2 theta)/2), c_eq omega = 4 lim/(pi A) (1 - s_c/A)",
    .source = "Griffin 1980",
    .range = "k > 0, A > 0; steady cycles of u = A cos p",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

inline constexpr std::array kFirstHarmonicParameters{kPeriod, kStartTime};
inline constexpr std::array kFirstHarmonicInputs{Signal{"time", "T", "time, never falling"},
                                                 Signal{"motion", "L", "relative motion"},
                                                 Signal{"force", "F", "friction force"}};
inline constexpr std::array kFirstHarmonicOutputs{
    Signal{"equivalent_stiffness", "F/L", "of the last whole cycle, 0 before the first is over"},
    Signal{"loss_stiffness", "F/L", "of the last whole cycle, 0 before the first is over"}};

inline PathEvaluator make_first_harmonic(std::span<const std::vector<double>> values) {
  struct State {
    Harmonic motion, force;
    Stiffness stiffness{0.0, 0.0};
    double begin = 0.0;
    bool started = false;
  };
  const double period = values[0][0];
  const double start_time = values[1][0];
  return [period, start_time, state = State{}](std::span<const double> inputs,
                                               std::span<double> outputs) mutable {
    // A row that begins or ends a cycle may miss it by the roundings of the time.
    constexpr double kRounding = 1e-9;
    const double phase = phase_at(inputs[0], start_time, period);
    const auto add = [&] {
      state.motion.add(phase, inputs[1]);
      state.force.add(phase, inputs[2]);
    };
    if (phase >= -kRounding) {
      if (!state.started) state.begin = phase;
      state.started = true;
      add();
      if (phase >= state.begin + 2.0 * std::numbers::pi - kRounding) {
        const std::complex<double> ratio = state.force.sum() / state.motion.sum();
        state.stiffness = {ratio.real(), ratio.imag()};
        state.begin = phase;
        state.motion = {};
        state.force = {};
        add();
      }
    }
    outputs[0] = state.stiffness.equivalent;
    outputs[1] = state.stiffness.loss;
  };
}

inline constexpr ClosedForm kFirstHarmonic{
    .name = "first_harmonic",
    .title = "Equivalent stiffness and damping of a sampled loop (Fourier post-processor)",
    .formula = "k_eq + i c_eq omega = (oint f e^-ip dp)/(oint u e^-ip dp)",
    .source = "Griffin 1980",
    .range = "each cycle ends on a row; second order in the rows' spacing",
    .parameters = kFirstHarmonicParameters,
    .inputs = kFirstHarmonicInputs,
    .outputs = kFirstHarmonicOutputs,
    .make = make_first_harmonic,
    .violation = no_violation};

}  // namespace slipbench::reference::harmonic_balance
