// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/simulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/bench/run_case.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::bench {
namespace {

// Rounding of sums of up to a hundred terms; the return mapping is exact in one dimension.
constexpr double kRounding = 1e-12;

double motion(const Row& row) { return row.quantities[0]; }
double force(const Row& row) { return row.definitions[0].update.state.force[0]; }

TEST_CASE("slip and dissipation add up along 0, A, -A, A to the closed form's running totals") {
  const cases::Case problem = slider_case({step("out", 10, 0, history::LinearTo{0.1}),
                                           step("back", 10, 0, history::LinearTo{-0.1}),
                                           step("again", 10, 0, history::LinearTo{0.1})});
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 31);
  // s = A - s_c and then 2 A - 2 s_c each way; W = lim s with lim = 20 N.
  const double slip[] = {0.08, 0.24, 0.40};
  for (std::size_t i = 0; i < 3; ++i) {
    const DefinitionRow& here = rows[10 * (i + 1)].definitions[0];
    CHECK(here.update.state.accumulated_slip == Approx(slip[i]).margin(kRounding));
    CHECK(here.dissipation == Approx(20.0 * slip[i]).margin(20.0 * kRounding));
    CHECK(here.work == Approx(here.dissipation + here.update.stored_energy).margin(kRounding));
  }
  CHECK(force(rows[20]) == Approx(-20.0).epsilon(kRounding));
}

TEST_CASE("row 0 is the initial state: first forces, no motion, limits known") {
  cases::Case problem = slider_case({step("slide", 4, 0, history::LinearTo{1.5})});
  problem.initial[0] = 0.5;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{1};
  problem.steps[0].drives.push_back({cases::kFirstForce + 1, history::Constant{50.0}});
  const std::vector<Row> rows = rows_of(problem);
  CHECK(rows[0].index == 0);
  CHECK(rows[0].time == 0.0);
  CHECK(rows[0].duration == 0.0);
  CHECK(motion(rows[0]) == 0.5);
  CHECK(rows[0].quantities[cases::kFirstForce + 1] == 50.0);
  CHECK(rows[0].definitions[0].update.limit == Approx(30.0).epsilon(kRounding));
  CHECK(rows[0].definitions[0].update.state.regime == law::Regime::kStick);
  CHECK(rows[1].duration == 0.25);
  CHECK(motion(rows[1]) == 0.75);
}

TEST_CASE("a breakpoint of a profile is never stepped over") {
  // Peaks of the triangle at 0.25 and 0.75; three increments alone would miss both.
  const cases::Case problem = slider_case(
      {step("cycle", 3, 0, history::Wave{history::WaveShape::kTriangle, 0.1, 1.0, 0.0, 0.0})});
  std::vector<double> times;
  double highest = 0.0;
  double lowest = 0.0;
  for (const Row& row : rows_of(problem)) {
    times.push_back(row.time);
    highest = std::max(highest, motion(row));
    lowest = std::min(lowest, motion(row));
  }
  REQUIRE(times.size() == 6);
  CHECK(times[1] == Approx(0.25));
  CHECK(times[4] == Approx(0.75));
  CHECK(highest == Approx(0.1));
  CHECK(lowest == Approx(-0.1));
}

TEST_CASE("a repeated step goes on from where it ended, in total time and in value") {
  const cases::Case problem = slider_case(
      {step("cycle", 4, 0, history::Wave{history::WaveShape::kSine, 0.1, 1.0, 0.0, 0.0}, 1.0, 3)});
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 13);
  CHECK(rows[9].pass == 2);
  CHECK(rows[9].step_time == 0.25);
  CHECK(rows[9].time == 2.25);
  CHECK(motion(rows[9]) == Approx(0.1));
  CHECK(rows[12].time == 3.0);
}

TEST_CASE("a quantity that a step does not mention keeps its value") {
  cases::Case problem =
      slider_case({step("press", 2, cases::kFirstForce + 1, history::LinearTo{30.0}),
                   step("slide", 2, 0, history::LinearTo{0.1})});
  const std::vector<Row> rows = rows_of(problem);
  CHECK(motion(rows[2]) == 0.0);
  CHECK(rows[4].quantities[cases::kFirstForce + 1] == 30.0);
  CHECK(motion(rows[4]) == 0.1);
}

TEST_CASE("a run that was cut and taken up again gives the same rows, to the last bit") {
  cases::Case problem = puck_case({});
  problem.steps = {
      step("slide", 7, 1, history::LinearTo{0.3}),
      step("turn", 5, 2, history::Wave{history::WaveShape::kTriangle, 0.1, 0.7, 0.0, 0.0}, 1.0, 2)};
  problem.steps[0].drives.push_back({cases::kFirstForce + 0, history::LinearTo{-100.0}});
  problem.steps[1].drives.push_back(
      {3, history::Wave{history::WaveShape::kSine, 0.2, 1.0, 0.0, 0.0}});
  const std::vector<Row> whole = rows_of(problem);
  REQUIRE(whole.size() > 15);
  for (const std::size_t cut : {std::size_t{0}, std::size_t{3}, std::size_t{7}, whole.size() - 2}) {
    auto first = Simulation::start(problem);
    REQUIRE(first);
    for (std::size_t i = 0; i < cut; ++i) REQUIRE(first->advance().value());
    auto second = Simulation::resume(problem, first->state());
    REQUIRE(second);
    for (std::size_t i = cut + 1; i < whole.size(); ++i) {
      REQUIRE(second->advance().value());
      const Row& row = second->row();
      CHECK(row.index == whole[i].index);
      CHECK(row.time == whole[i].time);
      CHECK(row.quantities == whole[i].quantities);
      for (std::size_t d = 0; d < row.definitions.size(); ++d) {
        CHECK(row.definitions[d].update.state == whole[i].definitions[d].update.state);
        CHECK(row.definitions[d].update.work == whole[i].definitions[d].update.work);
        CHECK(row.definitions[d].dissipation == whole[i].definitions[d].dissipation);
        CHECK(row.definitions[d].work == whole[i].definitions[d].work);
      }
    }
    CHECK_FALSE(second->advance().value());
  }
}

TEST_CASE("a state from beyond the end of the history is refused") {
  const cases::Case problem = slider_case({step("slide", 4, 0, history::LinearTo{0.1})});
  SimulationState state = Simulation::start(problem)->state();
  state.increments = 5;
  const auto resumed = Simulation::resume(problem, state);
  REQUIRE_FALSE(resumed);
  CHECK(resumed.error().message == "the history has 4 increments; the state was taken after 5");
}

TEST_CASE("a motion that does not start where the connector is, is noted") {
  const cases::Case problem = slider_case(
      {step("cycle", 4, 0, history::Wave{history::WaveShape::kSine, 0.1, 1.0, 0.5, 0.0}),
       step("on", 4, 0, history::LinearTo{0.0})});
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (simulation->advance().value()) {
  }
  REQUIRE(simulation->jumps().size() == 1);
  CHECK(simulation->jumps()[0].component == 0);
  CHECK(simulation->jumps()[0].size == 0.5);
  CHECK(simulation->jumps()[0].step == "cycle");
}

TEST_CASE("a measured history drives the case row by row from its first row on") {
  const TemporaryFolder folder;
  cases::Case problem = slider_case({});
  problem.measured = history::MeasuredSource{
      {folder.write("rig.csv", "time,disp\n1,0.5\n2,0.51\n4,0.6\n"), "rig.csv"},
      "time",
      {},
      {{0, "disp", {}}},
      false};
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].time == 1.0);
  CHECK(motion(rows[0]) == 0.5);
  CHECK(force(rows[0]) == 0.0);
  // 1000 N/mm times 0.01 mm; the difference 0.51 - 0.5 carries rounding of 1e-14 relative.
  CHECK(force(rows[1]) == Approx(10.0).epsilon(kRounding));
  CHECK(rows[2].duration == 2.0);
  CHECK(force(rows[2]) == Approx(20.0).epsilon(kRounding));
}

TEST_CASE("faulty data end the run and name their line") {
  const TemporaryFolder folder;
  cases::Case problem = slider_case({});
  problem.measured =
      history::MeasuredSource{{folder.write("rig.csv", "time,disp\n1,0.5\n2,x\n"), "rig.csv"},
                              "time",
                              {},
                              {{0, "disp", {}}},
                              false};
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  const auto more = simulation->advance();
  REQUIRE_FALSE(more);
  CHECK(more.error().kind == SimulationFailure::Kind::kInput);
  CHECK(more.error().message.substr(0, 10) == "rig.csv:3:");
}

TEST_CASE("a file that is missing is a failure of the environment") {
  cases::Case problem = slider_case({});
  problem.measured =
      history::MeasuredSource{{"missing.csv", "missing.csv"}, "t", {}, {{0, "u", {}}}, false};
  const auto simulation = Simulation::start(problem);
  REQUIRE_FALSE(simulation);
  CHECK(simulation.error().kind == SimulationFailure::Kind::kEnvironment);
}

TEST_CASE("a formula without value ends the run and names step, time and quantity") {
  auto formula = history::compile_profile("= sqrt(0.6 - t)", {});
  REQUIRE(formula);
  cases::Case problem = slider_case({step("slide", 4, 0, *formula)});
  problem.initial[0] = 0.7745966692414834;
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  CHECK(simulation->advance());
  CHECK(simulation->advance());
  const auto more = simulation->advance();
  REQUIRE_FALSE(more);
  CHECK(more.error().kind == SimulationFailure::Kind::kInput);
  CHECK(more.error().message.find("step 'slide', t = 0.75, CP1: ") == 0);
}

TEST_CASE("an update that is not finite ends the run and names step, time and definition") {
  cases::Case problem =
      slider_case({step("press", 2, cases::kFirstForce + 1, history::LinearTo{1.5e308})});
  problem.definitions[0].law.contact_force = law::DerivedComponent{law::norm_term({2}, 1.0)};
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  const auto more = simulation->advance();
  REQUIRE_FALSE(more);
  CHECK(more.error().kind == SimulationFailure::Kind::kNumerical);
  CHECK(more.error().message ==
        "step 'press', t = 0.5 (total time 0.5): definition 'sleeve': the normal force is not "
        "finite");
}

TEST_CASE("energies whose sum is not finite end the run, also of rows that come together") {
  // 1e153 N over 1e153 mm an increment: 180 of them are beyond the largest double.
  cases::Case problem = slider_case({step("rub", 400, 0, history::LinearTo{4e155})});
  problem.definitions[0].law.internal_contact_force = 5e153;
  problem.definitions[0].law.stick.value = 2.0;
  const std::string_view message = "definition 'sleeve': the sum of the energies is not finite";
  auto one_by_one = Simulation::start(problem);
  REQUIRE(one_by_one);
  int sound = 0;
  auto more = one_by_one->advance();
  for (; more && *more; more = one_by_one->advance()) ++sound;
  REQUIRE_FALSE(more);
  CHECK(more.error().kind == SimulationFailure::Kind::kNumerical);
  CHECK(more.error().message.ends_with(message));
  CHECK(sound == 179);

  int rows = -1;  // row 0 is no increment
  const auto together = run_in_blocks(
      problem, [&](std::span<const Row> some) { rows += static_cast<int>(some.size()); });
  REQUIRE_FALSE(together);
  CHECK(together.error().message == more.error().message);
  CHECK(rows == sound);
}

}  // namespace
}  // namespace slipbench::driver::bench
