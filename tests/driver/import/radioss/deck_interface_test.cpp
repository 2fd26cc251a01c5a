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
  const StarterDeck deck = split_deck(source, {"."}, diagnostics);
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
std::string card(std::initializer_list<std::pair<int, std::string>> fields) {
  constexpr std::size_t kColumn = 10;
  std::string line(10 * kColumn, ' ');
  for (const auto& [at, text] : fields) {
    line.replace(static_cast<std::size_t>(at) * kColumn, text.size(), text);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
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

TEST_CASE("The constants of a law are there as far as the law has them") {
  const std::string head =
      begin(2026) + "/INTER/TYPE7/1\nt\n" + kIds + kIds + kIds + card({{2, "0.1"}}) + kIbc;
  const std::string five = card({{0, "1"}, {2, "2"}, {4, "3"}, {6, "4"}, {8, "5"}});
  CHECK(only(head + card({{0, "0"}})).own.otherwise.c == std::array{0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  CHECK(only(head + card({{0, "2"}}) + five + card({{0, "6"}})).own.otherwise.c ==
        std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  CHECK(only(head).own.otherwise.fric == 0.1);
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
  CHECK(
      read(begin(2024) + head + fric + kIbc + laws).messages ==
      std::vector<std::string>{"10:Fric: '&mu' is no number that the deck states as a parameter"});
}

TEST_CASE("Cards that are too few or too many are found by the marks of IBC, or told") {
  const std::string fric = card({{2, "0.4"}});
  const std::string head = begin(2026) + "/INTER/TYPE7/6\nt\n" + kIds;
  CHECK(only(head + kIds + fric + kIbc).own.otherwise.fric == 0.4);
  CHECK(only(head + kIds + kIds + kIds + kIds + fric + kIbc).own.otherwise.fric == 0.4);
  const DeckInterface one = only(head + kIds + kIds + fric + card({{0, "7"}}));
  REQUIRE(one.unread.has_value());
  CHECK_THAT(*one.unread, Catch::Contains("IBC"));
  CHECK_FALSE(has_friction(one));
  CHECK(read(begin(2026) + "/INTER/TYPE2/6\nt\n" + kIds).interfaces.empty());
  CHECK(read(head + kIds + kIds + card({{2, "0.1"}}) + kIbc + card({{0, "7"}})).messages ==
        std::vector<std::string>{"5:FRIC001: unknown Ifric 7"});
}

TEST_CASE("A blank line of an interface is a card") {
  const std::string text = begin(2026) + "/INTER/TYPE7/6\nt\n" + kIds + "\n\n";
  CHECK(only(text + card({{2, "0.4"}}) + "\n").own.otherwise.fric == 0.4);
}

TEST_CASE("Numbers of a submodel count from its offsets, in its units and by its version") {
  const std::string cards = kIds + kIds + kIds + card({{2, "0.4"}}) + kIbc;
  const std::string submodel =
      "//SUBMODEL/3/0/V120\npump\n# off_def\n     10000         0         0      5000\n";
  const std::string friction = card({{0, "0"}, {9, "21"}});
  const std::string text = begin(2026) + submodel + "/INTER/TYPE7/6\nt\n" + cards + friction +
                           "//ENDSUB\n/INTER/TYPE7/7\nt\n" + cards + friction;
  const Read found = read(text);
  CHECK(found.messages.empty());
  REQUIRE(found.interfaces.size() == 2);
  CHECK(found.interfaces[0].id == 10006);
  CHECK(found.interfaces[0].friction_id == 0);  // version 120 has none
  CHECK(found.interfaces[1].id == 7);
  CHECK(found.interfaces[1].friction_id == 21);
  const std::string own =
      "/BEGIN\npump\n      2018         0\n                   g                  mm"
      "                  ms\n";
  const Read second = read(begin(2026) + submodel + own + "/INTER/TYPE7/6\nt\n" + cards + friction);
  REQUIRE(second.interfaces.size() == 1);
  CHECK(second.interfaces[0].friction_id == 10021);
  CHECK(second.interfaces[0].own.unit_id == -1);
}

TEST_CASE("Records and groups of a submodel name parts by its offset") {
  const std::string text = begin(2026) +
                           "//SUBMODEL/3\npump\n     10000         0         0      "
                           "5000\n/PART/7\np\n/GRPART/PART/2\ng\n"
                           "         7         8\n/FRICTION/1\nf\n         0\n" +
                           card({{0, "0"}}) + card({{2, "0.1"}}) + card({{0, "2"}, {3, "9"}}) +
                           card({{0, "0"}}) + card({{2, "0.2"}}) + "//ENDSUB\n/PART/7\np\n";
  const base::SourceText source("d.rad", text);
  base::Diagnostics diagnostics;
  const StarterDeck deck = split_deck(source, {"."}, diagnostics);
  const DeckContents contents = read_contents(deck, std::nullopt, diagnostics);
  REQUIRE(contents.frictions.size() == 1);
  CHECK(contents.frictions[0].id == 10001);
  REQUIRE(contents.frictions[0].pairs.size() == 1);
  CHECK(contents.frictions[0].pairs[0].sides[0].group == 10002);
  CHECK(contents.frictions[0].pairs[0].sides[1].part == 5009);
  CHECK(contents.parts == std::vector<int>{7, 5007});
  REQUIRE(contents.groups.size() == 1);
  CHECK(contents.groups[0].id == 10002);
  CHECK(contents.groups[0].parts == std::vector<int>{5007});
  CHECK(contents.groups[0].not_there == std::vector<int>{5008});
}

}  // namespace
}  // namespace slipbench::driver::radioss
