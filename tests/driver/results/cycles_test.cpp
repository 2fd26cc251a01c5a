// SPDX-License-Identifier: Apache-2.0
#include "driver/results/cycles.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

CycleCounter cycles_of(const cases::Case& problem) {
  CycleCounter cycles(problem);
  for (const bench::Row& row : bench::rows_of(problem)) cycles.add(row);
  return cycles;
}

const history::Wave kTriangle{history::WaveShape::kTriangle, 0.1, 1.0, 0.0, 0.0};

TEST_CASE("the energy of a cycle is found from the period of the motion") {
  // Reference cases, J2: 6.4 mJ a cycle; the first begins at rest, 0 -> A -> -A -> 0, which leaves
  // out one elastic slip of 0.02 mm: 20 N (0.08 + 0.16 + 0.06) mm.
  const cases::Case problem = bench::slider_case({bench::step("cycle", 120, 0, kTriangle, 3.5)});
  const CycleCounter cycles = cycles_of(problem);
  REQUIRE(cycles.energies().size() == 1);
  const CycleEnergy& energy = cycles.energies()[0];
  CHECK(energy.count == 3);
  CHECK(energy.first == Approx(6.0).epsilon(1e-12));
  CHECK(energy.before_last == Approx(6.4).epsilon(1e-12));
  CHECK(energy.last == Approx(6.4).epsilon(1e-12));
  CHECK(energy.lowest == Approx(6.0).epsilon(1e-12));
  CHECK(energy.highest == Approx(6.4).epsilon(1e-12));
  CHECK(cycles.found_by() == "period of the waves");
}

TEST_CASE("each pass of a repeated step is a cycle") {
  cases::Step pass = bench::step("there and back", 100, 0,
                                 history::Tabular{{0.0, 0.5, 1.0}, {0.0, 0.1, 0.0}}, 1.0, 4);
  const CycleCounter cycles = cycles_of(bench::slider_case({pass}));
  // 0 <-> 0.1 mm: 20 N x 2 x (0.1 - 0.04) mm, and 20 (0.08 + 0.06) from rest.
  CHECK(cycles.energies()[0].count == 4);
  CHECK(cycles.energies()[0].first == Approx(2.8).epsilon(1e-12));
  CHECK(cycles.energies()[0].last == Approx(2.4).epsilon(1e-12));
  CHECK(cycles.found_by() == "repeated step");
}

TEST_CASE("cycles that lie within one increment are counted at once") {
  std::vector<cases::Step> steps;
  for (const double to : {0.1, 0.0, 0.1}) {
    steps.push_back(bench::step("slide", 10, 0, history::LinearTo{to}));
    steps.back().drives.push_back(
        {cases::kFirstForce + 1, history::Wave{history::WaveShape::kSine, 1.0, 1e-9, 0.0, 0.0}});
  }
  const CycleEnergy energy = cycles_of(bench::slider_case(steps)).energies()[0];
  CHECK(energy.count == 3000000000);
  CHECK(energy.first == 0.0);
  CHECK(energy.lowest == 0.0);
  // 20 N times 1e-10 mm, but for the rounding of the whole energy of some mJ.
  CHECK(energy.before_last == Approx(2e-9).margin(1e-14));
  CHECK(energy.last == Approx(2e-9).margin(1e-14));
  CHECK(energy.highest == Approx(2e-9).margin(1e-14));
}

TEST_CASE("cycles counted at once have the energies of cycles counted one by one") {
  const auto energy_at = [](double period, int increments) {
    cases::Step step = bench::step("slide", increments, 0, history::LinearTo{0.1});
    step.drives.push_back(
        {cases::kFirstForce + 1, history::Wave{history::WaveShape::kSine, 1.0, period, 0.0, 0.0}});
    return cycles_of(bench::slider_case({step})).energies()[0];
  };
  for (const double period : {0.001, 0.0017, 0.00123}) {
    CAPTURE(period);
    // Increments of 0.1 and of 0.005; slip begins at t = 0.2.
    const CycleEnergy few = energy_at(period, 10);
    const CycleEnergy many = energy_at(period, 200);
    CHECK(few.count == many.count);
    CHECK(few.first == Approx(many.first).margin(1e-12));
    CHECK(few.before_last == Approx(many.before_last).epsilon(1e-9));
    CHECK(few.last == Approx(many.last).epsilon(1e-9));
    CHECK(few.lowest == Approx(many.lowest).margin(1e-12));
    CHECK(few.highest == Approx(many.highest).epsilon(1e-9));
  }
}

TEST_CASE("the length of a cycle is the longest period, if the others fit into it") {
  cases::Step both = bench::step("cycle", 10, 0, kTriangle, 3.0);
  both.drives.push_back(
      {cases::kFirstForce + 1, history::Wave{history::WaveShape::kSine, 1.0, 0.5, 0.0, 0.0}});
  CHECK(cycle_length(both) == 1.0);
  both.drives.push_back(
      {cases::kFirstForce + 2, history::Wave{history::WaveShape::kSine, 1.0, 0.3, 0.0, 0.0}});
  CHECK(cycle_length(both) == 0.0);
  CHECK(cycle_length(bench::step("short", 10, 0, kTriangle, 0.5)) == 0.0);
  CHECK(cycle_length(bench::step("once", 10, 0, history::LinearTo{1.0})) == 0.0);
}

}  // namespace
}  // namespace slipbench::driver::results
