// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "law/base/convention.hpp"

namespace slipbench::law {

/// First-order filter of the friction force,
///   F_k = alpha Fraw_k + (1 - alpha) F_{k-1},   F_{-1} = 0,
/// behind the friction bound; it starts again where contact opens. A constant force raw gives
/// F_k = Fraw (1 - (1 - alpha)^(k+1)); a harmonic one comes out at -3 dB where its step in phase w
/// has cos w = 1 - alpha^2 / (2 (1 - alpha)), which exists up to alpha = 2 (sqrt 2 - 1).
/// Source: Radioss reference guide, /FRICTION (key RADIOSS), Ifiltr 1 to 3.
struct Filter {
  enum class Kind : std::uint8_t {
    kNone,
    kSimple,    ///< alpha = value
    kPeriod,    ///< alpha = 2 pi dt / value, value a time [T]; must not exceed 1
    kFrequency  ///< alpha = min(1, 2 pi value dt), value a frequency [1/T]; as coded max(1, ..)
  };
  Kind kind = Kind::kNone;
  double value = 0.0;
  bool clip = false;  ///< after the filter back to mu N, which neither page nor program do
};

/// alpha [1] of an increment of duration dt [T]; 1 without a filter. Above 1, which a period
/// shorter than 2 pi dt gives, the filter over-corrects; the reader of cases refuses that.
inline double filter_coefficient(const Filter& filter, double dt, Convention convention) noexcept {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  switch (filter.kind) {
    case Filter::Kind::kSimple:
      return filter.value;
    case Filter::Kind::kPeriod:
      return kTwoPi * dt / filter.value;
    case Filter::Kind::kFrequency: {
      const double alpha = kTwoPi * filter.value * dt;
      return convention == Convention::kDocumented ? std::min(1.0, alpha) : std::max(1.0, alpha);
    }
    default:
      return 1.0;
  }
}

}  // namespace slipbench::law
