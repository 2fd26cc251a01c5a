// SPDX-License-Identifier: Apache-2.0
// Friction of contacts in decks of LS-DYNA and OpenSees, evaluated against their formulas.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
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

/// All cases of a deck, given as text.
ImportedDeck import_text(const std::string& name, const std::string& text,
                         const TemporaryFolder& folder) {
  ImportOptions options;
  options.deck = folder.write(name, text).string();
  options.all = true;
  return read_deck(options);
}

const std::string kTable =
    "*DEFINE_TABLE\n         1\n                 1.0\n                10.0\n"
    "*DEFINE_CURVE\n        11\n                 0.0                 0.4\n"
    "              1000.0                 0.2\n"
    "*DEFINE_CURVE\n        12\n                 0.0                 0.4\n"
    "              1000.0                 0.2\n";

TEST_CASE("FS 2 has VSF in its limit, and functions of curves do not end the deck") {
  const TemporaryFolder folder;
  const std::string contact =
      "*CONTACT_SURFACE_TO_SURFACE\n1,2\n2,1,0,50\n1,1,1,1,1,1,1,0.5\n*END\n";
  const ImportedDeck deck = import_text("a.k", "*KEYWORD\n" + kTable + contact, folder);
  INFO(deck.messages);
  const cases::Case problem = case_of(deck, "a_CONTACT_1", {{"area", 4.0}});
  CHECK(problem.definitions[0].law.force_limit == Approx(0.5 * 50.0 * 4.0));
  const ImportedDeck function = import_text(
      "b.k", "*KEYWORD\n*DEFINE_CURVE_FUNCTION\n5\n0.3*sin(TIME)\n" + kTable + contact, folder);
  INFO(function.messages);
  CHECK(function.code == base::kExitOk);
}

TEST_CASE("A contact of LS-DYNA whose cards are missing is told as such") {
  const TemporaryFolder folder;
  const ImportedDeck deck =
      import_text("a.k", "*KEYWORD\n*CONTACT_SURFACE_TO_SURFACE\n1,2\n*END\n", folder);
  CHECK_THAT(deck.messages, Catch::Contains("its card with FS is missing: it has 1 card of 3"));
}

TEST_CASE("*INCLUDE takes all its files, of its folder, and others of its kind are told") {
  const TemporaryFolder folder;
  const auto contact = [](int id, const std::string& friction) {
    return "*CONTACT_SURFACE_TO_SURFACE_ID\n" + std::to_string(id) + "\n1,2\n" + friction + "\n0\n";
  };
  folder.write("one.k", contact(1, "0.1"));
  folder.write("a_long_name.k", contact(2, "0.2"));
  const ImportedDeck deck = import_text(
      "a.k", "*KEYWORD\n*INCLUDE\none.k\n$ and\na_long +\n_name.k\n" + contact(3, "0.3") + "*END\n",
      folder);
  INFO(deck.messages);
  REQUIRE(deck.cases.size() == 3);
  CHECK(coefficient(case_of(deck, "a_CONTACT_2"), 1.0, 1.0) == 0.2);
  const ImportedDeck other = import_text(
      "b.k", "*KEYWORD\n*INCLUDE_TRANSFORM\none.k\n" + contact(3, "0.3") + "*END\n", folder);
  CHECK(other.cases.size() == 1);
  CHECK_THAT(other.messages,
             Catch::Contains("b.k:2:1: warning: *INCLUDE_TRANSFORM: is not followed"));
}

TEST_CASE("*PARAMETER_EXPRESSION is evaluated, with whole numbers as integers") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& expression) {
    return import_text("a.k",
                       "*KEYWORD\n*PARAMETER\nR  half          0.5I   two         2\n"
                       "*PARAMETER_EXPRESSION\nR fs      " +
                           expression + "\n*CONTACT_SURFACE_TO_SURFACE\n1,2\n       &fs\n0\n*END\n",
                       folder);
  };
  const auto friction = [&](const std::string& expression) {
    const ImportedDeck deck = read(expression);
    INFO(deck.messages);
    REQUIRE(deck.cases.size() == 1);
    return coefficient(case_of(deck, "a_CONTACT_1"), 1.0, 1.0);
  };
  CHECK(friction("(3-1)/10.0") == Approx(0.2));
  CHECK(friction("half*&TWO/10.") == Approx(0.1));
  CHECK(friction("min(0.3,half)") == Approx(0.3));
  CHECK(friction("1/two + 1.5d-1") == Approx(0.15));
  CHECK(friction("half**2") == Approx(0.25));
  CHECK_THAT(read("half*nope").messages,
             Catch::Contains("a.k:5:16: error: *PARAMETER_EXPRESSION: unknown name 'nope'"));
}

TEST_CASE("Decks include files of their own folder alone, unless they may") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "deck");
  std::filesystem::create_symlink(folder.path() / "up.inc", folder.path() / "deck" / "link.inc");
  folder.write("up.inc", "*CONTACT_SURFACE_TO_SURFACE\n1,2\n0.1\n0\n");
  const std::string absolute = (folder.path() / "up.inc").string();
  for (const std::string& name : {std::string("../up.inc"), std::string("link.inc"), absolute}) {
    ImportOptions options;
    options.deck = folder.write("deck/a.k", "*KEYWORD\n*INCLUDE\n" + name + "\n*END\n").string();
    const ImportedDeck refused = read_deck(options);
    INFO(name << "\n" << refused.messages);
    CHECK(refused.code == base::kExitBadInput);
    CHECK_THAT(refused.messages, Catch::Contains("a.k:3:1: error: *INCLUDE: ") &&
                                     Catch::Contains("unless --allow-outside is given"));
    options.allow_outside = true;
    const ImportedDeck allowed = read_deck(options);
    INFO(allowed.messages);
    CHECK(allowed.cases.size() == 1);
  }
  ImportOptions options;
  options.deck =
      folder.write("deck/a_0000.rad", "#RADIOSS STARTER\n#include ../up.inc\n/END\n").string();
  CHECK_THAT(read_deck(options).messages,
             Catch::Contains("a_0000.rad:2:1: error: #include: '../up.inc' contains '..'"));
}

/// The coefficient of the only model of a script, or what is said of it.
std::string coulomb(const std::string& name, const std::string& script) {
  const TemporaryFolder folder;
  const ImportedDeck deck = import_text(name, script, folder);
  if (deck.cases.empty()) return deck.messages;
  CHECK(deck.cases.size() == 1);
  const cases::Case problem = case_of(deck, name.substr(0, 1) + "_Coulomb_1");
  return fmt::format("{:.6g}", coefficient(problem, 1.0, 1.0));
}

TEST_CASE("Names of a script have the value that they have where a model takes them") {
  const std::string model = "\nfrictionModel Coulomb 1 $mu\n";
  CHECK(coulomb("a.tcl", "set mu 0.1" + model + "set mu 0.2\n") == "0.1");
  CHECK(coulomb("a.tcl", "set mu [expr 1/4]" + model) == "0");
  CHECK(coulomb("a.tcl", "set mu [expr 1/4.]" + model) == "0.25");
  CHECK(coulomb("a.tcl", "set n 3\nincr n 2\nset mu [expr {$n*0.1}]" + model) == "0.5");
  CHECK(coulomb("a.tcl", "set mu 0.1\nif {0} {\n  set mu 0.7\n}" + model) == "0.1");
  CHECK(coulomb("a.tcl",
                "set k 2\nif {$k == 1} {set mu 0.7} elseif {$k > 1} {\nset mu 0.3\n} "
                "else {set mu 0.9}" +
                    model) == "0.3");
  CHECK(coulomb("a.tcl", "proc f {x} {\n  set mu 0.7\n}\nset mu 0.2" + model) == "0.2");
  CHECK_THAT(coulomb("a.tcl", "set mu 0.1\nif {[f]} {\n  set mu 0.7\n}" + model),
             Catch::Contains("mu is set in a block that may not be run"));
  CHECK_THAT(coulomb("a.tcl", "set mu 0.1\nset mu [f]" + model),
             Catch::Contains("mu is set to '[f]', which is not read as a number"));
  CHECK_THAT(coulomb("a.tcl", "set mu 0.1\nif {1} {\n  set k 3" + model),
             Catch::Contains("a.tcl:2:8: error: this brace is never closed"));
  CHECK_THAT(coulomb("a.tcl", "frictionModel Coulomb 1e99 0.1\n"),
             Catch::Contains("a tag is a whole number"));
  const std::string call = "ops.frictionModel('Coulomb', 1, mu)\n";
  CHECK(coulomb("a.py", "mu = 0.1\nmu += 0.1\n" + call + "mu = 9\n") == "0.2");
  CHECK(coulomb("a.py", "mu = 1/4\n" + call) == "0.25");
  CHECK(coulomb("a.py", "mu = 7//2*0.1\n" + call) == "0.3");
  CHECK(coulomb("a.py", "mu, k = 0.1, 2\nmu *= k\n" + call) == "0.2");
  CHECK(coulomb("a.py", "mu = 0.1\nif False:\n    mu = 0.7\n" + call) == "0.1");
  CHECK(coulomb("a.py",
                "k = 2\nif k == 1:\n  mu = 0.7\nelif k > 1:\n  mu = 0.3\nelse:\n  mu = 0.9\n" +
                    call) == "0.3");
  CHECK(coulomb("a.py", "mu = 0.2\ndef f(x):\n    mu = 0.7\n" + call) == "0.2");
  CHECK(coulomb("a.py", "def main():\n    mu = 0.7\n    " + call) == "0.7");
  CHECK_THAT(coulomb("a.py", "mu = 0.1\nfor i in range(3):\n    mu += 0.1\n" + call),
             Catch::Contains("mu is set in a block that may not be run"));
}

}  // namespace
}  // namespace slipbench::driver::commands
