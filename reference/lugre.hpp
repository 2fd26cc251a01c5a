// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// The LuGre friction model: bristles that bend and break away, with a Stribeck curve.
///
/// Formula   z' = v - sigma_0 |v| z/g(v), f = sigma_0 z + sigma_1 z' + sigma_2 v, g = F_c + (F_s -
///           F_c) e^(-(v/v_s)^2). At constant v over t: z -> z_v + (z - z_v) e^(-sigma_0 |v| t/g),
///           z_v = sign(v) g/sigma_0. Steady: f = sign(v) g + sigma_2 v. Start-up from rest: f = g
///           (1 - e^(-sigma_0 v t/g)) + sigma_1 v e^(-sigma_0 v t/g) + sigma_2 v.
/// Symbols   v velocity [L/T], z bristle deflection [L], f friction force [F], F_c, F_s Coulomb and
///           static force [F], v_s Stribeck velocity [L/T], sigma_0 [F/L], sigma_1, sigma_2 [F
///           T/L].
/// Sign      f has the sign of the velocity it resists.
/// Source    Canudas de Wit, Olsson, Astrom and Lischinsky 1995.
/// Range     F_s >= F_c > 0, v_s > 0, sigma_0 > 0, sigma_1, sigma_2 >= 0. The velocity is constant
///           between rows, where the integrator is exact; a row's force is the one just before any
///           jump of the velocity. Second order in the rows' spacing for z on a smooth motion.
namespace slipbench::reference::lugre {

struct Bristles {
  double coulomb_force;      ///< F_c [F], > 0
  double static_force;       ///< F_s [F], >= F_c
  double stribeck_velocity;  ///< v_s [L/T], > 0
  double stiffness;          ///< sigma_0 [F/L], > 0
  double damping;            ///< sigma_1 [F T/L]
  double viscosity;          ///< sigma_2 [F T/L]
};

/// g(v) [F].
inline double stribeck_force(const Bristles& bristles, double velocity) {
  const double ratio = velocity / bristles.stribeck_velocity;
  return bristles.coulomb_force +
         (bristles.static_force - bristles.coulomb_force) * std::exp(-ratio * ratio);
}

/// Force of steady motion [F], sign(v) g(v) + sigma_2 v; 0 at v = 0, where any force up to F_s is
/// steady.
inline double steady_force(const Bristles& bristles, double velocity) {
  if (velocity == 0.0) return 0.0;
  return std::copysign(stribeck_force(bristles, velocity), velocity) +
         bristles.viscosity * velocity;
}

struct State {
  double deflection = 0.0;  ///< z [L]
  double force = 0.0;       ///< f [F]
};

/// After the time t > 0 [T] at the constant velocity v [L/T]; exact.
inline State advance(const Bristles& bristles, const State& begin, double velocity, double time) {
  const double g = stribeck_force(bristles, velocity);
  const double steady = std::copysign(g, velocity) / bristles.stiffness;
  const double rate = bristles.stiffness * std::abs(velocity) / g;
  State end;
  end.deflection = begin.deflection - (steady - begin.deflection) * std::expm1(-rate * time);
  const double deflection_rate = velocity - rate * end.deflection;
  end.force = bristles.stiffness * end.deflection + bristles.damping * deflection_rate +
              bristles.viscosity * velocity;
  return end;
}

inline constexpr std::array kParameters{
    Parameter{.name = "coulomb_force",
              .dimension = "F",
              .text = "friction force at speed, without viscosity",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "static_force",
              .dimension = "F",
              .text = "largest force at rest, not below the Coulomb force",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "stribeck_velocity",
              .dimension = "L/T",
              .text = "velocity over which static goes over into Coulomb friction",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "bristle_stiffness",
              .dimension = "F/L",
              .text = "stiffness sigma_0 of the bristles",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "bristle_damping",
              .dimension = "F T/L",
              .text = "damping sigma_1 of the bristles",
              .default_value = 0.0,
              .lower = 0.0},
    Parameter{.name = "viscous_damping",
              .dimension = "F T/L",
              .text = "viscous friction sigma_2",
              .default_value = 0.0,
              .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"motion", "L", "relative motion, linear between rows"},
                                    Signal{"time", "T", "time, rising wherever there is motion"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force at the end of the piece before the row"},
    Signal{"steady_force", "F", "force of steady motion at the piece's velocity"},
    Signal{"bristle_deflection", "L", "mean bending of the bristles"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[1][0] >= values[0][0]) return std::nullopt;
  return "static_force must not be below coulomb_force";
}

/// A row that moves without time makes the state NaN; one that repeats the time and the motion
/// changes nothing.
inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Bristles bristles{values[0][0], values[1][0], values[2][0],
                          values[3][0], values[4][0], values[5][0]};
  struct Row {
    State state;
    double motion = 0.0;
    double time = 0.0;
    double velocity = 0.0;
    bool started = false;
  };
  return
      [bristles, row = Row{}](std::span<const double> inputs, std::span<double> outputs) mutable {
        const double travel = inputs[0] - row.motion;
        const double time = inputs[1] - row.time;
        if (row.started && (time != 0.0 || travel != 0.0)) {
          row.velocity = time > 0.0 ? travel / time : std::numeric_limits<double>::quiet_NaN();
          row.state = advance(bristles, row.state, row.velocity, time);
        }
        row.motion = inputs[0];
        row.time = inputs[1];
        row.started = true;
        outputs[0] = row.state.force;
        outputs[1] = steady_force(bristles, row.velocity);
        outputs[2] = row.state.deflection;
      };
}

inline constexpr ClosedForm kForm{
    .name = "lugre",
    .title = "LuGre bristle model, exact at piecewise constant velocity",
    .formula = "z' = v - sigma_0 |v| z/g(v), f = sigma_0 z + sigma_1 z' + sigma_2 v",
    .source = "Canudas de Wit, Olsson, Astrom and Lischinsky 1995",
    .range = "F_s >= F_c > 0, v_s, sigma_0 > 0; motion linear between rows, time rising",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::lugre
