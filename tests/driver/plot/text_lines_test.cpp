// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/text_lines.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::plot {
namespace {

using Lines = std::vector<std::string>;

TEST_CASE("a text is broken at blanks") {
  CHECK(lines_of_length("one", 10, 2) == Lines{"one"});
  CHECK(lines_of_length("one two three", 10, 2) == Lines{"one two", "three"});
  CHECK(lines_of_length("one two three", 7, 2) == Lines{"one two", "three"});
  CHECK(lines_of_length("", 10, 2).empty());
}

TEST_CASE("a text that does not fit says so") {
  CHECK(lines_of_length("one two three four five six", 10, 2) == Lines{"one two", "three ..."});
}

TEST_CASE("a long word is broken between letters") {
  CHECK(lines_of_length("abcdefghij", 6, 2) == Lines{"abcdef", "ghij"});
  // Ten letters of two bytes each.
  CHECK(lines_of_length("ääääääääää", 6, 2) == Lines{"ääääää", "ääää"});
}

}  // namespace
}  // namespace slipbench::driver::plot
