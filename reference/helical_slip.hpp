// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/contact_force.hpp"
#include "reference/planar_slider.hpp"

/// A shaft that slides and turns in its bushing at once (CYLINDRICAL).
///
/// Formula   lim = mu F_N, F_N = sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2) + F_int; f1 = lim
///           v/V, m1 = lim R (R omega)/V, V = sqrt(v^2 + (R omega)^2), power = lim V.
/// Symbols   v velocity along the axis [L/T], omega rate of rotation [1/T], R radius [L], L overlap
///           [L], f2, f3, m2, m3 reactions [F, F L], f1, m1 friction force and moment [F, F L].
/// Sign      f1 and m1 have the signs of v and omega.
/// Source    docs/theory, sections 4 and 14.7.
/// Range     R > 0, mu, L, F_int >= 0 (L = 0 switches bending off); steady slip, each row by
///           itself.
namespace slipbench::reference::helical_slip {

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "radius",
              .dimension = "L",
              .text = "radius of the shaft",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "overlap",
              .dimension = "L",
              .text = "overlap of shaft and bushing; 0 leaves bending out",
              .lower = 0.0},
    Parameter{.name = "internal_contact_force",
              .dimension = "F",
              .text = "internal contact force",
              .default_value = 0.0,
              .lower = 0.0}};
inline constexpr Signal kF2{"f2", "F", "reaction force along 2"};
inline constexpr Signal kF3{"f3", "F", "reaction force along 3"};
inline constexpr Signal kM2{"m2", "F L", "reaction moment about 2"};
inline constexpr Signal kM3{"m3", "F L", "reaction moment about 3"};
inline constexpr std::array kInputs{Signal{"velocity", "L/T", "velocity along the axis"},
                                    Signal{"rotation_rate", "1/T", "rate of rotation about it"},
                                    kF2,
                                    kF3,
                                    kM2,
                                    kM3};
inline constexpr std::array kOutputs{Signal{"force", "F", "friction force along the axis"},
                                     Signal{"moment", "F L", "friction moment about the axis"},
                                     Signal{"limit", "F", "limiting friction force"},
                                     Signal{"slip_rate", "L/T", "rate of slip along the helix"},
                                     Signal{"power", "F L/T", "dissipated power"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const contact_force::Cylindrical joint{values[2][0], values[3][0]};
  return [joint, mu = values[0][0], radius = values[1][0]](std::span<const double> inputs,
                                                           std::span<double> outputs) {
    const double limit =
        mu * contact_force::cylindrical(joint, inputs[2], inputs[3], inputs[4], inputs[5]);
    const bool moves = inputs[0] != 0.0 || inputs[1] != 0.0;
    const auto slip = moves ? planar_slider::helical_slip(limit, radius, inputs[0], inputs[1])
                            : planar_slider::HelicalSlip{0.0, 0.0, 0.0, 0.0};
    outputs[0] = slip.force;
    outputs[1] = slip.moment;
    outputs[2] = limit;
    outputs[3] = slip.slip_rate;
    outputs[4] = slip.power;
  };
}

inline constexpr ClosedForm kForm{
    .name = "helical_slip",
    .title = "Steady slip of a CYLINDRICAL shaft that slides and turns",
    .formula = "f1 = lim v/V, m1 = lim R^2 omega/V, V = sqrt(v^2 + (R omega)^2)",
    .source = "docs/theory, sections 4 and 14.7",
    .range = "R > 0; steady slip, no force while nothing moves",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::helical_slip
