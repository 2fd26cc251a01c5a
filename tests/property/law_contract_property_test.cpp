// SPDX-License-Identifier: Apache-2.0
// Properties that every law of the list keeps, whatever its numbers: the tests fold over
// FrictionLaw, and a law that joins the list is tried without a word here.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "law/friction/law_list.hpp"
#include "law/update/return_mapping.hpp"
#include "law/update/uniqueness.hpp"
#include "tests/support/random_law.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

constexpr int kDraws = 2000;

CoefficientPoint at(const FrictionLaw& law, double rate, double force) {
  return evaluate(law, Ambient{}, {.slip_rate = rate, .contact_force = force});
}

/// Slip rates and forces of any size that the examples' numbers may be of.
double some_rate(Dice& dice) { return std::pow(10.0, dice.between(-1.0, 3.0)); }
double some_force(Dice& dice) { return std::pow(10.0, dice.between(0.0, 2.5)); }

/// Checks that a difference quotient of f over [x - h, x + h] is no further from the slope at x
/// than the slopes beside it are, but for the rounding of f.
template <class Value, class Slope>
void check_slope(double x, double h, const Value& f, const Slope& slope) {
  const double quotient = (f(x + h) - f(x - h)) / (2.0 * h);
  const double here = slope(x);
  const double change = std::abs(slope(x + h) - here) + std::abs(here - slope(x - h));
  REQUIRE(std::isfinite(here));
  // Across a joint, onto the floor, or to a number that the law does not take.
  if (!(change <= 0.1 * std::abs(here) + 1e-9)) return;
  const double rounding = 1e-11 * (1.0 + std::abs(f(x))) / h;
  CHECK(std::abs(quotient - here) <= change + rounding);
}

TEMPLATE_LIST_TEST_CASE("the slopes of any law are the derivatives of its coefficient", "",
                        LawList) {
  INFO("the law " << TestType::kName);
  Dice dice(1);
  for (int draw = 0; draw < kDraws; ++draw) {
    const FrictionLaw law = random_law<TestType>(dice);
    const double rate = some_rate(dice);
    const double force = some_force(dice);
    CAPTURE(draw, rate, force);
    check_slope(
        rate, 1e-3 * rate, [&](double x) { return at(law, x, force).mu; },
        [&](double x) { return at(law, x, force).to_slip_rate; });
    check_slope(
        force, 1e-3 * force, [&](double x) { return at(law, rate, x).mu; },
        [&](double x) { return at(law, rate, x).to_contact_force; });
  }
}

TEMPLATE_LIST_TEST_CASE("the slopes of any law to its numbers are derivatives", "", LawList) {
  INFO("the law " << TestType::kName);
  if constexpr (!std::is_same_v<TestType, TabularCoefficient>) {
    Dice dice(2);
    for (int draw = 0; draw < kDraws; ++draw) {
      TestType law = random_law<TestType>(dice);
      const SlipArguments slip{.slip_rate = some_rate(dice), .contact_force = some_force(dice)};
      std::size_t index = 0;
      const auto one = [&](const auto& field) {
        const std::size_t i = index++;
        auto& member = law.*(field.member);
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, double>) {
          const double number = member;
          const double h = 1e-4 * std::abs(number);
          if (!(h > 0.0)) return;
          CAPTURE(draw, field.key, number, slip.slip_rate, slip.contact_force);
          check_slope(
              number, h,
              [&](double x) {
                member = x;
                return evaluate(FrictionLaw(law), {}, slip).mu;
              },
              [&](double x) {
                member = x;
                return to_numbers(law, {}, slip)[i];
              });
          member = number;
        }
      };
      std::apply([&](const auto&... field) { (one(field), ...); }, TestType::fields());
    }
  }
}

TEMPLATE_LIST_TEST_CASE("a coefficient of any law does not change with the units", "", LawList) {
  INFO("the law " << TestType::kName);
  if constexpr (!std::is_same_v<TestType, TabularCoefficient>) {
    Dice dice(3);
    for (int draw = 0; draw < kDraws; ++draw) {
      const TestType here = random_law<TestType>(dice);
      const auto size = [&] { return std::pow(10.0, dice.between(-3.0, 3.0)); };
      const Units units{.length = size(), .force = size(), .time = size()};
      const double rate = some_rate(dice);
      const double force = some_force(dice);
      const CoefficientPoint a = at(here, rate, force);
      const CoefficientPoint b =
          at(in_units(here, units), rate * units.time / units.length, force / units.force);
      CAPTURE(draw, rate, force);
      // Rounding of terms that may cancel.
      CHECK(a.mu == Approx(b.mu).epsilon(1e-10).margin(1e-12));
      CHECK(a.to_slip_rate ==
            Approx(b.to_slip_rate * units.time / units.length).epsilon(1e-9).margin(1e-11));
      CHECK(a.to_contact_force ==
            Approx(b.to_contact_force / units.force).epsilon(1e-9).margin(1e-11));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("no law passes its bounds, and what it does not depend on it does not see",
                        "", LawList) {
  INFO("the law " << TestType::kName);
  Dice dice(4);
  for (int draw = 0; draw < kDraws / 10; ++draw) {
    const FrictionLaw law = random_law<TestType>(dice);
    const double top = some_rate(dice);
    const double force = some_force(dice);
    const CoefficientBounds near = coefficient_bounds(law, Ambient{}, force, top);
    const double most = largest(law);
    const double growth = largest_growth(law);
    const double steepest = steepest_weakening(law);
    CHECK(std::isfinite(near.largest));
    CHECK(std::isfinite(near.steepest_weakening));
    for (const auto& [rate, normal] : {std::pair{0.0, 0.0}, {0.0, force}, {top, 0.0}}) {
      const CoefficientPoint limit = at(law, rate, normal);
      INFO("coefficient() and its slopes are to be finite at rest and without normal force");
      CAPTURE(draw, rate, normal);
      CHECK(std::isfinite(limit.mu));
      CHECK(std::isfinite(limit.to_slip_rate));
      CHECK(std::isfinite(limit.to_contact_force));
    }
    for (int i = 0; i <= 60; ++i) {
      const double rate = top * i / 60.0;
      CAPTURE(draw, rate, force);
      const CoefficientPoint here = at(law, rate, force);
      constexpr double kRounding = 1.0 + 1e-9;
      CHECK(std::isfinite(here.mu));
      CHECK(here.mu >= (has_floor(law) ? kCoefficientFloor : 0.0));
      if (has_floor(law)) {
        const SlipArguments slip{.slip_rate = rate, .contact_force = force};
        CHECK(here.mu == std::max(raw_coefficient(law, Ambient{}, slip), kCoefficientFloor));
      }
      CHECK(here.mu <= std::min(most, near.largest) * kRounding);
      CHECK(here.mu + force * here.to_contact_force <= growth * kRounding + 1e-15);
      // Bounds beside the floor are looked for a billionth away from it.
      CHECK(-here.to_slip_rate <=
            std::min(steepest, near.steepest_weakening) * (1.0 + 1e-7) + 1e-12);
      if (!depends_on_slip_rate(law)) CHECK(at(law, 2.0 * rate + 1.0, force).mu == here.mu);
      if (!depends_on_contact_force(law)) CHECK(at(law, rate, 2.0 * force).mu == here.mu);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("between two bends the limit of any law is convex or concave", "",
                        LawList) {
  INFO("the law " << TestType::kName);
  Dice dice(5);
  for (int draw = 0; draw < kDraws; ++draw) {
    const FrictionLaw law = random_law<TestType>(dice);
    SlipLine line{.slip = dice.chance(0.3) ? 0.0 : dice.between(0.0, 2.0),
                  .rate_per_slip = some_rate(dice),
                  .force = some_force(dice)};
    line.end = line.slip + dice.between(0.1, 3.0);
    const bool belt = dice.chance(0.4);
    const auto sense = dice.chance(0.5) ? FlowSense::kForward : FlowSense::kBackward;
    const double wrap = dice.between(0.5, 12.0);
    if (!belt && dice.chance(0.7)) {
      line.force_per_slip = dice.between(-1.0, 1.0) * line.force / (line.end - line.slip);
    }
    const auto limit = [&](double x) {
      const double force = line.force_at(x);
      const double mu = at(law, line.rate_at(x), force).mu;
      return belt ? capstan_limit(wrap * mu, sense) : mu * force;
    };
    CAPTURE(draw, belt, line.slip, line.end, line.rate_per_slip, line.force, line.force_per_slip);
    double low = line.slip;
    int pieces = 0;
    for (; low < line.end && pieces < 60; ++pieces) {
      SlipLine rest = line;
      rest.slip = low;
      rest.force = line.force_at(low);
      const double bend = belt ? next_belt_bend(law, rest, wrap, sense) : next_bend(law, rest);
      REQUIRE(bend > low);
      const double high = std::min(bend, line.end);
      double least = 0.0, most = 0.0, size = 0.0;
      constexpr int kCells = 48;
      const double step = (high - low) / kCells;
      for (int i = 1; i < kCells; ++i) {
        const double x = low + step * i;
        const double a = limit(x - step), b = limit(x), c = limit(x + step);
        size = std::max({size, std::abs(a), std::abs(b), std::abs(c)});
        least = std::min(least, a - 2.0 * b + c);
        most = std::max(most, a - 2.0 * b + c);
      }
      if (!std::isfinite(size)) break;  // exp(mu alpha) has an end of its own
      INFO((belt ? "next_belt_bend()" : "next_bend()")
           << " passes a bend over between the slips " << low << " and " << high);
      // Second differences have one sign but for the rounding of terms that may cancel.
      CHECK(std::min(-least, most) <= 1e-12 * (size + line.force));
      low = high;
    }
    CHECK(pieces < 60);
  }
}

TEMPLATE_LIST_TEST_CASE("the first root is taken under any law", "", LawList) {
  INFO("the law " << TestType::kName);
  Dice dice(6);
  int slips = 0;
  int several = 0;
  // Without several roots the test would show nothing.
  const bool wanted = depends_on_slip_rate(TestType::example());
  for (int draw = 0; draw < kDraws || (wanted && several <= 5); ++draw) {
    REQUIRE(draw < 10 * kDraws);
    FrictionDefinition definition;
    definition.slip = slip_space({1});
    definition.law = random_law<TestType>(dice);
    const double most = some_force(dice);
    // Wear, or running-in, over a slip of about 1 in a time that makes rates of any size.
    const TableFunction internal =
        make_function({{most * dice.between(0.2, 1.0), 0.0}, {most * dice.between(0.2, 1.0), 1.0}},
                      {{IndependentKind::kAccumulatedSlip, 0}});
    definition.internal_contact_force = internal;
    const double top = some_rate(dice);
    const CoefficientBounds bounds = coefficient_bounds(definition.law, Ambient{}, most, top);
    const double fall = most * std::max(bounds.steepest_weakening * top, 0.1 * bounds.largest);
    const double kappa = fall * dice.between(0.05, 1.5);
    if (!(kappa > 0.0)) continue;
    definition.stick = {StickStiffness::Mode::kStiffness, kappa};
    ConnectorIncrement increment;
    increment.duration = 1.0 / top;
    const auto limit = [&](double slip) {
      const double normal = internal.value({}, {.accumulated_slip = slip});
      return at(definition.law, slip * top, normal).mu * normal;
    };
    if (!(limit(0.0) > 1e-6 * most)) continue;  // on the floor
    const double trial = limit(0.0) * dice.between(1.0001, 2.0);
    // Where an exponent overflows the run fails, and says so.
    if (!overflow(definition.law, trial / kappa * top).empty()) continue;
    increment.end.position[0] = trial / kappa;
    const FrictionUpdate u = update(definition, increment, FrictionState{});
    if (u.state.regime != Regime::kSlip) continue;
    ++slips;
    constexpr int kSteps = 2000;
    const double step = trial / kappa / kSteps;
    double first = trial / kappa;
    int changes = 0;
    bool above = true;
    for (int i = kSteps; i >= 1; --i) {
      const bool now_above = trial - kappa * step * i - limit(step * i) > 0.0;
      if (!now_above) first = step * i;
      if (i < kSteps && now_above != above) ++changes;
      above = now_above;
    }
    if (changes > 0) ++several;
    CAPTURE(draw, kappa, trial, top);
    CHECK(u.slip_increment <= first + 1e-9 * step);
    // A root, but for the rounding of the slip, and of terms that may cancel.
    const auto residual = [&](double slip) { return trial - kappa * slip - limit(slip); };
    constexpr double kSlipRounding = 4.0 * std::numeric_limits<double>::epsilon();
    CHECK(residual(u.slip_increment * (1.0 - kSlipRounding)) >= -1e-11 * (trial + most));
    CHECK(residual(u.slip_increment * (1.0 + kSlipRounding)) <= 1e-11 * (trial + most));
  }
  CHECK(slips > kDraws / 4);
}

}  // namespace
