// SPDX-License-Identifier: Apache-2.0
// change_friction as it is written: what it means, and what it must not say.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

/// The sound case with a second step that changes friction, and what it changes.
std::string with_change(const std::string& change, const std::vector<Change>& changes = {}) {
  std::vector<Change> all = changes;
  all.emplace_back("checks:", "  - step: go on\n    increments: 5\n    change_friction: " + change +
                                  "\nchecks:");
  return changed(all);
}

const std::vector<cases::FrictionChange>& changes_of(const cases::Case& problem) {
  return problem.steps.at(1).friction_changes;
}

double constant(const law::FrictionLaw& law) { return std::get<law::ConstantCoefficient>(law).mu; }

TEST_CASE("a change of friction keeps what it does not mention") {
  const cases::Case problem = sound(with_change("{sleeve: {coefficient: = 2*mu}}",
                                                {{"stick: {", "force_limit: 70\n    stick: {"}}));
  REQUIRE(changes_of(problem).size() == 1);
  const cases::FrictionChange& change = changes_of(problem)[0];
  CHECK(change.definition == 0);
  CHECK(constant(change.law) == 0.3);
  CHECK(std::get<history::LinearTo>(change.amplitude).value == 1.0);
  CHECK(change.force_limit == 70.0);
  CHECK(change.stick.value == 1e-4);
  CHECK(change.blends_elastic_slip);
  CHECK(problem.steps[0].friction_changes.empty());
}

TEST_CASE("amplitudes are linear, smooth or a table of weights") {
  const auto amplitude = [](const std::string& text) {
    return changes_of(
               sound(with_change("{sleeve: {coefficient: 0.1, amplitude: " + text + "}}")))[0]
        .amplitude;
  };
  CHECK(std::holds_alternative<history::LinearTo>(amplitude("linear")));
  CHECK(std::holds_alternative<history::SmoothTo>(amplitude("smooth")));
  const history::Profile table =
      amplitude("{columns: [weight, t], rows: [[0, 0], [0.5, 0.2], [0.5, 0.4], [1, 1]]}");
  CHECK(std::get<history::Tabular>(table).times == std::vector{0.0, 0.2, 0.4, 1.0});
  CHECK(std::get<history::Tabular>(table).values == std::vector{0.0, 0.5, 0.5, 1.0});
}

TEST_CASE("a later change knows the earlier ones, and reset goes back to the case's own") {
  const cases::Case problem = sound(changed(
      {{"checks:",
        "  - {step: one, increments: 5, change_friction: {sleeve: {coefficient: 0.1, force_limit: "
        "9, stick: {elastic_slip: 0.5}}}}\n"
        "  - {step: two, increments: 5, change_friction: {sleeve: {coefficient: 0.2}}}\n"
        "  - {step: three, increments: 5, change_friction: {sleeve: {reset: true}}}\n"
        "checks:"}}));
  const cases::FrictionChange& second = problem.steps[2].friction_changes.at(0);
  CHECK(second.force_limit == 9.0);
  CHECK(second.stick.value == 0.5);
  const cases::FrictionChange& third = problem.steps[3].friction_changes.at(0);
  CHECK(constant(third.law) == 0.15);
  CHECK(third.force_limit == law::kNoForceLimit);
  CHECK(third.stick.value == 1e-4);
}

TEST_CASE("the elastic slip switches in the first step and towards the exponential law") {
  const cases::Case first =
      sound(changed({{"increments: 10",
                      "increments: 10\n    change_friction: {sleeve: {coefficient: "
                      "0.1, stick: {elastic_slip: 0.5}}}"}}));
  CHECK_FALSE(first.steps[0].friction_changes.at(0).blends_elastic_slip);
  const cases::Case exponential = sound(with_change(
      "{sleeve: {coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 1}}}}"));
  CHECK_FALSE(changes_of(exponential)[0].blends_elastic_slip);
}

TEST_CASE("the name of a predefined definition with two checks changes both") {
  const std::string puck =
      "slipbench: 1\nconnector: {type: PLANAR}\nfriction:\n  - {NAMEpredefined: {R: 0.5, "
      "internal_contact_force: 1}, coefficient: 0.2, stick: {slip_tolerance: 1e-3}}\nhistory:\n  - "
      "{step: go, increments: 2, change_friction: {WHOM: {coefficient: 0.1}}}\n";
  const auto changes = [&](const std::string& name, const std::string& whom) {
    const cases::Case problem = sound(changed({{"NAME", name}, {"WHOM", whom}}, puck));
    std::vector<std::size_t> meant;
    for (const cases::FrictionChange& change : problem.steps[0].friction_changes) {
      meant.push_back(change.definition);
    }
    return meant;
  };
  using Meant = std::vector<std::size_t>;
  CHECK(changes("name: a, ", "a") == Meant{0, 1});
  CHECK(changes("name: a, ", "a.spinning") == Meant{1});
  CHECK(changes("", "sliding") == Meant{0});
  CHECK(changes("", "friction1") == Meant{0, 1});
}

TEST_CASE("a definition is changed once in a step") {
  const auto found = messages(
      "slipbench: 1\nconnector: {type: PLANAR}\nfriction:\n  - {name: a, predefined: {R: 0.5, "
      "internal_contact_force: 1}, coefficient: 0.2, stick: {slip_tolerance: 1e-3}}\nhistory:\n  - "
      "{step: go, increments: 2, change_friction: {a: {coefficient: 0.1}, a.sliding: {reset: "
      "true}}}\n");
  REQUIRE(found.size() == 2);  // the other is the note on the length of the stick stiffness
  CHECK(
      found[1] ==
      "6:72: error: history[0].change_friction.'a.sliding': the friction of 'a.sliding' is changed "
      "twice in this step, also by 'a'");
}

TEST_CASE("a reset of what nothing has changed is pointed out") {
  const auto found = messages(with_change("{sleeve: {reset: true}}"));
  REQUIRE(found.size() == 1);
  CHECK(
      found[0] ==
      "25:39: warning: history[1].change_friction.sleeve.reset: nothing to reset: no earlier step "
      "changes the friction of 'sleeve'");
}

TEST_CASE("faults of the friction do not make its names unknown") {
  const auto found =
      messages(with_change("{other: {coefficient: 0.1}}", {{"name: sleeve", "name: 7up"}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("friction[0].name") != std::string::npos);
}

TEST_CASE("test data of the exponential decay are in force as what they stand for") {
  const ReadCase read = read_text(changed(
      {{"coefficient: = mu",
        "coefficient: {exponential_test_data: {mu1: 0.3, mu2: 0.23, rate2: 20, mu_inf: 0.2}}"}}));
  REQUIRE(read.value);
  const auto& decay = std::get<law::ExponentialDecay>(read.value->definitions[0].law.law);
  CHECK(decay.kinetic == 0.2);
  CHECK(decay.decay == Approx(0.0601986402162968).epsilon(1e-14));
  const auto notes = read.diagnostics.sorted();
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].severity == base::Severity::kNote);
  CHECK(notes[0].message ==
        "stands for exponential_decay: static 0.3, kinetic 0.2, decay 0.0601986");
}

TEST_CASE("test data must fall, and fit no force limit") {
  const auto fault = [](const std::string& data, const std::string& more = "") {
    const auto found = messages(changed(
        {{"coefficient: = mu", "coefficient: {exponential_test_data: {" + data + "}}" + more}}));
    REQUIRE_FALSE(found.empty());
    return found.back();
  };
  CHECK(fault("mu1: 0.2, mu2: 0.3, rate2: 1") ==
        "16:42: error: friction[0].coefficient.exponential_test_data: wanted mu1 > mu2 > mu_inf >= "
        "0: 'mu1' is not above 'mu2' (found mu1 0.2, mu2 0.3, rate2 1)");
  CHECK(fault("mu1: 0.3, mu2: 0.2, rate2: 0").find("rate2: must be greater than 0, found 0") !=
        std::string::npos);
  CHECK(fault("mu1: 0.3, mu2: 0.2, rate2: 1", "\n    force_limit: 3") ==
        "17:18: error: friction[0].force_limit: exponential decay takes no force limit");
}

TEST_CASE("resets bring back so many rows of tables, each a copy, as the memory has room for") {
  std::string table = "coefficient: {columns: [mu, slip_rate], rows: [";
  for (int i = 0; i < 40000; ++i) table += "[0.1, " + std::to_string(i) + "], ";
  std::string steps;
  for (int i = 0; i < 60; ++i) {
    steps += "  - {step: s" + std::to_string(i) +
             ", increments: 1, change_friction: {sleeve: {reset: true}}}\n";
  }
  std::vector<std::string> errors =
      messages(changed({{"coefficient: = mu", table + "]}"}, {"checks:", steps + "checks:"}}));
  std::erase_if(errors, [](const std::string& message) {
    return message.find(": error: ") == std::string::npos;
  });
  REQUIRE(errors.size() == 1);
  CHECK_THAT(errors[0], Catch::Contains("history[51].change_friction.sleeve.reset: with this the "
                                        "resets of the case bring back more than 2000000 rows of "
                                        "tables; let fewer steps reset"));
}

}  // namespace
}  // namespace slipbench::driver::read
