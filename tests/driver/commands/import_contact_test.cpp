// SPDX-License-Identifier: Apache-2.0
// Friction of contacts in decks of LS-DYNA and OpenSees, evaluated against their formulas.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/commands/imported_deck.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::commands {
namespace {

const std::string kDecks = test::source_dir() + "/tests/decks/";

ImportedDeck import_file(const std::string& name) {
  ImportOptions options;
  options.deck = kDecks + name;
  options.all = true;
  ImportedDeck deck = read_deck(options);
  INFO(deck.messages);
  REQUIRE(deck.code == base::kExitOk);
  return deck;
}

/// A case whose open parameters are 1 but for those given.
cases::Case case_of(const ImportedDeck& deck, const std::string& stem,
                    std::vector<base::ParameterText> values = {}) {
  for (const ImportedCase& one : deck.cases) {
    if (one.stem != stem) continue;
    for (const std::string& name : one.written.asked) {
      bool given = false;
      for (const base::ParameterText& value : values) given = given || value.name == name;
      if (!given) values.push_back({name, 1.0});
    }
    const read::ReadCase read =
        read::read_case_text(base::SourceText("c", one.written.text), ".", {.overrides = values});
    INFO(base::render(read.diagnostics, read.sources));
    REQUIRE(read.value);
    return *read.value;
  }
  FAIL("no case " << stem);
  throw 0;
}

double coefficient(const cases::Case& problem, double rate, double force) {
  law::SlipArguments slip;
  slip.slip_rate = rate;
  slip.contact_force = force;
  return law::evaluate(problem.definitions[0].law.law, {}, slip).mu;
}

TEST_CASE("A contact of LS-DYNA has FS, FD, DC, VC and the factors of its third card") {
  const ImportedDeck deck = import_file("lsdyna/brake.k");
  CHECK(deck.cases.size() == 3);
  const cases::Case problem = case_of(deck, "brake_CONTACT_3", {{"area", 3.0}});
  const double v = 250.0;
  CHECK(coefficient(problem, v, 1.0) ==
        Approx(0.9 * (0.3 + (0.42 - 0.3) * std::exp(-2e-3 * v))).epsilon(1e-14));
  CHECK(problem.definitions[0].law.force_limit == Approx(180.0 * 3.0));
  CHECK_THAT(deck.messages, Catch::Contains("is tied: no friction") &&
                                Catch::Contains("FS -1 takes the coefficients of its parts"));
}

TEST_CASE("FS -2 takes the pairs of *DEFINE_FRICTION, sets of parts among them") {
  const ImportedDeck deck = import_file("lsdyna/brake.k");
  const auto between = [&](double a, double b) {
    return case_of(deck, "brake_CONTACT_4", {{"part1", a}, {"part2", b}, {"area", 2.0}});
  };
  const cases::Case pair = between(2, 1);
  CHECK(coefficient(pair, 100.0, 1.0) == Approx(0.3 + 0.1 * std::exp(-0.2)).epsilon(1e-14));
  CHECK(pair.definitions[0].law.force_limit == Approx(300.0));
  CHECK(coefficient(between(12, 9), 100.0, 1.0) == Approx(0.2));
  CHECK(between(12, 9).definitions[0].law.force_limit == law::kNoForceLimit);
  CHECK(coefficient(between(5, 6), 100.0, 1.0) == Approx(0.1 + 0.05 * std::exp(-0.1)));
}

TEST_CASE("FS 2 takes a table over velocity and pressure") {
  const ImportedDeck deck = import_file("lsdyna/brake.k");
  const cases::Case problem = case_of(deck, "brake_CONTACT_6", {{"area", 4.0}});
  CHECK(coefficient(problem, 0.0, 4.0) == Approx(0.4));
  CHECK(coefficient(problem, 500.0, 40.0) == Approx(0.3));
  CHECK(coefficient(problem, 1000.0, 4.0 * 5.5) == Approx(0.275));
}

TEST_CASE("Friction models of OpenSees are read from Tcl and Python") {
  const ImportedDeck deck = import_file("opensees/bearing.tcl");
  CHECK(deck.cases.size() == 5);
  const auto model = [&](const std::string& name, double normal_force = 900.0) {
    return case_of(deck, "bearing_" + name, {{"normal_force", normal_force}});
  };
  CHECK(coefficient(model("Coulomb_1"), 3.0, 1.0) == 0.05);
  const auto falling = [](double slow, double fast, double rate, double v) {
    return fast - (fast - slow) * std::exp(-rate * v);
  };
  const cases::Case slider = model("VelDependent_2");
  CHECK(coefficient(slider, 30.0, 1.0) == Approx(falling(0.03, 0.07, 0.025, 30.0)).epsilon(1e-13));
  REQUIRE(slider.definitions[0].law.formulation);
  CHECK(std::get<law::StiffnessPenalty>(slider.definitions[0].law.formulation->penalty).stiffness ==
        1250.0);
  // Beyond its last point it goes on with the last slope.
  CHECK(coefficient(model("VelDepMultiLinear_3"), 390.0, 1.0) == Approx(0.09));
  const ImportedDeck python = import_file("opensees/bearing.py");
  CHECK(coefficient(case_of(python, "bearing_VelDependent_2"), 30.0, 1.0) ==
        coefficient(slider, 30.0, 1.0));
}

TEST_CASE("Models of OpenSees over the normal force become tables") {
  const ImportedDeck deck = import_file("opensees/bearing.tcl");
  const cases::Case pressed = case_of(deck, "bearing_VelPressureDep_4");
  const cases::Case powers = case_of(deck, "bearing_VelNormalFrcDep_5", {{"normal_force", 900.0}});
  for (const double v : {0.0, 5.0, 60.0, 300.0}) {
    for (const double part : {0.3, 1.0, 2.3}) {
      const double fast = 0.085 - 0.02 * std::tanh(part);
      // The change is 0.055 over the velocity and 0.02 over the force.
      CHECK(coefficient(pressed, v, part * 7.0e4 / 0.05) ==
            Approx(fast - (fast - 0.03) * std::exp(-0.025 * v)).margin(6e-4));
      const double slow_n = 0.012 * std::pow(part, 0.8 - 1.0);
      const double fast_n = 0.018 * std::pow(part, 0.7 - 1.0);
      const double rate = v / 1000.0;
      CHECK(coefficient(powers, rate, part * 900.0) ==
            Approx(fast_n - (fast_n - slow_n) * std::exp(-25.0 * rate)).epsilon(0.03));
    }
  }
}

TEST_CASE("A faulty deck is refused with its place") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& name, const std::string& text) {
    ImportOptions options;
    options.deck = folder.write(name, text).string();
    const ImportedDeck deck = read_deck(options);
    CHECK(deck.code == base::kExitBadInput);
    CHECK(deck.cases.empty());
    return deck.messages;
  };
  CHECK_THAT(message("a.k", "*KEYWORD\n*CONTACT_SURFACE_TO_SURFACE\n1\n0.1,0.1,x\n0\n*END\n"),
             Catch::Contains("a.k:4:9: error") && Catch::Contains("DC"));
  CHECK_THAT(message("b.tcl", "frictionModel VelDependent 1 0.1 0.2\n"),
             Catch::Contains("b.tcl:1:1: error") && Catch::Contains("transRate is missing"));
  CHECK_THAT(message("c.tcl", "frictionModel Coulomb 1 $mu\n"), Catch::Contains("mu"));
  CHECK_THAT(message("d.tcl", "frictionModel Coulomb 1 0.1\nfrictionModel Coulomb 2 0.2\n"),
             Catch::Contains("choose one with --id"));
}

}  // namespace
}  // namespace slipbench::driver::commands
