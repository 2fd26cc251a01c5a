// SPDX-License-Identifier: Apache-2.0
// A dead zone and a coefficient for each direction: options of the bench around the law.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "driver/bench/dead_zone.hpp"
#include "law/friction/law_list.hpp"
#include "reference/backlash_slider.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/support/dice.hpp"

namespace slipbench::driver::bench {
namespace {

using test::Dice;
namespace closed = reference::backlash_slider;

/// Numbers of the random slider of a test: limits 20 N forward unless it has other coefficients.
struct Options {
  double gap = 0.0;
  double start = 0.0;
  double forward = 0.2;
  std::optional<double> backward = {};
  law::StickStiffness stick = {law::StickStiffness::Mode::kStiffness, 1000.0};
};

cases::Case with_options(const Options& options, std::vector<cases::Step> steps) {
  cases::Case problem = slider_case(std::move(steps));
  cases::CaseDefinition& definition = problem.definitions[0];
  definition.law.law = law::ConstantCoefficient{options.forward};
  definition.law.stick = options.stick;
  if (options.backward) definition.backward = law::ConstantCoefficient{*options.backward};
  if (options.gap > 0.0) definition.dead_zone = cases::DeadZone{options.gap, options.start};
  return problem;
}

/// A connected path of 60 straight steps, from far below the gap to far beyond gap and slip.
std::vector<cases::Step> random_path(Dice& dice) {
  std::vector<cases::Step> steps;
  double at = 0.0;
  for (int i = 0; i < 60; ++i) {
    at += dice.dyadic(-1.0, 1.0) * dice.one_of(std::vector<double>{0.0625, 0.25, 0.5, 1.0});
    steps.push_back(step("leg", 1 + dice.pick(3), 0, history::LinearTo{at}));
  }
  return steps;
}

Options random_options(Dice& dice) {
  Options options;
  options.gap = dice.chance(0.2) ? 0.0 : dice.dyadic(0.01, 0.5);
  options.start = 0.5 * options.gap * dice.one_of(std::vector<double>{-1.0, 0.0, 0.5, 1.0});
  options.forward = dice.between(0.05, 0.6);
  if (dice.chance(0.7)) options.backward = dice.between(0.05, 0.6);
  // A ratchet: nothing holds in one direction.
  if (dice.chance(0.2)) options.backward = 0.0;
  if (options.backward.value_or(1.0) > 0.0 && dice.chance(0.1)) options.forward = 0.0;
  if (dice.chance(0.5)) {
    options.stick = {law::StickStiffness::Mode::kElasticSlip, dice.between(1e-3, 0.1)};
  }
  return options;
}

TEST_CASE("a slider with backlash and two limits follows its closed form along any path") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Dice dice(seed);
    Options options = random_options(dice);
    options.stick = {law::StickStiffness::Mode::kStiffness, dice.between(100.0, 3000.0)};
    const cases::Case problem = with_options(options, random_path(dice));
    const closed::Slider slider{options.stick.value, 100.0 * options.forward,
                                100.0 * options.backward.value_or(options.forward), options.gap};
    closed::State state = closed::start(0.0, options.start);
    INFO("seed " << seed);
    for (const Row& row : rows_of(problem)) {
      state = closed::advance(slider, state, row.quantities[0]);
      const DefinitionRow& here = row.definitions[0];
      // Positions up to 5 carry roundings of 1e-15, which the stiffness turns into forces of 1e-12;
      // 180 of them add up.
      CHECK(std::abs(here.update.state.force[0] - state.force) <= 1e-9);
      // Without a limit the friction is open, and what slips there is not counted.
      if (std::min(slider.forward_limit, slider.backward_limit) > 0.0) {
        CHECK(std::abs(here.update.state.accumulated_slip - state.accumulated_slip) <= 1e-11);
      }
      CHECK(std::abs(here.dissipation - state.dissipation) <= 1e-9);
      CHECK(std::abs(here.work - state.work) <= 1e-9);
      if (options.gap > 0.0) CHECK(std::abs(here.play - closed::play(slider, state)) <= 1e-12);
    }
  }
}

TEST_CASE("dissipation never falls, the force stays within its limit, and energy is kept") {
  int backward = 0, in_the_gap = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    const Options options = random_options(dice);
    const std::vector<Row> rows = rows_of(with_options(options, random_path(dice)));
    INFO("seed " << seed);
    double before = 0.0;
    for (const Row& row : rows) {
      const DefinitionRow& here = row.definitions[0];
      const law::FrictionUpdate& update = here.update;
      CHECK(here.dissipation >= before);
      before = here.dissipation;
      CHECK(std::abs(update.state.force[0]) <= update.limit * (1.0 + 1e-14));
      CHECK(std::abs(here.play) <= 0.5 * options.gap);
      CHECK(update.onset >= 0.0);
      CHECK(update.onset <= 1.0);
      // Where the play lies between its ends nothing holds: no force at all, not even rounding.
      if (std::abs(here.play) < 0.5 * options.gap) {
        CHECK(update.state.force[0] == 0.0);
        ++in_the_gap;
      }
      // The coefficient is that of the direction of the force.
      if (options.backward && update.state.force[0] != 0.0) {
        CHECK(here.backward == (update.state.force[0] < 0.0));
        CHECK(update.mu == (here.backward ? *options.backward : options.forward));
        backward += here.backward ? 1 : 0;
      }
      // Sums of up to 180 increments of some 100 mJ.
      CHECK(std::abs(here.work - here.dissipation - update.stored_energy) <= 1e-10);
    }
  }
  CHECK(backward > 1000);
  CHECK(in_the_gap > 500);
}

TEST_CASE("one increment across the gap is as good as many") {
  for (const double width : {0.05, 0.3}) {
    const auto rows = [&](int increments) {
      Options options{.gap = width, .backward = 0.1};
      return rows_of(with_options(options, {step("in", increments, 0, history::LinearTo{0.5}),
                                            step("out", increments, 0, history::LinearTo{-0.4}),
                                            step("in", increments, 0, history::LinearTo{0.3})}));
    };
    const Row few = rows(1).back();
    const Row many = rows(997).back();
    // Roundings of a thousand increments.
    CHECK(few.definitions[0].dissipation == Approx(many.definitions[0].dissipation).epsilon(1e-11));
    CHECK(few.definitions[0].work == Approx(many.definitions[0].work).epsilon(1e-11));
    CHECK(few.definitions[0].play == many.definitions[0].play);
  }
}

TEST_CASE("slip begins where the gap and the elastic slip end") {
  // 0.3 of gap to its upper end, 0.02 of elastic slip, 1 in all.
  const Row row =
      rows_of(with_options({.gap = 0.6}, {step("in", 1, 0, history::LinearTo{1.0})})).back();
  CHECK(row.definitions[0].update.onset == Approx(0.32).epsilon(1e-12));  // rounding
  // Back: 0.02 + 0.6 + 0.02 of 2.
  const Row back = rows_of(with_options({.gap = 0.6}, {step("in", 1, 0, history::LinearTo{1.0}),
                                                       step("out", 1, 0, history::LinearTo{-1.0})}))
                       .back();
  CHECK(back.definitions[0].update.onset == Approx(0.32).epsilon(1e-12));
  // The same with two limits under one elastic slip, without a gap: 0.02 + 0.02 of 0.1.
  Options two{.forward = 0.3, .backward = 0.1};
  two.stick = {law::StickStiffness::Mode::kElasticSlip, 0.02};
  const Row turned = rows_of(with_options(two, {step("in", 1, 0, history::LinearTo{0.1}),
                                                step("out", 1, 0, history::LinearTo{0.0})}))
                         .back();
  CHECK(turned.definitions[0].update.onset == Approx(0.4).epsilon(1e-12));
}

TEST_CASE("lengths and forces in units of powers of two change nothing, to the last bit") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Dice dice(seed);
    const Options options = random_options(dice);
    const cases::Case here = with_options(options, random_path(dice));
    constexpr double kLength = 1024.0;
    constexpr double kForce = 0.125;
    cases::Case there = here;
    cases::CaseDefinition& d = there.definitions[0];
    d.law.internal_contact_force = 100.0 * kForce;
    const bool fixed = options.stick.mode == law::StickStiffness::Mode::kStiffness;
    d.law.stick.value *= fixed ? kForce / kLength : kLength;
    if (d.dead_zone) d.dead_zone = cases::DeadZone{options.gap * kLength, options.start * kLength};
    for (cases::Step& one : there.steps) {
      one.drives[0].profile =
          history::LinearTo{std::get<history::LinearTo>(one.drives[0].profile).value * kLength};
    }
    const std::vector<Row> a = rows_of(here);
    const std::vector<Row> b = rows_of(there);
    REQUIRE(a.size() == b.size());
    INFO("seed " << seed);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const DefinitionRow& one = a[i].definitions[0];
      const DefinitionRow& other = b[i].definitions[0];
      CHECK(one.update.state.force[0] * kForce == other.update.state.force[0]);
      CHECK(one.play * kLength == other.play);
      CHECK(one.work * kForce * kLength == other.work);
      CHECK(one.dissipation * kForce * kLength == other.dissipation);
    }
  }
}

TEST_CASE("mirrored motion with exchanged coefficients mirrors the force, to the last bit") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Dice dice(seed);
    Options options = random_options(dice);
    options.backward = dice.between(0.05, 0.6);
    const std::vector<cases::Step> path = random_path(dice);
    std::vector<cases::Step> mirrored = path;
    for (cases::Step& one : mirrored) {
      one.drives[0].profile =
          history::LinearTo{-std::get<history::LinearTo>(one.drives[0].profile).value};
    }
    Options other = options;
    other.forward = *options.backward;
    other.backward = options.forward;
    other.start = -options.start;
    const std::vector<Row> a = rows_of(with_options(options, path));
    const std::vector<Row> b = rows_of(with_options(other, mirrored));
    INFO("seed " << seed);
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].definitions[0].update.state.force[0] ==
            -b[i].definitions[0].update.state.force[0]);
      CHECK(a[i].definitions[0].play == -b[i].definitions[0].play);
      CHECK(a[i].definitions[0].work == b[i].definitions[0].work);
    }
  }
}

TEST_CASE("a gap of no width and equal coefficients are plain friction, to the last bit") {
  Dice dice(7);
  const std::vector<cases::Step> path = random_path(dice);
  const std::vector<Row> plain = rows_of(with_options({}, path));
  cases::Case problem = with_options({.backward = 0.2}, path);
  problem.definitions[0].dead_zone = cases::DeadZone{0.0, 0.0};
  const std::vector<Row> other = rows_of(problem);
  REQUIRE(plain.size() == other.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(plain[i].definitions[0].update.state == other[i].definitions[0].update.state);
    CHECK(plain[i].definitions[0].work == other[i].definitions[0].work);
  }
}

TEST_CASE("a run that was cut in a gap goes on with the same bytes") {
  Dice dice(3);
  const cases::Case problem =
      with_options({.gap = 0.4, .start = 0.1, .backward = 0.35}, random_path(dice));
  const std::vector<Row> whole = rows_of(problem);
  for (std::size_t cut = 0; cut + 1 < whole.size(); cut += 5) {
    auto first = Simulation::start(problem);
    for (std::size_t i = 0; i < cut; ++i) REQUIRE(first->advance().value());
    auto second = Simulation::resume(problem, first->state());
    REQUIRE(second);
    for (std::size_t i = cut + 1; i < whole.size(); ++i) {
      REQUIRE(second->advance().value());
      const DefinitionRow& row = second->row().definitions[0];
      const DefinitionRow& wanted = whole[i].definitions[0];
      CHECK(row.update.state == wanted.update.state);
      CHECK(row.play == wanted.play);
      CHECK(row.backward == wanted.backward);
      CHECK(row.work == wanted.work);
    }
  }
}

TEST_CASE("while the contact is open the play follows the motion and keeps its place") {
  cases::Case problem =
      with_options({.gap = 0.2}, {step("press", 2, 0, history::LinearTo{0.3}),
                                  step("lift", 2, 0, history::LinearTo{0.15}),
                                  step("press again", 2, 0, history::LinearTo{-0.3})});
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{1};
  problem.steps[0].drives.push_back({cases::kFirstForce + 1, history::Constant{100.0}});
  problem.steps[1].drives.push_back({cases::kFirstForce + 1, history::Constant{0.0}});
  problem.steps[2].drives.push_back({cases::kFirstForce + 1, history::Constant{100.0}});
  const std::vector<Row> rows = rows_of(problem);
  CHECK(rows[2].definitions[0].update.state.force[0] == Approx(20.0));
  const DefinitionRow& open = rows[4].definitions[0];
  CHECK(open.update.state.regime == law::Regime::kOpen);
  // The spring had 0.02 to give back: of the way back of 0.15 the gap took 0.13.
  CHECK(open.play == Approx(0.1 - 0.13).epsilon(1e-12));
  CHECK(rows[6].definitions[0].play == -0.1);
  CHECK(rows[6].definitions[0].update.state.force[0] == Approx(-20.0));
}

TEST_CASE("a direction that does not hold takes back the energy of the other one") {
  // 30 N on a spring of 0.03 mm: 0.45 mJ that the first increment back gives back.
  for (const double gap : {0.0, 0.06}) {
    for (const int increments : {1, 10}) {
      const std::vector<Row> rows =
          rows_of(with_options({.gap = gap, .forward = 0.3, .backward = 0.0},
                               {step("in", 1, 0, history::LinearTo{1.0}),
                                step("out", increments, 0, history::LinearTo{-1.0}),
                                step("in", 1, 0, history::LinearTo{1.0})}));
      const DefinitionRow& there = rows[1].definitions[0];
      const DefinitionRow& back = rows[1 + static_cast<std::size_t>(increments)].definitions[0];
      CHECK(back.update.state.regime == law::Regime::kOpen);
      CHECK(back.work == Approx(there.work - 0.45).epsilon(1e-12));  // rounding, as below
      CHECK(back.dissipation == there.dissipation);
      const DefinitionRow& end = rows.back().definitions[0];
      CHECK(end.update.stored_energy == Approx(0.45).epsilon(1e-12));
      CHECK(end.work == Approx(end.dissipation + 0.45).epsilon(1e-12));
    }
  }
}

TEST_CASE("a coefficient that falls in one direction alone has its thresholds there") {
  const law::FrictionLaw falling =
      law::ExponentialDecay{.mu_static = 0.3, .kinetic = 0.2, .decay = 0.5};
  const std::vector<cases::Step> path = {step("in", 4, 0, history::LinearTo{0.5}),
                                         step("out", 4, 0, history::LinearTo{-0.5})};
  cases::Case plain = with_options({}, path);
  plain.definitions[0].law.law = falling;
  const law::IncrementThresholds wanted = rows_of(plain).back().definitions[0].thresholds;
  REQUIRE(wanted.unique > 0.0);
  REQUIRE(wanted.smooth > 0.0);
  // The other one constant, or of a law that does not fall either.
  const law::FrictionLaw others[] = {
      law::ConstantCoefficient{0.2},
      law::ExponentialDecay{.mu_static = 0.2, .kinetic = 0.2, .decay = 0.5}};
  for (const law::FrictionLaw& other : others) {
    for (const bool backward : {true, false}) {
      cases::Case problem = plain;
      problem.definitions[0].law.law = backward ? other : falling;
      problem.definitions[0].backward = backward ? falling : other;
      const std::vector<Row> rows = rows_of(problem);
      const std::size_t here = backward ? 8 : 4;
      CHECK(rows[here].definitions[0].backward == backward);
      CHECK(rows[here].definitions[0].thresholds.unique == wanted.unique);
      CHECK(rows[backward ? 4 : 8].definitions[0].thresholds.smooth == 0.0);
    }
  }
}

TEST_CASE("thresholds see the motion that a gap leaves for the friction") {
  const auto thresholds = [](double gap) {
    cases::Case problem =
        with_options({.gap = gap}, {step("in", 1, 0, history::LinearTo{0.5 * gap + 0.05})});
    problem.definitions[0].law.law =
        law::ExponentialDecay{.mu_static = 0.3, .kinetic = 0.2, .decay = 10.0};
    return rows_of(problem).back().definitions[0].thresholds;
  };
  const law::IncrementThresholds plain = thresholds(0.0);
  const law::IncrementThresholds behind = thresholds(0.5);
  REQUIRE(plain.smooth > 0.0);
  CHECK(behind.weakening == Approx(plain.weakening).epsilon(1e-12));  // rounding of positions
  CHECK(behind.smooth == Approx(plain.smooth).epsilon(1e-12));
}

TEST_CASE("a floor of the backward coefficient is noted") {
  law::GeneralizedViscous floored = law::GeneralizedViscous::example();
  cases::Case problem = with_options({}, {step("out", 2, 0, history::LinearTo{-0.5})});
  // Forward it has no floor.
  for (const double shift : {0.0, -1.0}) {
    floored.fric = shift == 0.0 ? 1.0 : -1e3;
    problem.definitions[0].backward = floored;
    const DefinitionRow row = rows_of(problem).back().definitions[0];
    CHECK(row.backward);
    CHECK(row.clamped == (shift != 0.0));
    CHECK((row.raw_mu[0] < 0.0) == (shift != 0.0));
  }
}

TEST_CASE("a change of friction behind a gap: the spring is as long as its new stiffness wants") {
  // 15 N: 0.015 mm at 1000 N/mm, 0.075 at 200. The play stands at its upper end.
  law::FrictionDefinition softer = slider_case({}).definitions[0].law;
  law::FrictionState state;
  state.force[0] = 15.0;
  state.elastic_slip[0] = 0.015;
  softer.stick.value = 200.0;
  CHECK(elastic_extension(softer, state) == Approx(0.075).epsilon(1e-15));
  // With an allowable elastic slip the state has it.
  softer.stick = {law::StickStiffness::Mode::kElasticSlip, 0.02};
  CHECK(elastic_extension(softer, state) == 0.015);
}

TEST_CASE("in a scaled slip space the gap is in the unit of the component") {
  // A friction at the radius 10: 20 N there are 200 N mm, 1000 N/mm are 1e5 N mm a radian.
  for (const auto mode :
       {law::StickStiffness::Mode::kStiffness, law::StickStiffness::Mode::kElasticSlip}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Dice dice(seed);
      Options options = random_options(dice);
      options.stick = {mode, mode == law::StickStiffness::Mode::kStiffness
                                 ? dice.between(100.0, 3000.0)
                                 : dice.between(1e-3, 0.1)};
      const std::vector<cases::Step> path = random_path(dice);
      const std::vector<Row> along = rows_of(with_options(options, path));
      constexpr double kRadius = 8.0;
      options.gap /= kRadius;
      options.start /= kRadius;
      std::vector<cases::Step> turning = path;
      for (cases::Step& one : turning) {
        one.drives[0].quantity = 3;
        one.drives[0].profile =
            history::LinearTo{std::get<history::LinearTo>(one.drives[0].profile).value / kRadius};
      }
      cases::Case around = with_options(options, turning);
      around.connection = law::find_connection("CYLINDRICAL").value();
      around.definitions[0].law.slip = law::slip_space({4}, kRadius);
      const std::vector<Row> rows = rows_of(around);
      INFO("seed " << seed);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const DefinitionRow& one = along[i].definitions[0];
        const DefinitionRow& other = rows[i].definitions[0];
        // A power of two: no rounding.
        CHECK(one.update.state == other.update.state);
        CHECK(one.update.onset == other.update.onset);
        CHECK(one.work == other.work);
        CHECK(one.play == kRadius * other.play);
      }
    }
  }
}

TEST_CASE("the law in force is that of the direction") {
  const cases::Case problem = with_options(
      {.forward = 0.3, .backward = 0.1},
      {step("in", 1, 0, history::LinearTo{0.1}), step("out", 1, 0, history::LinearTo{0.0})});
  auto simulation = Simulation::start(problem);
  const auto mu = [&] {
    return std::get<law::ConstantCoefficient>(simulation->definition(0).law).mu;
  };
  CHECK(mu() == 0.3);
  REQUIRE(simulation->advance().value());
  CHECK(mu() == 0.3);
  REQUIRE(simulation->advance().value());
  CHECK(mu() == 0.1);
}

}  // namespace
}  // namespace slipbench::driver::bench
