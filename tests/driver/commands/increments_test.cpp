// SPDX-License-Identifier: Apache-2.0
// What the commands say about the size of increments.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "driver/analysis/compare_integration.hpp"
#include "driver/analysis/converge.hpp"
#include "driver/base/files/exit_code.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Around a corner in SLIDE-PLANE.
cases::Case corner_case(int increments) {
  cases::Case problem =
      bench::slider_case({bench::step("first leg", 1, 1, history::LinearTo{0.05}),
                          bench::step("second leg", increments, 2, history::LinearTo{0.05})});
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions[0].law.slip = law::slip_space({2, 3});
  problem.definitions[0].coupled = true;
  return problem;
}

/// Pulled at 1 mm/s on a coefficient that falls with the rate (reference case K3).
cases::Case falling_case(int increments) {
  cases::Case problem =
      bench::slider_case({bench::step("pull", increments, 0, history::LinearTo{0.1}, 0.1)});
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  return problem;
}

TEST_CASE("one dimension at a constant limit is the same by both methods, and converged") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 7, 0, history::LinearTo{0.1}),
                          bench::step("back", 7, 0, history::LinearTo{-0.1})});
  const auto text = analysis::compare_integration(problem);
  REQUIRE(text);
  CHECK(has(*text, "slider: backward_euler against exact, 14 increments\n"));
  CHECK(has(*text, "force       the same to rounding; the largest is 20\n"));
  const auto verdict = analysis::converge(problem);
  REQUIRE(verdict);
  CHECK(has(*verdict, "slider: 14, 28 and 56 increments\n"));
  CHECK(has(*verdict, "converged: smaller increments change nothing"));
}

TEST_CASE("around a corner backward Euler is off by first order, and told so") {
  const auto text = analysis::compare_integration(corner_case(100));
  REQUIRE(text);
  CHECK(has(*text, "apart at most"));
  CHECK(has(*text, "step 'second leg'"));
  const auto verdict = analysis::converge(corner_case(100));
  REQUIRE(verdict);
  CHECK(has(*verdict, "first order: half the increment, half the error"));
}

TEST_CASE("exact integration of the corner is converged with one increment") {
  cases::Case problem = corner_case(1);
  problem.integration.method = cases::IntegrationMethod::kExact;
  const auto verdict = analysis::converge(problem);
  REQUIRE(verdict);
  CHECK(has(*verdict, "converged: smaller increments change nothing"));
}

TEST_CASE("a saw-tooth does not converge, and the increment that decides is named") {
  const auto verdict = analysis::converge(falling_case(1000));
  REQUIRE(verdict);
  CHECK(has(*verdict, "not converging"));
  CHECK(has(*verdict, "increments below 0.0009512 turn its smooth answer into a saw-tooth"));
  const auto text = analysis::compare_integration(falling_case(1000));
  REQUIRE_FALSE(text);
  CHECK(text.error().code == base::kExitBadInput);
  CHECK(has(text.error().message, "falls with the rate of the slip"));
}

TEST_CASE("what a quarter of the increment does not change has settled at half of it") {
  // One increment sees nothing of a motion out and back, two see all of it.
  const cases::Case problem = read::sound(
      "slipbench: 1\nconnector: {type: SLOT}\n"
      "friction: [{component: 1, internal_contact_force: 100, coefficient: 0.2, stick: {stiffness: "
      "1000}}]\n"
      "history: [{step: out and back, increments: 1, motion: {CP1: '= 1 - abs(1 - 2*t)'}}]\n");
  const auto verdict = analysis::converge(problem);
  REQUIRE(verdict);
  INFO(*verdict);
  CHECK(has(*verdict, "converged at half the increment: a quarter changes nothing more"));
  CHECK_FALSE(has(*verdict, "second order"));
}

TEST_CASE("the order is judged from two differences") {
  CHECK(analysis::judge({1e-12, 1e-12, 1.0}) == analysis::ConvergenceVerdict::kSettled);
  CHECK(analysis::judge({0.4, 0.0, 1.0}) == analysis::ConvergenceVerdict::kSettles);
  CHECK(analysis::judge({0.4, 0.1, 1.0}) == analysis::ConvergenceVerdict::kSecondOrder);
  CHECK(analysis::judge({0.2, 0.1, 1.0}) == analysis::ConvergenceVerdict::kFirstOrder);
  CHECK(analysis::judge({0.2, 0.14, 1.0}) == analysis::ConvergenceVerdict::kSlow);
  CHECK(analysis::judge({0.2, 0.2, 1.0}) == analysis::ConvergenceVerdict::kNone);
  CHECK(analysis::judge({0.1, 0.3, 1.0}) == analysis::ConvergenceVerdict::kNone);
  // a = 1.2, b = 1.1, c = 1.05: the limit is 1.
  CHECK(analysis::Convergence{0.1, 0.05, 1.0}.error() == Approx(0.2));
  CHECK(std::isnan(analysis::Convergence{0.1, 0.1, 1.0}.error()));
}

}  // namespace
}  // namespace slipbench::driver::commands
