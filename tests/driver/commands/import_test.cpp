// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/import/radioss/deck_for_test.hpp"
#include "tests/driver/support/checks_for_test.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

const std::string kBrake =
    "/FRICTION/7\nbrake\n" + radioss::options(0, 0, "", 2) + radioss::coulomb(".1");
const std::string kSeal =
    "/FRICTION/8\nseal\n" + radioss::options(0, 0, "", 2) + radioss::coulomb(".9");

/// A deck in a folder of its own, and where its case goes.
struct Import {
  explicit Import(const std::string& text) {
    options.deck = folder.write("d.rad", text).string();
    options.output = (folder.path() / "c.yaml").string();
  }
  TemporaryFolder folder;
  ImportOptions options;
};

/// Takes the '# ' away before the checks of the records between the parts 1 and 2.
void switch_on(const fs::path& path) {
  std::ifstream in(path);
  std::string text;
  bool on = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("  # - name:")) {
      on = line.find("1 and 2") != std::string::npos || line.find("100 and") != std::string::npos;
    }
    text += (on && line.starts_with("  # ") ? "  " + line.substr(4) : line) + "\n";
  }
  in.close();
  std::ofstream(path) << text;
}

TEST_CASE("An import writes a case that wants the values a deck does not have") {
  Import one(kBrake);
  one.options.units = "mm N s";
  REQUIRE(import_command(one.options) == base::kExitOk);
  const read::ReadCase read = read::read_case(
      one.options.output,
      {{{"K_t", 1e4}, {"normal_force", 100.0}, {"speed", 10.0}, {"time_step", 1e-4}}, false});
  INFO(base::render(read.diagnostics));
  REQUIRE(read.value);
  CHECK(read.value->units.force == "N");
  CHECK_FALSE(read::read_case(one.options.output).value);
}

TEST_CASE("Of several frictions one is chosen by its id") {
  Import two(kBrake + kSeal);
  CHECK(import_command(two.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(two.options.output));
  two.options.id = 9;
  CHECK(import_command(two.options) == base::kExitBadInput);
  two.options.id = 8;
  CHECK(import_command(two.options) == base::kExitOk);
  CHECK(fs::exists(two.options.output));
}

TEST_CASE("A fault in another friction does not hold up the chosen one") {
  Import two("/FRICTION/8\nother\n" + radioss::options(9, 0, "", 1) + radioss::coulomb(".1") +
             kBrake);
  CHECK(import_command(two.options) == base::kExitBadInput);
  two.options.id = 8;
  CHECK(import_command(two.options) == base::kExitBadInput);
  two.options.id = 7;
  CHECK(import_command(two.options) == base::kExitOk);
}

TEST_CASE("A faulty deck leaves nothing behind") {
  for (const std::string& text : {std::string(), std::string("/BEGIN\nrun\n"),
                                  kBrake.substr(0, kBrake.size() / 2), std::string("\0\1", 2)}) {
    Import faulty(text);
    CHECK(import_command(faulty.options) == base::kExitBadInput);
    CHECK_FALSE(fs::exists(faulty.options.output));
  }
}

TEST_CASE("A deck that is not there, or would be overwritten, is the machine's fault") {
  Import missing(kBrake);
  const std::string deck = missing.options.deck;
  missing.options.deck = (missing.folder.path() / "other.rad").string();
  CHECK(import_command(missing.options) == base::kExitEnvironment);
  missing.options.deck = deck;
  missing.options.output = deck;
  CHECK(import_command(missing.options) == base::kExitEnvironment);
  CHECK(fs::file_size(deck) == kBrake.size());
}

TEST_CASE("Options of an import that mean nothing are refused") {
  Import one(kBrake);
  one.options.units = "mm N";
  CHECK(import_command(one.options) == base::kExitBadInput);
  one.options.units = "mm s N";
  CHECK(import_command(one.options) == base::kExitBadInput);
  one.options.units = "mm N s";
  one.options.normal = "0 0 0";
  CHECK(import_command(one.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(one.options.output));
}

TEST_CASE("A direction along the contact's normal is FRIC009") {
  Import woven(kBrake + radioss::sides(0, 0, 1, 2, 1) + radioss::coulomb(".3") +
               radioss::coulomb(".2") + "/FRIC_ORIENT/1\nweave\n" + radioss::integers({0, 1}) +
               radioss::reals({"0", "0", "2"}));
  woven.options.normal = "0 0 1";
  CHECK(import_command(woven.options) == base::kExitBadInput);
  woven.options.normal = "0 1 1";
  CHECK(import_command(woven.options) == base::kExitOk);
  // Of a part that no orthotropic record joins it does not matter.
  Import other(kBrake + radioss::sides(0, 0, 1, 2, 1) + radioss::coulomb(".3") +
               radioss::coulomb(".2") + "/FRIC_ORIENT/1\nweave\n" + radioss::integers({0, 3}) +
               radioss::reals({"0", "0", "2"}));
  other.options.normal = "0 0 1";
  CHECK(import_command(other.options) == base::kExitOk);
}

/// The values that a case from a deck wants; those it does not want are left out.
read::ReadOptions values_for(const fs::path& path) {
  std::ifstream stream(path);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  read::ReadOptions options;
  for (const auto& [name, value] : std::vector<base::ParameterText>{{"part1", 1.0},
                                                                    {"part2", 2.0},
                                                                    {"area", 4.0},
                                                                    {"K", 5000.0},
                                                                    {"m", 1e-3},
                                                                    {"K_t", 1e4},
                                                                    {"normal_force", 100.0},
                                                                    {"speed", 30.0},
                                                                    {"time_step", 1e-5},
                                                                    {"wrap_angle", 1.0},
                                                                    {"CP2", 0.5}}) {
    if (text.find("\n  " + name + ":") != std::string::npos)
      options.overrides.push_back({name, value});
  }
  return options;
}

TEST_CASE("A case that was imported runs once its parameters have values") {
  // Sets that use all that is in them, of each Ifric, and what is empty.
  const std::vector<std::pair<int, std::string>> sets{
      {0, radioss::coulomb(".3", "4")},
      {0, radioss::coulomb("0")},
      {1, radioss::set({"-2e-4", "-1E-4", "1-6", "4e-7", "5e-8", "", ".12", "2"})},
      {1, radioss::set({"", "1e-3", "", "", "", "9", "", ""})},
      {1, radioss::set({"0", "", "", "", "", "9", "", ""})},
      {1, radioss::set({"0", "", "", "", "", "", "-.1", ""})},
      {2, radioss::set({"1e-6", "-2e-3", "-2e-4", "-1e-3", ".1", "-5e-3", ".08", ""})},
      {2, radioss::set({"", "3", "", "", "", "0", "", ""})},
      {3, radioss::set({".15", ".10", ".25", ".05", "10", "100", "", ""})},
      {3, radioss::set({".3", ".1", ".25", ".05", "10", "100", "", "3"})},
      {3, radioss::set({"-.1", ".1", ".25", ".05", "10", "100", "", ""})},
      {3, radioss::coulomb(".2")},
      {4, radioss::set({".2", ".02", "", "", "", "", ".4", ""})},
      {4, radioss::set({".4", ".02", "", "", "", "", ".2", ""})},
      {4, radioss::set({"", "7", "", "", "", "0", "", ""})}};
  const std::string head = "/BEGIN\nbrake\n      2026         0\n" +
                           fmt::format("{:>20}{:>20}{:>20}\n", "Mg", "mm", "s") +
                           "/PART/1\na\n/PART/2\nb\n/PART/3\nc\n/GRPART/PART/100\npads\n" +
                           radioss::integers({1, 3, 9}) + "/GRPART/PART/200\ndisc\n" +
                           radioss::integers({2}) + "/FRIC_ORIENT/1\nweave\n" +
                           radioss::integers({0, 1}) + radioss::reals({"1", "1", "0"});
  const std::array<std::string_view, 4> xfreq{"", "0.1", "60.", "1000"};
  int filter = 0;
  int form = 0;
  for (const auto& [law, coefficients] : sets) {
    const std::string start =
        head + "/FRICTION/7\nbrake\n" +
        radioss::options(law, filter, xfreq[static_cast<std::size_t>(filter)], form) + coefficients;
    filter = (filter + 1) % 4;
    form = (form + 1) % 3;
    for (const std::string& records :
         {std::string(), radioss::sides(0, 0, 1, 2) + coefficients,
          radioss::sides(100, 200, 0, 0) + coefficients + radioss::sides(0, 0, 2, 3) + coefficients,
          radioss::sides(100, 200, 0, 0, 1) + coefficients + coefficients}) {
      Import one(start + records);
      REQUIRE(import_command(one.options) == base::kExitOk);
      // With the checks of all records that hold switched on.
      for (const bool own_checks : {false, true}) {
        if (own_checks) switch_on(one.options.output);
        const read::ReadCase read =
            read::read_case(one.options.output, values_for(one.options.output));
        INFO(start + records + base::render(read.diagnostics, read.sources));
        REQUIRE(read.value);
        CHECK(read.value->checks.size() >= (own_checks && law < 3 ? 2 : 1));
        CHECK(failed_checks(*read.value).empty());
      }
    }
  }
}

/// The deck of a file of the tests, and where its cases go.
struct ImportOfFile {
  explicit ImportOfFile(const std::string& file) {
    options.deck = test::source_dir() + "/tests/decks/" + file;
    options.output = (folder.path() / "c.yaml").string();
  }
  TemporaryFolder folder;
  ImportOptions options;

  cases::Case only() {
    REQUIRE(import_command(options) == base::kExitOk);
    const read::ReadCase read = read::read_case(options.output, values_for(options.output));
    INFO(base::render(read.diagnostics, read.sources));
    REQUIRE(read.value);
    CHECK(failed_checks(*read.value).empty());
    return *read.value;
  }
};

TEST_CASE("Friction of a deck is found in its interfaces, its includes and its own units") {
  const cases::Case local = ImportOfFile("radioss/local_units_0000.rad").only();
  CHECK(local.units.force == "N");
  CHECK(local.units.time == "s");
  const auto mu = [](const cases::Case& problem) {
    return std::get<law::ConstantCoefficient>(problem.definitions[0].law.law).mu;
  };
  CHECK(mu(ImportOfFile("radioss/include_0000.rad").only()) == 0.25);
  const cases::Case box = ImportOfFile("radioss/type25_own_coulomb_0000.rad").only();
  CHECK(mu(box) == 0.18);
  CHECK(std::holds_alternative<law::StiffnessPenalty>(box.definitions[0].law.formulation->penalty));
  // The interface names one of two /FRICTION, in place of its own Fric.
  const cases::Case drum = ImportOfFile("radioss/type7_points_at_friction_0000.rad").only();
  CHECK(std::get<law::ExponentialDecay>(drum.definitions[0].law.law).mu_static == 0.32);
}

TEST_CASE("All joints of a deck become cases in a folder, or none if the deck has a fault") {
  ImportOfFile belt("abaqus/belt.inp");
  CHECK(import_command(belt.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(belt.options.output));
  belt.options.output = (belt.folder.path() / "cases").string();
  belt.options.all = true;
  CHECK(import_command(belt.options) == base::kExitOk);
  CHECK(fs::exists(fs::path(belt.options.output) / "belt_1.yaml"));
  CHECK(fs::exists(fs::path(belt.options.output) / "belt_2.yaml"));
  CHECK(file_count(belt.options.output) == 2);
  ImportOfFile second("abaqus/belt.inp");
  second.options.connector = "belt_b";
  CHECK(second.only().belt->has_length);

  Import wrong("*NODE\n1, 0.\n*CONNECTOR BEHAVIOR, NAME=B\n*CONNECTOR FRICTION, FORCE=1\n");
  CHECK(import_command(wrong.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(wrong.options.output));
}

TEST_CASE("A history of the model takes the place of constraint forces that a deck has not") {
  ImportOfFile hinge("abaqus/cae_hinge.inp");
  hinge.options.history =
      hinge.folder
          .write("ctf.csv",
                 "# of last "
                 "night\nTime,CRF1,crf2,CTF3,CRM2,CRM3\n0,0,0,0,0,0\n2,200,300,400,3000,4000\n")
          .string();
  const cases::Case problem = hinge.only();
  CHECK(problem.parameters.empty());
  double limit = 0.0;
  REQUIRE(bench::run_case(problem,
                          [&](const bench::Row& row) { limit = row.definitions[0].update.limit; }));
  CHECK(limit == Approx(954.0));
  hinge.options.force = true;
  hinge.options.history = hinge.folder.write("no.csv", "CRF1,CRF2\n0,0\n").string();
  CHECK(import_command(hinge.options) == base::kExitEnvironment);
}

TEST_CASE("A history above the folder of the case is refused, or taken if it may be") {
  ImportOfFile hinge("abaqus/cae_hinge.inp");
  fs::create_directory(hinge.folder.path() / "cases");
  hinge.options.output = (hinge.folder.path() / "cases" / "c.yaml").string();
  hinge.options.history =
      hinge.folder.write("ctf.csv", "t,CRF1,CRF2,CRF3,CRM2,CRM3\n0,0,10,0,0,0\n5,0,60,0,0,0\n")
          .string();
  const ImportedDeck refused = read_deck(hinge.options);
  CHECK(refused.code == base::kExitBadInput);
  CHECK(refused.messages.find("a case reads files of its own folder only") != std::string::npos);
  CHECK(import_command(hinge.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(hinge.options.output));
  hinge.options.allow_outside = true;
  CHECK(import_command(hinge.options) == base::kExitOk);
}

TEST_CASE("A history of the model goes through the steps of a deck in total time") {
  ImportOfFile hinge("abaqus/cae_hinge.inp");
  std::string deck = file_text(hinge.options.deck);
  deck += "\n*STEP\n*STATIC\n0.1, 3.\n*END STEP\n";
  hinge.options.deck = hinge.folder.write("two.inp", deck).string();
  hinge.options.history =
      hinge.folder.write("ctf.csv", "t,CRF1,CRF2,CRF3,CRM2,CRM3\n0,0,10,0,0,0\n5,0,60,0,0,0\n")
          .string();
  const cases::Case problem = hinge.only();
  REQUIRE(problem.steps.size() == 2);
  double worst = 0.0;
  double last = 0.0;
  REQUIRE(bench::run_case(problem, [&](const bench::Row& row) {
    last = row.quantities[cases::kFirstForce + 1];
    worst = std::max(worst, std::abs(last - (10.0 + 10.0 * row.time)));
  }));
  CHECK(worst < 1e-9);
  CHECK(last == Approx(60.0));
}

}  // namespace
}  // namespace slipbench::driver::commands
