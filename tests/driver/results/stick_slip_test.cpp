// SPDX-License-Identifier: Apache-2.0
#include "driver/results/stick_slip.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "driver/results/summary.hpp"
#include "reference/stick_slip_oscillator.hpp"
#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

/// A summary knows its case, which has to outlive it.
Summary summary_of(const cases::Case& problem) {
  Summary summary(problem);
  for (const bench::Row& row : bench::rows_of(problem)) summary.add(row);
  return summary;
}
Summary summary_of(cases::Case&&) = delete;

/// m = 1 t, k = 100 N/mm, N = 10 N, mu_s = 0.4, mu_k = 0.3 on a belt of 0.05 mm/s.
cases::Case belt_case(int increments, double end = 12.0) {
  cases::Case problem = bench::slider_case({{"run", end, increments, 1, {}}});
  problem.definitions[0].law.internal_contact_force = 10.0;
  problem.definitions[0].law.law = law::ConstantCoefficient{0.3};
  problem.kinetic.elasticity[0].emplace(100.0);
  problem.dynamics = cases::DynamicsData{0, 1.0, 0.05, 0.05, 0.4};
  return problem;
}

TEST_CASE("stick-slip is told with the frequency and the amplitude of the closed form") {
  const reference::stick_slip_oscillator::Oscillator oscillator{1.0, 100.0, 10.0, 0.4, 0.3, 0.05};
  const auto exact = reference::stick_slip_oscillator::limit_cycle(oscillator);
  const cases::Case problem = belt_case(3000);
  const Summary summary = summary_of(problem);
  const StickSlip& found = summary.definitions()[0].stick_slip;
  CHECK(found.cycles == 13);
  CHECK(found.frequency() == Approx(1.0 / exact.period).epsilon(1e-10));
  CHECK(found.period.highest - found.period.lowest < 1e-10);
  CHECK(found.slip_time / found.time == Approx(exact.slip_time / exact.period).epsilon(1e-10));
  // Turns are found between the rows, 4 ms apart.
  CHECK(found.place.highest == Approx(exact.maximum_motion).epsilon(1e-7));
  const double lowest = 0.03 - exact.amplitude;
  CHECK(found.place.lowest == Approx(lowest).epsilon(1e-6));
  CHECK(summary.text().find(
            "  stick-slip at 1.239 Hz (period 0.8069 s over 13 cycles, t = 0.8 .. 11.29 s), "
            "amplitude 0.0112 mm, force -4.0 .. -2.0 N, slips 50 % of a cycle\n") !=
        std::string::npos);
  const std::string json = summary.to_json().dump();
  CHECK(json.find("\"frequency_unit\": \"Hz\"") != std::string::npos);
  CHECK(json.find("\"amplitude_unit\": \"mm\"") != std::string::npos);
}

TEST_CASE("a few rows a cycle find the same frequency, and nearly the amplitude") {
  const cases::Case of_many_rows = belt_case(3000);
  const cases::Case of_few_rows = belt_case(300);
  const Summary fine = summary_of(of_many_rows);
  const Summary coarse = summary_of(of_few_rows);
  CHECK(coarse.definitions()[0].stick_slip.frequency() ==
        Approx(fine.definitions()[0].stick_slip.frequency()).epsilon(1e-10));
  CHECK(coarse.definitions()[0].stick_slip.place.highest ==
        Approx(fine.definitions()[0].stick_slip.place.highest).epsilon(1e-4));
}

TEST_CASE("a vibration whose period changes tells the range of it") {
  // A heavier load lets it stick longer.
  cases::Case problem = belt_case(3000);
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{1};
  problem.steps[0].drives = {{cases::kFirstForce + 1, history::Tabular{{0.0, 12.0}, {10.0, 20.0}}}};
  const std::string text = summary_of(problem).text();
  CHECK(text.find("stick-slip at ") != std::string::npos);
  CHECK(text.find(" (period 0.8") != std::string::npos);
  CHECK(text.find(" .. 1.") != std::string::npos);
}

TEST_CASE("a loop that is driven to and fro is no vibration") {
  const cases::Case problem = bench::slider_case({bench::step(
      "cycle", 400, 0, history::Wave{history::WaveShape::kTriangle, 0.1, 0.1, 0.0, 0.0})});
  const Summary summary = summary_of(problem);
  REQUIRE(summary.definitions()[0].events > 10);
  CHECK(summary.definitions()[0].stick_slip.cycles == 0);
  CHECK(summary.text().find("stick-slip at") == std::string::npos);
  CHECK(summary.to_json().dump().find("\"stick_slip\"") == std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::results
