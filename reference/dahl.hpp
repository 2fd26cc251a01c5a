// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Dahl's friction model with the exponent 1: the force tends to the Coulomb force exponentially
/// over the motion; it slips a little from the first motion on.
///
/// Formula   df/du = sigma (1 - z f/F_c), z = sign(du). Over a piece du: f -> z F_c + (f - z F_c)
///           e^(-sigma |du|/F_c). Steady loop at A: F_A = F_c tanh(sigma A/F_c), E = 4 F_c [A -
///           (F_c/sigma) tanh(sigma A/F_c)].
/// Symbols   u motion [L], f friction force [F], F_c Coulomb force [F], sigma stiffness at rest
///           [F/L], A amplitude [L], E [F L].
/// Sign      f has the sign of the motion it resists.
/// Source    Dahl 1968.
/// Range     F_c, sigma > 0; exact on piecewise-linear motion with its turning points on rows.
namespace slipbench::reference::dahl {

struct Contact {
  double coulomb_force;  ///< F_c [F], > 0
  double stiffness;      ///< sigma [F/L], > 0
};

struct State {
  double force = 0.0;  ///< f [F]
  double work = 0.0;   ///< integral of f du [F L]
};

/// After a straight piece of motion du [L]; exact.
inline State advance(const Contact& contact, const State& begin, double travel) {
  const double target = std::copysign(contact.coulomb_force, travel);
  const double rate = contact.stiffness / contact.coulomb_force;
  // 1 - e^(-sigma |du|/F_c)
  const double decayed = -std::expm1(-rate * std::abs(travel));
  State end;
  end.force = begin.force + (target - begin.force) * decayed;
  end.work =
      begin.work + target * travel + (begin.force - target) * std::copysign(decayed / rate, travel);
  return end;
}

/// Force at the turning points of the steady loop between -A and A [F].
inline double loop_force(const Contact& contact, double amplitude) {
  return contact.coulomb_force * std::tanh(contact.stiffness * amplitude / contact.coulomb_force);
}

/// Energy of the steady loop between -A and A [F L].
inline double loop_energy(const Contact& contact, double amplitude) {
  return 4.0 * contact.coulomb_force *
         (amplitude - loop_force(contact, amplitude) / contact.stiffness);
}

inline constexpr std::array kParameters{Parameter{.name = "coulomb_force",
                                                  .dimension = "F",
                                                  .text = "force far from a reversal",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "stiffness",
                                                  .dimension = "F/L",
                                                  .text = "stiffness at zero force",
                                                  .lower = 0.0,
                                                  .lower_open = true}};
inline constexpr std::array kInputs{Signal{"motion", "L", "relative motion"}};
inline constexpr std::array kOutputs{Signal{"force", "F", "friction force"},
                                     Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Contact contact{values[0][0], values[1][0]};
  return [contact, state = State{}, motion = 0.0, started = false](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    if (started) state = advance(contact, state, inputs[0] - motion);
    started = true;
    motion = inputs[0];
    outputs[0] = state.force;
    outputs[1] = state.work;
  };
}

inline constexpr ClosedForm kForm{
    .name = "dahl",
    .title = "Dahl's friction model, exponent 1",
    .formula = "df/du = sigma (1 - sign(du) f/F_c); loop E = 4 F_c [A - (F_c/sigma) tanh(...)]",
    .source = "Dahl 1968",
    .range = "F_c, sigma > 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::dahl
