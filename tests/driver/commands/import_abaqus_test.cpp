// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_abaqus.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace slipbench::driver::commands {
namespace {

/// Writes a deck of `count` sliders with one behaviour.
std::string sliders(int count) {
  std::string text = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n*ELEMENT, TYPE=CONN3D2, ELSET=PINS\n";
  for (int i = 1; i <= count; ++i) text += std::to_string(i) + ", 1, 2\n";
  return text +
         "*CONNECTOR SECTION, ELSET=PINS, BEHAVIOR=B\nSLOT\n"
         "*CONNECTOR BEHAVIOR, NAME=B\n*CONNECTOR FRICTION, PREDEFINED\n10.\n*FRICTION\n0.1\n"
         "*STEP\n*STATIC\n0.01, 1.\n*END STEP\n";
}

ImportedDeck imported(int count, const std::string& connector, bool all) {
  ImportOptions options;
  options.deck = "deck.inp";
  options.text = base::SourceText("deck.inp", sliders(count));
  options.connector = connector;
  options.all = all;
  return import_abaqus(options);
}

TEST_CASE("A deck of many connectors is taken over in part, not as a whole") {
  CHECK(imported(20, "", true).cases.size() == 20);
  for (const bool all : {false, true}) {
    const ImportedDeck whole = imported(1001, "", all);
    CHECK(whole.code == base::kExitBadInput);
    CHECK(whole.cases.empty());
    CHECK(whole.messages.find("1001 connectors with friction are more than the 1000") !=
          std::string::npos);
    CHECK(whole.messages.find("their sections have PINS (1001)") != std::string::npos);
    CHECK(whole.messages.size() < 500);
  }
  for (const std::string chosen : {"1", "1001"}) {
    const ImportedDeck one = imported(1001, chosen, false);
    INFO(one.messages);
    CHECK(one.code == base::kExitOk);
    CHECK(one.cases.size() == 1);
    CHECK(one.messages.find("1001 connectors with friction") == 0);
  }
}

}  // namespace
}  // namespace slipbench::driver::commands
