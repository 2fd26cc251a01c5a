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

/// Engagement of a clutch: two inertias that rub on each other until they turn together.
///
/// Formula   J_1 w_1' = L_1 - s M, J_2 w_2' = L_2 + s M, s = sign(w_1 - w_2), until
///           t_e = |w_1 - w_2|/a, a = M (1/J_1 + 1/J_2) - s (L_1/J_1 - L_2/J_2); from then on
///           (J_1 + J_2) w' = L_1 + L_2, held by the moment (J_2 L_1 - J_1 L_2)/(J_1 + J_2).
///           Heat M |w_1 - w_2| (t - t^2/(2 t_e)) up to t_e. Without loads t_e =
///           J_1 J_2 |w_1 - w_2|/((J_1 + J_2) M), the common speed (J_1 w_1 + J_2 w_2)/(J_1 + J_2)
///           and the heat J_1 J_2 (w_1 - w_2)^2/(2 (J_1 + J_2)).
/// Symbols   J inertias [F L T^2], w speeds [1/T], L constant loads [F L], M moment of friction [F
///           L], 1 the driver, 2 the driven one; masses and forces in their place for a
///           translation.
/// Sign      loads and speeds of one sense; the moment of friction on the driven one is s M.
/// Source    textbook result, derived in docs/theory.
/// Range     J > 0, M > 0, a > 0 (the clutch does engage), and the load it holds afterwards not
///           beyond M.
namespace slipbench::reference::clutch_engagement {

struct Clutch {
  double driver_inertia;   ///< J_1 [F L T^2], > 0
  double driven_inertia;   ///< J_2 [F L T^2], > 0
  double driver_speed;     ///< w_1 at the start [1/T]
  double driven_speed;     ///< w_2 at the start [1/T]
  double friction_moment;  ///< M [F L], > 0
  double driver_load;      ///< L_1 [F L]
  double driven_load;      ///< L_2 [F L]
};

/// The sense of the slip of the driver over the driven one; 0 of a clutch that is engaged.
inline double sense(const Clutch& clutch) {
  const double slip = clutch.driver_speed - clutch.driven_speed;
  return slip == 0.0 ? 0.0 : std::copysign(1.0, slip);
}

/// The rate a [1/T^2] at which the two speeds come together.
inline double closing_rate(const Clutch& clutch) {
  return clutch.friction_moment * (1.0 / clutch.driver_inertia + 1.0 / clutch.driven_inertia) -
         sense(clutch) * (clutch.driver_load / clutch.driver_inertia -
                          clutch.driven_load / clutch.driven_inertia);
}

/// t_e [T], after which the two turn together.
inline double engagement_time(const Clutch& clutch) {
  return std::abs(clutch.driver_speed - clutch.driven_speed) / closing_rate(clutch);
}

struct State {
  double driver_speed;  ///< w_1 [1/T]
  double driven_speed;  ///< w_2 [1/T]
  double slip;          ///< angle slipped since the start [1]
  double heat;          ///< [F L]
  double moment;        ///< of friction on the driven one [F L]
};

/// The state at the time t >= 0 [T].
inline State at(const Clutch& clutch, double time) {
  const double end = engagement_time(clutch);
  const double slipping = std::min(time, end);
  const double together = time - slipping;
  const double s = sense(clutch);
  const double moment = s * clutch.friction_moment;
  const double first = std::abs(clutch.driver_speed - clutch.driven_speed);
  const double both = clutch.driver_inertia + clutch.driven_inertia;
  const double rate = (clutch.driver_load + clutch.driven_load) / both;
  State state;
  state.driver_speed = clutch.driver_speed +
                       slipping * (clutch.driver_load - moment) / clutch.driver_inertia +
                       together * rate;
  state.driven_speed = clutch.driven_speed +
                       slipping * (clutch.driven_load + moment) / clutch.driven_inertia +
                       together * rate;
  state.slip = first * slipping - 0.5 * closing_rate(clutch) * slipping * slipping;
  state.heat = clutch.friction_moment * state.slip;
  state.moment = time < end ? moment
                            : (clutch.driven_inertia * clutch.driver_load -
                               clutch.driver_inertia * clutch.driven_load) /
                                  both;
  return state;
}

inline constexpr Parameter positive(std::string_view name, std::string_view dimension,
                                    std::string_view text) {
  return {.name = name, .dimension = dimension, .text = text, .lower = 0.0, .lower_open = true};
}
inline constexpr std::array kParameters{
    positive("driver_inertia", "F L T^2", "inertia of the driver"),
    positive("driven_inertia", "F L T^2", "inertia of the driven one"),
    Parameter{.name = "driver_speed", .dimension = "1/T", .text = "of the driver at the start"},
    Parameter{.name = "driven_speed", .dimension = "1/T", .text = "of the driven one at the start"},
    positive("friction_moment", "F L", "moment that slip transmits"),
    Parameter{.name = "driver_load",
              .dimension = "F L",
              .text = "constant load on the driver",
              .default_value = 0.0},
    Parameter{.name = "driven_load",
              .dimension = "F L",
              .text = "constant load on the driven one",
              .default_value = 0.0},
    kStartTime};
inline constexpr std::array kInputs{Signal{"time", "T", "time; the clutch closes at the start"}};
inline constexpr std::array kOutputs{
    Signal{"driver_speed", "1/T", "speed of the driver"},
    Signal{"driven_speed", "1/T", "speed of the driven one"},
    Signal{"slip", "1", "angle slipped since the start"},
    Signal{"heat", "F L", "dissipated since the start"},
    Signal{"moment", "F L", "moment of friction on the driven one"}};

inline Clutch clutch_of(std::span<const std::vector<double>> v) {
  return {v[0][0], v[1][0], v[2][0], v[3][0], v[4][0], v[5][0], v[6][0]};
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return [clutch = clutch_of(values), start_time = values[7][0]](std::span<const double> inputs,
                                                                 std::span<double> outputs) {
    const State state = at(clutch, std::max(inputs[0] - start_time, 0.0));
    outputs[0] = state.driver_speed;
    outputs[1] = state.driven_speed;
    outputs[2] = state.slip;
    outputs[3] = state.heat;
    outputs[4] = state.moment;
  };
}

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  const Clutch clutch = clutch_of(values);
  if (!(closing_rate(clutch) > 0.0))
    return "the loads drive the two apart: the clutch never engages";
  const double held = at(clutch, std::numeric_limits<double>::max()).moment;
  if (std::abs(held) > clutch.friction_moment) return "the engaged clutch cannot hold its loads";
  return std::nullopt;
}

inline constexpr ClosedForm kForm{
    .name = "clutch_engagement",
    .title = "Engagement of a clutch of constant moment between two inertias",
    .formula = "J_1 w_1' = L_1 - s M, J_2 w_2' = L_2 + s M, s = sign(w_1 - w_2), then together",
    .source = "derived in docs/theory",
    .range = "J, M > 0; the clutch engages, and holds its loads afterwards",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::clutch_engagement
