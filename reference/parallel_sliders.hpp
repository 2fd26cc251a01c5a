// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/coulomb_slider.hpp"

/// Jenkins elements side by side under one motion (Masing's model).
///
/// Formula   f = sum f_i. From rest: F_b(u) = sign(u) sum min(k_i |u|, lim_i). After a reversal at
///           (u_r, F_r): F = F_r -+ 2 F_b(|u_r - u|/2), see masing.hpp. Closed loop: E = 4 sum
///           lim_i <A - lim_i/k_i>.
/// Symbols   u motion [L], k_i stick stiffnesses [F/L], lim_i limits [F], A amplitude [L], E [F L].
/// Sign      forces have the sign of the slip they resist.
/// Source    Masing 1926; Iwan 1966.
/// Range     k_i > 0, lim_i >= 0, equally many of both, at least one; exact on piecewise-linear
///           paths whose turning points are rows.
namespace slipbench::reference::parallel_sliders {

using coulomb_slider::Slider;

/// Force on the first loading from the relaxed state [F]; odd in the motion [L].
inline double backbone(std::span<const Slider> sliders, double motion) {
  double force = 0.0;
  for (const Slider& slider : sliders) {
    force += std::min(slider.stick_stiffness * std::abs(motion), slider.limit);
  }
  return std::copysign(force, motion);
}

/// Energy of one closed loop of half width A [F L]; minor loops anywhere cost the same.
inline double loop_energy(std::span<const Slider> sliders, double amplitude) {
  double energy = 0.0;
  for (const Slider& slider : sliders) energy += coulomb_slider::loop_energy(slider, amplitude);
  return energy;
}

inline constexpr std::array kParameters{Parameter{.name = "stick_stiffnesses",
                                                  .dimension = "F/L",
                                                  .text = "stick stiffness of each slider",
                                                  .list = true,
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "limits",
                                                  .dimension = "F",
                                                  .text = "limiting friction force of each slider",
                                                  .list = true,
                                                  .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"motion", "L", "relative motion of all sliders"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "sum of the friction forces"},
    Signal{"accumulated_slip", "L", "sum of all sliders' accumulated slips"},
    Signal{"dissipation", "F L", "sum of the sliders' dissipations"},
    Signal{"stored_energy", "F L", "sum of the energies held by the stick stiffnesses"},
    Signal{"work", "F L", "integral of the force over motion"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[0].empty()) return "stick_stiffnesses needs at least one entry";
  if (values[0].size() == values[1].size()) return std::nullopt;
  return "stick_stiffnesses has " + std::to_string(values[0].size()) + " entries and limits has " +
         std::to_string(values[1].size()) + "; each slider needs one of both";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  std::vector<Slider> sliders;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    sliders.push_back({values[0][i], values[1][i]});
  }
  return [sliders, states = std::vector<coulomb_slider::State>{}](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    const bool started = !states.empty();
    if (!started) states.assign(sliders.size(), coulomb_slider::start(inputs[0]));
    std::fill(outputs.begin(), outputs.end(), 0.0);
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      if (started) states[i] = coulomb_slider::advance(sliders[i], states[i], inputs[0]);
      outputs[0] += states[i].force;
      outputs[1] += states[i].accumulated_slip;
      outputs[2] += states[i].dissipation;
      outputs[3] += coulomb_slider::stored_energy(sliders[i], states[i].force);
      outputs[4] += states[i].work;
    }
  };
}

inline constexpr ClosedForm kForm{
    .name = "parallel_sliders",
    .title = "Elastic Coulomb sliders in parallel (Masing's model)",
    .formula = "f = sum f_i, each f_i = k_i (u - z_i) with |f_i| <= lim_i",
    .source = "Masing 1926; Iwan 1966",
    .range = "k_i > 0, lim_i >= 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::parallel_sliders
