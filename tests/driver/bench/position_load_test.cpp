// SPDX-License-Identifier: Apache-2.0
// Forces that follow the positions: at the position of the same row, solved for where the force
// makes the motion, and refused where there is none to follow.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::bench {
namespace {

std::string weight(const std::string& steps, const std::string& more = "") {
  return "slipbench: 1\n"
         "connector: {type: HINGE}\n"
         "friction:\n"
         "  - {component: 4, internal_contact_force: 400, coefficient: 1, stick: {stiffness: "
         "4000}}\n" +
         more + "history:\n" + steps;
}
std::string growing(int increments) {
  return weight("  - {step: load, increments: " + std::to_string(increments) +
                ", force: {m1: \"= 1000*t*cos(CPR1)\"}}\n");
}

std::string failure_of(const cases::Case& problem) {
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (true) {
    const auto more = simulation->advance();
    if (!more) return more.error().message;
    if (!*more) return {};
  }
}

TEST_CASE("where a weight slips to does not depend on the increments") {
  for (const int increments : {1, 2, 7, 50}) {
    INFO(increments);
    const Row end = rows_of(read::sound(growing(increments))).back();
    CHECK(end.quantities[3] == Approx(std::acos(0.4)).epsilon(1e-11));
    CHECK(end.forces.component[3].applied == Approx(400.0).epsilon(1e-11));
    CHECK(end.definitions[0].update.state.force[0] == Approx(400.0).epsilon(1e-12));
  }
}

TEST_CASE("loads that follow each other's positions are solved together") {
  const cases::Case problem = read::sound(
      "slipbench: 1\n"
      "connector: {type: CARTESIAN}\n"
      "friction: [{component: 3, internal_contact_force: 1, coefficient: 0.1, stick: {stiffness: "
      "1}}]\n"
      "elasticity: [{component: 1, stiffness: 10}, {component: 2, stiffness: 20}]\n"
      "history: [{step: go, increments: 3, force: {f1: \"= t*(10 + 3*CP2)\", f2: \"= t*(5 - "
      "2*CP1)\"}}]\n");
  for (const Row& row : rows_of(problem)) {
    // 10 x - 3 t y = 10 t, 2 t x + 20 y = 5 t.
    const double t = row.time, det = 200.0 + 6.0 * t * t;
    CHECK(row.quantities[0] == Approx((200.0 * t + 15.0 * t * t) / det).margin(1e-12));
    CHECK(row.quantities[1] == Approx((50.0 * t - 20.0 * t * t) / det).margin(1e-12));
  }
}

TEST_CASE("a load that grows faster with the way than the spring has no static solution") {
  const std::string text =
      "slipbench: 1\n"
      "connector: {type: SLOT}\n"
      "friction: [{component: 1, internal_contact_force: 100, coefficient: 0.2, stick: {stiffness: "
      "1000}}]\n"
      "elasticity: [{component: 1, stiffness: 5}]\n"
      "history: [{step: pull, increments: 4, force: {f1: \"= 16*t*(1 + CP1)\"}}]\n";
  // Up to 16 N the friction of 20 N holds elastically; at a stiffness of 8 a slip would go on.
  CHECK(failure_of(read::sound(text)).empty());
  const std::string message = failure_of(read::sound(read::changed({{"16*t", "32*t"}}, text)));
  INFO(message);
  CHECK(message.find("no static solution: component 1 is loaded with f1 = 20.") !=
        std::string::npos);
  CHECK(message.find(", and no position on its way holds it (friction 'friction1' has the limit "
                     "20)") != std::string::npos);
}

TEST_CASE("only forces follow positions, and only those the connector has") {
  const auto error = [](const std::string& drive) {
    const std::vector<std::string> all =
        read::messages(weight("  - {step: go, increments: 1, " + drive + "}\n"));
    REQUIRE(all.size() == 1);
    return all[0];
  };
  CHECK(error("motion: {CPR1: \"= 2*CPR1\"}") ==
        "6:46: error: history[0].motion.CPR1: only forces can follow a position such as CPR1; the "
        "variables here are t and T");
  CHECK(error("temperature: \"= 20 + CPR1\"").find("only forces can follow a position") !=
        std::string::npos);
  const std::vector<std::string> slot = read::messages(
      "slipbench: 1\n"
      "connector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: 0.2, stick: {stiffness: 1}}]\n"
      "history: [{step: go, increments: 1, force: {f2: \"= 100*cos(CPR1)\"}}]\n");
  REQUIRE(slot.size() == 1);
  CHECK(slot[0].find("history[0].force.f2: a SLOT connector has no position CPR1; it has CP1, CP2, "
                     "CP3") != std::string::npos);
  const std::vector<std::string> belt = read::messages(
      "slipbench: 1\n"
      "connector: {type: SLIPRING, wrap_angle: 1}\n"
      "friction: [{predefined: {}, coefficient: 0.3, stick: {stiffness: 10}}]\n"
      "history: [{step: go, increments: 1, force: {f1: \"= 5 + CP2\"}, motion: {CP2: {to: 1}}}]\n");
  REQUIRE(belt.size() == 1);
  CHECK(belt[0].find("only forces can follow a position such as CP2, and not the tensions of a "
                     "belt") != std::string::npos);
}

TEST_CASE("a parameter of the same name hides a position") {
  const cases::Case problem = read::sound(weight(
      "  - {step: go, increments: 2, force: {m1: \"= 100*t*CPR1\"}}\n", "parameters: {CPR1: 3}\n"));
  CHECK(std::holds_alternative<history::ExpressionProfile>(problem.steps[0].drives[0].profile));
  CHECK(rows_of(problem).back().forces.component[3].applied == Approx(300.0));
}

TEST_CASE("a formula without a value where the connector comes to ends the run there") {
  const cases::Case problem = read::sound(
      "slipbench: 1\n"
      "connector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: 0.2, stick: {stiffness: 1}}]\n"
      "history: [{step: go, increments: 4, force: {f2: \"= 10/(CP1 - 0.5)\"}, motion: {CP1: {to: "
      "1}}}]\n");
  CHECK(failure_of(problem).find("step 'go', t = 0.5, f2: ") == 0);
}

TEST_CASE("a run with loads over positions that was cut goes on with the same bytes") {
  const cases::Case problem = read::sound(growing(40));
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int i = 0; i < 25; ++i) REQUIRE(whole->advance());
  auto resumed = Simulation::resume(problem, whole->state());
  REQUIRE(resumed);
  REQUIRE(whole->advance());
  REQUIRE(resumed->advance());
  CHECK(whole->row().quantities == resumed->row().quantities);
  CHECK(whole->row().definitions[0].update.state.force ==
        resumed->row().definitions[0].update.state.force);
}

TEST_CASE("a mass under a load over its position moves as its increments do not say") {
  const auto end = [](int increments) {
    return rows_of(read::sound(weight(
                       "  - {step: swing, duration: 3, increments: " + std::to_string(increments) +
                           ", force: {m1: \"= -8000*sin(CPR1)\"}}\n",
                       "dynamics: {mass: 300, initial_velocity: 9}\n")))
        .back();
  };
  const Row one = end(1), many = end(60);
  CHECK(one.quantities[3] == Approx(many.quantities[3]).epsilon(1e-10));
  CHECK(one.forces.velocity == Approx(many.forces.velocity).margin(1e-9));
  CHECK(one.forces.external_work == Approx(8000.0 * (std::cos(one.quantities[3]) - 1.0))
                                        .margin(1e-7));  // of a kinetic energy of 12 kJ
  CHECK(one.quantities[cases::kFirstForce + 3] == Approx(-8000.0 * std::sin(one.quantities[3])));
}

TEST_CASE("a load that runs away is not followed to a balance on the other side") {
  // 20 t (1 + x) = 3 x + 2 in slip: x grows beyond all bounds at t = 0.15. From there on only the
  // balance 3 x - 2 at x < -1 is left, which any shift leaves.
  for (const int increments : {3, 10, 100}) {
    INFO(increments);
    const std::string end = failure_of(read::sound(
        "slipbench: 1\nconnector: {type: SLOT}\n"
        "friction: [{component: 1, internal_contact_force: 10, coefficient: 0.2, stick: "
        "{stiffness: 1000}}]\nelasticity: [{component: 1, stiffness: 3}]\n"
        "history: [{step: push, increments: " +
        std::to_string(increments) + ", force: {f1: \"= 20*t*(1 + CP1)\"}}]\n"));
    INFO(end);
    CHECK(end.find("no static solution: component 1 is loaded with f1 = ") != std::string::npos);
    const double time = std::stod(end.substr(end.find("t = ") + 4));
    CHECK(time > 0.14);
    CHECK(time < 0.151);
  }
}

TEST_CASE("exact integration takes a force over the position as straight from row to row") {
  const auto rows = [](const std::string& force) {
    return rows_of(
        read::sound("slipbench: 1\n"
                    "connector: {type: SLOT}\n"
                    "friction: [{predefined: {}, coefficient: 0.2, stick: {stiffness: 10}}]\n"
                    "integration: {method: exact}\n"
                    "history: [{step: go, increments: 10, force: {f2: " +
                    force + "}, motion: {CP1: {to: 10}}}]\n"));
  };
  // Of a motion that is straight in time, the same force over position and over time.
  const std::vector<Row> position = rows("\"= 50 - CP1^2/4\""),
                         time = rows("\"= 50 - (10*t)^2/4\"");
  REQUIRE(position.size() == time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    CHECK(position[i].definitions[0].dissipation ==
          Approx(time[i].definitions[0].dissipation).margin(1e-12));
    CHECK(position[i].quantities[7] == Approx(time[i].quantities[7]).margin(1e-12));
  }
}

}  // namespace
}  // namespace slipbench::driver::bench
