// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/masing.hpp"

/// Two elastic spheres, or a sphere on a plane, pressed together and then loaded tangentially:
/// microslip from the edge of the contact inwards.
///
/// Formula   Hertz: a = (3 N R_e/(4 E*))^(1/3). Loading: u = u_s [1 - (1 - q)^(2/3)], q = T/(mu N),
///           u_s = 3 mu N Lam/(16 a); stick radius c = a (1 - q)^(1/3). Reversals: Masing. Loop:
///           E = (9 (mu N)^2 Lam/(10 a)) {1 - (1-q)^(5/3) - (5q/6) [1 + (1-q)^(2/3)]}.
/// Symbols   N normal force [F], T tangential force [F], u tangential motion of distant points [L],
///           R_e effective radius [L], E* effective modulus [F/L^2], Lam = (2-nu_1)/G_1 +
///           (2-nu_2)/G_2 tangential compliance [L^2/F], a contact radius [L], mu coefficient [1].
/// Sign      T has the sign of the motion it resists.
/// Source    Cattaneo 1938; Mindlin 1949; Mindlin and Deresiewicz 1953; Johnson 1985, chapters 4
///           and 7.
/// Range     N, mu > 0, constant; small contact, elastically similar bodies (else approximate);
///           exact on piecewise-linear motion with its turning points on rows.
namespace slipbench::reference::cattaneo_mindlin {

struct Body {
  double radius;          ///< [L], infinite for a plane
  double youngs_modulus;  ///< [F/L^2], > 0
  double poissons_ratio;  ///< [1]
};

struct Pair {
  double effective_radius;       ///< R_e [L]: 1/R_e = 1/R_1 + 1/R_2
  double effective_modulus;      ///< E* [F/L^2]: 1/E* = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2
  double tangential_compliance;  ///< Lam [L^2/F]: (2-nu)/G summed over the bodies
};

/// The two bodies as one pair; not both may be planes.
inline Pair pair(const Body& first, const Body& second) {
  const auto softness = [](const Body& b) {
    return (1.0 - b.poissons_ratio * b.poissons_ratio) / b.youngs_modulus;
  };
  const auto shear = [](const Body& b) {
    return (2.0 - b.poissons_ratio) * 2.0 * (1.0 + b.poissons_ratio) / b.youngs_modulus;
  };
  return {1.0 / (1.0 / first.radius + 1.0 / second.radius),
          1.0 / (softness(first) + softness(second)), shear(first) + shear(second)};
}

struct Hertz {
  double contact_radius;  ///< a [L]
  double approach;        ///< of distant points, a^2/R_e [L]
  double peak_pressure;   ///< 3 N/(2 pi a^2) [F/L^2]
};

/// Contact of two spheres under N > 0 [F] (Hertz 1882).
inline Hertz hertz(const Pair& pair, double normal_force) {
  const double a = std::cbrt(0.75 * normal_force * pair.effective_radius / pair.effective_modulus);
  return {a, a * a / pair.effective_radius, 1.5 * normal_force / (std::numbers::pi * a * a)};
}

struct Contact {
  double limit;           ///< mu N [F], > 0
  double contact_radius;  ///< a [L], > 0
  double compliance;      ///< Lam [L^2/F], > 0
};

inline Contact contact(const Pair& pair, double mu, double normal_force) {
  return {mu * normal_force, hertz(pair, normal_force).contact_radius, pair.tangential_compliance};
}

/// Stiffness while nothing slips, 8 a/Lam [F/L].
inline double initial_stiffness(const Contact& contact) {
  return 8.0 * contact.contact_radius / contact.compliance;
}

/// The motion u_s at which everything slips [L], 1.5 times mu N over the initial stiffness.
inline double slip_motion(const Contact& contact) {
  return 1.5 * contact.limit / initial_stiffness(contact);
}

/// 1 - (1 - x)^p without cancellation for small x; x in [0, 1].
inline double power_fall(double x, double p) { return -std::expm1(p * std::log1p(-x)); }

/// Motion [L] on first loading to the force T [F], held at +-u_s beyond the limit; odd.
inline double loading_motion(const Contact& contact, double force) {
  const double q = std::min(std::abs(force) / contact.limit, 1.0);
  return std::copysign(slip_motion(contact) * power_fall(q, 2.0 / 3.0), force);
}

/// Radius [L] of the circle that sticks on first loading, a (1 - q)^(1/3); 0 beyond the limit.
inline double stick_radius(const Contact& contact, double force) {
  const double q = std::min(std::abs(force) / contact.limit, 1.0);
  return contact.contact_radius * std::cbrt(1.0 - q);
}

/// The sum over n >= first of (-x)^n (alpha C(3/2, n) + beta C(5/2, n)), C the binomials.
inline double binomial_tail(double x, int first, double alpha, double beta) {
  double three_halves = 1.0;
  double five_halves = 1.0;
  double sum = 0.0;
  for (int n = 1; n <= 50; ++n) {
    three_halves *= -x * (2.5 - n) / n;
    five_halves *= -x * (3.5 - n) / n;
    if (n >= first) sum += alpha * three_halves + beta * five_halves;
  }
  return sum;
}

/// Below this u/u_s the energies are summed as series, for their closed forms cancel.
inline constexpr double kSeriesBelow = 0.5;

/// Force [F] on first loading to the motion u [L]: mu N [1 - (1 - u/u_s)^(3/2)], then mu N; odd.
inline double backbone(const Contact& contact, double motion) {
  const double x = std::min(std::abs(motion) / slip_motion(contact), 1.0);
  return std::copysign(contact.limit * power_fall(x, 1.5), motion);
}

/// Integral of the backbone from 0 [F L]; even: mu N u_s [x - (2/5) (1 - (1-x)^(5/2))], x = u/u_s,
/// linear beyond.
inline double backbone_work(const Contact& contact, double motion) {
  const double scale = contact.limit * slip_motion(contact);
  const double x = std::abs(motion) / slip_motion(contact);
  if (x < kSeriesBelow) return scale * binomial_tail(x, 2, 0.0, 0.4);
  if (x > 1.0) return scale * (0.6 + (x - 1.0));
  return scale * (x - 0.4 * power_fall(x, 2.5));
}

/// Energy [F L] of one closed loop of the motion amplitude A >= 0 [L]; beyond u_s the whole contact
/// slides for the rest, 4 mu N (A - u_s).
inline double loop_energy(const Contact& contact, double amplitude) {
  const double limit = contact.limit;
  // (9 (mu N)^2 Lam/(10 a)) expressed with u_s = 3 mu N Lam/(16 a)
  const double scale = 4.8 * limit * slip_motion(contact);
  const double x = amplitude / slip_motion(contact);
  if (x < kSeriesBelow) return scale * binomial_tail(x, 3, 5.0 / 6.0, -1.0 / 6.0);
  if (x > 1.0) return scale / 6.0 + 4.0 * limit * slip_motion(contact) * (x - 1.0);
  const double q = power_fall(x, 1.5);
  return scale * (power_fall(x, 2.5) - 5.0 / 6.0 * q * (2.0 - x));
}

/// Energy [F L] of one closed loop of the force amplitude T [F], 0 <= T <= mu N; the value at mu N
/// beyond.
inline double loop_energy_over_force(const Contact& contact, double force_amplitude) {
  return loop_energy(contact, loading_motion(contact, force_amplitude));
}

inline constexpr std::array kHertzParameters{
    Parameter{.name = "radius1",
              .dimension = "L",
              .text = "radius of the first sphere",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "radius2",
              .dimension = "L",
              .text = "radius of the second sphere; a plane if absent",
              .default_value = std::numeric_limits<double>::infinity(),
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "youngs_modulus1",
              .dimension = "F/L^2",
              .text = "Young's modulus of the first body",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "youngs_modulus2",
              .dimension = "F/L^2",
              .text = "Young's modulus of the second body",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "poissons_ratio1",
              .dimension = "1",
              .text = "Poisson's ratio of the first body",
              .lower = 0.0,
              .upper = 0.5},
    Parameter{.name = "poissons_ratio2",
              .dimension = "1",
              .text = "Poisson's ratio of the second body",
              .lower = 0.0,
              .upper = 0.5}};
inline constexpr std::array kParameters{kHertzParameters[0],
                                        kHertzParameters[1],
                                        kHertzParameters[2],
                                        kHertzParameters[3],
                                        kHertzParameters[4],
                                        kHertzParameters[5],
                                        Parameter{.name = "normal_force",
                                                  .dimension = "F",
                                                  .text = "normal force, constant",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "mu",
                                                  .dimension = "1",
                                                  .text = "friction coefficient",
                                                  .lower = 0.0,
                                                  .lower_open = true}};

inline Pair pair_of(std::span<const std::vector<double>> values) {
  return pair({values[0][0], values[2][0], values[4][0]},
              {values[1][0], values[3][0], values[5][0]});
}

inline Contact contact_of(std::span<const std::vector<double>> values) {
  return contact(pair_of(values), values[7][0], values[6][0]);
}

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (!std::isinf(values[0][0]) || !std::isinf(values[1][0])) return std::nullopt;
  return "radius1 and radius2 are both infinite; one body must be a sphere";
}

inline constexpr std::array kInputs{Signal{"motion", "L", "relative tangential motion"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "tangential force"},
    Signal{"dissipation", "F L", "energy dissipated by microslip and sliding"},
    Signal{"stored_energy", "F L", "work less dissipation"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return masing::evaluator(contact_of(values));
}

inline constexpr ClosedForm kForm{
    .name = "cattaneo_mindlin",
    .title = "Microslip of two spheres under constant normal force, Masing branches",
    .formula = "T = mu N [1 - (1 - u/u_s)^(3/2)], u_s = 3 mu N Lam/(16 a); T = T_r -+ 2 T(|du|/2)",
    .source = "Cattaneo 1938; Mindlin 1949; Mindlin and Deresiewicz 1953; Johnson 1985",
    .range = "mu, N > 0; elastically similar bodies; turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

inline constexpr std::array kLoopInputs{
    Signal{"force", "F", "amplitude of the tangential force, up to mu N; held beyond"}};
inline constexpr std::array kLoopOutputs{
    Signal{"motion", "L", "motion on first loading to that force"},
    Signal{"stick_radius", "L", "radius of the circle that still sticks"},
    Signal{"loop_energy", "F L", "energy of one closed loop of that amplitude"}};

inline PathEvaluator make_loop(std::span<const std::vector<double>> values) {
  return [contact = contact_of(values)](std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = loading_motion(contact, inputs[0]);
    outputs[1] = stick_radius(contact, inputs[0]);
    outputs[2] = loop_energy_over_force(contact, std::abs(inputs[0]));
  };
}

inline constexpr ClosedForm kLoopForm{
    .name = "cattaneo_mindlin_loop",
    .title = "Loading curve and loop energy of two spheres over the force amplitude",
    .formula = "u = u_s [1 - (1 - q)^(2/3)]; E = (9 (mu N)^2 Lam/(10 a)) {1 - (1-q)^(5/3) - ...}",
    .source = "Mindlin and Deresiewicz 1953; Johnson 1985, chapter 7",
    .range = "mu, N > 0; |T| <= mu N; each row by itself",
    .parameters = kParameters,
    .inputs = kLoopInputs,
    .outputs = kLoopOutputs,
    .make = make_loop,
    .violation = violation};

inline constexpr std::array kHertzInputs{
    Signal{"normal_force", "F", "normal force, none or less is no contact"}};
inline constexpr std::array kHertzOutputs{
    Signal{"contact_radius", "L", "radius of the contact"},
    Signal{"approach", "L", "approach of distant points"},
    Signal{"peak_pressure", "F/L^2", "pressure in the middle of the contact"},
    Signal{"tangential_stiffness", "F/L", "8 a/Lam, while nothing slips"}};

inline PathEvaluator make_hertz(std::span<const std::vector<double>> values) {
  return [pair = pair_of(values)](std::span<const double> inputs, std::span<double> outputs) {
    const bool touches = inputs[0] > 0.0;
    const Hertz contact = touches ? hertz(pair, inputs[0]) : Hertz{0.0, 0.0, 0.0};
    outputs[0] = contact.contact_radius;
    outputs[1] = contact.approach;
    outputs[2] = contact.peak_pressure;
    outputs[3] = 8.0 * contact.contact_radius / pair.tangential_compliance;
  };
}

inline constexpr ClosedForm kHertzForm{
    .name = "hertz",
    .title = "Contact of two spheres without friction",
    .formula = "a = (3 N R_e/(4 E*))^(1/3), approach a^2/R_e, p_0 = 3 N/(2 pi a^2)",
    .source = "Hertz 1882; Johnson 1985, chapter 4",
    .range = "a much smaller than the radii; each row by itself",
    .parameters = kHertzParameters,
    .inputs = kHertzInputs,
    .outputs = kHertzOutputs,
    .make = make_hertz,
    .violation = violation};

}  // namespace slipbench::reference::cattaneo_mindlin
