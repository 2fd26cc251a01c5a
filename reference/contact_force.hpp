// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "reference/closed_form.hpp"

/// Normal force (or moment) of the connection types whose friction is predefined; the universal
/// joint has a header of its own.
///
/// Formula   F_N = F_C + F_int with F_C from the reactions, one function a type below. Two end
///           reactions of a shaft of overlap L that carries the moment M are M/L each, hence the
///           lever 2/L; a puck of radius R carries a tilting moment with M/(2R) on either side,
///           hence 1/R; 2/3 R is the mean friction arm of an evenly pressed disc, of a ring
///           2/3 (R^3 - R_i^3)/(R^2 - R_i^2).
/// Symbols   f1..f3 reaction forces [F], m1..m3 reaction moments [F L], radii and lengths [L],
///           internal contact force [F] or moment [F L].
/// Sign      the result is never negative; the signs of the reactions do not matter.
/// Source    docs/theory, section 4.
/// Range     radii, lengths and internal forces >= 0. A length or radius of 0 switches its term
///           off.
namespace slipbench::reference::contact_force {

/// F_N = |F_C + F_int| [F] for a contact force that may have a sign of its own (a single reaction
/// component); the absolute value is taken after the addition.
inline double effective(double contact_force, double internal_contact_force) {
  return std::abs(contact_force + internal_contact_force);
}

/// The lever that turns a bending moment into contact force [1/L or 1]: numerator/length, 0 if
/// length is.
inline double lever(double numerator, double length) {
  return length == 0.0 ? 0.0 : numerator / length;
}

/// SLOT [F]: sqrt(f2^2 + f3^2) + F_int. In two dimensions there is no f3: give 0 and get |f2| +
/// F_int.
inline double slot(double f2, double f3, double internal_contact_force) {
  return std::hypot(f2, f3) + internal_contact_force;
}

/// SLIDE-PLANE [F]: |f1| + F_int.
inline double slide_plane(double f1, double internal_contact_force) {
  return std::abs(f1) + internal_contact_force;
}

struct Cylindrical {
  double overlap;                 ///< L [L]
  double internal_contact_force;  ///< F_int [F]
};

/// CYLINDRICAL [F]: sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2) + F_int. The radius R does not
/// enter.
inline double cylindrical(const Cylindrical& joint, double f2, double f3, double m2, double m3) {
  return std::hypot(f2, f3) + lever(2.0, joint.overlap) * std::hypot(m2, m3) +
         joint.internal_contact_force;
}

struct Translator {
  double rotation_radius;         ///< R_r [L], the arm at which the guide carries m1
  double overlap;                 ///< L [L]
  double internal_contact_force;  ///< F_int [F]
};

/// TRANSLATOR [F]: |m1|/R_r + sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2) + F_int.
inline double translator(const Translator& joint, double f2, double f3, double m1, double m2,
                         double m3) {
  return lever(1.0, joint.rotation_radius) * std::abs(m1) + std::hypot(f2, f3) +
         lever(2.0, joint.overlap) * std::hypot(m2, m3) + joint.internal_contact_force;
}

struct Hinge {
  double pin_radius;               ///< R_p [L]
  double axial_radius;             ///< R_a [L], the friction arm of the axial force
  double overlap;                  ///< L_s [L]
  double internal_contact_moment;  ///< M_int [F L]
};

/// HINGE [F L]: R_a |f1| + R_p sqrt(f2^2 + f3^2) + (2 R_p/L_s) sqrt(m2^2 + m3^2) + M_int.
inline double hinge(const Hinge& joint, double f1, double f2, double f3, double m2, double m3) {
  return joint.axial_radius * std::abs(f1) + joint.pin_radius * std::hypot(f2, f3) +
         lever(2.0 * joint.pin_radius, joint.overlap) * std::hypot(m2, m3) +
         joint.internal_contact_moment;
}

/// PLANAR, sliding [F]: |f1| + (1/R) sqrt(m2^2 + m3^2) + F_int; R is the puck's radius [L].
inline double planar_sliding(double radius, double internal_contact_force, double f1, double m2,
                             double m3) {
  return std::abs(f1) + lever(1.0, radius) * std::hypot(m2, m3) + internal_contact_force;
}

struct Ring {
  double radius;        ///< R [L]
  double inner_radius;  ///< R_i [L], 0 of a disc
};

/// The mean arm of friction [L] under a ring pressed evenly: the integral of r dA over that of dA.
/// The quotient of the two differences loses all digits of a thin ring; both hold the factor R -
/// R_i.
inline double mean_arm(const Ring& ring) {
  const double a = ring.radius, b = ring.inner_radius;
  return a + b > 0.0 ? 2.0 * (a * a + a * b + b * b) / (3.0 * (a + b)) : 0.0;
}

/// PLANAR, spinning [F L]: a |f1| + sqrt(m2^2 + m3^2) + M_int; a is the ring's mean arm [L].
inline double planar_spinning(const Ring& ring, double internal_contact_moment, double f1,
                              double m2, double m3) {
  return mean_arm(ring) * std::abs(f1) + std::hypot(m2, m3) + internal_contact_moment;
}

inline constexpr std::string_view kSource = "docs/theory, section 4";
inline constexpr std::string_view kRange =
    "lengths, radii and internal forces >= 0; 0 drops a term";

inline constexpr Signal kF1{"f1", "F", "reaction force along 1"};
inline constexpr Signal kF2{"f2", "F", "reaction force along 2"};
inline constexpr Signal kF3{"f3", "F", "reaction force along 3"};
inline constexpr Signal kM1{"m1", "F L", "reaction moment about 1"};
inline constexpr Signal kM2{"m2", "F L", "reaction moment about 2"};
inline constexpr Signal kM3{"m3", "F L", "reaction moment about 3"};
inline constexpr std::array kForceOutput{Signal{"normal_force", "F", "effective normal force"}};
inline constexpr std::array kMomentOutput{Signal{"normal_force", "F L", "effective normal moment"}};

/// A length or radius that switches its term off when absent.
constexpr Parameter optional_length(std::string_view name, std::string_view text) {
  return {.name = name, .dimension = "L", .text = text, .default_value = 0.0, .lower = 0.0};
}

/// A length or radius without which the type has no friction.
constexpr Parameter required_length(std::string_view name, std::string_view text) {
  return {.name = name, .dimension = "L", .text = text, .lower = 0.0, .lower_open = true};
}

inline constexpr Parameter kInternalForce{.name = "internal_contact_force",
                                          .dimension = "F",
                                          .text = "self-equilibrated contact force",
                                          .default_value = 0.0,
                                          .lower = 0.0};
inline constexpr Parameter kInternalMoment{.name = "internal_contact_moment",
                                           .dimension = "F L",
                                           .text = "self-equilibrated contact moment",
                                           .default_value = 0.0,
                                           .lower = 0.0};

inline constexpr std::array kInternalForceOnly{kInternalForce};
inline constexpr std::array kCylindricalParameters{
    required_length("R", "radius; it scales the slip, not the normal force"),
    optional_length("L", "overlap of shaft and sleeve"), kInternalForce};
inline constexpr std::array kTranslatorParameters{
    optional_length("R_r", "arm at which the guide carries the moment about 1"),
    optional_length("L", "overlap of shaft and guide"), kInternalForce};
inline constexpr std::array kHingeParameters{
    required_length("R_p", "radius of the pin"),
    optional_length("R_a", "friction arm of the axial force"),
    optional_length("L_s", "overlap of pin and bearing"), kInternalMoment};
inline constexpr std::array kPlanarParameters{optional_length("R", "radius of the puck"),
                                              kInternalForce, kInternalMoment,
                                              optional_length("R_i", "inner radius of a ring")};

inline constexpr std::array kSlotInputs{
    kF2, Signal{"f3", "F", "reaction force along 3; 0 in two dimensions"}};
inline constexpr std::array kSlidePlaneInputs{kF1};
inline constexpr std::array kCylindricalInputs{kF2, kF3, kM2, kM3};
inline constexpr std::array kTranslatorInputs{kF2, kF3, kM1, kM2, kM3};
inline constexpr std::array kHingeInputs{kF1, kF2, kF3, kM2, kM3};
inline constexpr std::array kPlanarInputs{kF1, kM2, kM3};

inline PathEvaluator make_slot(std::span<const std::vector<double>> values) {
  return [internal = values[0][0]](std::span<const double> in, std::span<double> out) {
    out[0] = slot(in[0], in[1], internal);
  };
}

inline PathEvaluator make_slide_plane(std::span<const std::vector<double>> values) {
  return [internal = values[0][0]](std::span<const double> in, std::span<double> out) {
    out[0] = slide_plane(in[0], internal);
  };
}

inline PathEvaluator make_cylindrical(std::span<const std::vector<double>> values) {
  const Cylindrical joint{values[1][0], values[2][0]};
  return [joint](std::span<const double> in, std::span<double> out) {
    out[0] = cylindrical(joint, in[0], in[1], in[2], in[3]);
  };
}

inline PathEvaluator make_translator(std::span<const std::vector<double>> values) {
  const Translator joint{values[0][0], values[1][0], values[2][0]};
  return [joint](std::span<const double> in, std::span<double> out) {
    out[0] = translator(joint, in[0], in[1], in[2], in[3], in[4]);
  };
}

inline PathEvaluator make_hinge(std::span<const std::vector<double>> values) {
  const Hinge joint{values[0][0], values[1][0], values[2][0], values[3][0]};
  return [joint](std::span<const double> in, std::span<double> out) {
    out[0] = hinge(joint, in[0], in[1], in[2], in[3], in[4]);
  };
}

inline PathEvaluator make_planar_sliding(std::span<const std::vector<double>> values) {
  return [radius = values[0][0], internal = values[1][0]](std::span<const double> in,
                                                          std::span<double> out) {
    out[0] = planar_sliding(radius, internal, in[0], in[1], in[2]);
  };
}

inline std::optional<std::string> ring_violation(std::span<const std::vector<double>> values) {
  const double outer = values[0][0], inner = values[3][0];
  if (inner == 0.0 || inner < outer) return std::nullopt;
  return "R_i must be less than R";
}

inline PathEvaluator make_planar_spinning(std::span<const std::vector<double>> values) {
  const Ring ring{values[0][0], values[3][0]};
  return [ring, internal = values[2][0]](std::span<const double> in, std::span<double> out) {
    out[0] = planar_spinning(ring, internal, in[0], in[1], in[2]);
  };
}

inline PathEvaluator make_component(std::span<const std::vector<double>> values) {
  const double internal = values[0][0];
  return [internal](std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = effective(inputs[0], internal);
  };
}

inline constexpr std::array kComponentInputs{
    Signal{"contact_force", "F", "contact force with its sign, a single reaction"}};

inline constexpr ClosedForm kComponent{
    .name = "contact_force_component",
    .title = "Normal force from a signed contact force and an internal one",
    .formula = "F_N = |F_C + F_int|",
    .source = kSource,
    .range = kRange,
    .parameters = kInternalForceOnly,
    .inputs = kComponentInputs,
    .outputs = kForceOutput,
    .make = make_component,
    .violation = no_violation};
inline constexpr ClosedForm kSlot{.name = "contact_force_slot",
                                  .title = "Normal force of SLOT, two and three dimensions",
                                  .formula = "F_N = sqrt(f2^2 + f3^2) + F_int",
                                  .source = kSource,
                                  .range = kRange,
                                  .parameters = kInternalForceOnly,
                                  .inputs = kSlotInputs,
                                  .outputs = kForceOutput,
                                  .make = make_slot,
                                  .violation = no_violation};
inline constexpr ClosedForm kSlidePlane{.name = "contact_force_slide_plane",
                                        .title = "Normal force of SLIDE-PLANE",
                                        .formula = "F_N = |f1| + F_int",
                                        .source = kSource,
                                        .range = kRange,
                                        .parameters = kInternalForceOnly,
                                        .inputs = kSlidePlaneInputs,
                                        .outputs = kForceOutput,
                                        .make = make_slide_plane,
                                        .violation = no_violation};
inline constexpr ClosedForm kCylindrical{
    .name = "contact_force_cylindrical",
    .title = "Normal force of CYLINDRICAL",
    .formula = "F_N = sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2) + F_int",
    .source = kSource,
    .range = kRange,
    .parameters = kCylindricalParameters,
    .inputs = kCylindricalInputs,
    .outputs = kForceOutput,
    .make = make_cylindrical,
    .violation = no_violation};
inline constexpr ClosedForm kTranslator{
    .name = "contact_force_translator",
    .title = "Normal force of TRANSLATOR",
    .formula = "F_N = |m1|/R_r + sqrt(f2^2 + f3^2) + (2/L) sqrt(m2^2 + m3^2) + F_int",
    .source = kSource,
    .range = kRange,
    .parameters = kTranslatorParameters,
    .inputs = kTranslatorInputs,
    .outputs = kForceOutput,
    .make = make_translator,
    .violation = no_violation};
inline constexpr ClosedForm kHinge{
    .name = "contact_force_hinge",
    .title = "Normal moment of HINGE",
    .formula = "M_N = R_a |f1| + R_p sqrt(f2^2 + f3^2) + (2 R_p/L_s) sqrt(m2^2 + m3^2) + M_int",
    .source = kSource,
    .range = kRange,
    .parameters = kHingeParameters,
    .inputs = kHingeInputs,
    .outputs = kMomentOutput,
    .make = make_hinge,
    .violation = no_violation};
inline constexpr ClosedForm kPlanarSliding{
    .name = "contact_force_planar_sliding",
    .title = "Normal force of PLANAR against sliding",
    .formula = "F_N = |f1| + (1/R) sqrt(m2^2 + m3^2) + F_int",
    .source = kSource,
    .range = kRange,
    .parameters = kPlanarParameters,
    .inputs = kPlanarInputs,
    .outputs = kForceOutput,
    .make = make_planar_sliding,
    .violation = no_violation};
inline constexpr ClosedForm kPlanarSpinning{
    .name = "contact_force_planar_spinning",
    .title = "Normal moment of PLANAR against spinning",
    .formula = "M_N = (2/3)(R^3 - R_i^3)/(R^2 - R_i^2) |f1| + sqrt(m2^2 + m3^2) + M_int",
    .source = kSource,
    .range = kRange,
    .parameters = kPlanarParameters,
    .inputs = kPlanarInputs,
    .outputs = kMomentOutput,
    .make = make_planar_spinning,
    .violation = ring_violation};

}  // namespace slipbench::reference::contact_force
