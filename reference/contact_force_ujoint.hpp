// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "reference/closed_form.hpp"
#include "reference/contact_force.hpp"

/// Normal moments of a universal joint: two hinges on each of the cross's two axes.
///
/// Formula   With the cross's axes e1 and e3b = (sin b, -sin a cos b, cos a cos b) their common
///           normal is (0, -cos a, -sin a) for every |b| < pi/2, so that the force's shares are
///           A1 = |f1|, A3 = |f1 sin b + cos b (f3 cos a - f2 sin a)|, B = |f2 cos a + f3 sin a|.
///           A hinge carries, with T = |m2|, the shear V = t_tw T/L_a and the bending share
///           W = (2/L_s) sqrt((B L_a/8)^2 + (k_tw T)^2);
///           M_N1 = 2 [k_ax A1 R_a + R_p (sqrt((B/4)^2 + V^2 + (t_ax A3)^2) + W)] + M_int1,
///           M_N3 the same with A1 and A3 exchanged and M_int3.
/// Symbols   f1..f3 [F], m2 [F L], a = alpha and b = beta joint angles [1], R_p pin radius,
///           R_a friction arm of the axial force, L_s overlap of pin and bearing, L_a length of the
///           cross's arms [L], k_ax, t_ax, k_tw, t_tw slenderness factors [1].
/// Sign      shares are magnitudes; the results are never negative.
/// Source    docs/theory, section 5 (the factors are a fit to a published
///           plot, good to 0.0022); trigonometric form derived in docs/theory.
/// Range     R_p > 0, L_a > 0, |b| < pi/2; R_a, L_s, M_int >= 0 and 0 switches their term off.
namespace slipbench::reference::contact_force_ujoint {

struct SlendernessFactors {
  double axial;          ///< k_ax
  double shear;          ///< t_ax = 1/2 - k_ax
  double twist_bending;  ///< k_tw
  double twist_shear;    ///< t_tw = k_tw + 1/4
};

/// The four factors for a slenderness L_a/R_p > 0 [1].
///
/// With c = 24/0.9: k_ax = (s^2 + c)/(2 (s^2 + c + 12)), below s = 2 the chord from 1/4 at s = 0;
/// k_tw = (2 s^2 - c)/(4 (4 s^2 + c)), below s = 6 the chord from 0 at s = 0.
inline SlendernessFactors slenderness_factors(double slenderness) {
  constexpr double kShear = 24.0 / 0.9;
  const auto axial = [](double s) { return 0.5 * (s * s + kShear) / (s * s + kShear + 12.0); };
  const auto twist = [](double s) {
    return 0.25 * (2.0 * s * s - kShear) / (4.0 * s * s + kShear);
  };
  const double k_ax =
      slenderness < 2.0 ? 0.25 + 0.5 * slenderness * (axial(2.0) - 0.25) : axial(slenderness);
  const double k_tw = slenderness < 6.0 ? slenderness / 6.0 * twist(6.0) : twist(slenderness);
  return {k_ax, 0.5 - k_ax, k_tw, k_tw + 0.25};
}

struct Ujoint {
  double pin_radius;                 ///< R_p [L]
  double axial_radius;               ///< R_a [L]
  double overlap;                    ///< L_s [L]
  double arm_length;                 ///< L_a [L]
  double internal_contact_moment_1;  ///< M_int1 [F L]
  double internal_contact_moment_3;  ///< M_int3 [F L]
};

struct Load {
  double f1;     ///< [F]
  double f2;     ///< [F]
  double f3;     ///< [F]
  double m2;     ///< [F L]
  double alpha;  ///< [1]
  double beta;   ///< [1], |beta| < pi/2
};

struct NormalMoments {
  double axis_1;  ///< M_N1 [F L]
  double axis_3;  ///< M_N3 [F L]
};

/// The normal moments about both axes [F L], with given slenderness factors.
inline NormalMoments normal_moments(const Ujoint& joint, const SlendernessFactors& factors,
                                    const Load& load) {
  const double cos_alpha = std::cos(load.alpha);
  const double sin_alpha = std::sin(load.alpha);
  const double along_1 = std::abs(load.f1);
  const double along_3 =
      std::abs(load.f1 * std::sin(load.beta) +
               std::cos(load.beta) * (load.f3 * cos_alpha - load.f2 * sin_alpha));
  const double across = std::abs(load.f2 * cos_alpha + load.f3 * sin_alpha);
  const double twist = std::abs(load.m2);

  const double shear = factors.twist_shear * twist / joint.arm_length;
  const double bending = contact_force::lever(2.0, joint.overlap) *
                         std::hypot(across * joint.arm_length / 8.0, factors.twist_bending * twist);
  const auto moment = [&](double own_axis, double other_axis, double internal) {
    const double radial = std::hypot(across / 4.0, shear, factors.shear * other_axis);
    return 2.0 * (factors.axial * own_axis * joint.axial_radius +
                  joint.pin_radius * (radial + bending)) +
           internal;
  };
  return {moment(along_1, along_3, joint.internal_contact_moment_1),
          moment(along_3, along_1, joint.internal_contact_moment_3)};
}

/// The normal moments about both axes [F L], factors from the slenderness L_a/R_p.
inline NormalMoments normal_moments(const Ujoint& joint, const Load& load) {
  return normal_moments(joint, slenderness_factors(joint.arm_length / joint.pin_radius), load);
}

inline constexpr std::array kParameters{
    contact_force::required_length("R_p", "radius of the pins"),
    contact_force::optional_length("R_a", "friction arm of the axial force"),
    contact_force::optional_length("L_s", "overlap of pin and bearing"),
    contact_force::required_length("L_a", "length of the cross's arms, hinge to hinge"),
    Parameter{.name = "internal_contact_moment_1",
              .dimension = "F L",
              .text = "self-equilibrated contact moment on axis 1",
              .default_value = 0.0,
              .lower = 0.0},
    Parameter{.name = "internal_contact_moment_3",
              .dimension = "F L",
              .text = "self-equilibrated contact moment on axis 3",
              .default_value = 0.0,
              .lower = 0.0}};
inline constexpr std::array kInputs{
    contact_force::kF1,
    contact_force::kF2,
    contact_force::kF3,
    contact_force::kM2,
    Signal{"alpha", "1", "angle of the joint about axis 1"},
    Signal{"beta", "1", "angle of the joint about the turned axis 2"}};

/// The evaluator of one axis, chosen by the member that holds its moment.
template <double NormalMoments::*axis>
PathEvaluator make(std::span<const std::vector<double>> values) {
  const Ujoint joint{values[0][0], values[1][0], values[2][0],
                     values[3][0], values[4][0], values[5][0]};
  return [joint](std::span<const double> in, std::span<double> out) {
    out[0] = normal_moments(joint, Load{in[0], in[1], in[2], in[3], in[4], in[5]}).*axis;
  };
}

inline constexpr std::string_view kSource = "docs/theory, section 5";
inline constexpr std::string_view kRange =
    "R_p > 0, L_a > 0, |beta| < pi/2; the factors are a fit to a plot, good to 0.0022";

inline constexpr ClosedForm kAxis1{
    .name = "contact_force_ujoint_1",
    .title = "Normal moment of UJOINT about axis 1",
    .formula = "M_N1 = 2 [k_ax A1 R_a + R_p (sqrt((B/4)^2 + V^2 + (t_ax A3)^2) + W)] + M_int1",
    .source = kSource,
    .range = kRange,
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = contact_force::kMomentOutput,
    .make = make<&NormalMoments::axis_1>,
    .violation = no_violation};
inline constexpr ClosedForm kAxis3{
    .name = "contact_force_ujoint_3",
    .title = "Normal moment of UJOINT about axis 3",
    .formula = "M_N3 = 2 [k_ax A3 R_a + R_p (sqrt((B/4)^2 + V^2 + (t_ax A1)^2) + W)] + M_int3",
    .source = kSource,
    .range = kRange,
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = contact_force::kMomentOutput,
    .make = make<&NormalMoments::axis_3>,
    .violation = no_violation};

}  // namespace slipbench::reference::contact_force_ujoint
