// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

#include "law/base/capstan.hpp"
#include "law/base/field.hpp"
#include "law/friction/coefficient_point.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/slip_line.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Exponential decay from the static to the kinetic coefficient (docs/theory, section 9):
///   mu = kinetic + (static - kinetic) exp(-decay rate),  rate >= 0 the equivalent slip rate.
/// Continuous and monotone; mu(0) = static, mu(inf) = kinetic. No other dependence and no force
/// limit together with it. Admissible: static >= kinetic >= 0, decay >= 0 [T/L].
/// Source: Oden & Martins 1985 (key OM1985). Proven by law/friction/friction_law_test.
struct ExponentialDecay {
  static constexpr std::string_view kName = "exponential_decay";
  static constexpr std::string_view kTitle = "Exponential decay from static to kinetic friction";
  static constexpr std::string_view kFormula =
      "mu = kinetic + (static - kinetic) exp(-decay slip_rate)";
  static constexpr std::string_view kSource = "OM1985";
  static constexpr std::array<std::string_view, 1> kRules{"'static' must not be below 'kinetic'"};
  static constexpr bool kHasFloor = false;

  double mu_static = 0.0;  ///< key `static`, which C++ keeps for itself
  double kinetic = 0.0;
  double decay = 0.0;

  static constexpr auto fields() {
    return std::tuple{Field{"static", &ExponentialDecay::mu_static, dimension::kNone, kNotNegative,
                            true, "Coefficient at slip rate zero, mu_s."},
                      Field{"kinetic", &ExponentialDecay::kinetic, dimension::kNone, kNotNegative,
                            true, "Coefficient at high slip rate, mu_k."},
                      Field{"decay", &ExponentialDecay::decay, Dimension{0, -1, 1}, kNotNegative,
                            true, "Decay constant d, the reciprocal of a slip rate."}};
  }

  /// A rule between the fields that is broken, in words, or nothing.
  std::optional<std::string_view> violation() const {
    if (mu_static < kinetic) return kRules[0];
    return std::nullopt;
  }

  static ExponentialDecay example() { return {0.3, 0.2, 0.05}; }

  /// Part of static - kinetic that is left; as the coefficient less `kinetic` it would lose digits.
  template <class Number>
  Number above_kinetic(const Number& slip_rate) const {
    using std::exp;
    return (mu_static - kinetic) * exp(-decay * slip_rate);
  }
  template <class Number>
  Number coefficient(const Number& slip_rate) const {
    return kinetic + above_kinetic(slip_rate);
  }
  CoefficientPoint evaluate(const Ambient& /*ambient*/, const SlipArguments& slip) const noexcept {
    const double left = above_kinetic(slip.slip_rate);
    return {kinetic + left, -decay * left, 0.0};
  }
  /// dmu/d(number) in the order of fields().
  std::array<double, 3> to_numbers(const Ambient& /*ambient*/,
                                   const SlipArguments& slip) const noexcept {
    const double left = std::exp(-decay * slip.slip_rate);
    return {left, 1.0 - left, -slip.slip_rate * (mu_static - kinetic) * left};
  }
  bool depends_on_slip_rate() const { return decay > 0.0 && mu_static > kinetic; }
  bool depends_on_contact_force() const { return false; }
  LawRange range() const {
    return {depends_on_slip_rate() ? exponential_scale(-decay) : 0.0,
            0.0,
            {{{depends_on_slip_rate() ? "static" : "", 0.0}}}};
  }
  double largest() const { return mu_static; }
  double largest_growth() const { return mu_static; }
  double steepest_weakening() const { return decay * (mu_static - kinetic); }
  /// The inflection of mu F_N where F_N changes: at d rate = 2 + that of F_N's zero.
  double next_bend(const SlipLine& line) const noexcept {
    const double per_slip = decay * line.rate_per_slip;
    if (!(per_slip > 0.0) || line.force_per_slip == 0.0) return kNoBend;
    const double bend = line.slip + 2.0 / per_slip - line.force / line.force_per_slip;
    return is_ahead(line, bend) ? bend : kNoBend;
  }
  /// Forward, exp(mu alpha) of a convex coefficient is convex. Backward, -exp(-mu alpha) turns from
  /// concave to convex where alpha (static - kinetic) exp(-d rate) = 1, if ever.
  double next_belt_bend(const SlipLine& line, double wrap_angle, FlowSense sense) const noexcept {
    const double falling = wrap_angle * (mu_static - kinetic);
    const double per_slip = decay * line.rate_per_slip;
    if (sense == FlowSense::kForward || !(falling > 1.0) || !(per_slip > 0.0)) return kNoBend;
    const double bend = std::log(falling) / per_slip;
    return bend > line.slip ? bend : kNoBend;
  }
};

}  // namespace slipbench::law
