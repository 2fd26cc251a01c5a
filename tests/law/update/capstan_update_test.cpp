// SPDX-License-Identifier: Apache-2.0
#include "law/update/capstan_update.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "law/connection/slipring.hpp"
#include "law/update/connector_tangent.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
using std::numbers::pi;

FrictionDefinition belt(double mu, double wrap_angle, StickStiffness stick = allowable_slip(0.01)) {
  SlipRing ring;
  ring.wrap_angles = {wrap_angle};
  const PredefinedFriction predefined = ring.predefined().at(0);
  FrictionDefinition definition;
  definition.slip = predefined.slip;
  definition.criterion = predefined.criterion;
  definition.contact_force = predefined.contact_force;
  definition.law = ConstantCoefficient{mu};
  definition.stick = stick;
  return definition;
}

/// A belt under the tension T, still at rest.
FrictionRun under(double tension, FrictionDefinition definition) {
  FrictionRun run(std::move(definition));
  run.force[0] = tension;
  run.step();
  return run;
}

const std::vector<StickStiffness> kBothModes = {allowable_slip(0.01), fixed_stiffness(5000.0)};

TEST_CASE("the stick band of the example: T = 5, mu = 0.1, a quarter turn") {
  for (const StickStiffness stick : kBothModes) {
    FrictionRun run = under(5.0, belt(0.1, pi / 2, stick));
    // Documented with six digits.
    CHECK(run.move_to(2, 1.0).state.force[0] == Approx(0.850444).epsilon(1e-6));
    CHECK(tension_behind(run.last) / 5.0 == Approx(1.17009).margin(5e-6));
    CHECK(run.move_to(2, -1.0).state.force[0] == Approx(-0.726820).epsilon(1e-6));
    CHECK(tension_behind(run.last) / 5.0 == Approx(0.854636).margin(5e-7));
  }
}

TEST_CASE("the ratio of the tensions in slip is exp(+-mu alpha) at any angle") {
  struct Row {
    double mu, degrees, ratio;
  };
  // Reference cases C1, printed with 15 digits.
  const std::vector<Row> rows = {
      {0.1, 30, 1.05375489702567},  {0.1, 90, 1.17008878749642},  {0.1, 180, 1.36910777062485},
      {0.1, 360, 1.87445608758534}, {0.1, 720, 3.51358562428573}, {0.1, 1080, 6.58606196269472},
      {0.2, 30, 1.11039938300559},  {0.2, 90, 1.36910777062485},  {0.2, 180, 1.87445608758534},
      {0.2, 360, 3.51358562428573}, {0.2, 720, 12.3452839391874}, {0.2, 1080, 43.3762121764543},
      {0.3, 30, 1.17008878749642},  {0.3, 90, 1.60197765128236},  {0.3, 180, 2.56633239520814},
      {0.3, 360, 6.58606196269472}, {0.3, 720, 43.3762121764543}, {0.3, 1080, 285.678421101121}};
  for (const Row& row : rows) {
    for (const StickStiffness stick : kBothModes) {
      FrictionRun run = under(10.0, belt(row.mu, row.degrees * pi / 180.0, stick));
      run.move_to(2, 5.0);
      CHECK(run.last.state.regime == Regime::kSlip);
      CHECK(tension_behind(run.last) / 10.0 == Approx(row.ratio).epsilon(1e-14));
      run.move_to(2, -5.0);
      // The difference of the tension and a force nearly as large: rounding times the ratio.
      CHECK(tension_behind(run.last) / 10.0 ==
            Approx(1.0 / row.ratio).epsilon(1e-14 + 3e-16 * row.ratio));
    }
  }
}

TEST_CASE("both senses, with the numbers of reference case C2") {
  // There f_bc is given, here f_ab: of f_bc = 100 the case prints f_ab in slip.
  FrictionRun run = under(53.3488091091103, belt(0.2, pi));
  run.move_to(2, 1.0);
  CHECK(tension_behind(run.last) == Approx(100.0).epsilon(1e-14));
  CHECK(run.last.state.force[0] == Approx(46.6511908908897).epsilon(1e-14));
  run = under(187.445608758534, belt(0.2, pi));
  run.move_to(2, -1.0);
  CHECK(tension_behind(run.last) == Approx(100.0).epsilon(1e-14));
  CHECK(run.last.state.force[0] == Approx(-87.4456087585338).epsilon(1e-14));
}

TEST_CASE("for the smallest wrap angles the limit is T mu alpha, not its rounding") {
  for (const double mu_alpha : {1e-6, 1e-12, 1e-15, 1e-200}) {
    FrictionRun run = under(100.0, belt(1.0, mu_alpha));
    // The next term of the series is mu_alpha / 2.
    CHECK(run.move_to(2, 1.0).state.force[0] == Approx(100.0 * mu_alpha).epsilon(mu_alpha + 1e-15));
    CHECK(run.move_to(2, -1.0).state.force[0] ==
          Approx(-100.0 * mu_alpha).epsilon(mu_alpha + 1e-15));
  }
}

TEST_CASE("stick is elastic in the flow, with the stiffness of the side it lies on") {
  const double up = 100.0 * std::expm1(0.2 * pi), down = -100.0 * std::expm1(-0.2 * pi);
  FrictionRun run = under(100.0, belt(0.2, pi, allowable_slip(0.01)));
  CHECK(run.move_to(2, 0.004).state.force[0] == Approx(0.4 * up).epsilon(1e-14));
  CHECK(run.last.state.regime == Regime::kStick);
  CHECK(run.move_to(2, -0.004).state.force[0] == Approx(-0.4 * down).epsilon(1e-14));
  CHECK(run.last.state.regime == Regime::kStick);
  CHECK(run.last.limit == Approx(down).epsilon(1e-14));
  CHECK(run.last.phi == Approx(-0.6 * down).epsilon(1e-14));
  run = under(100.0, belt(0.2, pi, fixed_stiffness(1000.0)));
  CHECK(run.move_to(2, 0.004).state.force[0] == Approx(4.0).epsilon(1e-14));
  CHECK(run.move_to(2, -0.004).state.force[0] == Approx(-4.0).epsilon(1e-14));
  // Exactly on the limit it still sticks; the band is narrower backward.
  run.move_to(2, -down / 1000.0);
  CHECK(run.last.state.regime == Regime::kStick);
  run.move_to(2, -down / 1000.0 - 1e-9);
  CHECK(run.last.state.regime == Regime::kSlip);
  CHECK(run.last.slip_increment == Approx(1e-9).epsilon(1e-6));  // of a difference 5e-2
}

TEST_CASE(
    "the tension scales the force with an elastic slip and leaves it with a fixed stiffness") {
  FrictionRun run = under(100.0, belt(0.2, pi, allowable_slip(0.01)));
  const double before = run.move_to(2, 0.005).state.force[0];
  run.force[0] = 150.0;
  CHECK(run.step().state.force[0] == Approx(1.5 * before).epsilon(1e-14));
  run = under(100.0, belt(0.2, pi, fixed_stiffness(1000.0)));
  run.move_to(2, 0.05);
  run.force[0] = 150.0;
  CHECK(run.step().state.force[0] == Approx(50.0).epsilon(1e-14));
  // When the limit falls below the force the belt slips without being moved.
  run.force[0] = 20.0;
  run.step();
  CHECK(run.last.state.regime == Regime::kSlip);
  CHECK(run.last.state.force[0] == Approx(20.0 * std::expm1(0.2 * pi)).epsilon(1e-14));
}

TEST_CASE("the onset of slip is where the force meets its side's limit, also through zero") {
  for (const StickStiffness stick : {allowable_slip(0.01), fixed_stiffness(2000.0)}) {
    const double up = 100.0 * std::expm1(0.2 * pi), down = -100.0 * std::expm1(-0.2 * pi);
    const bool fixed = stick.mode == StickStiffness::Mode::kStiffness;
    FrictionRun run = under(100.0, belt(0.2, pi, stick));
    run.move_to(2, 1.0);
    CHECK(run.last.onset == Approx(fixed ? up / 2000.0 : 0.01).epsilon(1e-13));
    run.move_to(2, 2.0);
    CHECK(run.last.onset == Approx(0.0).margin(1e-13));
    run.move_to(2, 1.0);
    CHECK(run.last.onset == Approx(fixed ? (up + down) / 2000.0 : 0.02).epsilon(1e-13));
    // The band shrinks with the tension, and with it a force that has a stiffness of its own: slip
    // from the first, without a motion.
    run.force[0] = 50.0;
    run.step();
    CHECK((run.last.state.regime == Regime::kSlip) == fixed);
    CHECK(run.last.onset == 0.0);
  }
}

TEST_CASE("a slack belt has no friction and starts again from a stress-free state") {
  for (const double tension : {0.0, -1e-300, -10.0}) {
    FrictionRun run = under(100.0, belt(0.2, pi));
    run.move_to(2, 1.0);
    run.force[0] = tension;
    run.move_to(2, 1.5);
    CHECK(run.last.state.regime == Regime::kOpen);
    CHECK(run.last.state.force[0] == 0.0);
    CHECK(run.last.normal_force == 0.0);
    CHECK(tension_behind(run.last) == 0.0);
    CHECK(run.last.tangent.radial == 0.0);
    const double slip = run.state.accumulated_slip;
    run.force[0] = 100.0;
    run.step();
    CHECK(run.last.state.regime == Regime::kStick);
    CHECK(run.last.state.force[0] == 0.0);
    CHECK(run.state.accumulated_slip == slip);
  }
}

TEST_CASE("without friction or without a wrap angle both tensions are equal") {
  for (const FrictionDefinition& definition : {belt(0.0, pi), belt(0.3, 0.0)}) {
    FrictionRun run = under(7.0, definition);
    run.move_to(2, 3.0);
    CHECK(run.last.state.regime == Regime::kOpen);
    CHECK(tension_behind(run.last) == 7.0);
    CHECK(run.state.accumulated_slip == 0.0);
  }
}

TEST_CASE("however large the friction, the tension behind the ring is never negative") {
  for (const StickStiffness stick : kBothModes) {
    FrictionRun run = under(100.0, belt(1.0, 200.0, stick));
    run.move_to(2, -1000.0);
    CHECK(run.last.state.regime == Regime::kSlip);
    CHECK(tension_behind(run.last) == 0.0);
    CHECK(run.last.state.force[0] == -100.0);
  }
}

TEST_CASE("a force limit caps both sides") {
  FrictionDefinition definition = belt(0.2, pi);
  definition.force_limit = 60.0;  // above the backward limit 46.7, below the forward one 87.4
  FrictionRun run = under(100.0, definition);
  CHECK(run.move_to(2, 1.0).state.force[0] == 60.0);
  CHECK(run.last.tangent.contact == 0.0);
  CHECK(run.move_to(2, -1.0).state.force[0] == Approx(-46.6511908908897).epsilon(1e-14));
}

TEST_CASE("the coefficient sees the rate of the flow, the tension and the temperature") {
  const double dt = 0.5;
  for (const StickStiffness stick : kBothModes) {
    for (const double sense : {1.0, -1.0}) {
      FrictionDefinition definition = belt(0.0, 2.0, stick);
      definition.law =
          TabularCoefficient{make_function({{0.4, 0, 0, 0},
                                            {0.2, 4, 0, 0},
                                            {0.3, 0, 200, 0},
                                            {0.1, 4, 200, 0},
                                            {0.2, 0, 0, 100},
                                            {0.1, 4, 0, 100},
                                            {0.2, 0, 200, 100},
                                            {0.1, 4, 200, 100}},
                                           {kOverSlipRate, kOverContactForce, kOverTemperature})};
      FrictionRun run = under(100.0, definition);
      run.duration = dt;
      run.temperature = 50.0;
      run.move_to(2, sense * 1.0);
      const double rate = run.last.slip_increment / dt;
      // 0.35 -> 0.15 at temperature 0, 0.2 -> 0.1 at 100, half way between.
      const double mu = 0.275 - 0.0375 * rate;
      CHECK(run.last.mu == Approx(mu).epsilon(1e-14));
      const double y = sense * 100.0 * std::abs(std::expm1(sense * 2.0 * mu));
      CHECK(run.last.state.force[0] == Approx(y).epsilon(1e-12));
      // The root of the return mapping: motion = elastic slip + slip.
      CHECK(std::abs(run.state.elastic_slip[0]) + run.last.slip_increment ==
            Approx(1.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("on request the coefficient sees the rate of the whole motion") {
  FrictionDefinition definition = belt(0.0, pi);
  definition.law = ExponentialDecay{0.3, 0.2, 0.5};
  definition.slip_rate = SlipRateMeasure::kRelativeMotion;
  FrictionRun run = under(100.0, definition);
  run.duration = 0.25;
  run.move_to(2, -1.0);
  const double mu = 0.2 + 0.1 * std::exp(-0.5 * 4.0);
  CHECK(run.last.slip_rate == 4.0);
  CHECK(run.last.state.force[0] == Approx(100.0 * std::expm1(-mu * pi)).epsilon(1e-14));
}

TEST_CASE("with a constant stiffness the slip is the first at which the limit is met") {
  Dice dice(11);
  int implicit = 0;
  for (int i = 0; i < 4000; ++i) {
    FrictionDefinition d = belt(0.0, dice.between(0.1, 12.0), fixed_stiffness(0.0));
    d.stick.value = std::exp(dice.between(std::log(5.0), std::log(5000.0)));
    const double kinetic = dice.between(0.0, 0.3);
    if (dice.chance(0.5)) {
      d.law = ExponentialDecay{kinetic + dice.between(0.05, 0.5), kinetic, dice.between(0.1, 20.0)};
    } else {
      d.law = TabularCoefficient{make_function({{dice.between(0.1, 0.6), 0.0},
                                                {dice.between(0.0, 0.6), dice.between(0.1, 1.0)},
                                                {dice.between(0.0, 0.6), dice.between(1.0, 3.0)}},
                                               {kOverSlipRate})};
    }
    if (dice.chance(0.2)) d.force_limit = dice.between(1.0, 100.0);
    ConnectorIncrement increment;
    increment.duration = dice.one_of(std::vector<double>{1e-3, 0.05, 1.0});
    increment.force[0] = dice.between(1.0, 100.0);
    increment.end.position[1] = dice.between(-2.0, 2.0);
    const FrictionUpdate u = update(d, increment, {});
    if (u.state.regime != Regime::kSlip) continue;
    ++implicit;
    const double trial = d.stick.value * std::abs(increment.end.position[1]);
    const auto excess = [&](double slip) {
      const double mu = evaluate(d.law, increment.end, {.slip_rate = slip / increment.duration}).mu;
      const double a = mu * std::get<Capstan>(d.criterion).wrap_angle;
      const double limit = increment.end.position[1] > 0.0 ? std::expm1(a) : -std::expm1(-a);
      return trial - d.stick.value * slip - std::min(increment.force[0] * limit, d.force_limit);
    };
    // Rounding of the exponential at angles up to 12 and of the trial force.
    CHECK(std::abs(excess(u.slip_increment)) <= 1e-11 * (trial + u.limit));
    double lowest = 0.0;
    for (int k = 0; k < 400; ++k) {
      lowest = std::min(lowest, excess(u.slip_increment * k / 400.0));
    }
    CHECK(lowest >= -1e-11 * (trial + u.limit));
  }
  CHECK(implicit > 1500);
}

TEST_CASE("work through zero without slip is that of a spring on either side") {
  FrictionRun run = under(5.0, belt(0.1, pi / 2));
  const double before = run.move_to(2, 0.004).state.force[0];
  const double after = run.move_to(2, -0.004).state.force[0];
  REQUIRE(run.last.state.regime == Regime::kStick);
  CHECK(run.last.work == Approx(-0.5 * 0.004 * (before + after)).epsilon(1e-14));
}

TEST_CASE("work is dissipated or stored, to rounding, at constant tension") {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const StickStiffness stick =
        i % 2 == 0 ? allowable_slip(dice.between(0.01, 0.2)) : fixed_stiffness(500.0);
    FrictionRun run = under(100.0, belt(dice.between(0.05, 0.4), dice.between(0.1, 7.0), stick));
    double largest = 0.0;
    for (int k = 0; k < 40; ++k) {
      run.move_to(2, dice.between(-0.5, 0.5));
      largest = std::max({largest, run.dissipation, run.last.stored_energy});
      CHECK(run.last.dissipation >= 0.0);
      CHECK(std::abs(run.work - run.dissipation - run.last.stored_energy) <= 1e-13 * largest);
    }
  }
}

TEST_CASE("the consistent tangent of a belt meets differences in every regime") {
  Dice dice(3);
  int compared[3] = {};
  for (int i = 0; i < 3000; ++i) {
    FrictionDefinition d = belt(0.0, dice.between(0.2, 6.0),
                                i % 2 == 0 ? allowable_slip(0.05) : fixed_stiffness(800.0));
    switch (i % 3) {
      case 0:
        d.law = ConstantCoefficient{dice.between(0.05, 0.5)};
        break;
      case 1:
        d.law = ExponentialDecay{0.3, 0.2, 0.3};
        break;
      default:
        d.law = TabularCoefficient{
            make_function({{0.3, 0, 0}, {0.2, 50, 0}, {0.2, 0, 500}, {0.15, 50, 500}},
                          {kOverSlipRate, kOverContactForce})};
    }
    if (dice.chance(0.3)) d.slip_rate = SlipRateMeasure::kRelativeMotion;
    if (dice.chance(0.3)) d.blend = {0.25, 0.4};
    if (dice.chance(0.2)) d.force_limit = dice.between(5.0, 50.0);
    FrictionState old;
    ConnectorIncrement first;
    first.duration = 1.0;
    first.force[0] = dice.between(10.0, 200.0);
    first.end.position[1] = dice.between(-0.2, 0.2);
    old = update(d, first, old).state;
    ConnectorIncrement increment = first;
    increment.begin_position = first.end.position;
    increment.force[0] = dice.chance(0.1) ? -5.0 : dice.between(10.0, 200.0);
    increment.end.position[1] += dice.between(-0.3, 0.3);
    const FrictionUpdate here = update(d, increment, old);
    const ConnectorTangent tangent = connector_tangent(d, increment, here);
    const auto force_at = [&](const ConnectorIncrement& moved) -> std::optional<double> {
      const FrictionUpdate u = update(d, moved, old);
      const bool same = u.state.regime == here.state.regime &&
                        (u.limit >= d.force_limit) == (here.limit >= d.force_limit) &&
                        u.direction == here.direction &&
                        u.motion_direction == here.motion_direction;
      return same ? std::optional(u.state.force[0]) : std::nullopt;
    };
    for (const double side : {1.0, -1.0}) {
      const auto by_flow = one_sided_derivative(
          [&](double h) {
            ConnectorIncrement moved = increment;
            moved.end.position[1] += h;
            return force_at(moved);
          },
          side * 2e-6);
      const auto by_tension = one_sided_derivative(
          [&](double h) {
            ConnectorIncrement moved = increment;
            moved.force[0] += h;
            return force_at(moved);
          },
          side * 2e-4);
      if (!by_flow || !by_tension) continue;
      ++compared[static_cast<int>(here.state.regime)];
      // Differences over 2e-6 of forces up to 1e3 carry 1e-7 of rounding, relative to stiffness.
      const double stiffness = here.limit / 0.05 + 800.0;
      CHECK(std::abs(tangent.to_motion(1, 1) - by_flow->value) <=
            2e-6 * stiffness + 20.0 * by_flow->error);
      CHECK(std::abs(tangent.to_force(1, 0) - by_tension->value) <=
            1e-6 * (1.0 + here.limit / increment.force[0]) + 20.0 * by_tension->error);
    }
  }
  for (const int count : compared) CHECK(count > 200);
}

TEST_CASE("with both tensions given the belt sticks strictly between the two ratios") {
  const FrictionDefinition d = belt(0.2, pi);
  ConnectorIncrement increment;
  increment.force[0] = 100.0;
  const auto judged = [&](double behind) { return judge_capstan(d, increment, behind); };
  for (const double behind : {53.4, 100.0, 187.4}) {
    CHECK(judged(behind).state.regime == Regime::kStick);
    CHECK(judged(behind).phi < 0.0);
    CHECK(capstan_utilisation(judged(behind), pi) < 1.0);
  }
  for (const double behind : {0.0, 53.3, 187.5, 1e6}) {
    CHECK(judged(behind).state.regime == Regime::kSlip);
    CHECK(judged(behind).phi > 0.0);
    CHECK(capstan_utilisation(judged(behind), pi) > 1.0);
  }
  CHECK(judged(187.4).limit == Approx(87.4456087585338).epsilon(1e-14));
  CHECK(judged(53.4).limit == Approx(46.6511908908897).epsilon(1e-14));
  CHECK(judged(150.0).state.force[0] == 50.0);
  CHECK(judged(150.0).state.accumulated_slip == 0.0);
  CHECK(tension_behind(judged(150.0)) == 150.0);
  // Half of the way in the logarithm: the geometric mean of the tension and its limit.
  CHECK(capstan_utilisation(judged(100.0 * std::exp(0.1 * pi)), pi) == Approx(0.5).epsilon(1e-14));
  CHECK(capstan_utilisation(judged(100.0 * std::exp(-0.1 * pi)), pi) == Approx(0.5).epsilon(1e-14));
  increment.force[0] = 0.0;
  CHECK(judged(0.0).state.regime == Regime::kOpen);
  CHECK(judged(1.0).state.regime == Regime::kSlip);
  CHECK(capstan_utilisation(judged(0.0), pi) == 0.0);
}

}  // namespace
