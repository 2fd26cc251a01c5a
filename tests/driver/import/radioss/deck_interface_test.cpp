// SPDX-License-Identifier: Apache-2.0
// Friction that stands in an interface, in the layouts of its types and years.
#include "driver/import/radioss/deck_interface.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/import/radioss/deck_for_test.hpp"

namespace slipbench::driver::radioss {
namespace {

/// Interfaces of a deck, and what is said of it.
struct Read {
  std::vector<DeckInterface> interfaces;
  std::vector<std::string> messages;
};

Read read(const std::string& text) {
  const base::SourceText source("d.rad", text);
  base::Diagnostics diagnostics;
  const StarterDeck deck = split_deck(source, ".", diagnostics);
  Read read{read_interfaces(deck, diagnostics), {}};
  for (const base::Diagnostic& one : diagnostics.sorted()) {
    read.messages.push_back(fmt::format("{}:{}", one.where.line, one.message));
  }
  return read;
}

std::string begin(int version) {
  return fmt::format("#RADIOSS STARTER\n/BEGIN\nrun\n{:>10}         0\n", version);
}

/// A card of numbers at columns of 10 (from 0), two columns wide where the text is a real's.
std::string card(std::initializer_list<std::pair<int, std::string>> fields, int column = 10) {
  std::string line(std::size_t{10} * static_cast<std::size_t>(column), ' ');
  for (const auto& [at, text] : fields) {
    line.replace(static_cast<std::size_t>(at) * static_cast<std::size_t>(column), text.size(),
                 text);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

/// A card of the boundary conditions, whose digits end in the first column.
std::string ibc(std::initializer_list<std::pair<int, std::string>> fields, int column = 10) {
  std::string line = card(fields, column);
  return line.replace(0, static_cast<std::size_t>(column),
                      column == 10 ? "       101" : "     101");
}

const std::string kIds = card({{0, "1"}, {1, "2"}});
const std::string kIbc = "       000\n";

DeckInterface only(const std::string& text) {
  const Read found = read(text);
  INFO((found.messages.empty() ? "" : found.messages.front()));
  REQUIRE(found.messages.empty());
  REQUIRE(found.interfaces.size() == 1);
  return found.interfaces.front();
}

TEST_CASE("Fric, VISF, Ifric, filter and Iform of an interface stand around its card of IBC") {
  const std::string laws = card({{0, "1"}, {1, "3"}, {2, "500."}, {4, "2"}}) +
                           card({{0, "1e-3"}, {2, "2e-3"}, {4, "3e-3"}, {6, "4e-3"}, {8, "5e-3"}});
  for (const int version : {51, 100, 120, 2017, 2026}) {
    INFO("version " << version);
    for (const int type : {7, 19, 20}) {
      // Cards of gaps and curves before that of Stfac are more or fewer.
      for (int more = 0; more < 4; ++more) {
        std::string text = begin(version) + fmt::format("/INTER/TYPE{}/6\n drum\n", type) + kIds;
        for (int i = 0; i < more; ++i) text += card({{0, "0"}, {2, "1.5"}});
        text += card({{0, "1."}, {2, "0.25"}, {4, "0."}, {6, "0."}, {8, "1e30"}});
        text += ibc({{5, "0.05"}, {6, "3.0"}}) + laws;
        const DeckInterface one = only(text);
        CHECK(one.type == type);
        CHECK(one.id == 6);
        CHECK(one.own.title == "drum");
        CHECK(one.own.otherwise.fric == 0.25);
        CHECK(one.own.otherwise.visf == 3.0);
        CHECK(one.own.law == 1);
        CHECK(one.own.filter == 3);
        CHECK(one.own.xfreq == 500.0);
        CHECK(one.own.formulation == 2);
        CHECK(one.own.otherwise.c == std::array{1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 0.0});
        CHECK(one.friction_id == 0);
      }
    }
  }
}

TEST_CASE("The constants of a law are there as far as the law has them") {
  const std::string head =
      begin(2026) + "/INTER/TYPE7/1\nt\n" + kIds + kIds + kIds + card({{2, "0.1"}}) + kIbc;
  const std::string five = card({{0, "1"}, {2, "2"}, {4, "3"}, {6, "4"}, {8, "5"}});
  CHECK(only(head + card({{0, "0"}})).own.otherwise.c == std::array{0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  CHECK(only(head + card({{0, "2"}}) + five + card({{0, "6"}})).own.otherwise.c ==
        std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  CHECK(only(head).own.otherwise.fric == 0.1);
}

TEST_CASE("Interfaces of TYPE21, 24 and 25 always have the stiffness penalty") {
  for (const int type : {21, 24, 25}) {
    const DeckInterface one =
        only(begin(2022) + fmt::format("/INTER/TYPE{}/3\nself\n", type) + kIds + kIds + kIds +
             kIds + card({{2, "0.18"}}) + ibc({{6, "9."}}) + card({{0, "0"}, {4, "1"}}));
    CHECK(one.own.formulation == 2);
    CHECK(one.own.otherwise.fric == 0.18);
    CHECK(one.own.otherwise.visf == 0.0);
  }
}

TEST_CASE("An interface of TYPE11 has Coulomb's law, with Iform beside Stmin") {
  const std::string text = "/INTER/TYPE11/4\nedges\n" + kIds +
                           card({{0, "0."}, {2, "1e30"}, {8, "2"}}) + card({{2, "0.3"}}) +
                           ibc({{6, "2.5"}});
  const DeckInterface one = only(begin(2017) + text);
  CHECK(one.own.formulation == 2);
  CHECK(one.own.law == 0);
  CHECK(one.own.otherwise.fric == 0.3);
  CHECK(one.own.otherwise.visf == 2.5);
  CHECK(only(begin(2026) + text + card({{9, "17"}})).friction_id == 17);
}

TEST_CASE("Interfaces of TYPE3 and 5 have a limit of the shear stress") {
  const std::string cards = kIds + card({{0, "1."}, {2, "0.2"}}) + ibc({{8, "35."}});
  const DeckInterface third = only(begin(120) + "/INTER/TYPE3/1\nt\n" + cards);
  CHECK(third.own.otherwise.fric == 0.2);
  CHECK(third.shear_limit == 35.0);
  const DeckInterface fifth = only(begin(120) + "/INTER/TYPE5/1\nt\n" + cards + card({{0, "4"}}) +
                                   card({{0, "0.1"}, {2, "5"}}));
  CHECK(fifth.own.law == 4);
  CHECK(fifth.own.otherwise.c[1] == 5.0);
}

TEST_CASE("Decks of versions 41 and 44 have columns of eight, and the title behind the keyword") {
  const std::string text = "/INTER/TYPE7/2/lid on drum\n" + card({{0, "1"}, {1, "2"}}, 8) +
                           card({{0, "0"}}, 8) + card({{0, "1."}, {2, "0.15"}}, 8) +
                           ibc({{6, "1.5"}}, 8) + card({{0, "0"}, {4, "1"}}, 8);
  for (const int version : {41, 44}) {
    const DeckInterface one = only(begin(version) + text);
    CHECK(one.id == 2);
    CHECK(one.own.otherwise.fric == 0.15);
    CHECK(one.own.otherwise.visf == 1.5);
    CHECK(one.own.formulation == 1);
  }
}

TEST_CASE("fric_ID, a function of the temperature and parameters of the deck are read") {
  const std::string head = "/INTER/TYPE7/6\nt\n" + kIds + kIds + kIds;
  const std::string laws = card({{0, "0"}, {4, "2"}, {6, "12"}, {9, "21"}});
  const std::string fric = card({{0, "1."}, {2, "&mu"}});
  const std::string parameter = "/PARAMETER/GLOBAL/REAL/1\nmu\nmu                  0.22\n";
  DeckInterface one = only(begin(2024) + parameter + head + fric + kIbc + laws);
  CHECK(one.friction_id == 21);
  CHECK(one.temperature_function == 12);
  CHECK(one.own.otherwise.fric == 0.22);
  one = only(begin(2017) + parameter + head + fric + kIbc + laws);
  CHECK(one.friction_id == 0);
  CHECK(one.temperature_function == 12);
  one = only(begin(120) + parameter + head + fric + kIbc + laws);
  CHECK(one.temperature_function == 0);
  CHECK(read(begin(2024) + head + fric + kIbc + laws).messages ==
        std::vector<std::string>{"10:Fric: '&mu' is no number of a /PARAMETER of the deck"});
}

TEST_CASE("A card of IBC without marks stands where its type has it, or the interface is told") {
  const std::string cards = kIds + kIds + kIds + card({{2, "0.4"}}) + card({{6, "2"}}) + card({});
  CHECK(only(begin(2026) + "/INTER/TYPE7/6\nt\n" + cards).own.otherwise.fric == 0.4);
  const DeckInterface one = only(begin(2026) + "/INTER/TYPE24/6\nt\n" + cards);
  REQUIRE(one.unread.has_value());
  CHECK_THAT(*one.unread, Catch::Contains("IBC"));
  CHECK_FALSE(has_friction(one));
  CHECK(read(begin(2026) + "/INTER/TYPE2/6\nt\n" + cards).interfaces.empty());
  CHECK(read(begin(2026) + "/INTER/TYPE7/6\nt\n" + kIds + kIds + kIds + card({{2, "0.1"}}) + kIbc +
             card({{0, "7"}}))
            .messages == std::vector<std::string>{"5:FRIC001: unknown Ifric 7"});
}

}  // namespace
}  // namespace slipbench::driver::radioss
