// SPDX-License-Identifier: Apache-2.0
#include "driver/results/plausibility.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"
#include "tests/support/law_tables.hpp"

namespace slipbench::driver::results {
namespace {

std::vector<std::string> findings_of(const cases::Case& problem) {
  Plausibility plausibility(problem);
  for (const bench::Row& row : bench::rows_of(problem)) plausibility.add(row);
  return plausibility.findings();
}

/// A slider pressed by its constraint force f3 alone.
cases::Case pressed_slider(std::vector<cases::Step> steps) {
  cases::Case problem = bench::slider_case(std::move(steps));
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{2};
  return problem;
}

TEST_CASE("a contact force that is never driven was told when the case was read") {
  cases::Case problem = pressed_slider({bench::step("out", 3, 0, history::LinearTo{6.0})});
  problem.steps[0].drives.push_back({cases::kFirstForce + 1, history::Constant{100.0}});
  CHECK(findings_of(problem).empty());
}

TEST_CASE("a contact force that is driven, and stays 0, is told apart") {
  cases::Case problem = pressed_slider({bench::step("out", 3, 0, history::LinearTo{6.0})});
  problem.steps[0].drives.push_back({cases::kFirstForce + 2, history::Constant{0.0}});
  CHECK(findings_of(problem) ==
        std::vector<std::string>{
            "friction 'sleeve': nothing ever presses: its contact force is 0 all along, and so is "
            "its friction; look at the size and the sign of f3 in the history"});
}

TEST_CASE("a definition with nothing that could press says what it lacks") {
  cases::Case problem = bench::slider_case({bench::step("out", 3, 0, history::LinearTo{6.0})});
  problem.definitions[0].law.internal_contact_force = 0.0;
  CHECK(findings_of(problem) ==
        std::vector<std::string>{
            "friction 'sleeve': nothing ever presses: its contact force is 0 all along, and so is "
            "its friction; it has no 'contact_force' that could be driven, and no "
            "'internal_contact_force'"});
}

TEST_CASE(
    "an internal contact force that is 0 in every row is told, unless it presses in between") {
  // 0, and what it rises to, over the position of component 1 on its way from 0 to 6.
  for (const double middle : {0.0, 100.0}) {
    cases::Case problem = bench::slider_case({bench::step("out", 1, 0, history::LinearTo{6.0})});
    problem.integration.method = cases::IntegrationMethod::kExact;
    problem.definitions[0].law.internal_contact_force =
        test::make_function({{0.0, 0.0}, {middle, 3.0}, {0.0, 6.0}}, {test::over_position(1)});
    const std::vector<std::string> findings = findings_of(problem);
    if (middle > 0.0) {
      CHECK(findings.empty());
    } else {
      CHECK(findings == std::vector<std::string>{
                            "friction 'sleeve': nothing ever presses: its contact force is 0 all "
                            "along, and so is its friction; look at its 'internal_contact_force'"});
    }
  }
}

TEST_CASE("a contact that is lost for a while is nobody's mistake") {
  cases::Case problem = pressed_slider({bench::step("out", 30, 0, history::LinearTo{6.0})});
  problem.steps[0].drives.push_back(
      {cases::kFirstForce + 2, history::Tabular{{0.0, 0.4, 0.5, 1.0}, {100.0, 100.0, 0.0, 0.0}}});
  CHECK(findings_of(problem).empty());
}

TEST_CASE("a case in which nothing moves says what would") {
  const cases::Case still = bench::slider_case({bench::step("rest", 3, 0, history::LinearTo{0.0})});
  CHECK(findings_of(still) ==
        std::vector<std::string>{
            "history: nothing moves: CP1 never changes, so nothing can slip; a step "
            "moves it, for example 'motion: {CP1: {to: 1}}'"});
}

TEST_CASE("a motion within the elastic slip measures the stick spring") {
  cases::Case problem = bench::slider_case({bench::step("out", 3, 0, history::LinearTo{0.005}),
                                            bench::step("back", 3, 0, history::LinearTo{-0.005})});
  CHECK(findings_of(problem) ==
        std::vector<std::string>{
            "friction 'sleeve': its motion, 0.01 mm in all, is less than the elastic slip that "
            "comes before any slip, 0.02 mm: it never slips, and its force is that of the stick "
            "spring; move farther, or raise the 'stiffness' under 'stick'"});
  problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip, 0.5};
  CHECK(findings_of(problem) ==
        std::vector<std::string>{
            "friction 'sleeve': its motion, 0.01 mm in all, is less than the elastic slip that "
            "comes before any slip, 0.5 mm: it never slips, and its force is that of the stick "
            "spring; move farther, or take a smaller elastic slip under 'stick'"});
  // What the advice says helps.
  problem.definitions[0].law.stick.value = 1e-4;
  CHECK(findings_of(problem).empty());
}

TEST_CASE("a load below the limit is no motion within the elastic slip") {
  cases::Case problem = bench::slider_case(
      {bench::step("press", 10, cases::kFirstForce + 0, history::LinearTo{10.0})});
  problem.force_driven.insert(0);
  CHECK(findings_of(problem).empty());
}

/// Slip while the contact force falls from 100 to 10 N.
cases::Case falling_force(int increments) {
  cases::Case problem = pressed_slider({bench::step("out", increments, 0, history::LinearTo{6.0})});
  problem.steps[0].drives.push_back(
      {cases::kFirstForce + 2, history::Tabular{{0.0, 1.0}, {100.0, 10.0}}});
  return problem;
}

TEST_CASE("an energy balance that is open by more than 1 % is told, with what closes it") {
  CHECK(findings_of(falling_force(10)) ==
        std::vector<std::string>{
            "friction 'sleeve': the energy balance is open by 7.5 % (work 65.3 mJ, dissipated 60.4 "
            "mJ, stored 2.0 uJ): too much changes within an increment; take more 'increments', as "
            "many as it needs for this to go below 1 % ('run --converge' tells what they change)"});
  // What the advice says helps.
  CHECK(findings_of(falling_force(100)).empty());
}

TEST_CASE("a stick stiffness that follows the limit opens the balance, whatever the increments") {
  const auto stuck = [](int increments) {
    // 0.5 of the elastic slip, then pressed twice as hard.
    cases::Case problem = pressed_slider(
        {bench::step("out", increments, 0, history::LinearTo{0.05}),
         bench::step("press", increments, cases::kFirstForce + 2, history::LinearTo{200.0}),
         bench::step("on", increments, 0, history::LinearTo{0.15})});
    problem.steps[0].drives.push_back({cases::kFirstForce + 2, history::Constant{100.0}});
    problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip, 0.1};
    return problem;
  };
  const std::string told =
      "friction 'sleeve': the energy balance is open by 6.7 % (work 3.75 mJ, dissipated 2.0 mJ, "
      "stored 2.0 mJ): the stick stiffness changes while its spring is stretched, which no work of "
      "the friction pays for; a constant 'stick: {stiffness: ..}' and longer motions make it less";
  CHECK(findings_of(stuck(10)) == std::vector<std::string>{told});
  CHECK(findings_of(stuck(1000)) == std::vector<std::string>{told});
  cases::Case constant = stuck(1000);
  constant.definitions[0].law.stick = {law::StickStiffness::Mode::kStiffness, 200.0};
  CHECK(findings_of(constant).empty());
}

}  // namespace
}  // namespace slipbench::driver::results
