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

/// Generalised viscous friction, a polynomial of pressure and speed (Radioss Ifric 1):
///   mu = Fric + C1 p + C2 V + C3 p V + C4 p^2 + C5 V^2,   p = F_N/A,
///   dmu/dV = C2 + C3 p + 2 C5 V,   dmu/dp = C1 + C3 V + 2 C4 p,
/// kept above kCoefficientFloor, where the slopes vanish. V is the slip rate [L/T]. The page's
/// sixth coefficient is not used by this law. All numbers are admissible; a polynomial grows
/// without bound or falls below zero outside of the data it was fitted to. Source: Altair Radioss
/// reference guide, /FRICTION (key RADIOSS). Proven by law/friction/radioss_law_test.
struct GeneralizedViscous {
  static constexpr std::string_view kName = "generalized_viscous";
  static constexpr std::string_view kTitle = "Generalised viscous (Radioss Ifric 1)";
  static constexpr std::string_view kFormula =
      "mu = Fric + C1 p + C2 V + C3 p V + C4 p^2 + C5 V^2, p = N/area";
  static constexpr std::string_view kSource = "RADIOSS";
  static constexpr std::array<std::string_view, 0> kRules{};
  static constexpr bool kHasFloor = true;

  double fric = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0, c5 = 0.0, c6 = 0.0;
  std::optional<double> area;  ///< without one it counts as 1

  static constexpr auto fields() {
    using L = GeneralizedViscous;
    return std::tuple{
        Field{"Fric", &L::fric, dimension::kNone, kAnyNumber, false,
              "Coefficient at p = 0, V = 0."},
        Field{"C1", &L::c1, Dimension{-1, 2, 0}, kAnyNumber, false, "Factor of p."},
        Field{"C2", &L::c2, Dimension{0, -1, 1}, kAnyNumber, false, "Factor of V."},
        Field{"C3", &L::c3, Dimension{-1, 1, 1}, kAnyNumber, false, "Factor of p V."},
        Field{"C4", &L::c4, Dimension{-2, 4, 0}, kAnyNumber, false, "Factor of p^2."},
        Field{"C5", &L::c5, Dimension{0, -2, 2}, kAnyNumber, false, "Factor of V^2."},
        Field{"C6", &L::c6, dimension::kNone, kAnyNumber, false, "Not used by this law."},
        Field{"area", &L::area, Dimension{0, 2, 0}, kPositive, false,
              "Area A of p = N/A; if not given that of the connector."}};
  }

  static GeneralizedViscous example() { return {0.12, -2e-4, -1e-4, 1e-6, 4e-7, 5e-8, 0.0, 1.0}; }

  Remark remark() const {
    if (c6 == 0.0) return {};
    return {"C6", "C6 is not used by this law (Radioss Ifric 1 has C1 to C5)"};
  }

  /// The coefficient before the floor at p [F/L^2] and V [L/T].
  template <class Number>
  Number raw_coefficient(const Number& p, const Number& v) const {
    return fric + (c1 + c3 * v + c4 * p) * p + (c2 + c5 * v) * v;
  }
  double raw(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    return raw_coefficient(slip.contact_force * per_force(), slip.slip_rate);
  }
  CoefficientPoint evaluate(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    // What it does not depend on it does not look at.
    const double p = depends_on_contact_force() ? slip.contact_force * per_force() : 0.0;
    const double v = depends_on_slip_rate() ? slip.slip_rate : 0.0;
    return clamped({raw_coefficient(p, v), c2 + c3 * p + 2.0 * c5 * v,
                    (c1 + c3 * v + 2.0 * c4 * p) * per_force()});
  }
  /// dmu/d(number) in the order of fields(); 0 on the floor.
  std::array<double, 8> to_numbers(const Ambient& ambient,
                                   const SlipArguments& slip) const noexcept {
    if (!(raw(ambient, slip) >= kCoefficientFloor)) return {};
    const double v = slip.slip_rate;
    const double p = slip.contact_force * per_force();
    const double by_area = -(c1 + c3 * v + 2.0 * c4 * p) * p * per_force();
    return {1.0, p, v, p * v, p * p, v * v, 0.0, by_area};
  }
  bool depends_on_slip_rate() const { return c2 != 0.0 || c3 != 0.0 || c5 != 0.0; }
  bool depends_on_contact_force() const { return c1 != 0.0 || c3 != 0.0 || c4 != 0.0; }
  LawRange range() const {
    return {
        polynomial_scale(fric, c2, c5), area.value_or(1.0) * polynomial_scale(fric, c1, c4), {}};
  }
  bool needs_area() const { return depends_on_contact_force() && !area; }

  /// The bounds over all rates and forces; infinity where a term grows for ever.
  double largest() const {
    const bool grows = c1 > 0.0 || c2 > 0.0 || c3 > 0.0 || c4 > 0.0 || c5 > 0.0;
    return grows ? std::numeric_limits<double>::infinity() : std::max(fric, kCoefficientFloor);
  }
  /// Returns the steepest growth of the limit; where no term of p rises, it is that at p = 0.
  double largest_growth() const { return largest(); }
  double steepest_weakening() const {
    return c3 < 0.0 || c5 < 0.0 ? std::numeric_limits<double>::infinity() : std::max(-c2, 0.0);
  }

  CoefficientCurve along(const SlipLine& line) const noexcept {
    const double span = line.end - line.slip;
    const double p = line.force * per_force();
    const double dp = line.force_per_slip * span * per_force();
    const double v = line.rate_at(line.slip);
    const double dv = line.rate_per_slip * span;
    return {.numerator =
                polynomial({raw_coefficient(p, v),
                            (c1 + c3 * v + 2.0 * c4 * p) * dp + (c2 + c3 * p + 2.0 * c5 * v) * dv,
                            c3 * dp * dv + c4 * dp * dp + c5 * dv * dv}),
            .denominator = {}};
  }
  double next_bend(const SlipLine& line) const noexcept {
    return line.force_per_slip == 0.0 ? next_at_floor(line) : law::next_bend(along(line), line);
  }
  double next_belt_bend(const SlipLine& line, double wrap_angle, FlowSense sense) const noexcept {
    return law::next_belt_bend(along(line), line, wrap_angle, sense);
  }

 private:
  /// Under a constant normal force mu F_N is a parabola, which bends at the floor alone: the next
  /// root of a v^2 + b v + c.
  double next_at_floor(const SlipLine& line) const noexcept {
    if (!(line.rate_per_slip > 0.0)) return kNoBend;
    const double p = line.force * per_force();
    const double a = c5;
    const double b = c2 + c3 * p;
    const double c = raw_coefficient(p, double{0.0}) - kCoefficientFloor;
    const double square = b * b - 4.0 * a * c;
    if (!(square >= 0.0)) return kNoBend;
    // The form of the roots that does not cancel; a division by 0 gives none ahead.
    const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
    double next = kNoBend;
    for (const double v : {q / a, c / q}) {
      const double x = (v - line.rate_at_zero) / line.rate_per_slip;
      if (is_ahead(line, x)) next = std::min(next, x);
    }
    return next;
  }
  double per_force() const { return 1.0 / area.value_or(1.0); }
};

}  // namespace slipbench::law
