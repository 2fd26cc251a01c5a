// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/text_changes.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/yaml/parse.hpp"

using slipbench::driver::calibrate::NodeChange;

namespace {

NodeChange changed(const std::vector<std::size_t>& way, const std::string& text) {
  NodeChange root;
  NodeChange* change = &root;
  for (const std::size_t i : way) change = &change->children[i];
  change->text = text;
  return root;
}

std::string edited(const std::string& text, const NodeChange& change) {
  const auto tree =
      slipbench::driver::yaml::parse_yaml(slipbench::driver::base::SourceText("t.yaml", text));
  REQUIRE(tree);
  const auto result = slipbench::driver::calibrate::with_changes(*tree, change);
  return result ? *result : "fault: " + result.error();
}

}  // namespace

TEST_CASE("a text without changes stays as it is") {
  const std::string text = "# head\na:   1 # one\nb: [1,  2, {c: x}]\n\n";
  CHECK(edited(text, {}) == text);
}

TEST_CASE("a number is replaced where it stands, with its comment and layout kept") {
  CHECK(edited("a:   1   # one\nb: 2\n", changed({0}, "0.25")) == "a:   0.25   # one\nb: 2\n");
  CHECK(edited("p: {mu: 0.3, k: 1e4}\n", changed({0, 1}, "4213.5")) == "p: {mu: 0.3, k: 4213.5}\n");
  CHECK(edited("r:\n  - [1, 2]\n  -\n    - 3   # three\n    - 4\n", changed({0, 1, 0}, "7")) ==
        "r:\n  - [1, 2]\n  -\n    - 7   # three\n    - 4\n");
}

TEST_CASE("places are counted in characters, not in bytes") {
  CHECK(edited("{µ: \"ä'ö\", b: 2} # ü\n", changed({1}, "3")) == "{µ: \"ä'ö\", b: 3} # ü\n");
}

TEST_CASE("a quoted expression is replaced with its quotes") {
  CHECK(edited("a: \"= max(b, 1)\" # why\nb: '= 2'\n", changed({0}, "5")) ==
        "a: 5 # why\nb: '= 2'\n");
  CHECK(edited("a: = 2*b   # why\nb: 1\n", changed({0}, "-3")) == "a: -3   # why\nb: 1\n");
}

TEST_CASE("a value that was left empty is put behind its key") {
  CHECK(edited("mu:   # to be found\nk: 1\n", changed({0}, "0.3")) ==
        "mu: 0.3   # to be found\nk: 1\n");
  CHECK(edited("p: {mu: , k: 1}\n", changed({0, 0}, "0.3")) == "p: {mu: 0.3 , k: 1}\n");
  CHECK(edited("mu: ~\n", changed({0}, "0.3")) == "mu: 0.3\n");
}

TEST_CASE("an anchor keeps its name and its new value, and aliases their old one") {
  CHECK(edited("a: &x 1\nb: *x\n", changed({0}, "2")) == "a: &x 2\nb: 1\n");
  CHECK(edited("a: &x 1\nb: *x # same\n", changed({1}, "2")) == "a: &x 1\nb: 2 # same\n");
  NodeChange both = changed({0}, "2");
  both.children[1].text = "2";
  CHECK(edited("a: &x 1\nb: *x\n", both) == "a: &x 2\nb: 2\n");
}

TEST_CASE("an alias of a list or a map is written out if something in it changes") {
  const std::string text = "a: &t {c: [mu, v], r: [[1, 2], [3, 4]]}\nb: *t\nd: &q '= x'\ne: *q\n";
  CHECK(edited(text, changed({0, 1, 1, 0}, "9")) ==
        "a: &t {c: [mu, v], r: [[1, 2], [9, 4]]}\nb: {c: [mu, v], r: [[1, 2], [3, 4]]}\nd: &q '= "
        "x'\ne: *q\n");
  CHECK(edited(text, changed({1, 1, 1, 0}, "9")) ==
        "a: &t {c: [mu, v], r: [[1, 2], [3, 4]]}\nb: {c: [mu, v], r: [[1, 2], [9, 4]]}\nd: &q '= "
        "x'\ne: *q\n");
  CHECK(edited(text, changed({2}, "9")) ==
        "a: &t {c: [mu, v], r: [[1, 2], [3, 4]]}\nb: *t\nd: &q 9\ne: \"= x\"\n");
}

TEST_CASE("a key gets another name together with another kind of value") {
  NodeChange change = changed({0, 1}, "[[1, 2],\n      [3, 4]]");
  change.children[0].children[1].key = "rows";
  CHECK(edited("t: {columns: [mu, v], csv: mu.csv}  # x\n", change) ==
        "t: {columns: [mu, v], rows: [[1, 2],\n      [3, 4]]}  # x\n");
  CHECK(edited("t:\n  columns: [mu, v]\n  csv: mu.csv\nu: 1\n", change) ==
        "t:\n  columns: [mu, v]\n  rows: [[1, 2],\n      [3, 4]]\nu: 1\n");
}

TEST_CASE("a value over several lines is refused with its line") {
  CHECK(edited("b: 1\na: \"= 1 +\n  2\"\n", changed({1}, "3")) ==
        "fault: line 2: a value over several lines cannot be replaced; write it in one line");
  CHECK(edited("b: 1\na: |\n  = 2\n", changed({1}, "3")).starts_with("fault: line 2"));
  CHECK(edited("b: 1\na: = 1 +\n  2\n", changed({1}, "3")).starts_with("fault: line 2"));
}

TEST_CASE("texts are quoted where YAML would read something else") {
  using slipbench::driver::calibrate::yaml_scalar;
  CHECK(yaml_scalar("data/rig.csv") == "data/rig.csv");
  CHECK(yaml_scalar("../my rig.csv") == "\"../my rig.csv\"");
  CHECK(yaml_scalar("-1.5e3") == "-1.5e3");
  CHECK(yaml_scalar("- a") == "\"- a\"");
  CHECK(yaml_scalar("= 2*mu") == "\"= 2*mu\"");
  CHECK(yaml_scalar("3", true) == "\"3\"");
  CHECK(yaml_scalar("") == "\"\"");
}
