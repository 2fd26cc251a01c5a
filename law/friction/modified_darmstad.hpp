// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>

#include "law/base/field.hpp"
#include "law/friction/coefficient_curve.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/radioss_coefficient.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Modified Darmstad friction, exponentials of the speed over the pressure (Radioss Ifric 2):
///   mu = Fric + C1 exp(C2 V) p^2 + C3 exp(C4 V) p + C5 exp(C6 V),   p = F_N/A,
///   dmu/dV = C1 C2 exp(C2 V) p^2 + C3 C4 exp(C4 V) p + C5 C6 exp(C6 V),
///   dmu/dp = 2 C1 exp(C2 V) p + C3 exp(C4 V),
/// kept above kCoefficientFloor, where the slopes vanish. V is the slip rate [L/T]. All numbers are
/// admissible; an exponent above kLargestExponent makes the coefficient infinite, and overflow()
/// names it. Without C1 to C4 it is ExponentialDecay (darmstad_decay()).
/// Source: Altair Radioss reference guide, /FRICTION (key RADIOSS). Proven by
/// law/friction/radioss_law_test.
struct ModifiedDarmstad {
  static constexpr std::string_view kName = "modified_darmstad";
  static constexpr std::string_view kTitle = "Modified Darmstad (Radioss Ifric 2)";
  static constexpr std::string_view kFormula =
      "mu = Fric + C1 exp(C2 V) p^2 + C3 exp(C4 V) p + C5 exp(C6 V), p = N/area";
  static constexpr std::string_view kSource = "RADIOSS";
  static constexpr std::array<std::string_view, 0> kRules{};
  static constexpr bool kHasFloor = true;

  double fric = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0, c5 = 0.0, c6 = 0.0;
  std::optional<double> area;  ///< without one it counts as 1

  static constexpr auto fields() {
    using L = ModifiedDarmstad;
    constexpr Dimension kPerSpeed{0, -1, 1};
    return std::tuple{
        Field{"Fric", &L::fric, dimension::kNone, kAnyNumber, false, "Constant part."},
        Field{"C1", &L::c1, Dimension{-2, 4, 0}, kAnyNumber, false, "Factor of p^2 at V = 0."},
        Field{"C2", &L::c2, kPerSpeed, kAnyNumber, false, "Growth of the p^2 part with V."},
        Field{"C3", &L::c3, Dimension{-1, 2, 0}, kAnyNumber, false, "Factor of p at V = 0."},
        Field{"C4", &L::c4, kPerSpeed, kAnyNumber, false, "Growth of the p part with V."},
        Field{"C5", &L::c5, dimension::kNone, kAnyNumber, false, "Part without p at V = 0."},
        Field{"C6", &L::c6, kPerSpeed, kAnyNumber, false, "Growth of the part without p with V."},
        Field{"area", &L::area, Dimension{0, 2, 0}, kPositive, false,
              "Area A of p = N/A; if not given that of the connector."}};
  }

  static ModifiedDarmstad example() { return {0.08, 1e-6, -2e-3, -2e-4, -1e-3, 0.1, -5e-3, 1.0}; }

  /// The coefficient before the floor at p [F/L^2] and V [L/T].
  template <class Number>
  Number raw_coefficient(const Number& p, const Number& v) const {
    using std::exp;
    return fric + (c1 * exp(c2 * v) * p + c3 * exp(c4 * v)) * p + c5 * exp(c6 * v);
  }
  double raw(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    return point(slip).mu;
  }
  CoefficientPoint evaluate(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    return clamped(point(slip));
  }
  /// dmu/d(number) in the order of fields(); 0 on the floor and where an exponent overflows.
  std::array<double, 8> to_numbers(const Ambient& /*ambient*/,
                                   const SlipArguments& slip) const noexcept {
    const CoefficientPoint here = point(slip);
    if (!(here.mu >= kCoefficientFloor) || !std::isfinite(here.mu)) return {};
    const double v = slip.slip_rate;
    const double per_force = 1.0 / area.value_or(1.0);
    const double p = slip.contact_force * per_force;
    const double square = std::exp(std::min(c2 * v, kLargestExponent)) * p * p;
    const double linear = std::exp(std::min(c4 * v, kLargestExponent)) * p;
    const double alone = std::exp(std::min(c6 * v, kLargestExponent));
    return {1.0,
            square,
            c1 * v * square,
            linear,
            c3 * v * linear,
            alone,
            c5 * v * alone,
            -here.to_contact_force * slip.contact_force * per_force};
  }
  /// The coefficient whose exponent overflows at a slip rate [L/T]; empty if none does.
  std::string_view overflow(double slip_rate) const {
    if (c1 != 0.0 && c2 * slip_rate > kLargestExponent) return "C2";
    if (c3 != 0.0 && c4 * slip_rate > kLargestExponent) return "C4";
    if (c5 != 0.0 && c6 * slip_rate > kLargestExponent) return "C6";
    return {};
  }
  bool depends_on_slip_rate() const {
    return (c1 != 0.0 && c2 != 0.0) || (c3 != 0.0 && c4 != 0.0) || (c5 != 0.0 && c6 != 0.0);
  }
  bool depends_on_contact_force() const { return c1 != 0.0 || c3 != 0.0; }
  LawRange range() const {
    LawRange result;
    // Twice as far as the fastest of them: the others are seen well enough.
    for (const auto& [factor, rate] : {std::pair{c1, c2}, {c3, c4}, {c5, c6}}) {
      const double scale = factor == 0.0 ? 0.0 : 2.0 * exponential_scale(rate);
      if (scale > 0.0 && (result.slip_rate == 0.0 || scale < result.slip_rate)) {
        result.slip_rate = scale;
      }
    }
    result.contact_force = area.value_or(1.0) * polynomial_scale(fric + c5, c3, c1);
    return result;
  }
  bool needs_area() const { return depends_on_contact_force() && !area; }

  /// The bounds over all rates and forces; infinity where a term grows for ever.
  double largest() const {
    if (c1 > 0.0 || c3 > 0.0 || (c5 > 0.0 && c6 > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    return std::max(fric + std::max(c5, 0.0), kCoefficientFloor);
  }
  /// Returns the steepest growth of the limit; where no term of p rises, it is that at p = 0.
  double largest_growth() const { return largest(); }
  double steepest_weakening() const {
    const auto falls = [](double factor, double exponent) { return factor * exponent < 0.0; };
    // A pressure has no bound, nor has a negative part that grows.
    if (falls(c1, c2) || falls(c3, c4) || (c5 < 0.0 && c6 > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    return falls(c5, c6) ? -c5 * c6 : 0.0;
  }

  CoefficientCurve along(const SlipLine& line) const noexcept {
    const double span = line.end - line.slip;
    const double per_force = 1.0 / area.value_or(1.0);
    const double p = line.force * per_force;
    const double dp = line.force_per_slip * span * per_force;
    const double v = line.rate_at(line.slip);
    const double dv = line.rate_per_slip * span;
    CoefficientCurve curve;
    curve.numerator = polynomial({fric});
    if (c1 != 0.0) {
      const double factor = c1 * std::exp(c2 * v);
      curve.numerator.add(
          exponential_term(c2 * dv, {factor * p * p, 2.0 * factor * p * dp, factor * dp * dp}));
    }
    if (c3 != 0.0) {
      const double factor = c3 * std::exp(c4 * v);
      curve.numerator.add(exponential_term(c4 * dv, {factor * p, factor * dp}));
    }
    if (c5 != 0.0) curve.numerator.add(exponential_term(c6 * dv, {c5 * std::exp(c6 * v)}));
    return curve;
  }
  double next_bend(const SlipLine& line) const noexcept {
    // Positive exponentials are convex.
    const bool convex = c1 >= 0.0 && c3 >= 0.0 && c5 >= 0.0 && fric >= kCoefficientFloor;
    if ((convex && line.force_per_slip == 0.0) || overflows_at(line)) return kNoBend;
    return law::next_bend(along(line), line);
  }
  double next_belt_bend(const SlipLine& line, double wrap_angle, FlowSense sense) const noexcept {
    if (overflows_at(line)) return kNoBend;
    return law::next_belt_bend(along(line), line, wrap_angle, sense);
  }

 private:
  /// Tells whether an exponent overflows where the search stands: the coefficient is infinite from
  /// there on.
  bool overflows_at(const SlipLine& line) const noexcept {
    return !overflow(line.rate_at(line.slip)).empty();
  }
  /// Before the floor.
  CoefficientPoint point(const SlipArguments& slip) const noexcept {
    const double v = slip.slip_rate;
    if (!overflow(v).empty()) return kOverflown;
    const double per_force = 1.0 / area.value_or(1.0);
    const double p = depends_on_contact_force() ? slip.contact_force * per_force : 0.0;
    const double square = part(c1, c2, v) * p;
    const double linear = part(c3, c4, v);
    const double alone = part(c5, c6, v);
    return {fric + (square + linear) * p + alone, (square * c2 + linear * c4) * p + alone * c6,
            (2.0 * square + linear) * per_force};
  }
  /// factor exp(exponent v), which does not look at v where that does not matter.
  static double part(double factor, double exponent, double v) {
    return factor == 0.0 || exponent == 0.0 ? factor : factor * std::exp(exponent * v);
  }
};

/// The exponential decay from a static to a kinetic coefficient as a case of this law.
inline ModifiedDarmstad darmstad_decay(double mu_static, double kinetic, double decay) {
  ModifiedDarmstad law;
  law.fric = kinetic;
  law.c5 = mu_static - kinetic;
  law.c6 = -decay;
  return law;
}

}  // namespace slipbench::law
