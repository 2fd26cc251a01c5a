// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/translate.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

const std::string kDecks = test::source_dir() + "/tests/decks/";

/// The only joint of a deck, in the words of a program, with 100 for all that it asks.
DeckOutput take(const std::string& text, const std::string& program) {
  ImportOptions options;
  options.deck = "deck";
  options.text = base::SourceText("deck", text);
  options.all = true;
  const ImportedDeck deck = read_deck(options);
  INFO(deck.messages);
  REQUIRE(deck.cases.size() == 1);
  std::vector<base::ParameterText> values;
  for (const std::string& name : deck.cases[0].written.asked) {
    values.push_back({name, name == "part1" ? 7.0 : name == "part2" ? 9.0 : 100.0});
  }
  DeckOutputOptions form;
  form.to = program;
  auto made = translated(deck.cases[0].written, values, form);
  INFO(deck.cases[0].written.text << "\n" << (made ? made->deck.text : made.error()));
  REQUIRE(made);
  INFO((made->difference ? "" : made->difference.error()));
  REQUIRE(made->difference);
  return std::move(*made);
}

std::string slot(const std::string& friction) {
  return "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n"
         "*CONNECTOR SECTION, ELSET=PIN, BEHAVIOR=B\nSLOT\n*CONNECTOR BEHAVIOR, NAME=B\n"
         "*CONNECTOR FRICTION, PREDEFINED\n10.\n" +
         friction + "*STEP\n*STATIC\n0.01, 1.\n*CONNECTOR MOTION\nPIN, 1, 20.\n*END STEP\n";
}

TEST_CASE("A constant and a decay of Abaqus keep all digits in programs of contacts") {
  for (const std::string friction :
       {"*FRICTION\n0.17,\n", "*FRICTION, EXPONENTIAL DECAY\n0.3, 0.1, 0.07\n"}) {
    for (const std::string program : {"radioss", "lsdyna", "opensees"}) {
      const DeckOutput made = take(slot(friction), program);
      INFO(made.deck.text << analysis::difference_text(*made.difference));
      CHECK(made.difference->is_none());
      CHECK(made.difference->dissipation > 0.0);
    }
  }
}

TEST_CASE("A translation says of nothing that it is kept which the other deck drops") {
  const DeckOutput made = take(
      "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n"
      "*CONNECTOR SECTION, ELSET=PIN, BEHAVIOR=B\nSLOT\n*CONNECTOR BEHAVIOR, NAME=B\n"
      "*CONNECTOR FRICTION, PREDEFINED\n10.\n*FRICTION\n0.2,\n"
      "*CONNECTOR ELASTICITY, COMPONENT=1\n5.,\n"
      "*STEP\n*STATIC\n0.01, 1.\n*CONNECTOR MOTION\nPIN, 1, 20.\n*END STEP\n"
      "*STEP\n*STATIC\n0.01, 1.\n*CONNECTOR MOTION\nPIN, 1, 40.\n"
      "*CHANGE FRICTION, ELSET=PIN\n*FRICTION\n0.7,\n*END STEP\n",
      "lsdyna");
  const std::string report = loss_report(made.deck.losses);
  INFO(report);
  CHECK(report.find("kept: 1 component") == std::string::npos);
  CHECK(report.find("kept: 2 steps") == std::string::npos);
  CHECK(report.find("dropped: springs, dampers and stops") != std::string::npos);
  CHECK(report.find("dropped: changes of friction") != std::string::npos);
  CHECK_FALSE(made.difference->is_none());
}

TEST_CASE("VISF of an interface is squared, as that of the /FRICTION which takes its place") {
  const std::string head =
      "#RADIOSS STARTER\n/BEGIN\ndrum\n      2026         0\n"
      "                  Mg                  mm                   s\n"
      "                  Mg                  mm                   s\n";
  const DeckOutput interface =
      take(head +
               "/INTER/TYPE7/6\nlining on drum\n"
               "         1         2         0         0         0                   0         0\n"
               "                   0                   0                   0                   0\n"
               "                   0                   0                   0                   0\n"
               "                   1                 0.3                   0                   0\n"
               "       000                             0                   0                 0.5\n"
               "         0         0                   0         1         0                   "
               "0\n/END\n",
           "radioss");
  INFO(loss_report(interface.deck.losses));
  CHECK(interface.deck.text.find("0.3                0.25\n") != std::string::npos);
  const std::string told = loss_report(interface.deck.losses);
  CHECK(told.find("VISF 0.5 of the interface is 0.25 here") != std::string::npos);
  CHECK(told.find("kept: VISF 0.25: C = sqrt(VISF) sqrt(2 K m)") != std::string::npos);
  const DeckOutput card =
      take(head + "/FRICTION/1\nlining\n" +
               "         0         0                   0         1\n"
               "                   0                   0                   0                   0"
               "                   0\n"
               "                   0                 0.3                 0.5\n/END\n",
           "radioss");
  CHECK(card.deck.text.find("0.3                 0.5\n") != std::string::npos);
  CHECK(loss_report(card.deck.losses).find("approximated: VISF 0.5: C = VISF sqrt(2 K m)") !=
        std::string::npos);
}

TEST_CASE("The slip rate is told of only where a coefficient depends on it") {
  const std::string head =
      "#RADIOSS STARTER\n/BEGIN\npads\n      2022         0\n"
      "                  Mg                  mm                   s\n"
      "                  Mg                  mm                   s\n/FRICTION/1\npads\n";
  const auto told = [&](const std::string& law, const std::string& c1, const std::string& c2) {
    const DeckOutput made =
        take(head + "         " + law + "         0                   0         2\n" +
                 fmt::format("{:>20}{:>20}{:>20}{:>20}{:>20}\n", c1, c2, 0, 0, 0) +
                 "                   0                 0.3                   0\n/END\n",
             "abaqus");
    return loss_report(made.deck.losses).find("slip_rate: relative_motion") != std::string::npos;
  };
  CHECK_FALSE(told("0", "0", "0"));
  CHECK(told("4", "0.1", "0.004"));
}

TEST_CASE("Records of part pairs of Radioss keep all digits in LS-DYNA") {
  const DeckOutput made = take(
      "#RADIOSS STARTER\n/BEGIN\npads\n      2022         0\n"
      "                  Mg                  mm                   s\n"
      "                  Mg                  mm                   s\n"
      "/FRICTION/1\npairs\n#    Ifric   Ifiltr               Xfreq     Iform\n"
      "         4         0                   0         2\n"
      "               0.123                0.02                   0                   0"
      "                   0\n                   0                 0.2                   0\n"
      "         0         0         7         9                    0\n"
      "               0.234                0.01                   0                   0"
      "                   0\n                   0               0.456                   0\n/END\n",
      "lsdyna");
  INFO(made.deck.text << analysis::difference_text(*made.difference));
  CHECK(made.difference->is_none());
  CHECK(made.difference->dissipation > 0.0);
  CHECK(made.deck.text.find("*DEFINE_FRICTION") != std::string::npos);
}

TEST_CASE("What the deck has no number for is asked for only if the other deck depends on it") {
  TemporaryFolder folder;
  const std::string line = kProgram + " translate " + kDecks + "lsdyna/brake.k --interface 6 --to ";
  const Ended asks = shell(folder, line + "table -o a.csv");
  CHECK(asks.code == base::kExitBadInput);
  CHECK(
      asks.output.find("the deck for table depends on area, normal_force: give them with --set") !=
      std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "a.csv"));
  const Ended done = shell(folder, line + "table -o a.csv --set area=4 --set normal_force=40");
  INFO(done.output);
  CHECK(done.code == base::kExitOk);
  CHECK(done.output.find("not measured: give K_t, speed, time_step with --set") !=
        std::string::npos);
  const Ended unknown = shell(folder, line + "table --set mu=0.3");
  CHECK(unknown.code == base::kExitBadInput);
  CHECK(unknown.output.find("--set mu: nothing of this name is asked for") != std::string::npos);
}

TEST_CASE("All contacts of a deck are translated, and those that cannot be are told") {
  TemporaryFolder folder;
  const Ended done = shell(folder, kProgram + " translate " + kDecks +
                                       "lsdyna/brake.k --all --to radioss -o out --json");
  CHECK(done.code == base::kExitBadInput);
  CHECK(done.output.find("6: is not translated: Radioss has no coefficient table") !=
        std::string::npos);
  CHECK(std::filesystem::exists(folder.path() / "out/brake_CONTACT_3_0000.rad"));
  CHECK(std::filesystem::exists(folder.path() / "out/brake_CONTACT_4_0000.rad"));
  CHECK(done.output.find("\"deck\": \"out/brake_CONTACT_4_0000.rad\"") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::commands
