// SPDX-License-Identifier: Apache-2.0
#include "law/friction/friction_law.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "law/friction/law_list.hpp"
#include "law/update/uniqueness.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

TEMPLATE_LIST_TEST_CASE("a law's slopes are the derivatives of its coefficient", "", LawList) {
  const FrictionLaw law = TestType::example();
  Ambient ambient;
  ambient.temperature = 60.0;
  for (const double rate : {0.0, 0.7, 3.0, 10.0, 40.0}) {
    for (const double force : {1.0, 30.0, 99.0, 400.0}) {
      const CoefficientPoint point =
          evaluate(law, ambient, {.slip_rate = rate, .contact_force = force});
      const auto by_rate = one_sided_derivative(
          [&](double h) -> std::optional<double> {
            return evaluate(law, ambient, {.slip_rate = rate + h, .contact_force = force}).mu;
          },
          1e-2);
      const auto by_force = one_sided_derivative(
          [&](double h) -> std::optional<double> {
            return evaluate(law, ambient, {.slip_rate = rate, .contact_force = force + h}).mu;
          },
          1e-2);
      // Rounding of mu over the step dominates.
      CHECK(point.to_slip_rate == Approx(by_rate->value).epsilon(1e-9).margin(1e-12));
      CHECK(point.to_contact_force == Approx(by_force->value).epsilon(1e-9).margin(1e-12));
    }
  }
}

TEMPLATE_LIST_TEST_CASE(
    "a law stays between 0 and its largest value and weakens no faster than said", "", LawList) {
  const FrictionLaw law = TestType::example();
  double steepest = 0.0;
  for (double temperature = 0.0; temperature <= 140.0; temperature += 10.0) {
    Ambient ambient;
    ambient.temperature = temperature;
    for (double rate = 0.0; rate < 70.0; rate += 0.5) {
      for (double force = 0.0; force <= 120.0; force += 20.0) {
        const CoefficientPoint point =
            evaluate(law, ambient, {.slip_rate = rate, .contact_force = force});
        CHECK(point.mu >= 0.0);
        CHECK(point.mu <= largest(law) * (1.0 + 1e-15));
        steepest = std::max(steepest, -point.to_slip_rate);
        const CoefficientBounds here = coefficient_bounds(law, ambient, force, rate);
        CHECK(std::isfinite(here.steepest_weakening));
        CHECK(point.mu <= here.largest * (1.0 + 1e-15));
        CHECK(-point.to_slip_rate <= here.steepest_weakening * (1.0 + 1e-12));
      }
    }
  }
  CHECK(steepest <= steepest_weakening(law) * (1.0 + 1e-12));
  // The steepest place is on the grid above, so the bound is reached, not only kept; that of a
  // scanned bound lies up to half a step beside it.
  const double beside = requires(const TestType& l) { l.steepest_weakening(); }
  ? 0.0 : 1e-2;
  if (std::isfinite(steepest_weakening(law))) {
    CHECK(steepest == Approx(steepest_weakening(law)).epsilon(beside + 1e-14).margin(1e-15));
  }
}

TEMPLATE_LIST_TEST_CASE("a law that says it does not depend on something does not look at it", "",
                        LawList) {
  const FrictionLaw law = TestType::example();
  Ambient ambient;
  ambient.temperature = 60.0;
  const double mu = evaluate(law, ambient, {.slip_rate = 1.0, .contact_force = 50.0}).mu;
  const double poison = std::nan("");
  if (!depends_on_slip_rate(law)) {
    CHECK(evaluate(law, ambient, {.slip_rate = poison, .contact_force = 50.0}).mu == mu);
  } else {
    CHECK(evaluate(law, ambient, {.slip_rate = 2.0, .contact_force = 50.0}).mu != mu);
  }
  if (!depends_on_contact_force(law)) {
    CHECK(evaluate(law, ambient, {.slip_rate = 1.0, .contact_force = poison}).mu == mu);
  } else {
    CHECK(evaluate(law, ambient, {.slip_rate = 1.0, .contact_force = 60.0}).mu != mu);
  }
}

TEMPLATE_LIST_TEST_CASE("a law names itself, its formula and its source", "", LawList) {
  CHECK_FALSE(std::string(TestType::kName).empty());
  CHECK_FALSE(std::string(TestType::kTitle).empty());
  CHECK_FALSE(std::string(TestType::kFormula).empty());
  CHECK_FALSE(std::string(TestType::kSource).empty());
  for (const std::string_view rule : TestType::kRules) CHECK_FALSE(rule.empty());
}

TEMPLATE_LIST_TEST_CASE("a law's example keeps its own rules and bounds", "", LawList) {
  const TestType law = TestType::example();
  if constexpr (requires { law.violation(); }) CHECK_FALSE(law.violation().has_value());
  if constexpr (requires { TestType::fields(); }) {
    const auto within = [&](const auto& field) {
      if constexpr (std::is_convertible_v<decltype(law.*(field.member)), std::optional<double>>) {
        const std::optional<double> value = law.*(field.member);
        INFO(field.key);
        if (value) CHECK(field.bounds.contains(*value));
      }
    };
    std::apply([&](const auto&... field) { (within(field), ...); }, TestType::fields());
  }
}

TEST_CASE("exponential decay gives the reference values (K1)") {
  const ExponentialDecay law{0.3, 0.2, 0.05};
  CHECK(law.coefficient(0.0) == 0.3);
  CHECK(law.coefficient(1.0) == Approx(0.295122942450071).epsilon(1e-14));
  CHECK(law.coefficient(10.0) == Approx(0.260653065971263).epsilon(1e-14));
  CHECK(law.coefficient(50.0) == Approx(0.20820849986239).epsilon(1e-14));
  CHECK(law.coefficient(100.0) == Approx(0.200673794699909).epsilon(1e-14));
}

TEST_CASE("exponential decay gives the documentation's values") {
  const ExponentialDecay law{0.25, 0.10, 0.2};
  // The numbers are given to six digits.
  CHECK(law.coefficient(1.0) == Approx(0.222810).margin(5e-7));
  CHECK(law.coefficient(5.0) == Approx(0.155182).margin(5e-7));
  CHECK(law.coefficient(20.0) == Approx(0.102747).margin(5e-7));
}

TEST_CASE("exponential decay refuses a kinetic coefficient above the static one") {
  CHECK(ExponentialDecay{0.2, 0.3, 1.0}.violation().has_value());
  CHECK_FALSE(ExponentialDecay{0.3, 0.3, 1.0}.violation().has_value());
  CHECK_FALSE(depends_on_slip_rate(ExponentialDecay{0.3, 0.3, 1.0}));
  CHECK_FALSE(depends_on_slip_rate(ExponentialDecay{0.3, 0.2, 0.0}));
}

TEST_CASE("the decay through measured points has the reference values (K2)") {
  const ExponentialDecay three = ExponentialTestData{0.3, 0.23, 20.0, 0.2}.fit();
  CHECK(three.mu_static == 0.3);
  CHECK(three.kinetic == 0.2);
  CHECK(three.decay == Approx(0.0601986402162968).epsilon(1e-14));
  const ExponentialDecay two = ExponentialTestData{0.3, 0.23, 20.0, {}}.fit();
  CHECK(two.kinetic == Approx(0.226315789473684).epsilon(1e-14));
  CHECK(two.decay == Approx(0.1497866136777).epsilon(1e-13));
}

TEST_CASE("the decay through measured points has the values of the example") {
  // The numbers are given to six digits.
  const ExponentialTestData two{0.3, 0.2, 5.0, {}};
  CHECK(two.fit().kinetic == Approx(0.194737).margin(5e-7));
  CHECK(two.fit().decay == Approx(0.599146).margin(5e-7));
  CHECK(two.coefficient(2.0) == Approx(0.226496).margin(5e-7));
  const ExponentialTestData three{0.3, 0.2, 5.0, 0.18};
  CHECK(three.fit().decay == Approx(0.358352).margin(5e-7));
  CHECK(three.coefficient(2.0) == Approx(0.238603).margin(5e-7));
}

TEST_CASE("the decay through measured points meets them") {
  for (const std::optional<double> mu_inf : {std::optional<double>(), std::optional(0.18)}) {
    const ExponentialTestData data{0.31, 0.2, 3.7, mu_inf};
    CHECK(data.coefficient(0.0) == Approx(0.31).epsilon(1e-15));
    // Differences of the coefficients cost two digits.
    CHECK(data.coefficient(3.7) == Approx(0.2).epsilon(1e-14));
    CHECK(data.coefficient(1e6) == Approx(data.kinetic()).epsilon(1e-15));
  }
}

TEST_CASE("the test data of a decay must fall from point to point") {
  const auto broken = [](const ExponentialTestData& data) {
    return std::string(data.violation().value_or("nothing"));
  };
  CHECK(broken({0.3, 0.2, 5.0, 0.1}) == "nothing");
  CHECK(broken({0.3, 0.2, 5.0, {}}) == "nothing");
  CHECK(broken({0.2, 0.2, 5.0, 0.1}).find("'mu1' is not above 'mu2'") != std::string::npos);
  CHECK(broken({0.3, 0.2, 5.0, 0.2}).find("'mu2' is not above 'mu_inf'") != std::string::npos);
  CHECK(broken({0.3, 0.01, 5.0, {}}).find("is negative") != std::string::npos);
  CHECK(broken({0.3, 0.2, 1e-310, {}}).find("no number a double can hold") != std::string::npos);
  // 5 % of mu1 is the least mu2 that needs no mu_inf.
  CHECK(broken({0.25, 0.0126, 5.0, {}}) == "nothing");
}

TEST_CASE("a coefficient table that is prolonged below zero stops at zero") {
  const FrictionLaw law = TabularCoefficient{
      make_function({{0.3, 0}, {0.1, 10}}, {kOverSlipRate}, 1, Extrapolation::kLinear)};
  const CoefficientPoint point = evaluate(law, Ambient{}, {.slip_rate = 100.0});
  CHECK(point.mu == 0.0);
  CHECK(point.to_slip_rate == 0.0);
}

TEST_CASE("a law says when it is asked outside its data") {
  const FrictionLaw table = TabularCoefficient::example();
  Ambient ambient;
  ambient.temperature = 60.0;
  CHECK_FALSE(outside(table, ambient, {.slip_rate = 5.0, .contact_force = 50.0}));
  CHECK(outside(table, ambient, {.slip_rate = 21.0, .contact_force = 50.0}));
  ambient.temperature = 121.0;
  CHECK(outside(table, ambient, {.slip_rate = 5.0, .contact_force = 50.0}));
  CHECK_FALSE(outside(ExponentialDecay::example(), ambient, {.slip_rate = 1e9}));
}

TEST_CASE("a coefficient table bends at the next knot of its contact force, either way") {
  const TabularCoefficient law{
      make_function({{0.1, 10}, {0.3, 20}, {0.2, 40}, {0.1, 50}}, {kOverContactForce})};
  // The force moves by 2 a unit of slip from where the search stands, at slip 3.
  const auto bend_from = [&](double force, double way) {
    return law.next_bend({.slip = 3.0, .end = 100.0, .force = force, .force_per_slip = way});
  };
  CHECK(bend_from(30.0, 2.0) == 8.0);
  CHECK(bend_from(30.0, -2.0) == 8.0);
  CHECK(bend_from(5.0, 2.0) == 5.5);
  CHECK(bend_from(60.0, -2.0) == 8.0);
  // A knot on which the force stands is past.
  CHECK(bend_from(20.0, 2.0) == 13.0);
  CHECK(bend_from(20.0, -2.0) == 8.0);
  CHECK(bend_from(20.0 * (1.0 + 1e-15), -2.0) == Approx(8.0).epsilon(1e-13));
  CHECK(bend_from(20.0 * (1.0 - 1e-15), 2.0) == Approx(13.0).epsilon(1e-13));
  CHECK(bend_from(50.0, 2.0) == kNoBend);
  CHECK(bend_from(10.0, -2.0) == kNoBend);
  CHECK(bend_from(30.0, 0.0) == kNoBend);
}

TEST_CASE(
    "a coefficient table bends at the next knot of its slip rate, counted from that at rest") {
  const TabularCoefficient law{make_function({{0.3, 0}, {0.2, 5}, {0.1, 11}}, {kOverSlipRate})};
  // The rate is 2 at slip 0 and 5 at slip 1.5.
  const auto bend_from = [&](double slip) {
    return law.next_bend({.slip = slip, .end = 100.0, .rate_at_zero = 2.0, .rate_per_slip = 2.0});
  };
  CHECK(bend_from(0.0) == 1.5);
  CHECK(bend_from(1.5) == 4.5);
  CHECK(bend_from(4.5) == kNoBend);
}

TEST_CASE("a coefficient table without the slip rate does not weaken with it") {
  const FrictionLaw law =
      TabularCoefficient{make_function({{0.3, 0}, {0.1, 10}}, {kOverContactForce})};
  CHECK(steepest_weakening(law) == 0.0);
  CHECK_FALSE(depends_on_slip_rate(law));
}

}  // namespace
