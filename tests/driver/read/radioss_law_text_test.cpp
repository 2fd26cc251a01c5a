// SPDX-License-Identifier: Apache-2.0
// How the Radioss laws of the coefficient are read: areas, units of speed, rules.
#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "law/friction/law_list.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

const std::string kRenard = "C1: 0.15, C2: 0.10, C3: 0.25, C4: 0.05, C5: 10, C6: 100";

std::string case_with(const std::string& law, const std::string& connector = "type: SLOT",
                      const std::string& units = "length: mm, force: N, time: s") {
  return "slipbench: 1\nunits: {" + units + "}\nconnector: {" + connector +
         "}\nfriction:\n  - predefined: {}\n    coefficient: {" + law +
         "}\n    stick: {stiffness: 1}\nhistory:\n  - {step: a, duration: 1, increments: 2, "
         "force: {f2: 1}, motion: {CP1: {to: 1}}}\n";
}

template <class Law>
Law law_of(const std::string& text) {
  const cases::Case problem = sound(text);
  REQUIRE(problem.definitions.size() == 1);
  const Law* law = law::get_law_if<Law>(problem.definitions[0].law.law);
  REQUIRE(law != nullptr);
  return *law;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST_CASE("A law of the pressure has its own area or else the connector's") {
  using law::GeneralizedViscous;
  CHECK(law_of<GeneralizedViscous>(case_with("generalized_viscous: {C1: 1, area: 3}")).area == 3.0);
  CHECK(law_of<GeneralizedViscous>(case_with("generalized_viscous: {C1: 1}", "type: SLOT, area: 2"))
            .area == 2.0);
  CHECK(law_of<GeneralizedViscous>(
            case_with("generalized_viscous: {C1: 1, area: 3}", "type: SLOT, area: 2"))
            .area == 3.0);
  CHECK(
      law_of<law::ModifiedDarmstad>(case_with("modified_darmstad: {C3: 1}", "type: SLOT, area: 2"))
          .area == 2.0);
}

TEST_CASE("Only a law whose coefficients see the pressure needs an area") {
  const std::string refused = complaint(case_with("modified_darmstad: {Fric: 0.1, C1: 1}"));
  CHECK(says(refused, "error: friction[0].coefficient.modified_darmstad: "));
  CHECK(says(refused, "'area' here"));
  CHECK(says(refused, "'connector: {area: ..}'"));
  CHECK_FALSE(
      law_of<law::ModifiedDarmstad>(case_with("modified_darmstad: {Fric: 0.1, C5: 1}")).area);
  // A faulty area is one fault, not two.
  const std::string faulty =
      complaint(case_with("generalized_viscous: {C1: 1}", "type: SLOT, area: -1"));
  CHECK(says(faulty, "connector.area"));
  CHECK_FALSE(says(faulty, "no area"));
}

TEST_CASE("Renard's constants keep their unit of speed, the case's get the factor") {
  using law::Renard;
  CHECK(law_of<Renard>(case_with("renard: {" + kRenard + "}")).speed_factor == 1.0);
  const Renard law = law_of<Renard>(case_with("renard: {" + kRenard + ", speed_unit: mm/ms}"));
  // 1 mm/s is 0.001 mm/ms; the factor is rounded twice.
  CHECK(law.speed_factor == Approx(1.0e-3).epsilon(1e-15));
  CHECK(law.c5 == 10.0);
  CHECK(law_of<Renard>(case_with("renard: {" + kRenard + ", speed_unit: mm/s}", "type: SLOT",
                                 "length: mm, force: kN, time: ms"))
            .speed_factor == Approx(1.0e3).epsilon(1e-15));
}

TEST_CASE("Renard asks for units, and for a speed as the unit of its constants") {
  CHECK(says(complaint(case_with("renard: {" + kRenard + "}", "type: SLOT", "force: N")),
             "units of length and time"));
  CHECK(says(complaint(case_with("renard: {" + kRenard + "}", "type: SLOT", "length: mm")),
             "units of length and time"));
  CHECK(says(complaint(case_with("renard: {" + kRenard + ", speed_unit: s}")),
             "unit 's' does not measure"));
  CHECK(says(complaint(case_with("renard: {" + kRenard + ", speed_unit: furlong/fortnigt}")),
             "unknown unit"));
}

TEST_CASE("In a rotation the unit of Renard's constants is that of an angle per time") {
  const auto hinge = [](const std::string& law) {
    return "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: HINGE, area: "
           "5}\nfriction:\n  - predefined: {R_p: 2}\n    coefficient: {" +
           law +
           "}\n    stick: {stiffness: 1}\nhistory:\n  - {step: a, increments: 2, force: {f2: 1}, "
           "motion: {CPR1: {to: 1}}}\n";
  };
  CHECK(law_of<law::Renard>(hinge("renard: {" + kRenard + ", speed_unit: rad/ms}")).speed_factor ==
        Approx(1.0e-3).epsilon(1e-15));
  const std::string wrong = complaint(hinge("renard: {" + kRenard + ", speed_unit: m/s}"));
  CHECK(says(wrong, "unit 'm/s' does not measure"));
  CHECK(says(wrong, "its V is in rad/s"));
  // What this law calls a pressure is none.
  const std::string warned = complaint(hinge("generalized_viscous: {C1: 1}"));
  CHECK(says(warned,
             "warning: friction[0].coefficient.generalized_viscous: F_N of this definition "
             "is a moment"));
  CHECK_FALSE(says(complaint(hinge("generalized_viscous: {C2: 1}")), "moment"));
}

TEST_CASE("A faulty law does not make its columns unknown in checks") {
  const std::string checks =
      "checks:\n  - {name: c, quantity: SPEED, against: {expression: \"= 1\"}, tolerance: "
      "{absolute: 1}}\n";
  const std::string text = complaint(case_with("renard: {C1: 0.3}") + checks);
  CHECK(says(text, "renard"));
  CHECK_FALSE(says(text, "SPEED"));
  CHECK(says(
      complaint(case_with("exponential_decay: {static: 0.3, kinetic: 0.2, decay: 1}") + checks),
      "SPEED"));
}

TEST_CASE("Every broken rule of Renard is quoted, with the numbers once") {
  const std::string text =
      complaint(case_with("renard: {C1: 0.3, C2: 0.28, C3: 0.25, C4: 0.05, C5: 10, C6: 100}"));
  CHECK(says(text, "C1 <= C3 must hold (found C1 0.3, C2 0.28, C3 0.25"));
  CHECK(says(text, "C2 <= C3 must hold\n"));
  CHECK_FALSE(says(text, "C4 <= C1"));
}

TEST_CASE("Lenient rules are warnings, but a pole stays an error") {
  const std::string text = complaint(case_with(
      "renard: {C1: 0.3, C2: 0.1, C3: 0.25, C4: -0.05, C5: 10, C6: 100, rules: lenient}"));
  CHECK_FALSE(says(text, "error:"));
  CHECK(says(text, "warning: friction[0].coefficient.renard: C1 <= C3 must hold"));
  CHECK(says(text, "C4 >= 0 must hold"));
  const std::string pole = complaint(case_with(
      "renard: {C1: 0.15, C2: 0.1, C3: 0.25, C4: 0.12, C5: 10, C6: 100, rules: lenient}"));
  CHECK(says(pole, "error: friction[0].coefficient.renard: C4 <= C2 must hold"));
  CHECK(says(complaint(case_with("renard: {" + kRenard + ", rules: loose}")),
             "wanted strict or lenient, found 'loose'"));
}

TEST_CASE("A coefficient that is not used, or starts below zero, is pointed out") {
  const std::string unused = complaint(case_with("generalized_viscous: {Fric: 0.1, C6: 2}"));
  CHECK(says(unused, "warning: friction[0].coefficient.generalized_viscous.C6: "));
  CHECK_FALSE(says(unused, "error:"));
  CHECK(
      says(complaint(case_with("modified_darmstad: {Fric: 0.1, C5: -0.2}")), "mu = -0.1 at rest"));
  CHECK_FALSE(says(complaint(case_with("modified_darmstad: {Fric: 0.1, C5: 0.2}")), "warning"));
}

}  // namespace
}  // namespace slipbench::driver::read
