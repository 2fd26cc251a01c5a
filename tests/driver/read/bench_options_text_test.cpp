// SPDX-License-Identifier: Apache-2.0
// dead_zone and direction_dependent as they are written: what they mean, and what they must not
// say.
#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

const std::string kSleeve =
    "slipbench: 1\nparameters: {g: 0.4}\nconnector: {type: SLOT}\nfriction:\n  - {name: sleeve, "
    "predefined: {}, coefficient: MU, stick: {stiffness: 10}}\nZONE\nhistory:\n  - {step: go, "
    "increments: 2, force: {f2: 3}, motion: {CP1: {to: 1}}}\n";

std::string sleeve(const std::string& mu, const std::string& zone = "") {
  return changed({{"MU", mu}, {"ZONE", zone}}, kSleeve);
}

TEST_CASE("a dead zone belongs to the definition of its component, its play where it is told") {
  const auto start = [](const std::string& position) {
    const cases::Case problem =
        sound(sleeve("0.2", "dead_zone: [{component: 1, width: = g" + position + "}]"));
    REQUIRE(problem.definitions.at(0).dead_zone.has_value());
    CHECK(problem.definitions[0].dead_zone->width == 0.4);
    return problem.definitions[0].dead_zone->start;
  };
  CHECK(start("") == 0.0);
  CHECK(start(", position: centred") == 0.0);
  CHECK(start(", position: lower") == -0.2);
  CHECK(start(", position: upper") == 0.2);
  CHECK(start(", position: = g/4") == 0.1);
  CHECK_FALSE(sound(sleeve("0.2")).definitions[0].dead_zone.has_value());
}

TEST_CASE("each direction has a law of its own, a number, a table or one by name") {
  const cases::Case problem = sound(sleeve(
      "{direction_dependent: {forward: {columns: [mu, slip_rate], rows: [[0.3, 0], [0.2, 9]]}, "
      "backward: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 1}}}}"));
  const cases::CaseDefinition& definition = problem.definitions.at(0);
  CHECK(std::holds_alternative<law::TabularCoefficient>(definition.law.law));
  REQUIRE(definition.backward.has_value());
  CHECK(std::holds_alternative<law::ExponentialDecay>(*definition.backward));
}

TEST_CASE("a record of part pairs may have a coefficient for each direction") {
  const cases::Case problem = sound(
      "slipbench: 1\nconnector: {type: SLOT, parts: [1, 2]}\nfriction_pairs: {default: "
      "{coefficient: {direction_dependent: {forward: 0.3, backward: 0.1}}}}\nfriction:\n  - "
      "{predefined: {}, stick: {stiffness: 10}}\nhistory:\n  - {step: go, increments: 2}\n");
  REQUIRE(problem.definitions.at(0).backward.has_value());
  CHECK(std::get<law::ConstantCoefficient>(*problem.definitions[0].backward).mu == 0.1);
}

TEST_CASE("snap-back is judged with the coefficient of either direction") {
  const auto found = messages(
      "slipbench: 1\nconnector: {type: TRANSLATOR}\nfriction:\n  - {component: 1, "
      "internal_contact_force: {columns: [F, accumulated_slip], rows: [[100, 0], [0, 1]]}, "
      "coefficient: {direction_dependent: {forward: 0.01, backward: 0.2}}, stick: {stiffness: "
      "10}}\nhistory:\n  - {step: go, increments: 2}\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("direction_dependent.backward: wear may fall faster") != std::string::npos);
}

TEST_CASE("a component has one dead zone, and friction behind it") {
  const auto twice =
      messages(sleeve("0.2", "dead_zone: [{component: 1, width: 1}, {component: 1, width: 2}]"));
  REQUIRE(twice.size() == 1);
  CHECK(twice[0] == "6:51: error: dead_zone[1].component: component 1 already has a dead zone");
  const auto beyond =
      messages(sleeve("0.2", "dead_zone: [{component: 1, width: 1, position: -0.6}]"));
  REQUIRE(beyond.size() == 1);
  CHECK(beyond[0] ==
        "6:48: error: dead_zone[0].position: the play lies between -width/2 and width/2, -0.5 and "
        "0.5: found -0.6");
}

TEST_CASE("dead zones and directions are refused around a formulation and a mass") {
  const std::string formulated =
      changed({{"stick: {stiffness: 10}", "formulation: {penalty: stiffness, K_t: 10}"}},
              sleeve("{direction_dependent: {forward: 0.3, backward: 0.1}}",
                     "dead_zone: [{component: 1, width: 1}]"));
  const auto found = messages(formulated);
  REQUIRE(found.size() == 2);
  CHECK(found[0].find("a coefficient for each direction needs the connector's stick") !=
        std::string::npos);
  CHECK(
      found[1].find("a dead zone needs the connector's stick and return mapping, and the friction "
                    "of component 1 has a 'formulation'") != std::string::npos);
  const auto mass = messages(
      "slipbench: 1\nconnector: {type: SLOT}\nfriction:\n  - {predefined: {}, coefficient: "
      "0.2}\ndead_zone: [{component: 1, width: 1}]\ndynamics: {mass: 1}\nhistory:\n  - {step: go, "
      "increments: 2, force: {f2: 3}}\n");
  REQUIRE(mass.size() == 1);
  CHECK(mass[0].find("the mass of 'dynamics:' sticks rigidly") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::read
