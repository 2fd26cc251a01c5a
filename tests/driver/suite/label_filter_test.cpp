// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/label_filter.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace slipbench::driver::suite {
namespace {

TEST_CASE("a filter without wildcards is a part of the label") {
  CHECK(label_matches("examples/belt", "belt"));
  CHECK(label_matches("examples/belt", "examples/"));
  CHECK(label_matches("examples/belt", ""));
  CHECK_FALSE(label_matches("examples/belt", "Belt"));
  CHECK_FALSE(label_matches("examples/belt", "belts"));
}

TEST_CASE("a filter with wildcards describes the whole label") {
  CHECK(label_matches("examples/belt_guide", "examples/*"));
  CHECK(label_matches("examples/belt_guide", "*belt*"));
  CHECK(label_matches("examples/belt_guide", "*/belt_?uide"));
  CHECK(label_matches("examples/belt", "*belt"));
  CHECK(label_matches("examples/belt", "*belt*"));
  CHECK(label_matches("a", "?"));
  CHECK(label_matches("", "*"));
  CHECK_FALSE(label_matches("examples/belt_guide", "belt*"));
  CHECK_FALSE(label_matches("examples/belt", "*belt?"));
  CHECK_FALSE(label_matches("", "?"));
}

TEST_CASE("a question mark stands for one character, not for one byte") {
  CHECK(label_matches("größe", "gr?ße"));
  CHECK(label_matches("größe", "*ß?"));
  CHECK_FALSE(label_matches("größe", "gr??ße"));
}

TEST_CASE("many stars over a long label take no time") {
  const std::string label(100000, 'a');
  CHECK_FALSE(label_matches(label, "*a*a*a*a*a*a*a*a*a*a*b"));
  CHECK(label_matches(label, "*a*a*a*a*a*a*a*a*a*a*"));
}

TEST_CASE("one of several filters is enough, and none lets all through") {
  const std::vector<std::string> filters = {"hinge", "belt*"};
  CHECK(label_matches_any("belt_guide", filters));
  CHECK(label_matches_any("a/hinge_2", filters));
  CHECK_FALSE(label_matches_any("a/belt", filters));
  CHECK(label_matches_any("anything", {}));
}

}  // namespace
}  // namespace slipbench::driver::suite
