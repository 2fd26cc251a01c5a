// SPDX-License-Identifier: Apache-2.0
// A deck of each layout that an interface with friction has had, from version 41 to 2026. The cards
// follow OpenRadioss's reader configuration of these versions.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "driver/import/radioss/deck_interface.hpp"
#include "tests/driver/import/radioss/deck_for_test.hpp"

namespace slipbench::driver::radioss {
namespace {

/// Cards as "name:width .."; '-' is blank, '*' a number that is no friction, names are those below.
struct Layout {
  int type;
  int since;
  std::vector<std::string> cards;
};

// Cards that many layouts share.
const std::string kFric = "*:20 FRIC:20 *:20 *:20 *:20";
const std::string kFricOld = "*:16 FRIC:16 *:16 *:16 *:16";
const std::string kViscous = "IBC:10 -:20 *:10 *:20 VISF:20 *:20";
const std::string kViscousOld = "IBC:8 -:16 *:8 *:16 VISF:16 *:16";
const std::string kStiff = "IBC:10 -:20 *:10 *:20";
const std::string kFive = "C1:20 C2:20 C3:20 C4:20 C5:20";
const std::string kSix = "C6:20";
const std::string kStiffnesses = "*:20 *:20 *:20 *:20 *:10 *:10";
const std::string kIds = "*:10 *:10 *:10 *:10 *:10 *:10 *:10 *:10 ICURV:10 *:10";
const std::string kNodes = "NODE:10 NODE:10";
const std::string kLaw = "IFRIC:10 IFILTR:10 XFREQ:20 IFORM:10";
const std::string kLawStiff = "IFRIC:10 IFILTR:10 XFREQ:20";

const std::vector<Layout> kLayouts = {
    {3, 41, {"*:8 *:8", kFricOld, "IBC:8 *:8 *:8"}},
    {3, 51, {"*:10 *:10 -:50 *:10", kFric, "IBC:10 *:10 *:10"}},
    {3, 2018, {"*:10 *:10 -:50 *:10", kFric, "IBC:10 *:10 *:10", "-:60 PTLIM:20"}},
    {5, 41, {"*:8 *:8", kFricOld, "IBC:8 -:8 *:8"}},
    {5, 42, {"*:8 *:8 -:16 IFRIC:8", kFricOld, "IBC:8 -:8 *:8", "C1:16 C2:16 C3:16 C4:16 C5:16"}},
    {5,
     44,
     {"*:8 *:8 -:32 *:8", kFricOld, "IBC:8 -:8 *:8", "IFRIC:8 IFILTR:8 XFREQ:16",
      "C1:16 C2:16 C3:16 C4:16 C5:16", "C6:16"}},
    {5, 51, {"*:10 *:10 -:40 *:10 *:10", kFric, "IBC:10 -:10 *:10", kLawStiff, kFive, kSix}},
    {5,
     120,
     {"*:10 *:10 -:40 *:10 *:10", kFric, "IBC:10 -:10 *:10 *:10", kLawStiff + " -:10 *:10", kFive,
      kSix}},
    {5,
     2018,
     {"*:10 *:10 -:40 *:10 *:10", kFric, "IBC:10 -:10 *:10 *:10", kLawStiff + " -:10 *:10 PTLIM:20",
      kFive, kSix}},
    {7, 41, {"*:8 *:8 *:8 -:8 *:8 *:8", kFricOld, kViscousOld}},
    {7,
     44,
     {"*:8 *:8 *:8 -:8 *:8 *:8 *:8 *:8", kFricOld, kViscousOld,
      "IFRIC:8 IFILTR:8 XFREQ:16 "
      "IFORM:8"}},
    {7, 51, {kIds, "*:20 *:20", "*:20 *:20", kNodes, kFric, kViscous, kLaw, kFive, kSix}},
    {7, 90, {kIds, "*:20 *:20", "*:20 *:20", kNodes, kFric, kViscous, kLaw, kFive, kSix, "*:20"}},
    {7, 110, {kIds, "*:20 *:20", "*:20 *:20 *:20", kNodes, kFric, kViscous, kLaw, kFive, kSix}},
    {7,
     120,
     {kIds, "*:20 *:20 *:20", kStiffnesses, kNodes, kFric, kViscous, kLaw + " *:10", kFive, kSix}},
    {7,
     140,
     {kIds, "*:20 *:20 *:20", kStiffnesses, kNodes, kFric, kViscous,
      kLaw + " *:10 FUNCTION:10 *:20", kFive, kSix}},
    {7,
     2018,
     {kIds, "*:20 *:20 *:20", kStiffnesses, kNodes, kFric, kViscous,
      kLaw + " *:10 FUNCTION:10 *:20 POINTER:10", kFive, kSix, "*:10 *:20 *:20"}},
    {7,
     2020,
     {kIds, "*:20 *:20 *:20 -:20 *:10", kStiffnesses, kNodes, kFric, kViscous,
      kLaw + " *:10 FUNCTION:10 *:20 POINTER:10", kFive, kSix}},
    {7,
     2026,
     {kIds, "*:20 *:20 *:20 -:20 *:10 *:10", kStiffnesses, kNodes, kFric, kViscous,
      kLaw + " *:10 FUNCTION:10 *:20 POINTER:10", kFive, kSix}},
    {11, 41, {"*:8 *:8 *:8 -:8 *:8", kFricOld, kViscousOld}},
    {11, 51, {"*:10 *:10 *:10 -:10 *:10 *:10 -:10 *:10", kFric, kViscous}},
    {11, 110, {"*:10 *:10 *:10 -:10 *:10 *:10 -:10 *:10", "*:20 *:20 *:20", kFric, kViscous}},
    {11,
     120,
     {"*:10 *:10 *:10 -:10 *:10 -:20 *:10", "*:20 *:20 *:20 *:20 IFORM:10 *:10", kFric, kViscous}},
    {11,
     140,
     {"*:10 *:10 *:10 *:10 *:10 -:20 *:10", "*:20 *:20 *:20 *:20 IFORM:10 *:10", kFric, kViscous,
      "*:20 *:10 *:20 *:20 *:10", "*:20 *:20"}},
    {11,
     2018,
     {"*:10 *:10 *:10 *:10 *:10 -:20 *:10", "*:20 *:20 *:20 *:20 IFORM:10 *:10", kFric, kViscous,
      "-:90 POINTER:10", "*:20 *:10 *:20 *:20 *:10"}},
    {11,
     2020,
     {"*:10 *:10 *:10 *:10 *:10 -:10 *:10 *:10", "*:20 *:20 *:20 *:20 IFORM:10 *:10", kFric,
      kViscous, "-:90 POINTER:10"}},
    {19, 90, {kIds, "*:20 *:20", "*:20 *:20", kNodes, kFric, kViscous, kLaw, kFive, kSix}},
    {19,
     120,
     {kIds, "*:20 *:20", "*:20 *:20 -:20 *:20", kNodes, kFric, kViscous, kLaw + " *:10", kFive,
      kSix}},
    {19,
     2018,
     {kIds, "*:20 *:20", "*:20 *:20 -:20 *:20", kNodes, kFric, kViscous,
      kLaw + " *:10 -:30 POINTER:10", kFive, kSix}},
    {19,
     2020,
     {kIds, "*:20 *:20", kStiffnesses, kNodes, kFric, kViscous, kLaw + " *:10 -:30 POINTER:10",
      kFive, kSix}},
    {19,
     2024,
     {kIds, "*:20 *:20 *:20", kStiffnesses, kNodes, kFric, kViscous, kLaw + " *:10 -:30 POINTER:10",
      kFive, kSix}},
    {20,
     100,
     {"*:10 *:10 *:10 *:10 *:10 *:10 *:10 -:10 *:20", "-:40 *:10 *:10 *:10 *:10", "-:40 *:20",
      "-:100", kFric, "IBC:10 -:20 *:10 *:20 VISF:20", kLaw, kFive, kSix}},
    {21,
     100,
     {"*:10 *:10 *:10 -:10 *:10 *:10 -:30 *:10", "*:20 *:20 *:20 *:20", "*:20 *:20", kFric,
      "IBC:10 -:20 *:10 *:20 -:20 *:20", kLawStiff, kFive, kSix, "*:10 *:20 *:20"}},
    {21,
     120,
     {"*:10 *:10 *:10 *:10 *:10 *:10 -:30 *:10", "*:20 *:20 *:20 *:20", "*:20 *:20", kFric,
      "IBC:10 -:20 *:10 *:20 -:20 *:20", kLawStiff + " -:10 *:10", kFive, kSix, "*:10 *:20 *:20"}},
    {21,
     140,
     {"*:10 *:10 *:10 *:10 *:10 -:40 *:10", "*:20 *:20 *:20 *:20", "*:20 *:20", kFric,
      "IBC:10 -:20 *:10 *:20 -:20 *:20", kLawStiff + " -:10 *:10 FUNCTION:10 *:20", kFive, kSix}},
    {21,
     2017,
     {"*:10 *:10 *:10 *:10 *:10 -:30 *:10 *:10", "*:20 *:20 *:20 *:20 *:10", "*:20 *:20", kFric,
      "IBC:10 -:20 *:10 *:20 -:20 *:20", kLawStiff + " -:10 *:10 FUNCTION:10 *:20", kFive, kSix}},
    {21,
     2020,
     {"*:10 *:10 *:10 *:10 *:10 -:20 *:10 *:10 *:10", "*:20 *:20 *:20 *:20 *:10",
      "*:20 *:20 -:20 *:20", kFric, "IBC:10 -:20 *:10 *:20 -:20 *:20",
      kLawStiff + " -:10 *:10 FUNCTION:10 *:20", kFive, kSix}},
    {21,
     2025,
     {"*:10 *:10 *:10 *:10 *:10 -:20 *:10 *:10 *:10", "*:20 *:20 *:20 *:20 *:10",
      "*:20 *:20 -:20 *:20", kFric, "IBC:10 -:20 *:10 *:20 -:20 *:20",
      kLawStiff + " -:10 *:10 FUNCTION:10 *:20 POINTER:10", kFive, kSix}},
    {24,
     120,
     {"*:10 *:10 *:10", "NODE:10 -:50 *:20 *:20", "*:20 *:20 *:10 -:10 *:20 *:20",
      "*:20 FRIC:20 -:20 *:20 *:20", kStiff, kLawStiff + " -:10 *:10", kFive, kSix}},
    {24,
     2017,
     {"*:10 *:10 *:10 -:40 *:10", "NODE:10 -:20 *:10 *:20 *:20 *:20", "*:20 *:20 *:10 *:10 *:20",
      "*:20 FRIC:20 -:20 *:20 *:20", kStiff, kLawStiff + " -:10 *:10", kFive, kSix}},
    {24,
     2018,
     {"*:10 *:10 *:10 -:20 *:10 -:10 *:10", "NODE:10 -:20 *:10 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20", "*:20 FRIC:20 -:20 *:20 *:20", kStiff,
      kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive, kSix}},
    {24,
     2021,
     {"*:10 *:10 *:10 -:20 *:10 -:10 *:10", "NODE:10 -:20 *:10 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20", "*:20 FRIC:20 -:20 *:20 *:20", kStiff + " -:20 *:20",
      kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive, kSix}},
    {24,
     2023,
     {"*:10 *:10 *:10 -:20 *:10 -:10 *:10 -:10 *:10", "NODE:10 -:20 *:10 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20 *:20", "*:20 FRIC:20 -:20 *:20 *:20", kStiff + " -:20 *:20",
      kLawStiff + " -:10 *:10 *:20 -:10 POINTER:10", kFive, kSix}},
    {25,
     2018,
     {"*:10 *:10 *:10 -:10 *:10 -:20 *:10", "NODE:10 -:30 *:20 *:20 *:20", "*:20 *:20 *:10",
      "*:20 FRIC:20 -:20 *:20 *:20", kStiff, kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive,
      kSix}},
    {25,
     2019,
     {"*:10 *:10 *:10 -:10 *:10 *:10 -:10 *:10", "NODE:10 -:10 *:20 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10", "*:20 FRIC:20 -:20 *:20 *:20", "IBC:10 -:10 *:10 *:10 *:20",
      kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive, kSix, "*:20 *:20 *:20"}},
    {25,
     2021,
     {"*:10 *:10 *:10 *:10 *:10 *:10 -:10 *:10 *:10", "NODE:10 -:10 *:20 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20", "*:20 FRIC:20 -:20 *:20 *:20",
      "IBC:10 -:10 *:10 *:10 *:20 *:10 -:10 *:20", kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive,
      kSix, "*:20 -:10 *:10 *:20 -:10 *:10 *:20"}},
    {25,
     2022,
     {"*:10 *:10 *:10 *:10 *:10 *:10 -:10 *:10 *:10", "NODE:10 -:10 *:20 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20", kFric, "IBC:10 -:10 *:10 *:10 *:20 *:10 -:10 *:20",
      kLawStiff + " -:10 *:10 -:30 POINTER:10", kFive, kSix}},
    {25,
     2023,
     {"*:10 *:10 *:10 *:10 *:10 *:10 -:10 *:10 *:10 *:10", "NODE:10 -:10 *:20 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20 *:20", kFric, "IBC:10 -:10 *:10 *:10 *:20 *:10 -:10 *:20",
      kLawStiff + " -:10 *:10 *:20 -:10 POINTER:10", kFive, kSix}},
    {25,
     2026,
     {"*:10 *:10 *:10 *:10 *:10 *:10 -:10 *:10 *:10 *:10", "NODE:10 -:10 *:20 *:20 *:20 *:20",
      "*:20 *:20 *:10 *:10 *:20 *:20", kFric, "IBC:10 -:10 *:10 *:10 *:20 *:10 -:10 *:20",
      kLawStiff + " -:10 *:10 *:20 -:10 POINTER:10", kFive, kSix, "*:20 *:20 *:20 *:20"}},
};

using Values = std::map<std::string, std::string>;

bool has(const Layout& layout, const std::string& name) {
  for (const std::string& card : layout.cards) {
    if ((" " + card).find(" " + name + ":") != std::string::npos) return true;
  }
  return false;
}

/// The interface as a deck of a version; numbers stand at the right end of their columns.
std::string deck(const Layout& layout, int version, const Values& values) {
  const bool titled = version >= 51 || layout.type == 3 || layout.type == 5;
  std::string text = fmt::format("#RADIOSS STARTER\n/BEGIN\nrun\n{:>10}         0\n/INTER/TYPE{}/6",
                                 version, layout.type);
  text += titled ? "\nlid on drum\n" : "/lid on drum\n";
  const bool curved = values.at("ICURV") != "0";
  const bool lawful = values.at("IFRIC") != "0";
  for (const std::string& card : layout.cards) {
    // Constants are there if a law wants them, of TYPE21 always; nodes if Icurv is 1 or 2.
    if (card == kNodes && !curved) continue;
    if ((card.starts_with("C1:") || card.starts_with("C6:")) && !lawful && layout.type != 21) {
      continue;
    }
    std::istringstream fields(card);
    for (std::string field; fields >> field;) {
      const std::size_t colon = field.find(':');
      const std::string name = field.substr(0, colon);
      const int width = std::stoi(field.substr(colon + 1));
      const std::string value = name == "-"   ? ""
                                : name == "*" ? (width > 10 ? "1.5" : "1")
                                              : values.at(name);
      text += fmt::format("{:>{}}", value, width);
    }
    text += "\n";
  }
  return text;
}

DeckInterface read_one(const std::string& text) {
  const base::SourceText source("d.rad", text);
  base::Diagnostics diagnostics;
  const StarterDeck starter = split_deck(source, {"."}, diagnostics);
  std::vector<DeckInterface> found = read_interfaces(starter, diagnostics);
  INFO(text);
  REQUIRE(diagnostics.empty());
  REQUIRE(found.size() == 1);
  return std::move(found.front());
}

/// Reads a layout and holds it against the values; constants of a law as far as its layout has
/// them.
void check(const Layout& layout, int version, const Values& values) {
  const std::string text = deck(layout, version, values);
  INFO(text);
  const DeckInterface one = read_one(text);
  CHECK_FALSE(one.unread);
  CHECK(one.id == 6);
  CHECK(one.own.title == "lid on drum");
  CHECK(one.own.unit_id == 0);
  const auto number = [&](const std::string& name) {
    return has(layout, name) ? std::stod(values.at(name)) : 0.0;
  };
  CHECK(one.own.otherwise.fric == number("FRIC"));
  CHECK(one.own.otherwise.visf == number("VISF"));
  CHECK(one.shear_limit == number("PTLIM"));
  CHECK(one.own.law == static_cast<int>(number("IFRIC")));
  CHECK(one.own.filter == static_cast<int>(number("IFILTR")));
  CHECK(one.own.xfreq == number("XFREQ"));
  const bool stiff = layout.type == 21 || layout.type == 24 || layout.type == 25;
  CHECK(one.own.formulation == (stiff                  ? 2
                                : has(layout, "IFORM") ? std::stoi(values.at("IFORM"))
                                                       : 1));
  CHECK(one.temperature_function == static_cast<int>(number("FUNCTION")));
  CHECK(one.friction_id == static_cast<int>(number("POINTER")));
  for (std::size_t i = 0; i < 6; ++i) {
    INFO("C" << i + 1);
    const bool wanted = one.own.law > (i == 5 ? 1 : 0);
    CHECK(one.own.otherwise.c[i] == (wanted ? number(fmt::format("C{}", i + 1)) : 0.0));
  }
}

TEST_CASE("Friction of an interface is read in every layout that its type has had") {
  const Values law = {{"FRIC", "0.23"}, {"IBC", "101"},    {"VISF", "3.5"}, {"IFRIC", "2"},
                      {"IFILTR", "3"},  {"XFREQ", "500."}, {"IFORM", "2"},  {"FUNCTION", "12"},
                      {"POINTER", "0"}, {"PTLIM", "35."},  {"ICURV", "0"},  {"NODE", "101"},
                      {"C1", "1e-3"},   {"C2", "2e-3"},    {"C3", "3e-3"},  {"C4", "4e-3"},
                      {"C5", "5e-3"},   {"C6", "-6e-3"}};
  Values coulomb = law;
  coulomb["IFRIC"] = coulomb["IFILTR"] = "0";
  coulomb["IBC"] = "";
  coulomb["IFORM"] = "1";
  // Node 101 of a curvature is no card of IBC 101.
  Values curved = law;
  curved["ICURV"] = "2";
  Values pointed = law;
  pointed["POINTER"] = "21";
  pointed["IBC"] = "0";
  for (std::size_t i = 0; i < kLayouts.size(); ++i) {
    const Layout& layout = kLayouts[i];
    const bool last = i + 1 == kLayouts.size() || kLayouts[i + 1].type != layout.type;
    // Its first version, and the last one before the next layout.
    const int until = last ? 2026 : kLayouts[i + 1].since - 1;
    for (const int version : {layout.since, until}) {
      INFO("TYPE" << layout.type << " of version " << version);
      for (const Values& values : {law, coulomb, curved, pointed}) check(layout, version, values);
    }
  }
}

TEST_CASE("An interface whose cards are not those of its version is told as unread") {
  const Values values = {{"FRIC", "0.23"}, {"IBC", "000"}};
  std::string text = "#RADIOSS STARTER\n/BEGIN\nrun\n      2026         0\n/INTER/TYPE7/6\nt\n";
  for (const char* const card : {"         1         2", "                 1.5", "       777"}) {
    text += std::string(card) + "\n";
  }
  const DeckInterface one = read_one(text);
  REQUIRE(one.unread);
  CHECK_THAT(*one.unread, Catch::Contains("card 5 of a TYPE7 of version 2026"));
}

}  // namespace
}  // namespace slipbench::driver::radioss
