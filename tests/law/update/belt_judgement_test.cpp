// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "law/friction/law_list.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/uniqueness.hpp"

namespace {

using namespace slipbench::law;

FrictionDefinition belt(double mu, double wrap_angle) {
  FrictionDefinition definition;
  definition.slip = slip_space({2});
  definition.criterion = Capstan{wrap_angle};
  definition.contact_force = ComponentContactForce{0};
  definition.law = ConstantCoefficient{mu};
  return definition;
}

FrictionUpdate judged(const FrictionDefinition& definition, double tension, double behind) {
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.force[0] = tension;
  return judge_capstan(definition, increment, behind);
}

TEST_CASE("a belt between two given tensions does not stick beyond its force limit") {
  FrictionDefinition definition = belt(0.2, 3.0);  // the band reaches to 82 without the limit
  definition.force_limit = 10.0;
  const FrictionUpdate inside = judged(definition, 100.0, 109.0);
  CHECK(inside.state.regime == Regime::kStick);
  CHECK(capstan_utilisation(inside, 3.0) == Approx(0.9).epsilon(1e-15));
  for (const double behind : {110.0, 150.0, 90.0, 60.0}) {
    const FrictionUpdate beyond = judged(definition, 100.0, behind);
    CHECK(beyond.phi >= 0.0);
    CHECK(beyond.state.regime == Regime::kSlip);
    CHECK(capstan_utilisation(beyond, 3.0) >= 1.0);
  }
  // A limit above the band changes nothing.
  definition.force_limit = 1000.0;
  const FrictionUpdate free = judged(definition, 100.0, 150.0);
  CHECK(free.state.regime == Regime::kStick);
  CHECK(capstan_utilisation(free, 3.0) == std::log1p(0.5) / (0.2 * 3.0));
  // As small as a unit of force may make them.
  const FrictionUpdate small = judged(belt(0.2, 3.0), 1e-3, 0.9e-3);
  CHECK(capstan_utilisation(small, 3.0) == Approx(-std::log(0.9) / (0.2 * 3.0)).epsilon(1e-14));
}

TEST_CASE("a belt without friction between equal tensions is open, and slips between others") {
  CHECK(judged(belt(0.0, 3.0), 100.0, 100.0).state.regime == Regime::kOpen);
  CHECK(judged(belt(0.2, 0.0), 100.0, 100.0).state.regime == Regime::kOpen);
  CHECK(judged(belt(0.0, 3.0), 100.0, 101.0).state.regime == Regime::kSlip);
  CHECK(judged(belt(0.2, 3.0), 100.0, 100.0).state.regime == Regime::kStick);
}

TEST_CASE("the sense of a belt is that of the change of its tension, however small") {
  const FrictionDefinition definition = belt(0.2, 3.0);
  for (const double tension : {100.0, 1e-4}) {
    const FrictionUpdate forward = judged(definition, tension, 1.01 * tension);
    CHECK(forward.direction[0] == 1.0);
    CHECK(forward.limit == Approx(tension * std::expm1(0.6)).epsilon(1e-14));
    const FrictionUpdate backward = judged(definition, tension, 0.99 * tension);
    CHECK(backward.direction[0] == -1.0);
    CHECK(backward.limit == Approx(-tension * std::expm1(-0.6)).epsilon(1e-14));
    CHECK(judged(definition, tension, tension).direction[0] == 0.0);
  }
  CHECK(judged(definition, 100.0, 101.0).direction[0] == 1.0);
  CHECK(judged(definition, -2.0, -1.0).state.regime == Regime::kOpen);
}

TEST_CASE("a slack belt has no limit, even if it is wound without end") {
  const FrictionUpdate slack = judged(belt(1.0, 1e4), 0.0, 0.0);
  CHECK(slack.limit == 0.0);
  CHECK(slack.phi == 0.0);
  CHECK(slack.state.regime == Regime::kOpen);
}

TEST_CASE("increments longer than a belt's threshold have one solution at any rate of the motion") {
  FrictionDefinition definition = belt(0.0, 4.0);
  definition.law = ExponentialDecay{0.6, 0.1, 5.0};
  definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
  // The limit falls fastest at rest: T alpha exp(mu_s alpha) (mu_s - mu_k) d / kappa.
  const double expected = 100.0 * 4.0 * std::exp(2.4) * 0.5 * 5.0 / 1000.0;
  for (const double rate : {0.0, 0.1, 1.0, 10.0}) {
    const IncrementThresholds t = increment_thresholds(definition, Ambient{}, 100.0, rate);
    CHECK(t.unique == Approx(expected).epsilon(1e-14));
    // The force trial - kappa x - L(x) that is left after the slip x falls all the way.
    const double duration = 1.0001 * t.unique;
    double before = 1.0;
    int rises = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double x = 0.01 * i * duration;
      const double mu = 0.1 + 0.5 * std::exp(-5.0 * x / duration);
      const double left = -1000.0 * x - 100.0 * std::expm1(4.0 * mu);
      if (i > 0 && left >= before) ++rises;
      before = left;
    }
    CHECK(rises == 0);
  }
}

TEST_CASE("decay through test data has the same first root on a belt as the decay it stands for") {
  // Backward, at A_d > 1: the limit turns from concave to convex within the increment.
  const ExponentialTestData data{0.9, 0.3, 1.0, 0.05};
  int slips = 0;
  for (const double duration : {0.01, 0.1, 1.0}) {
    for (double motion = -0.05; motion > -2.0; motion *= 1.1) {
      FrictionDefinition definition = belt(0.0, 6.0);
      definition.stick = {StickStiffness::Mode::kStiffness, 150.0};
      ConnectorIncrement increment;
      increment.duration = duration;
      increment.force[0] = 100.0;
      increment.end.position[1] = motion;
      definition.law = data.fit();
      const FrictionUpdate fitted = update_capstan(definition, increment, {});
      definition.law = data;
      const FrictionUpdate through_points = update_capstan(definition, increment, {});
      CHECK(through_points.slip_increment == fitted.slip_increment);
      if (fitted.state.regime == Regime::kSlip) ++slips;
    }
  }
  CHECK(slips > 20);
}

}  // namespace
