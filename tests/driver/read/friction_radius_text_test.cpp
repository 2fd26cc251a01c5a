// SPDX-License-Identifier: Apache-2.0
// One coefficient that sliding and spinning share: said where it sees two units, and converted at a
// friction radius.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

const std::string kPuck =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "connector: {type: PLANAR}\n"
    "friction:\n"
    "  - predefined: {R: 12, internal_contact_force: 5}\n"
    "    coefficient: {exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}\n"
    "    stick: {slip_tolerance: 1.0e-4}\n"
    "history:\n"
    "  - {step: go, increments: 2, motion: {CP2: {to: 1}}}\n";

const Change kRadius{"{type: PLANAR}", "{type: PLANAR, friction_radius: 8}"};
const Change kTable{"coefficient: {exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}",
                    "coefficient: {columns: [mu, slip_rate, contact_force], rows: [[0.3, 0, 0], "
                    "[0.1, 50, 0], [0.25, 0, 100], [0.08, 50, 100]]}"};

std::vector<std::string> warnings(const std::vector<Change>& changes,
                                  const std::string& text = kPuck) {
  std::vector<std::string> found = messages(changed(changes, text));
  std::erase_if(
      found, [](const std::string& line) { return line.find(": warning:") == std::string::npos; });
  return found;
}

TEST_CASE("a coefficient over the slip rate is said to see two units, once, with numbers") {
  const std::vector<std::string> found = warnings({});
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "6:18: warning: friction[0].coefficient: 'exponential_decay' is asked for slip rates in "
        "mm/s for sliding and rad/s for spinning; at the same speed 50 mm/s at the radius 8 mm mu "
        "is 0.1164 sliding and 0.2463 spinning; 'connector: {friction_radius: 8}' asks for both at "
        "that radius, the puck's mean arm of friction");
  // The numbers are the law's.
  CHECK(0.1 + 0.2 * std::exp(-0.05 * 50.0) == Approx(0.1164).epsilon(1e-3));
  CHECK(0.1 + 0.2 * std::exp(-0.05 * 50.0 / 8.0) == Approx(0.2463).epsilon(1e-3));
}

TEST_CASE(
    "the radius that is proposed for a ring is its mean arm, and a ring has a hole less than R") {
  const std::vector<std::string> found = warnings({{"{R: 12,", "{R: 12, R_i: 6,"}});
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("'connector: {friction_radius: 9.33333}'") != std::string::npos);
  CHECK(warnings({{"{R: 12,", "{R: 12, R_i: 0,"}}) == warnings({}));
  CHECK(warnings({{"{R: 12,", "{R: 12, R_i: 0,"}, kRadius}).empty());
  const std::vector<std::string> thick =
      messages(changed({{"{R: 12,", "{R: 12, R_i: 12,"}}, kPuck));
  CHECK(
      std::count(thick.begin(), thick.end(),
                 "5:30: error: friction[0].predefined.R_i: the inner radius of a ring must be less "
                 "than its radius R, 12") == 1);
}

TEST_CASE("a table over rate and force, and one over the force alone, are said to as well") {
  const std::vector<std::string> both = warnings({kTable});
  REQUIRE(both.size() == 1);
  CHECK(both[0].find("'table' is asked for slip rates in mm/s for sliding and rad/s for spinning, "
                     "contact forces in N and N mm; at the same speed ") != std::string::npos);
  const std::vector<std::string> force =
      warnings({{"{exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}",
                 "{columns: [mu, contact_force], rows: [[0.3, 0], [0.1, 100]]}"}});
  REQUIRE(force.size() == 1);
  CHECK(force[0].find("contact forces in N for sliding and N mm for spinning") !=
        std::string::npos);
}

TEST_CASE("what sees neither rate nor force, or has a friction radius, is not warned of") {
  CHECK(
      warnings({{"{exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}", "0.2"}}).empty());
  CHECK(warnings({{"{exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}",
                   "{columns: [mu, temperature], rows: [[0.3, 0], [0.1, 100]]}"},
                  {"increments: 2,", "increments: 2, temperature: 20,"}})
            .empty());
  CHECK(warnings({kRadius}).empty());
  CHECK(warnings({kRadius, kTable}).empty());
}

TEST_CASE("at the friction radius the spinning has the coefficient of the sliding") {
  for (const std::vector<Change>& changes :
       {std::vector<Change>{kRadius}, std::vector<Change>{kRadius, kTable}}) {
    const cases::Case problem = sound(changed(changes, kPuck));
    REQUIRE(problem.definitions.size() == 2);
    for (const double speed : {0.0, 3.0, 20.0, 70.0}) {
      for (const double force : {0.0, 40.0, 150.0}) {
        const auto mu = [&](std::size_t d, double rate, double normal) {
          return law::evaluate(problem.definitions[d].law.law, {},
                               {.slip_rate = rate, .contact_force = normal})
              .mu;
        };
        CHECK(mu(1, speed / 8.0, force * 8.0) == Approx(mu(0, speed, force)).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("a law with a hidden unit of speed keeps it at the friction radius") {
  const Change renard{"{exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}",
                      "{renard: {C1: 0.15, C2: 0.1, C3: 0.25, C4: 0.05, C5: 1, C6: 2, speed_unit: "
                      "m/s}}"};
  const cases::Case problem = sound(changed({kRadius, renard}, kPuck));
  for (const double speed : {500.0, 1500.0, 9000.0}) {
    const auto mu = [&](std::size_t d, double rate) {
      return law::evaluate(problem.definitions[d].law.law, {}, {.slip_rate = rate}).mu;
    };
    CHECK(mu(1, speed / 8.0) == Approx(mu(0, speed)).epsilon(1e-12));
  }
}

TEST_CASE("a change of friction is converted at the friction radius too, and warned of once") {
  const Change constant{"{exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}", "0.2"};
  const std::string change =
      ", change_friction: {friction1: {coefficient: {exponential_decay: {static: 0.3, kinetic: "
      "0.1, decay: 0.05}}}}}\n";
  const Change changing{"{CP2: {to: 1}}}\n", "{CP2: {to: 1}}}\n  - {step: more, increments: 2" +
                                                 change + "  - {step: again, increments: 2" +
                                                 change};
  const std::vector<std::string> found = warnings({constant, changing});
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("history[1].change_friction.friction1.coefficient: 'exponential_decay' is "
                      "asked for slip rates in mm/s") != std::string::npos);
  CHECK(warnings({kRadius, constant, changing}).empty());
  const cases::Case problem = sound(changed({kRadius, constant, changing}, kPuck));
  const std::vector<cases::FrictionChange>& changes = problem.steps[1].friction_changes;
  REQUIRE(changes.size() == 2);
  CHECK(std::get<law::ExponentialDecay>(changes[0].law).decay == 0.05);
  CHECK(std::get<law::ExponentialDecay>(changes[1].law).decay == Approx(0.4));
}

TEST_CASE("a friction radius that nothing needs is pointed out") {
  const std::vector<std::string> found =
      warnings({{"type: PLANAR", "type: SLIDE-PLANE, friction_radius: 8"}, {"R: 12, ", ""}});
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "3:49: warning: connector.friction_radius: not used: no coefficient is shared by a "
        "translation and a rotation");
  // The shaft's coefficient is shared, and its rotation has a radius of its own.
  const std::string own =
      "connector.friction_radius: not used: translation and rotation slip together, at the radius "
      "0.24 of the rotation's 'scale' or of 'predefined'";
  const Change shaft{"type: CYLINDRICAL", "type: CYLINDRICAL\n  friction_radius: 8"};
  CHECK(warnings({shaft}, kSoundCase) == std::vector<std::string>{"7:20: warning: " + own});
  const Change predefined{
      "potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    contact_force: "
      "normal\n",
      "predefined: {R: = r}\n"};
  CHECK(warnings({shaft, predefined}, kSoundCase) ==
        std::vector<std::string>{"7:20: warning: " + own});
}

TEST_CASE("parts that meet share one coefficient among all definitions") {
  const std::string pair =
      "slipbench: 1\n"
      "units: {length: mm, force: N, time: s}\n"
      "connector: {type: CYLINDRICAL, parts: [1, 2]}\n"
      "friction:\n"
      "  - {component: 1, internal_contact_force: 5, stick: {elastic_slip: 1e-4}}\n"
      "  - {component: 4, internal_contact_force: 5, stick: {elastic_slip: 1e-4}}\n"
      "friction_pairs:\n"
      "  default: {coefficient: {exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}}\n"
      "history:\n"
      "  - {step: go, increments: 2, motion: {CP1: {to: 1}}}\n";
  const std::vector<std::string> found = warnings({}, pair);
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "8:26: warning: friction_pairs.default.coefficient: 'exponential_decay' is asked for slip "
        "rates in mm/s for sliding and rad/s for spinning; 'connector: {friction_radius: R}' asks "
        "for both at that radius");
  const cases::Case problem =
      sound(changed({{"parts: [1, 2]", "parts: [1, 2], friction_radius: 10 mm"}}, pair));
  CHECK(std::get<law::ExponentialDecay>(problem.definitions[0].law.law).decay == 0.05);
  CHECK(std::get<law::ExponentialDecay>(problem.definitions[1].law.law).decay == Approx(0.5));
}

TEST_CASE("a rotation without a radius in a potential of translations is said to mix rates") {
  const Change law{"coefficient: = mu",
                   "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.1, decay: 0.05}}"};
  const std::vector<std::string> found = warnings({law, {", scale: = r", ""}}, kSoundCase);
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "14:31: warning: friction[0].potential.terms[1]: component 4 is a rotation beside "
        "translations: without a 'scale' its rate in rad is added to theirs, and the coefficient "
        "depends on the sum; 'scale' is the radius it rubs at");
  CHECK(warnings({law}, kSoundCase).empty());
  // A constant coefficient compares forces with moments.
  CHECK(warnings({{", scale: = r", ""}}, kSoundCase) ==
        std::vector<std::string>{
            "14:31: warning: friction[0].potential.terms[1]: component 4 is a rotation beside "
            "translations: without a 'scale' its moment counts like their forces, as at the radius "
            "1; 'scale' is the radius it rubs at"});
}

TEST_CASE("one coefficient of a shaft's translation and rotation is looked up at its surface") {
  const std::string shaft =
      "slipbench: 1\n"
      "units: {length: mm, force: N, time: s}\n"
      "connector: {type: CYLINDRICAL}\n"
      "friction:\n"
      "  - predefined: {R: 8}\n"
      "    coefficient: {columns: [mu, slip_rate], rows: [[0.3, 0], [0.1, 50]]}\n"
      "    stick: {elastic_slip: 1.0e-4}\n"
      "history:\n"
      "  - {step: go, increments: 2, motion: {CP1: {to: 1}}, force: {f2: 50}}\n";
  CHECK(warnings({}, shaft).empty());
  const cases::Case problem = sound(shaft);
  REQUIRE(problem.definitions.size() == 1);
  CHECK(problem.definitions[0].law.slip.scale[1] == 8.0);
}

}  // namespace
}  // namespace slipbench::driver::read
