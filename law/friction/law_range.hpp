// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

namespace slipbench::law {

/// A point of a coefficient over the slip rate that has a name of its own.
struct Landmark {
  std::string_view name;   ///< "C3"; empty: none
  double slip_rate = 0.0;  ///< [L/T]
};

/// Range over which a coefficient is drawn to be understood; 0 where the law has no scale of its
/// own.
struct LawRange {
  double slip_rate = 0.0;      ///< [L/T]
  double contact_force = 0.0;  ///< F_N [F]
  std::array<Landmark, 3> landmarks{};
};

/// After so many times the reciprocal of its rate an exponential has nothing left to show.
inline constexpr double kDecays = 4.0;

/// Returns where constant + linear x + square x^2 has turned (twice the vertex), or else has
/// changed by its own size; 0 if it never does.
inline double polynomial_scale(double constant, double linear, double square) {
  // The size of a change of mu that is worth seeing, where the law has none itself.
  constexpr double kTypicalCoefficient = 0.1;
  if (linear * square < 0.0) return -linear / square;
  const double size = std::fmax(std::abs(constant), kTypicalCoefficient);
  if (linear != 0.0) return size / std::abs(linear);
  return square != 0.0 ? std::sqrt(size / std::abs(square)) : 0.0;
}

/// Returns where exp(rate x) has died away, or grown e times.
inline double exponential_scale(double rate) {
  if (rate == 0.0) return 0.0;
  return rate < 0.0 ? -kDecays / rate : 1.0 / rate;
}

}  // namespace slipbench::law
