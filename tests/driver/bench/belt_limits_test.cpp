// SPDX-License-Identifier: Apache-2.0
// Belts of several rings, with damping and stops: what is refused or told, and runs that are cut.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/results/columns.hpp"
#include "driver/results/summary.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::bench {
namespace {

std::string belt(const std::string& connector, const std::string& more,
                 const std::string& history) {
  return "slipbench: 1\nconnector: {type: SLIPRING, " + connector +
         "}\nfriction:\n  - {predefined: {}, coefficient: 0.2, stick: {elastic_slip: 0.01}}\n" +
         more + "history:\n  - {step: s, increments: 4, " + history + "}\n";
}

/// The one message of a case, from the key on.
std::string message(const std::string& text) {
  const auto all = read::messages(text);
  INFO(text);
  REQUIRE(all.size() == 1);
  return all[0].substr(all[0].find(": ") + 2);
}

std::string end_of(const cases::Case& problem, std::vector<std::string>* warnings = nullptr) {
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  results::Summary summary(problem);
  summary.add(simulation->row());
  while (true) {
    const auto more = simulation->advance();
    if (!more) return more.error().message;
    if (!*more) break;
    summary.add(simulation->row());
  }
  if (warnings != nullptr) *warnings = summary.warnings(simulation->jumps());
  return "";
}

const std::string kPull = "force: {f1: 50}, motion: {CP2: {to: 1}}";

TEST_CASE("what cannot stand together in a belt is said with its reason") {
  const std::string nodes = "nodes: {a: [-3, 0, 0], b: [0, 0, 0], c: [0, 2, 0]}";
  CHECK(message(belt(nodes + ", wrap_angle: 7, half_turns: 2", "", kPull)) ==
        "error: connector.half_turns: give 'wrap_angle', which then stays, or 'half_turns', from "
        "which the angle follows the nodes");
  CHECK(message(belt("wrap_angle: 7, half_turns: 2", "", kPull)) ==
        "error: connector.half_turns: without 'nodes' there is no angle to add half turns to; "
        "'wrap_angle' may be of any size");
  CHECK(message(belt("wrap_angle: [1, 2], initial: {CP1: 9}, lengths: [3]", "", kPull)) ==
        "error: connector.lengths: wanted the length of the segment behind each ring (2), found 1; "
        "the segment between a and b is 'initial: {CP1: ..}'");
  CHECK(message(belt("wrap_angle: [1, 2], lengths: [3, 4]", "", kPull)) ==
        "error: connector.lengths: the length of the segment before the first ring is not known; "
        "give 'initial: {CP1: ...}', the distance of a and b");
  CHECK_THAT(message(belt(nodes + ", lengths: [3]", "", kPull)),
             Catch::Contains("'lengths' and 'nodes' say two things"));
  CHECK_THAT(message(belt("wrap_angle: 1, initial: {CP1: 9}",
                          "damping: [{component: 1, coefficient: 5}]\n", kPull)),
             Catch::Contains("the damping of a belt acts beside its elasticity, and this belt has "
                             "none"));
  CHECK_THAT(message(belt("wrap_angle: 1, initial: {CP1: 9}", "stops: [{component: 2, lower: 1}]\n",
                          kPull)),
             Catch::Contains("the stops of a SLIPRING bound the distance of its nodes a and b"));
  CHECK_THAT(message(belt("wrap_angle: 1", "stops: [{component: 1, lower: 1}]\n", kPull)),
             Catch::Contains("the distance of the nodes is not known, which the stop bounds"));
}

TEST_CASE("a chain takes one definition for all rings or one for each, and no other number") {
  const std::string third =
      "  - {predefined: {}, coefficient: 0.1, stick: {elastic_slip: 0.01}}\n"
      "  - {predefined: {}, coefficient: 0.1, stick: {elastic_slip: 0.01}}\n";
  CHECK(
      message(belt("wrap_angle: [1, 2]", third, kPull)) ==
      "error: friction: a belt over 2 rings has one definition, which all rings share, or one for "
      "each; found 3; 'wrap_angle' lists the angle of each ring: [= pi/2, = pi/3]");
  const cases::Case three = read::sound(belt("wrap_angle: [1, 2, 3]", third, kPull));
  REQUIRE(three.definitions.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(three.definitions[i].name == "ring" + std::to_string(i + 1));
    CHECK(std::get<law::Capstan>(three.definitions[i].law.criterion).wrap_angle == 1.0 + double(i));
  }
}

TEST_CASE("a tension that is written and faulty is not told as missing") {
  CHECK(message(belt("wrap_angle: 1", "", "motion: {CP2: {to: 1}}, force: {f1: '= 20*CP2'}"))
            .find("only forces can follow a position such as CP2") != std::string::npos);
}

TEST_CASE("a distance beyond a stop, or below a hundredth of the first, ends the run") {
  CHECK(end_of(read::sound(belt("wrap_angle: 1.5, initial: {CP1: 100}",
                                "stops: [{component: 1, lower: 50}]\n",
                                "force: {f1: 50}, motion: {CP1: {to: 20}}"))) ==
        "step 's', t = 0.75 (total time 0.75): CP1 = 40 is beyond the lower stop of component 1 at "
        "50");
  const std::string to = "force: {f1: 50}, motion: {CP1: {to: 0.1}}";
  const std::string down = belt("wrap_angle: 1.5, initial: {CP1: 100}", "", to);
  CHECK(message(down) ==
        "warning: history[0].motion.CP1: CP1 goes down to 0.1 in step 's': below 1, a hundredth of "
        "the initial distance, a belt locks");
  CHECK(end_of(read::sound(down)) ==
        "step 's', t = 1 (total time 1): the distance CP1 = 0.1 of the nodes is below 1, a "
        "hundredth of the initial one: the belt locks there, and nothing says with what force");
  std::vector<std::string> warnings;
  CHECK(end_of(read::sound(belt("wrap_angle: 1.5, initial: {CP1: 100}", "",
                                "force: {f1: 50}, motion: {CP1: \"= 100 - 98.5*t\"}")),
               &warnings)
            .empty());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] ==
        "the distance CP1 came down to 1.5 at t = 1.0, near 1.0, a hundredth of the initial one, "
        "where "
        "a belt locks");
}

TEST_CASE("a tension below 0 is told of once") {
  std::vector<std::string> warnings;
  CHECK(end_of(read::sound(
                   belt("wrap_angle: 1.5, initial: {CP1: 100}", "",
                        "force: {f1: {columns: [value, t], rows: [[50, 0], [-50, 1]]}}, motion: "
                        "{CP2: {to: 1}}")),
               &warnings)
            .empty());
  REQUIRE(warnings.size() == 1);
  CHECK(
      warnings[0] ==
      "the tension f1 is below 0 in 2 of 4 increments, down to -50.0 at t = 1.0: a belt pulls, it "
      "does not push; it is slack there, and CTF1, CSF2 and f_bc are 0");
}

TEST_CASE("an elastic belt that is never tight is told by its strain") {
  std::vector<std::string> warnings;
  CHECK(end_of(read::sound(belt("wrap_angle: 1, initial: {CP1: 100}, initial_strain: -0.1",
                                "elasticity: [{component: 1, stiffness: 500}]\n",
                                "motion: {CP2: {to: 1}}")),
               &warnings)
            .empty());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("look at the size and the sign of the strain CU1 in the history") !=
        std::string::npos);
}

TEST_CASE("the force of a belt is the difference of its tensions, prescribed slack too") {
  const cases::Case problem =
      read::sound(belt("wrap_angle: 1.5", "", "force: {f1: {to: -50}, f_bc: 30}"));
  const auto columns = results::result_columns(problem);
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (simulation->advance().value()) {
    const auto value = [&](const char* name) {
      return results::column_value(*results::find_column(problem, columns, name), problem,
                                   simulation->row());
    };
    CHECK(value("CTF1") == 0.0);
    CHECK(value("f_bc") == 30.0);
    CHECK(value("CSF2") == 30.0);
    CHECK(value("STATUS") == 2.0);
  }
}

TEST_CASE("a chain of known lengths that is cut goes on as if it had not been") {
  const cases::Case problem = read::sound(
      belt("wrap_angle: [1, 2], initial: {CP1: 9}, initial_strain: 0.01, lengths: [3, 4]",
           "elasticity: [{component: 1, stiffness: 100}]\n"
           "damping: [{component: 1, coefficient: 5}]\n",
           "motion: {CP1: {to: 9.1}, CP2: {to: 0.2}, CP3: {to: 0.1}}"));
  const auto columns = results::result_columns(problem);
  std::vector<std::vector<double>> whole;
  const auto values = [&](const Row& row) {
    std::vector<double> all;
    for (const results::Column& column : columns)
      all.push_back(results::column_value(column, problem, row));
    return all;
  };
  auto first = Simulation::start(problem);
  REQUIRE(first);
  std::vector<SimulationState> states{first->state()};
  while (first->advance().value()) {
    whole.push_back(values(first->row()));
    states.push_back(first->state());
  }
  for (std::size_t cut = 0; cut + 1 < states.size(); ++cut) {
    auto second = Simulation::resume(problem, states[cut]);
    REQUIRE(second);
    for (std::size_t i = cut; i < whole.size(); ++i) {
      REQUIRE(second->advance().value());
      CHECK(values(second->row()) == whole[i]);
    }
  }
}

TEST_CASE("a segment behind a ring whose elasticity ends below its tension ends the run") {
  const cases::Case problem = read::sound(
      belt("wrap_angle: 3, initial: {CP1: 9}, initial_strain: 0.01, lengths: [3]",
           "elasticity:\n  - {component: 1, columns: [force, displacement], rows: [[0, 0], [10, "
           "0.01], [12, 0.1]]}\n",
           "motion: {CP2: {to: 1}, CP3: {to: 1}}"));
  CHECK_THAT(end_of(problem),
             Catch::Contains("the elasticity of the belt never reaches the tension "
                             "18.2") &&
                 Catch::Contains("behind ring 1"));
}

TEST_CASE("keywords of connectors that the bench has not are refused by name, with the reason") {
  const std::vector<std::pair<std::string, std::string>> keywords = {
      {"plasticity", "a connector of this bench has no plasticity"},
      {"damage", "a connector of this bench has no damage"},
      {"failure", "a connector of this bench does not fail"},
      {"lock", "a connector of this bench does not lock for good"},
      {"uniaxial_behavior", "a connector of this bench has no uniaxial behavior"}};
  for (const auto& [key, why] : keywords) {
    const std::string text = read::changed({{"history:", key + ": []\nhistory:"}});
    CHECK_THAT(message(text), Catch::StartsWith("error: " + key + ": " + why));
  }
  CHECK_THAT(
      message(read::changed({{"type: CYLINDRICAL", "type: RETRACTOR"}})),
      Catch::StartsWith("error: connector.type: a RETRACTOR is JOIN + FLOW-CONVERTER: node b "
                        "sits on a"));
}

TEST_CASE("the flags of stops are numbered from 1 to 6") {
  const cases::Case problem =
      read::sound(read::changed({{"history:",
                                  "stops: [{component: 1, upper: 9}, {component: 4, upper: 9}]\n"
                                  "history:"}}));
  const auto columns = results::result_columns(problem);
  CHECK(results::find_column(problem, columns, "CSLST1"));
  CHECK(results::find_column(problem, columns, "CSLST4"));
  CHECK_FALSE(results::find_column(problem, columns, "CSLSTR1"));
}

TEST_CASE("exact integration of a damped belt is refused with its reason") {
  const std::string text =
      belt("wrap_angle: 1, initial: {CP1: 9}, initial_strain: 0.01",
           "elasticity: [{component: 1, stiffness: 100}]\n"
           "damping: [{component: 1, coefficient: 5}]\nintegration: {method: exact}\n",
           "motion: {CP1: {to: 9.1}}");
  CHECK_THAT(message(text), Catch::Contains("the damping of a belt lets its tension jump"));
}

TEST_CASE("a belt counts its flows from where they started") {
  const cases::Case problem =
      read::sound(belt("wrap_angle: 1, initial: {CP2: 4, CP3: 5}", "",
                       "force: {f1: 9}, motion: {CP2: {to: 6}, CP3: {to: 6}}"));
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (simulation->advance().value()) {
  }
  const auto columns = results::result_columns(problem);
  CHECK(results::column_value(*results::find_column(problem, columns, "CU2"), problem,
                              simulation->row()) == 2.0);
  CHECK(results::column_value(*results::find_column(problem, columns, "CU3"), problem,
                              simulation->row()) == 1.0);
}

}  // namespace
}  // namespace slipbench::driver::bench
