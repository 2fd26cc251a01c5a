// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/solver_report.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "driver/bench/connector_increment.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::analysis {
namespace {

std::string report_of(const cases::Case& problem) {
  SolverReport report(problem, nullptr);
  auto simulation = bench::Simulation::start(problem);
  REQUIRE(simulation);
  do {
    report.add(*simulation);
  } while (simulation->advance().value());
  return report.text();
}

SolverDemand last_demand(const cases::Case& problem) {
  const std::vector<bench::Row> rows = bench::rows_of(problem);
  return solver_demand(problem.definitions[0].law, bench::connector_increment(problem, rows.back()),
                       rows.back().definitions[0].update, problem.kinetic);
}

bool contains(const std::string& text, const std::string& part) {
  INFO(text);
  return text.find(part) != std::string::npos;
}

TEST_CASE("a press fit at a constant limit leaves a symmetric tangent") {
  const std::string text =
      report_of(bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1})}));
  CHECK(contains(text,
                 "tangent to the motion symmetric\n    one answer for any increment\n    an "
                 "implicit solver needs no unsymmetric scheme\n"));
}

TEST_CASE("a contact force over constraint forces couples by the coefficient") {
  cases::Case problem = bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1})});
  problem.definitions[0].law.contact_force = law::DerivedComponent{law::norm_term({2, 3}, 1.0)};
  problem.steps[0].drives.push_back({cases::kFirstForce + 1, history::Constant{50.0}});
  problem.definitions[0].law.law = law::ConstantCoefficient{0.25};
  // In slip dF_lim/dF_C = mu.
  CHECK(last_demand(problem).force_coupling == Approx(0.25).epsilon(1e-14));
  CHECK(contains(report_of(problem),
                 "will want its unsymmetric scheme: the contact force follows "
                 "the constraint forces 0.25"));
  problem.definitions[0].law.law = law::ConstantCoefficient{0.1};
  CHECK(contains(report_of(problem), "can do without its unsymmetric scheme"));
}

TEST_CASE("a rate of the motion that turns against the force makes the tangent unsymmetric") {
  // Two directions, right angle: the force points along the first, the motion along the second.
  cases::Case problem =
      bench::slider_case({bench::step("out", 10, 0, history::LinearTo{1.0}),
                          bench::step("turn", 1, 1, history::LinearTo{0.05}, 0.05)});
  problem.connection = law::find_connection("CARTESIAN").value();
  problem.definitions[0].coupled = true;
  problem.definitions[0].law.slip = law::slip_space({1, 2});
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.1, 0.5};
  problem.definitions[0].law.slip_rate = law::SlipRateMeasure::kRelativeMotion;
  const SolverDemand demand = last_demand(problem);
  // rate n m^T alone has the asymmetry |t_r| sqrt(2) |sin(n, m)|.
  const auto update = bench::rows_of(problem).back().definitions[0].update;
  const double sine = update.direction[0] * update.motion_direction[1] -
                      update.direction[1] * update.motion_direction[0];
  CHECK(demand.by_rate == Approx(std::abs(update.tangent.rate * sine) / 1000.0).epsilon(1e-12));
  CHECK(demand.by_rate > 1e-3);
  CHECK(demand.by_position == 0.0);
  CHECK(demand.asymmetry > 0.0);
}

TEST_CASE("the snap-back number is that of the wear at the state reached (W1)") {
  cases::Case problem = bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1})});
  law::Table table;
  law::TableError error;
  const std::vector<std::vector<double>> rows = {{100, 0.0}, {0, 0.2}};
  REQUIRE(law::Table::build(rows, 1, 1, law::Extrapolation::kConstant, &table, &error));
  problem.definitions[0].law.internal_contact_force =
      law::TableFunction(table, {{law::IndependentKind::kAccumulatedSlip}});
  // mu c / k = 0.2 500 / 1000.
  CHECK(last_demand(problem).snap_back == Approx(0.1).epsilon(1e-14));
  CHECK(contains(report_of(problem), "snap-back number mu|F'|/k up to 0.1"));
}

TEST_CASE("springs that press stay the measure where next to nothing does") {
  // The spring of component 2 swings back to where it presses with rounding alone.
  const cases::Case problem = read::sound(
      "slipbench: 1\nconnector: {type: CARTESIAN}\n"
      "friction: [{component: 1, contact_force: 2, coefficient: 0.3, stick: {elastic_slip: "
      "1e-3}}]\n"
      "elasticity: [{component: 2, stiffness: 400}]\n"
      "history: [{step: a, increments: 8, motion: {CP1: {to: 1}, CP2: '= 0.2*sin(2*pi*t)'}}]\n");
  const SolverDemand demand = last_demand(problem);
  // mu K and its transpose over K.
  CHECK(demand.by_position == Approx(0.3 * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("the report names the increment that makes the answer unique") {
  cases::Case problem =
      bench::slider_case({bench::step("out", 100, 0, history::LinearTo{1.0}, 0.01)});
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  // N max|mu'| / k = 100 x 0.1 x 0.05 / 1000 s; the increments are 1e-4 s.
  CHECK(
      contains(report_of(problem),
               "increments longer than 0.0005 s have one answer; the shortest is 0.0001 s, 100 of "
               "100 are below their bound"));
}

}  // namespace
}  // namespace slipbench::driver::analysis
