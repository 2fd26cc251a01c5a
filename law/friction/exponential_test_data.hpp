// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

#include "law/base/field.hpp"
#include "law/friction/coefficient_point.hpp"
#include "law/friction/exponential_decay.hpp"
#include "law/friction/law_range.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Exponential decay through measured points (docs/theory, section 9): mu1 at rate 0, mu2 at
/// rate2, and mu_inf at high rates:
///   static = mu1,   kinetic = mu_inf,   decay = -ln((mu2 - mu_inf)/(mu1 - mu_inf)) / rate2.
/// Without mu_inf the ratio of the differences is taken as 5 %:
///   mu_inf = (mu2 - 0.05 mu1)/0.95,   decay = ln(20) / rate2.
/// The rate is the equivalent slip rate [L/T]. Admissible: mu1 > mu2 > mu_inf >= 0, rate2 > 0; then
/// all of ExponentialDecay holds, which this is once fitted (the reader of cases fits at once).
/// Source: Oden & Martins 1985 (key OM1985) for the law, the points are the user's.
/// Proven by law/friction/friction_law_test.
struct ExponentialTestData {
  static constexpr std::string_view kName = "exponential_test_data";
  static constexpr std::string_view kTitle = "Exponential decay through two or three points";
  static constexpr std::string_view kFormula =
      "exponential_decay with static = mu1, kinetic = mu_inf, decay = ln((mu1 - mu_inf)/(mu2 - "
      "mu_inf))/rate2";
  static constexpr std::string_view kSource = "OM1985";
  static constexpr std::array<std::string_view, 1> kRules{
      "mu1 > mu2 > mu_inf >= 0, also where mu_inf = (mu2 - 0.05 mu1)/0.95 is not given"};
  static constexpr bool kHasFloor = false;

  /// The part of mu1 - mu_inf that mu2 - mu_inf is taken as where mu_inf is not given.
  static constexpr double kRest = 0.05;

  double mu1 = 0.0;
  double mu2 = 0.0;
  double rate2 = 1.0;
  std::optional<double> mu_inf;

  static constexpr auto fields() {
    return std::tuple{
        Field{"mu1", &ExponentialTestData::mu1, dimension::kNone, kNotNegative, true,
              "Coefficient at slip rate zero."},
        Field{"mu2", &ExponentialTestData::mu2, dimension::kNone, kNotNegative, true,
              "Coefficient at slip rate rate2; mu1 > mu2 > mu_inf."},
        Field{"rate2", &ExponentialTestData::rate2, Dimension{0, 1, -1}, kPositive, true,
              "Slip rate of mu2."},
        Field{"mu_inf", &ExponentialTestData::mu_inf, dimension::kNone, kNotNegative, false,
              "Coefficient at high slip rate; if not given (mu2 - 0.05 mu1)/0.95."}};
  }

  static ExponentialTestData example() { return {0.3, 0.23, 20.0, 0.2}; }

  /// The coefficient at high slip rate, given or by the convention [1].
  double kinetic() const { return mu_inf ? *mu_inf : (mu2 - kRest * mu1) / (1.0 - kRest); }

  /// The decay through the points. Meaningful if there is no violation.
  ExponentialDecay fit() const {
    const double fall =
        mu_inf ? std::log((mu1 - *mu_inf) / (mu2 - *mu_inf)) : -std::log(double{kRest});
    return {mu1, kinetic(), fall / rate2};
  }

  /// A rule between the fields that is broken, in words, or nothing.
  std::optional<std::string_view> violation() const {
    if (!(mu1 > mu2)) return "wanted mu1 > mu2 > mu_inf >= 0: 'mu1' is not above 'mu2'";
    if (!(kinetic() >= 0.0)) {
      return "wanted mu1 > mu2 > mu_inf >= 0: mu_inf = (mu2 - 0.05 mu1)/0.95 is negative, give "
             "'mu_inf'";
    }
    if (!(mu2 > kinetic())) return "wanted mu1 > mu2 > mu_inf >= 0: 'mu2' is not above 'mu_inf'";
    if (!std::isfinite(fit().decay)) return "the decay is no number a double can hold";
    return std::nullopt;
  }

  template <class Number>
  Number coefficient(const Number& slip_rate) const {
    return fit().coefficient(slip_rate);
  }
  CoefficientPoint evaluate(const Ambient& ambient, const SlipArguments& slip) const noexcept {
    return fit().evaluate(ambient, slip);
  }
  /// dmu/d(number) in the order of fields(), by way of the fitted decay.
  std::array<double, 4> to_numbers(const Ambient& ambient,
                                   const SlipArguments& slip) const noexcept {
    const ExponentialDecay decay = fit();
    const auto [by_static, by_kinetic, by_decay] = decay.to_numbers(ambient, slip);
    const double by_rate2 = -by_decay * decay.decay / rate2;
    if (!mu_inf) {
      return {by_static - by_kinetic * kRest / (1.0 - kRest), by_kinetic / (1.0 - kRest), by_rate2,
              0.0};
    }
    const double high = 1.0 / (rate2 * (mu1 - *mu_inf));
    const double low = 1.0 / (rate2 * (mu2 - *mu_inf));
    return {by_static + by_decay * high, -by_decay * low, by_rate2,
            by_kinetic + by_decay * (low - high)};
  }
  bool depends_on_slip_rate() const { return fit().depends_on_slip_rate(); }
  bool depends_on_contact_force() const { return false; }
  LawRange range() const {
    return {std::max(fit().range().slip_rate, 1.5 * rate2), 0.0, {{{"mu1", 0.0}, {"mu2", rate2}}}};
  }
  double largest() const { return mu1; }
  double largest_growth() const { return mu1; }
  double steepest_weakening() const { return fit().steepest_weakening(); }
  double next_bend(const SlipLine& line) const noexcept { return fit().next_bend(line); }
  double next_belt_bend(const SlipLine& line, double wrap_angle, FlowSense sense) const noexcept {
    return fit().next_belt_bend(line, wrap_angle, sense);
  }
};

}  // namespace slipbench::law
