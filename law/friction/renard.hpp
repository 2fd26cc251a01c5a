// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "law/base/field.hpp"
#include "law/base/unit_name.hpp"
#include "law/friction/coefficient_curve.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/radioss_coefficient.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Fate of a broken rule of Renard's constants.
enum class RenardRules : std::uint8_t {
  kStrict,  ///< an error
  kLenient  ///< a warning, where mu still has a meaning
};
constexpr std::array<std::string_view, 2> enum_words(RenardRules) { return {"strict", "lenient"}; }

/// Renard friction: from C1 at rest up to C3 at the speed C5, down to C4 at C6, then towards C2
/// (Radioss Ifric 3). With the speed V in the unit the constants were fitted in:
///   V <= C5:      x = V/C5,                mu = C1 + (C3 - C1) x (2 - x)
///   C5 < V < C6:  y = (V - C5)/(C6 - C5),  mu = C3 - (C3 - C4) y^2 (3 - 2 y)
///   V >= C6:      d = C2 - C4, s = V - C6, q = 1 + d s^2,   mu = C2 - d/q
/// and the slopes dmu/dV = 2 (C3 - C1) (1 - x)/C5, -6 (C3 - C4) y (1 - y)/(C6 - C5), 2 d^2 s/q^2.
/// Value and slope are continuous; at C5 and C6 the slope is 0. The pressure does not enter.
/// The last piece hides a unit: d has none, s is a speed, so half of the way from C4 to C2 is
/// covered 1/sqrt(C2 - C4) speed units beyond C6, whatever that unit is. V = speed_factor times the
/// slip rate keeps the constants, and that unit, as they were fitted.
/// Admissible: see kRules; lenient lets pass all but C5 > 0, C5 < C6 and C4 <= C2, without which mu
/// has no meaning or a pole.
/// Source: Altair Radioss reference guide, /FRICTION (key RADIOSS). Proven by
/// law/friction/radioss_law_test.
struct Renard {
  static constexpr std::string_view kName = "renard";
  static constexpr std::string_view kTitle = "Renard (Radioss Ifric 3)";
  static constexpr std::string_view kFormula =
      "V <= C5: mu = C1 + (C3 - C1) x (2 - x), x = V/C5; C5 < V < C6: mu = C3 - (C3 - C4) y^2 (3 - "
      "2 y), y = (V - C5)/(C6 - C5); V >= C6: mu = C2 - d/(1 + d s^2), d = C2 - C4, s = V - C6";
  static constexpr std::string_view kSource = "RADIOSS";
  static constexpr std::size_t kNeeded = 3;  ///< of kRules, even if lenient
  static constexpr std::array<std::string_view, 10> kRules{
      "C5 > 0 must hold",   "C5 < C6 must hold",  "C4 <= C2 must hold, or mu has a pole beyond C6",
      "C1 <= C3 must hold", "C2 <= C3 must hold", "C4 <= C1 must hold",
      "C1 >= 0 must hold",  "C2 >= 0 must hold",  "C3 >= 0 must hold",
      "C4 >= 0 must hold"};
  static constexpr bool kHasFloor = true;
  static constexpr std::string_view kNote =
      "The unit of speed is part of the constants: the last piece adds (V - C6)^2 to a number "
      "without unit, so half of the way from C4 to C2 is done 1/sqrt(C2 - C4) units of speed "
      "beyond C6, whichever unit that is. The case must state its units; 'speed_unit' is that of "
      "the constants if it is another.";
  static constexpr std::string_view kWithoutUnits =
      "its piece beyond C6 hides a unit of speed: the case must state its units of length and time";
  static constexpr Remark kForeignKey{"Fric",
                                      "Renard's law has no Fric: its coefficient at rest is C1"};

  double c1 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0, c5 = 1.0, c6 = 2.0;
  double speed_factor = 1.0;  ///< (unit of speed of the case)/(that of the constants)
  UnitName speed_unit;        ///< of C5, C6 and the last piece; empty: the case's own
  RenardRules rules = RenardRules::kStrict;

  static constexpr auto fields() {
    using L = Renard;
    constexpr Dimension kSpeed{0, 1, -1};
    return std::tuple{
        Field{"C1", &L::c1, dimension::kNone, kAnyNumber, true, "mu_s, at rest."},
        Field{"C2", &L::c2, dimension::kNone, kAnyNumber, true, "mu_d, at high speed."},
        Field{"C3", &L::c3, dimension::kNone, kAnyNumber, true, "mu_max, at the speed C5."},
        Field{"C4", &L::c4, dimension::kNone, kAnyNumber, true, "mu_min, at the speed C6."},
        Field{"C5", &L::c5, kSpeed, kPositive, true, "Vcr1, the speed of mu_max."},
        Field{"C6", &L::c6, kSpeed, kPositive, true, "Vcr2, the speed of mu_min."},
        Field{"speed_unit", &L::speed_unit, dimension::kNone, kAnyNumber, false,
              "Unit of speed the constants were fitted in (mm/ms), if not the case's own."},
        Field{"rules", &L::rules, dimension::kNone, kAnyNumber, false,
              "lenient makes warnings of the rules without which mu still has a meaning."}};
  }

  static Renard example() {
    Renard law;
    law.c1 = 0.15, law.c2 = 0.10, law.c3 = 0.25, law.c4 = 0.05, law.c5 = 10.0, law.c6 = 100.0;
    return law;
  }

  /// Tells whether the rules hold, in the order of kRules.
  std::array<bool, kRules.size()> rules_held() const {
    return {c5 > 0.0, c5 < c6,   c4 <= c2,  c1 <= c3,  c2 <= c3,
            c4 <= c1, c1 >= 0.0, c2 >= 0.0, c3 >= 0.0, c4 >= 0.0};
  }
  /// The first broken rule that is an error, or nothing.
  std::optional<std::string_view> violation() const {
    const auto held = rules_held();
    const std::size_t count = rules == RenardRules::kLenient ? kNeeded : kRules.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!held[i]) return kRules[i];
    }
    return std::nullopt;
  }
  /// The broken rules that lenient lets pass.
  std::vector<std::string_view> leniences() const {
    std::vector<std::string_view> broken;
    const auto held = rules_held();
    for (std::size_t i = kNeeded; i < kRules.size() && rules == RenardRules::kLenient; ++i) {
      if (!held[i]) broken.push_back(kRules[i]);
    }
    return broken;
  }

  LawRange range() const {
    // All of the way back to C2 where that is not far beyond the joints.
    const double recovery = c2 > c4 ? 3.0 / std::sqrt(c2 - c4) : 0.0;
    const double end = std::max(1.5 * c6, std::min(c6 + recovery, 3.0 * c6));
    const double unit = 1.0 / speed_factor;
    return {unit * end, 0.0, {{{"C1", 0.0}, {"C3", unit * c5}, {"C4", unit * c6}}}};
  }
  double raw(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    return point(slip.slip_rate).mu;
  }
  CoefficientPoint evaluate(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    return clamped(point(slip.slip_rate));
  }
  /// dmu/d(number) in the order of fields(), of C1 to C6; 0 on the floor. At C5 and C6 the slope to
  /// the joint is that of the piece that begins there.
  std::array<double, 8> to_numbers(const Ambient& /*ambient*/,
                                   const SlipArguments& slip) const noexcept {
    if (!(point(slip.slip_rate).mu >= kCoefficientFloor)) return {};
    const double v = speed_factor * slip.slip_rate;
    if (v <= c5) {
      const double x = v / c5;
      const double way = x * (2.0 - x);
      return {1.0 - way, 0.0, way, 0.0, -2.0 * (c3 - c1) * (1.0 - x) * x / c5};
    }
    if (v < c6) {
      const double width = c6 - c5;
      const double y = (v - c5) / width;
      const double way = y * y * (3.0 - 2.0 * y);
      const double slope = -6.0 * (c3 - c4) * y * (1.0 - y) / width;  // to v
      return {0.0, 0.0, 1.0 - way, way, slope * (y - 1.0), -slope * y};
    }
    const double d = c2 - c4;
    const double s = v - c6;
    const double q = 1.0 + d * s * s;
    const double by_d = 1.0 / (q * q);
    return {0.0, 1.0 - by_d, 0.0, by_d, 0.0, -2.0 * d * d * s * by_d};
  }
  bool depends_on_slip_rate() const { return c1 != c3 || c3 != c4 || c4 != c2; }
  bool depends_on_contact_force() const { return false; }
  double largest() const { return std::max({c1, c2, c3, c4, kCoefficientFloor}); }
  double largest_growth() const { return largest(); }
  /// Half way between C5 and C6; of lenient constants perhaps at rest.
  double steepest_weakening() const {
    return speed_factor * std::max({1.5 * (c3 - c4) / (c6 - c5), 2.0 * (c1 - c3) / c5, 0.0});
  }

  CoefficientCurve along(const SlipLine& line) const noexcept {
    const double span = line.end - line.slip;
    const double v = speed_factor * line.rate_at(line.slip);
    const double dv = speed_factor * line.rate_per_slip * span;
    const auto end_of_piece = [&](double joint) {
      return dv > 0.0 ? (joint - v) / dv : std::numeric_limits<double>::infinity();
    };
    const double ahead = v + standing(line) * dv;
    if (ahead < c5 || (dv == 0.0 && v <= c5)) {
      const double x = v / c5, dx = dv / c5, rise = c3 - c1;
      return {.numerator = polynomial(
                  {c1 + rise * x * (2.0 - x), 2.0 * rise * (1.0 - x) * dx, -rise * dx * dx}),
              .denominator = {},
              .until = end_of_piece(c5)};
    }
    if (ahead < c6) {
      const CoefficientPoint here = falling(v);
      const double y = (v - c5) / (c6 - c5), dy = dv / (c6 - c5), fall = c3 - c4;
      return {.numerator =
                  polynomial({here.mu, here.to_slip_rate * line.rate_per_slip * span,
                              -3.0 * fall * (1.0 - 2.0 * y) * dy * dy, 2.0 * fall * dy * dy * dy}),
              .denominator = {},
              .until = end_of_piece(c6)};
    }
    const double d = c2 - c4, s = v - c6;
    if (d == 0.0) return {.numerator = polynomial({c2}), .denominator = {}};
    const double square = d * s * s, cross = 2.0 * d * s * dv, growth = d * dv * dv;
    return {.numerator = polynomial({c4 + c2 * square, c2 * cross, c2 * growth}),
            .denominator = polynomial({1.0 + square, cross, growth}),
            .recovery = d};
  }
  double next_bend(const SlipLine& line) const noexcept {
    if (line.force_per_slip != 0.0 || std::min({c1, c2, c3, c4}) < kCoefficientFloor) {
      return law::next_bend(along(line), line);
    }
    if (!(line.rate_per_slip > 0.0)) return kNoBend;
    // Under a constant normal force: the joints, and the inflections of the last two pieces.
    const double d = c2 - c4;
    const double last = d > 0.0 ? c6 + 1.0 / std::sqrt(3.0 * d) : c6;
    for (const double v : {c5, 0.5 * (c5 + c6), c6, last}) {
      const double x = (v / speed_factor - line.rate_at_zero) / line.rate_per_slip;
      if (is_ahead(line, x)) return x;
    }
    return kNoBend;
  }
  double next_belt_bend(const SlipLine& line, double wrap_angle, FlowSense sense) const noexcept {
    return law::next_belt_bend(along(line), line, wrap_angle, sense);
  }

 private:
  /// Before the floor.
  CoefficientPoint point(double slip_rate) const noexcept {
    if (!depends_on_slip_rate()) return {c2, 0.0, 0.0};
    const double v = speed_factor * slip_rate;
    if (v <= c5) {
      const double x = v / c5, z = (c5 - v) / c5, rise = c3 - c1;
      return {x < z ? c1 + rise * x * (2.0 - x) : c3 - rise * z * z,
              speed_factor * 2.0 * rise * z / c5, 0.0};
    }
    if (v < c6) return falling(v);
    const double d = c2 - c4;
    const double s = v - c6;
    // Not 1/(1/d + s^2), which fails where C2 = C4.
    const double square = d * s * s;
    const double q = 1.0 + square;
    // The first cancels where s is small, the second overflows where it is large.
    const double mu = square > 1.0 ? c2 - d / q : (c4 + c2 * square) / q;
    return {mu, speed_factor * 2.0 * d * d * s / (q * q), 0.0};
  }

  /// The coefficient between C5 and C6, from the nearer of the two: a small one is no difference of
  /// large ones.
  CoefficientPoint falling(double v) const noexcept {
    const double fall = c3 - c4, width = c6 - c5;
    const double y = (v - c5) / width, z = (c6 - v) / width;
    return {y < z ? c3 - fall * y * y * (3.0 - 2.0 * y) : c4 + fall * z * z * (3.0 - 2.0 * z),
            -speed_factor * 6.0 * fall * y * z / width, 0.0};
  }
};

}  // namespace slipbench::law
