// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

#include "law/base/field.hpp"

namespace slipbench::law {

/// Stribeck friction with a viscous part: it falls from rest to sliding and rises with the speed:
///   mu = kinetic + (static - kinetic) exp(-(V/V_s)^delta) + c V,   V >= 0 the slip rate [L/T].
/// Smooth for V > 0; mu(0) = static. Admissible: static >= kinetic >= 0, V_s > 0, c >= 0, and
/// delta >= 1, below which the coefficient falls with an infinite slope from rest.
/// Source: Armstrong-Helouvry, Dupont & Canudas de Wit 1994 (key ADC1994); without their sign of
/// the velocity, which the slip direction has. Proven by law/friction/stribeck_test.
template <class Number = double>
struct Stribeck {
  static constexpr std::string_view kName = "stribeck";
  static constexpr std::string_view kTitle = "Stribeck friction with a viscous part";
  static constexpr std::string_view kFormula =
      "mu = kinetic + (static - kinetic) exp(-(V/stribeck_rate)^exponent) + viscous V";
  static constexpr std::string_view kSource = "ADC1994";
  static constexpr std::array<std::string_view, 1> kRules{"'static' must not be below 'kinetic'"};
  static constexpr bool kHasFloor = false;  // every term is >= 0

  Number mu_static{}, kinetic{}, stribeck_rate{1.0}, exponent{2.0}, viscous{};

  static constexpr auto fields() {
    return std::tuple{
        Field{"static", &Stribeck::mu_static, dimension::kNone, kNotNegative, true,
              "Coefficient at slip rate zero, mu_s."},
        Field{"kinetic", &Stribeck::kinetic, dimension::kNone, kNotNegative, true,
              "Coefficient far beyond the Stribeck rate without the viscous part, mu_c."},
        Field{"stribeck_rate", &Stribeck::stribeck_rate, Dimension{0, 1, -1}, kPositive, true,
              "Stribeck velocity V_s, at which 1/e of static - kinetic is left."},
        Field{"exponent", &Stribeck::exponent, dimension::kNone, Bounds{.lower = 1.0}, false,
              "Shape delta of the fall: 1 exponential, 2 Gaussian."},
        Field{"viscous", &Stribeck::viscous, Dimension{0, -1, 1}, kNotNegative, false,
              "Growth c of the coefficient with the slip rate."}};
  }
  std::optional<std::string_view> violation() const {
    if (mu_static < kinetic) return kRules[0];
    return std::nullopt;
  }
  static Stribeck example() { return {0.3, 0.2, 10.0, 2.0, 1e-4}; }

  Number coefficient(const Number& slip_rate) const {
    using std::exp, std::pow;
    return kinetic + (mu_static - kinetic) * exp(-pow(slip_rate / stribeck_rate, exponent)) +
           viscous * slip_rate;
  }
};

}  // namespace slipbench::law
