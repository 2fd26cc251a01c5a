// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Strain of the belt between two slip rings through which material flows.
///
/// Formula   l_ref = d(0)/d_p + Psi_a - Psi_b, d_p = 1 + initial strain; strain = d/l_ref - 1;
///           tension = EA strain, 0 where that is negative.
/// Symbols   d distance of the nodes [L], l_ref reference length of the material between them [L],
///           Psi_a flow in at a, Psi_b flow out at b [L], d_p initial stretch [1], EA axial
///           stiffness [F].
/// Sign      flows count from their first value; a segment of negative strain is slack.
/// Source    docs/theory, section 4.1.
/// Range     d, l_ref > 0, EA >= 0, initial strain > -1; each row by itself. A segment from which
///           all material has flowed out has an infinite strain.
namespace slipbench::reference::belt_segment {

/// Reference length [L] of the material between the nodes.
inline double reference_length(double initial_distance, double initial_strain, double flow_in,
                               double flow_out) {
  return initial_distance / (1.0 + initial_strain) + flow_in - flow_out;
}

/// d/l_ref - 1 [1], written so that a small strain keeps its digits.
inline double strain(double distance, double reference_length) {
  return (distance - reference_length) / reference_length;
}

inline constexpr std::array kParameters{Parameter{.name = "initial_strain",
                                                  .dimension = "1",
                                                  .text = "strain at the first row",
                                                  .default_value = 0.0,
                                                  .lower = -1.0,
                                                  .lower_open = true},
                                        Parameter{.name = "axial_stiffness",
                                                  .dimension = "F",
                                                  .text = "EA of the belt",
                                                  .default_value = 0.0,
                                                  .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"distance", "L", "distance of the two nodes"},
                                    Signal{"flow_a", "L", "material flow into the segment at a"},
                                    Signal{"flow_b", "L", "material flow out of it at b"}};
inline constexpr std::array kOutputs{
    Signal{"strain", "1", "strain of the belt"},
    Signal{"reference_length", "L", "unstrained length of the material in the segment"},
    Signal{"stretch", "1", "1 + strain"}, Signal{"tension", "F", "EA times strain, not negative"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return
      [initial_strain = values[0][0], stiffness = values[1][0], first = std::array{0.0, 0.0, 0.0},
       started = false](std::span<const double> inputs, std::span<double> outputs) mutable {
        if (!started) first = {inputs[0], inputs[1], inputs[2]};
        started = true;
        outputs[1] =
            reference_length(first[0], initial_strain, inputs[1] - first[1], inputs[2] - first[2]);
        outputs[0] = strain(inputs[0], outputs[1]);
        outputs[2] = inputs[0] / outputs[1];
        outputs[3] = stiffness * std::max(outputs[0], 0.0);
      };
}

inline constexpr ClosedForm kForm{
    .name = "belt_segment",
    .title = "Strain and tension of a belt segment through which material flows",
    .formula = "strain = d/l_ref - 1, l_ref = d(0)/(1 + initial strain) + Psi_a - Psi_b",
    .source = "docs/theory, section 4.1",
    .range = "d > 0 and l_ref > 0; each row by itself, flows from the first row",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::belt_segment
