// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/deck_friction.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "tests/driver/import/radioss/deck_for_test.hpp"

namespace slipbench::driver::radioss {
namespace {

using Messages = std::vector<std::string>;

const std::string kHead = "/FRICTION/7\nbrake\n";

bool says(const ReadDeck& read, const std::string& words) {
  return read.said.find(words) != std::string::npos;
}

TEST_CASE("The default and the records of a friction are read from their columns") {
  const DeckFriction friction =
      sound_friction("#RADIOSS STARTER\n/BEGIN\nrun\n      2026         0\n" + kHead + "# Ifric\n" +
                     options(1, 2, "60.", 2) + "\n" +
                     set({"-2.D-4", "-1E-4", "1-6", "4e-7", "5e-8", "", ".12", "2"}) +
                     sides(100, 200, 0, 0) + coulomb(".2") + sides(0, 0, 2, 4, 1) +
                     coulomb(".3", "3") + coulomb(".1") + "/END\nrubbish\n");
  CHECK(friction.id == 7);
  CHECK(friction.title == "brake");
  CHECK(friction.law == 1);
  CHECK(friction.filter == 2);
  CHECK(friction.xfreq == 60.0);
  CHECK(friction.formulation == 2);
  CHECK(friction.otherwise.c == std::array{-2e-4, -1e-4, 1e-6, 4e-7, 5e-8, 0.0});
  CHECK(friction.otherwise.fric == 0.12);
  CHECK(friction.otherwise.visf == 2.0);
  REQUIRE(friction.pairs.size() == 2);
  CHECK(friction.pairs[0].sides[0].group == 100);
  CHECK(friction.pairs[0].sides[1].group == 200);
  CHECK(friction.pairs[0].first.fric == 0.2);
  CHECK_FALSE(friction.pairs[0].second);
  CHECK(friction.pairs[1].sides[0].part == 2);
  CHECK(friction.pairs[1].sides[1].part == 4);
  REQUIRE(friction.pairs[1].second);
  CHECK(friction.pairs[1].second->fric == 0.1);
  CHECK(friction.pairs[1].line == 15);
}

TEST_CASE("CRLF, comments and blank lines change nothing but the line numbers") {
  std::string text =
      kHead + options(0, 0, "", 1) + coulomb(".1") + sides(0, 0, 1, 2) + coulomb(".2");
  const DeckFriction plain = sound_friction(text);
  std::string crlf;
  for (const char c : text)
    crlf += c == '\n' ? std::string("\r\n# note\r\n\r\n") : std::string(1, c);
  const DeckFriction other = sound_friction(crlf);
  CHECK(other.title == plain.title);
  REQUIRE(other.pairs.size() == 1);
  CHECK(other.pairs[0].first.fric == 0.2);
  CHECK(says(read_deck(crlf),
             "3:1: warning: /FRICTION/7: a blank line is passed over: a line "
             "without values is written as zeros"));
}

TEST_CASE("Iform 0 is the viscous penalty, and a line without the last columns is read") {
  CHECK(sound_friction(kHead + "         0\n" + coulomb(".1")).formulation == 1);
}

TEST_CASE("A deck that is cut inside a block is incomplete at its last line") {
  const std::string whole = kHead + options(0, 0, "", 1) + coulomb(".1") + sides(0, 0, 1, 2, 1) +
                            coulomb(".2") + coulomb(".3");
  CHECK(read_deck(whole).messages.empty());
  // Cut line by line: of the ten lines only the first five and all ten are whole.
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole[i] == '\n') ends.push_back(i + 1);
  }
  REQUIRE(ends.size() == 10);
  for (std::size_t lines = 1; lines < 10; ++lines) {
    const ReadDeck cut = read_deck(whole.substr(0, ends[lines - 1]));
    INFO(lines << " lines: " << cut.said);
    CHECK(says(cut, "FRIC006: incomplete block") == (lines != 5));
    CHECK(cut.contents.frictions.empty() == (lines != 5));
  }
  CHECK(read_deck(whole.substr(0, ends[7])).messages ==
        Messages{"8:1: error: /FRICTION/7: FRIC006: incomplete block: the line of C1 .. C5 along "
                 "direction 2 is missing behind this one"});
}

TEST_CASE("Numbers outside their columns are read with a warning") {
  const ReadDeck read = read_deck(kHead + "0 1 0.5 2\n0 0 0 0 0\n0 0.25 1\n1 2 0 0 1\n" +
                                  "0 0 0 0 0\n0 0.3 1\n0 0 0 0 0\n0 0.1 1\n");
  INFO(read.said);
  CHECK(read.messages.front() ==
        "3:1: warning: /FRICTION/7: read in free format: the numbers of Ifric, Ifiltr, Xfreq, "
        "Iform do not stand in their columns");
  REQUIRE(read.contents.frictions.size() == 1);
  const DeckFriction& friction = read.contents.frictions[0];
  CHECK(friction.xfreq == 0.5);
  CHECK(friction.formulation == 2);
  CHECK(friction.otherwise.fric == 0.25);
  REQUIRE(friction.pairs.size() == 1);
  CHECK(friction.pairs[0].sides[1].group == 2);
  CHECK(friction.pairs[0].second->fric == 0.1);
}

TEST_CASE("A word where a number belongs is refused at its column") {
  CHECK(read_deck(kHead + options(0, 0, "abc", 1) + coulomb(".1")).messages ==
        Messages{"3:38: error: /FRICTION/7: Ifric, Ifiltr, Xfreq, Iform: wanted a number, found "
                 "'abc'"});
}

TEST_CASE("Options beyond the known ones are refused") {
  CHECK(read_deck(kHead + options(5, 0, "", 1) + coulomb(".1")).messages ==
        Messages{"3:10: error: /FRICTION/7: FRIC001: unknown Ifric 5; 0 Coulomb, 1 generalised "
                 "viscous, 2 modified Darmstad, 3 Renard, 4 exponential decay"});
  CHECK(says(read_deck(kHead + options(0, 4, "", 1) + coulomb(".1")), "FRIC002: unknown Ifiltr 4"));
  CHECK(says(read_deck(kHead + options(0, 0, "", 3) + coulomb(".1")), "unknown Iform 3"));
}

TEST_CASE("Filter coefficients keep alpha between 0 and 1") {
  const auto read = [](int filter, std::string_view xfreq) {
    return read_deck(kHead + options(0, filter, xfreq, 1) + coulomb(".1"));
  };
  CHECK(read(1, "1").messages.empty());
  CHECK(says(read(1, "1.0001"),
             "3:35: error: /FRICTION/7: FRIC002: Ifiltr 1 wants alpha = Xfreq "
             "between 0 and 1, found Xfreq 1.0001"));
  CHECK(says(read(1, "-0.1"), "FRIC002"));
  CHECK(read(2, "6.2832").messages.empty());
  CHECK(says(read(2, "6.2831"), "FRIC002"));
  CHECK(read(3, "1000").messages.empty());
  CHECK(says(read(3, "-0.1"), "FRIC002"));
  CHECK(says(read(3, ""), "warning: /FRICTION/7: Ifiltr 3 with Xfreq 0 filters nothing"));
}

TEST_CASE("Negative coefficients are refused where they mean nothing") {
  CHECK(says(read_deck(kHead + options(0, 0, "", 1) + coulomb("-.1")),
             "FRIC007: Fric must not be negative, found -0.1"));
  CHECK(says(read_deck(kHead + options(0, 0, "", 1) + coulomb(".1", "-2")),
             "5:59: error: /FRICTION/7: FRIC007: VISF must not be negative, found -2"));
  // The constant part of a polynomial may have either sign.
  CHECK(read_deck(kHead + options(1, 0, "", 1) + set({"", "1", "", "", "", "", "-.1", ""}))
            .messages.empty());
}

TEST_CASE("A record names something on both sides") {
  const std::string head = kHead + options(0, 0, "", 1) + coulomb(".1");
  const ReadDeck one_side = read_deck(head + sides(0, 0, 1, 0) + coulomb(".2"));
  CHECK(says(one_side,
             "6:1: error: /FRICTION/7: FRIC003: side 2 of the record names no group and "
             "no part; OpenRadioss passes over such a record in silence"));
  CHECK(says(read_deck(head + sides(0, 0, -1, 2) + coulomb(".2")), "FRIC003"));
  const ReadDeck both = read_deck(head + sides(100, 200, 3, 0) + coulomb(".2"));
  CHECK(says(both, "side 1 of the record names group 100 and part 3: the group counts"));
  CHECK(both.contents.frictions[0].pairs[0].sides[0].part == 0);
}

const Messages kMissingFile{
    "1:1: warning: #include: the file cannot be read: what it has is missing here; files that a "
    "deck includes are looked for in its folder"};

TEST_CASE("Parts are looked up where the deck has all of them") {
  const std::string friction =
      kHead + options(0, 0, "", 1) + coulomb(".1") + sides(0, 0, 1, 9) + coulomb(".2");
  const std::string parts = "/PART/1\none\n1 1\n/PART/2\ntwo\n1 1\n";
  CHECK(read_deck(friction).messages.empty());
  CHECK(says(read_deck(parts + friction), "FRIC003: the deck has no part 9"));
  CHECK(read_deck("#include more.rad\n" + parts + friction).messages == kMissingFile);
  // Behind //SUBMODEL ids count from an offset, if there is one.
  const std::string none = "//SUBMODEL/1\nleft\n" + parts + "//ENDSUB\n" + friction;
  CHECK(read_deck(none).messages ==
        Messages{"15:1: error: /FRICTION/7: FRIC003: the deck has no part 9"});
  const std::string shifted =
      "//SUBMODEL/1\nleft\n" + integers({8}) + parts + "//ENDSUB\n/PART/1\none\n" + friction;
  CHECK(read_deck(shifted).messages.empty());
}

TEST_CASE("Parts that a group lists and the deck does not have are left out of it") {
  const std::string parts = "/PART/1\none\n1 1\n/PART/2\ntwo\n1 1\n";
  const std::string groups = "/GRPART/PART/100\nbody\n" + integers({9, 1, 2}) +
                             "/GRPART/PART/200\nlid\n" + integers({8, 7});
  const std::string friction = kHead + options(0, 0, "", 1) + coulomb(".1") +
                               sides(100, 200, 0, 0) + coulomb(".2") + sides(100, 100, 0, 0) +
                               coulomb(".3");
  const ReadDeck read = read_deck(groups + parts + friction);
  CHECK(read.messages ==
        Messages{"18:1: warning: /FRICTION/7: FRIC003: the deck has no part 9, which group 100 "
                 "lists; it is left out of the group",
                 "18:1: warning: /FRICTION/7: FRIC003: the deck has no part 7, 8, which group 200 "
                 "lists; it is left out of the group",
                 "18:1: warning: /FRICTION/7: the deck does not list the parts of group 200; list "
                 "them under 'G200' of the case"});
  CHECK(find_group(read.contents, 100)->parts == std::vector<int>{1, 2});
  const ReadDeck more = read_deck("#include more.rad\n" + groups + parts + friction);
  CHECK(more.messages == kMissingFile);
  CHECK(find_group(more.contents, 100)->parts == std::vector<int>{1, 2, 9});
}

TEST_CASE("A group is its parts where the deck lists them, and else waits for them") {
  const std::string friction =
      kHead + options(0, 0, "", 1) + coulomb(".1") + sides(100, 200, 0, 0) + coulomb(".2");
  const ReadDeck read =
      read_deck("/GRPART/PART/100\nbody\n" + integers({3, 1, 2, 5}) + integers({-5, 4}) +
                "/GRPART/MAT/200\nsteels\n" + integers({1}) + friction);
  const DeckGroup* body = find_group(read.contents, 100);
  REQUIRE(body != nullptr);
  CHECK(body->title == "body");
  CHECK(body->parts == std::vector<int>{1, 2, 3, 4});
  REQUIRE(find_group(read.contents, 200) != nullptr);
  CHECK(find_group(read.contents, 200)->parts.empty());
  CHECK(find_group(read.contents, 300) == nullptr);
  REQUIRE(read.messages.size() == 1);
  CHECK(
      read.messages[0] ==
      "13:1: warning: /FRICTION/7: the deck does not list the parts of group 200; list them under "
      "'G200' of the case");
}

TEST_CASE("Renard sets are held against their rules, which are quoted") {
  const auto read = [](std::array<std::string_view, 6> c) {
    return read_deck(kHead + options(3, 0, "", 1) +
                     set({c[0], c[1], c[2], c[3], c[4], c[5], "", ""}));
  };
  CHECK(read({".15", ".10", ".25", ".05", "10", "100"}).messages.empty());
  CHECK(says(read({".15", ".04", ".25", ".05", "10", "100"}),
             "error: /FRICTION/7: FRIC004: Renard wants C4 <= C2 (found C1 0.15, C2 0.04"));
  CHECK(says(read({".15", ".10", ".25", ".05", "0", "100"}), "FRIC004: Renard wants C5 > 0"));
  CHECK(says(read({".15", ".10", ".25", ".05", "100", "100"}), "FRIC004: Renard wants C5 < C6"));
  CHECK(says(read({".3", ".10", ".25", ".05", "10", "100"}),
             "warning: /FRICTION/7: FRIC004: Renard wants C1 <= C3"));
  CHECK(says(read({".15", ".3", ".25", ".05", "10", "100"}), "FRIC004: Renard wants C2 <= C3"));
  CHECK(says(read({".04", ".10", ".25", ".05", "10", "100"}), "FRIC004: Renard wants C4 <= C1"));
  // A set of zeros is no friction, not a broken rule.
  CHECK(read({"0", "", "", "", "", "0"}).messages.empty());
  CHECK(read_deck(kHead + options(3, 0, "", 1) + coulomb(".2")).messages ==
        Messages{"5:1: warning: /FRICTION/7: Fric is not used by Ifric 3, found 0.2"});
}

TEST_CASE("What is said of C6 and Fric points at their line, the second of the set") {
  CHECK(read_deck(kHead + options(0, 0, "", 1) + coulomb("-.1")).messages ==
        Messages{"5:1: error: /FRICTION/7: FRIC007: Fric must not be negative, found -0.1"});
  const ReadDeck growing =
      read_deck(kHead + options(2, 0, "", 1) + set({"", "", "1", "3", "1", "7", ".1", ""}));
  CHECK(says(growing, "4:1: warning: /FRICTION/7: FRIC008: C4 is positive"));
  CHECK(says(growing, "5:1: warning: /FRICTION/7: FRIC008: C6 is positive"));
}

TEST_CASE("Faults of a friction that is not chosen are warnings") {
  const std::string good = kHead + options(0, 0, "", 1) + coulomb(".1");
  const std::string bad = "/FRICTION/8\nother\n" + options(9, 0, "", 1) + coulomb(".1");
  const ReadDeck read = read_deck(bad + good, 7);
  REQUIRE(read.messages.size() == 1);
  CHECK(says(read, "3:10: warning: /FRICTION/8: FRIC001: unknown Ifric 9"));
  CHECK(says(read, "the block is passed over"));
  REQUIRE(read.contents.frictions.size() == 1);
  CHECK(says(read_deck(bad + good, 8), "error: /FRICTION/8: FRIC001"));
  CHECK(says(read_deck(bad + good), "error: /FRICTION/8: FRIC001"));
  // So are those of directions that no record needs.
  const std::string direction = "/FRIC_ORIENT/1\nweave\n" + integers({0, 1}) + "abc\n";
  CHECK(says(read_deck(good + direction), "warning: /FRIC_ORIENT/1: Vx, Vy"));
  CHECK(says(read_deck(good + sides(0, 0, 1, 2, 1) + coulomb(".3") + coulomb(".2") + direction),
             "error: /FRIC_ORIENT/1: Vx, Vy"));
}

TEST_CASE("Directions count for the orthotropic records that join their part") {
  const std::string friction = kHead + options(0, 0, "", 1) + coulomb(".1") + sides(0, 0, 1, 2, 1) +
                               coulomb(".3") + coulomb(".2") + sides(100, 0, 0, 2, 1) +
                               coulomb(".3") + coulomb(".2") + sides(0, 0, 5, 6) + coulomb(".3");
  const ReadDeck read =
      read_deck("/GRPART/PART/100\nbody\n" + integers({3, 4}) + "/GRPART/PART/200\nlid\n" +
                integers({4, 5}) + "/GRPART/PART/300\nrim\n" + integers({5, 6}) + friction);
  REQUIRE(read.contents.frictions.size() == 1);
  const auto used = [&](int group, int part) {
    DeckContents contents = read.contents;
    contents.orientations = {DeckOrientation{.of = {group, part}}};
    return !used_orientations(contents, contents.frictions[0]).empty();
  };
  for (const int part : {1, 2, 3, 4}) CHECK(used(0, part));
  for (const int part : {5, 6, 7}) CHECK_FALSE(used(0, part));
  CHECK(used(100, 0));
  CHECK(used(200, 0));
  CHECK_FALSE(used(300, 0));
  CHECK(used(400, 0));  // whose parts the deck does not list
}

TEST_CASE("Units of /BEGIN are units of mass, length and time, in this order") {
  const auto begin = [](const std::string& units) {
    return read_deck("/BEGIN\nrun\n      2026         0\n" + units + "\n").contents;
  };
  const auto faults = [&](const std::string& units) {
    const DeckContents contents = begin(units);
    CHECK_FALSE(contents.units);
    std::vector<std::string> said;
    for (const DeckFault& fault : contents.unit_faults) said.push_back(fault.message);
    return said;
  };
  const DeckContents crash = begin("                 ton                  mm                   s");
  REQUIRE(crash.units);
  CHECK(crash.unit_faults.empty());
  CHECK(crash.units->force == "N");
  CHECK(begin("kg\tmm\tms").units->force == "kN");
  CHECK(begin("g cm mus").units.has_value() == false);
  CHECK(faults("g cm mus") == Messages{"no unit of force has a name that goes with g, cm and us: "
                                       "it is 1e+07 N"});
  CHECK(faults("Mg mm Mg") == Messages{"wanted a unit of time, found 'Mg'"});
  CHECK(faults("mm Mg s") ==
        Messages{"wanted a unit of mass, found 'mm'", "wanted a unit of length, found 'Mg'"});
  CHECK(faults("kg mm") == Messages{"the unit of time is missing"});
  CHECK(begin("").unit_faults.empty());
}

TEST_CASE("Messages about a keyword of any length are short") {
  CHECK(read_deck("/FRICTION/7/" + std::string(200000, 'x') + "\nbrake\n").said.size() < 1000);
}

TEST_CASE("What a case needs beyond the deck, or what the deck has in vain, is said once") {
  const ReadDeck area =
      read_deck(kHead + options(1, 0, "", 1) + set({"1e-3", "", "", "", "", "", ".1", ""}) +
                sides(0, 0, 1, 2) + set({"1e-3", "", "", "", "", "5", ".1", ""}));
  CHECK(area.messages.size() == 2);
  CHECK(says(area, "4:1: warning: /FRICTION/7: FRIC005: the coefficients see the pressure"));
  CHECK(says(area, "8:1: warning: /FRICTION/7: C6 is not used by Ifric 1, found 5"));
  const ReadDeck growing =
      read_deck(kHead + options(2, 0, "", 1) + set({"", "", "", "", ".1", "7", ".1", ""}));
  CHECK(says(growing,
             "FRIC008: C6 is positive: exp(C6 V) grows with the speed and overflows "
             "beyond V = 100"));
}

TEST_CASE("What the program makes of a record is said with it") {
  const std::string head = kHead + options(1, 0, "", 1) + coulomb(".1");
  CHECK(says(read_deck("/GRPART/PART/100\nbody\n" + integers({1}) + head + sides(100, 0, 0, 2) +
                       coulomb(".2")),
             "the record joins a part and a group: OpenRadioss may use other coefficients"));
  CHECK(says(read_deck(head + sides(0, 0, 1, 2, 1) + coulomb(".2") + coulomb(".3")),
             "an orthotropic record with Ifric 1: OpenRadioss may use other coefficients"));
  const ReadDeck interfaces = read_deck("/INTER/TYPE7/1\n/INTER/TYPE11/2\n/INTER/TYPE24/3\n" +
                                        kHead + options(0, 0, "", 1) + coulomb(".1") +
                                        sides(0, 0, 1, 2, 1) + coulomb(".2") + coulomb(".3"));
  CHECK(says(interfaces, "note: /FRICTION/7: an interface of TYPE24 always uses the stiffness"));
  CHECK(says(interfaces, "note: /FRICTION/7: an interface of TYPE11 uses only Fric"));
  CHECK(says(interfaces, "an interface of TYPE11 has no orthotropic friction"));
  CHECK_FALSE(says(interfaces, "TYPE7 "));
}

TEST_CASE("Two frictions of one id are refused") {
  const std::string one = kHead + options(0, 0, "", 1) + coulomb(".1");
  CHECK(says(read_deck(one + one), "6:1: error: /FRICTION/7: stands twice, first in line 1"));
}

TEST_CASE("The units of a deck give the force that goes with them") {
  const auto units = [](const std::string& mass, const std::string& length,
                        const std::string& time) {
    return read_deck("/BEGIN\nrun\n      2026         0\n" + reals({mass, length, time}) +
                     reals({mass, length, time}))
        .contents.units;
  };
  REQUIRE(units("Mg", "mm", "s"));
  CHECK(units("Mg", "mm", "s")->force == "N");
  CHECK(units("kg", "mm", "ms")->force == "kN");
  CHECK(units("kg", "m", "s")->force == "N");
  CHECK(units("g", "mm", "ms")->force == "N");
  CHECK(units("kg", "mm", "ms")->time == "ms");
  CHECK(units("g", "mm", "mus")->time == "us");
  CHECK_FALSE(units("g", "cm", "us"));
  CHECK_FALSE(units("stone", "mm", "s"));
}

TEST_CASE("Directions are read, an empty one is the x axis") {
  const ReadDeck read = read_deck(
      "/FRIC_ORIENT/3\nweave\n" + integers({0, 4}) + reals({"0", "1", "1"}).substr(0, 60) +
      fmt::format("{:>10}{:>20}{:>10}\n", 0, "0.5", 0) + integers({100, 0}) + "         0\n");
  INFO(read.said);
  REQUIRE(read.contents.orientations.size() == 2);
  const DeckOrientation& first = read.contents.orientations[0];
  CHECK(first.of.part == 4);
  CHECK(first.vector == std::array{0.0, 1.0, 1.0});
  CHECK(first.phi == 0.5);
  CHECK(read.contents.orientations[1].of.group == 100);
  CHECK(read.contents.orientations[1].vector == std::array{1.0, 0.0, 0.0});
  const auto in_plane = direction_in_plane(first, {0.0, 0.0, 2.0});
  REQUIRE(in_plane);
  CHECK(*in_plane == std::array{0.0, 1.0, 0.0});
  CHECK_FALSE(direction_in_plane(first, {0.0, 3.0, 3.0}));
}

TEST_CASE("Bytes that are no text are refused at once") {
  const std::string binary = kHead + std::string("\0\1\2", 3) + options(0, 0, "", 1);
  CHECK(read_deck(binary).messages ==
        Messages{"3:1: error: is no text: a starter deck has no control characters"});
  CHECK(says(read_deck("/FRICTION/1\rtitle\r"), "a carriage return stands without a line feed"));
  // Titles of all encodings pass.
  CHECK(read_deck("/FRICTION/1\nBremsbel\xE4ge\n" + options(0, 0, "", 1) + coulomb(".1"))
            .messages.empty());
}

TEST_CASE("No piece of a deck upsets the reader") {
  const std::string whole = kHead + options(3, 2, "60", 1) +
                            set({".15", ".10", ".25", ".05", "10", "100", "", "1"}) +
                            sides(0, 0, 1, 2, 1) + coulomb(".2") + coulomb(".3");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const ReadDeck read = read_deck(whole.substr(0, length));
    for (const std::string& message : read.messages) CHECK_FALSE(message.empty());
  }
}

TEST_CASE("An id behind an offset stays an int") {
  constexpr int kLargest = std::numeric_limits<int>::max();
  CHECK(with_offset(3, 100) == 103);
  CHECK(with_offset(0, 100) == 0);
  CHECK(with_offset(kLargest, 100) == kLargest);
  CHECK(with_offset(3, -100) == 0);
}

}  // namespace
}  // namespace slipbench::driver::radioss
