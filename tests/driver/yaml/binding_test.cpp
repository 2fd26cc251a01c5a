// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/binding.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/yaml/parse.hpp"

namespace slipbench::driver::yaml {
namespace {

/// A file that nobody has, so that what is tested are the rules and no key of a case.
struct Spoke {
  double length = 0.0;
  At<int> holes;

  template <class Visitor>
  static void declare(Visitor&& key) {
    key("length", &Spoke::length,
        {.required = true, .dimension = {.length = 1}, .bounds = law::kPositive});
    key("holes", &Spoke::holes, {.text = "Holes of the rim"});
  }
};
struct Wheel {
  std::string name;
  std::optional<bool> driven;
  std::vector<double> loads;
  NamedMap<Spoke> spokes;

  template <class Visitor>
  static void declare(Visitor&& key) {
    key("name", &Wheel::name, {.required = true});
    key("driven", &Wheel::driven, {});
    key("loads", &Wheel::loads, {.dimension = {.force = 1}, .most = 4});
    key("spokes", &Wheel::spokes, {.most = 3});
  }
};

const FileWords kWords{[](std::string_view) { return std::optional<LaterKey>(); },
                       [](std::string_view) { return std::string(); },
                       [](std::string_view) { return std::string(); },
                       [](std::string_view) { return std::string(); }, "no such name"};

struct Bound {
  std::optional<Tree> tree;  ///< nodes point into it
  Wheel wheel;
  bool good = false;
  base::Diagnostics messages;
  std::string text;  ///< the messages, as a user sees them
};

Bound bound(const std::string& text) {
  Bound result;
  const base::SourceText source("wheel.yaml", text);
  const auto tree = parse_yaml(source);
  if (tree) {
    result.tree = *tree;
    const base::NamedNumbers parameters{{"r", 300.0}};
    Binder binder(result.messages, parameters, {}, ".", false, kWords);
    binder.set_units(base::UnitSystem{"mm", "N", "s", "K"});
    result.good = read_struct(binder, tree->root(), {}, result.wheel);
  } else {
    result.messages = tree.error();
  }
  result.text = render(result.messages, {&source, 1});
  return result;
}

const std::string kWheel =
    "name: \"front\"\n"
    "driven: true\n"
    "loads: [100, 0.2 kN, = 2*r]\n"
    "spokes:\n"
    "  left: {length: 28 cm, holes: 16}\n"
    "  right: {length: = r - 10}\n";

TEST_CASE("declared keys are read, with units, expressions and names of the user") {
  const Bound found = bound(kWheel);
  REQUIRE(found.text == "");
  REQUIRE(found.good);
  CHECK(found.wheel.name == "front");
  CHECK(found.wheel.driven == true);
  CHECK(found.wheel.loads == std::vector<double>{100.0, 200.0, 600.0});
  REQUIRE(found.wheel.spokes.size() == 2);
  const Spoke& left = found.wheel.spokes[0].value;
  CHECK(found.wheel.spokes[0].name == "left");
  CHECK(left.length == 280.0);
  CHECK(left.holes.value == 16);
  CHECK(left.holes.path.text() == "spokes.left.holes");
  CHECK(left.holes.node->where().line == 5);
  CHECK(found.wheel.spokes[1].value.length == 290.0);
  CHECK_FALSE(found.wheel.spokes[1].value.holes.given());
}

TEST_CASE("every fault of a map is reported once, at its place, and what is sound is kept") {
  const Bound found = bound(
      "nam: front\n"
      "driven: perhaps\n"
      "loads: {a: 1}\n"
      "spokes:\n"
      "  left: {length: -1, holes: 1.5}\n"
      "  right: [1]\n"
      "  last: {holes: 3}\n");
  CHECK_FALSE(found.good);
  std::string places;
  for (const base::Diagnostic& one : found.messages.sorted()) {
    places += std::to_string(one.where.line) + " " + one.path + "\n";
  }
  CHECK(places ==
        "1 nam\n2 driven\n3 loads\n5 spokes.left.length\n5 spokes.left.holes\n6 spokes.right\n"
        "7 spokes.last\n");
  CHECK(found.text.find("nam: unknown key; did you mean 'name'?") != std::string::npos);
  REQUIRE(found.wheel.spokes.size() == 3);
  CHECK(found.wheel.spokes[0].value.holes.faulty());
  CHECK(found.wheel.spokes[2].value.holes.value == 3);
}

TEST_CASE("a list and a map have as many items as is declared, in the schema too") {
  CHECK(bound("name: a\nloads: [1, 2, 3, 4]\n").good);
  const Bound list = bound("name: a\nloads: [1, 2, 3, 4, 5]\n");
  CHECK_FALSE(list.good);
  CHECK(list.text.find("error: loads: 5 items, at most 4 are read") != std::string::npos);
  const std::string spoke = ": {length: 1}\n  ";
  CHECK(bound("name: a\nspokes:\n  a" + spoke + "b" + spoke + "c" + spoke).good);
  const Bound map =
      bound("name: a\nspokes:\n  a" + spoke + "b" + spoke + "c" + spoke + "d" + spoke);
  CHECK_FALSE(map.good);
  CHECK(map.text.find("error: spokes: 4 items, at most 3 are read") != std::string::npos);
  CHECK(map.wheel.spokes.empty());

  const std::string schema = struct_schema<Wheel>().dump();
  CHECK(schema.find("\"maxItems\"") != std::string::npos);
  CHECK(schema.find("\"maxProperties\"") != std::string::npos);
  CHECK(limits_in_words({.most = 4}) == "at most 4");
  CHECK(limits_in_words({.bounds = law::kPositive}) == "greater than 0");
}

TEST_CASE("once there are more errors than are kept, no near name is looked for") {
  std::string text = "name: a\n";
  for (int i = 0; i <= static_cast<int>(base::Diagnostics::kMaxKept); ++i)
    text += "lods" + std::to_string(i) + ": 1\n";
  const base::SourceText source("wheel.yaml", text);
  const auto tree = parse_yaml(source);
  REQUIRE(tree);
  base::Diagnostics messages;
  const base::NamedNumbers none;
  Binder binder(messages, none, {}, ".", false, kWords);
  const std::vector<std::string_view> names{"loads"};
  CHECK(binder.nearest_or("lods", names, "else") == "did you mean 'loads'?");
  Wheel wheel;
  CHECK_FALSE(read_struct(binder, tree->root(), {}, wheel));
  CHECK(binder.flooded());
  CHECK(binder.nearest_or("lods", names, "else").empty());
}

TEST_CASE("a wheel with any character replaced is read or refused at a place of the text") {
  std::size_t read = 0;
  std::size_t refused = 0;
  for (std::size_t at = 0; at < kWheel.size(); ++at) {
    for (const char character : std::string_view("\"'[{:=*-#\n 9e\xC3")) {
      std::string text = kWheel;
      text[at] = character;
      const Bound found = bound(text);
      INFO(text);
      REQUIRE(found.good != found.messages.has_errors());
      ++(found.messages.has_errors() ? refused : read);
      const int lines = base::SourceText("wheel.yaml", text).line_count();
      for (const base::Diagnostic& one : found.messages.sorted()) {
        REQUIRE(one.where.line >= 1);
        REQUIRE(one.where.line <= lines);
      }
    }
  }
  // Both kinds must be met, or the test tests nothing.
  CHECK(read > 100);
  CHECK(refused > 1000);
}

}  // namespace
}  // namespace slipbench::driver::yaml
