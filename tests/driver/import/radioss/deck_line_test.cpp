// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/deck_line.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace slipbench::driver::radioss {
namespace {

constexpr std::array kThree{DeckField{0, 20, "a", false}, DeckField{20, 20, "b", false},
                            DeckField{40, 10, "n", true}};

std::vector<double> fixed(std::string_view line) {
  const auto numbers = read_numbers(line, kThree, 0);
  REQUIRE(numbers);
  CHECK_FALSE(numbers->free_format);
  return numbers->values;
}

std::string fault(std::string_view line) {
  const auto numbers = read_numbers(line, kThree, 0);
  REQUIRE_FALSE(numbers);
  return numbers.error().message;
}

TEST_CASE("A number is read as Fortran writes it") {
  const auto value = [](std::string_view text) {
    const auto number = parse_fortran_number(text);
    INFO(text);
    REQUIRE(number);
    return *number;
  };
  CHECK(value("1.5") == 1.5);
  CHECK(value("1.") == 1.0);
  CHECK(value(".5") == 0.5);
  CHECK(value("+2") == 2.0);
  CHECK(value("-0.25") == -0.25);
  CHECK(value("1.0D-3") == 1e-3);
  CHECK(value("1d5") == 1e5);
  CHECK(value("1-3") == 1e-3);
  CHECK(value("1.5+3") == 1500.0);
  CHECK(value("-2.E+02") == -200.0);
  CHECK(value("007") == 7.0);
  CHECK(value("0.0D+999") == 0.0);
}

TEST_CASE("What is no Fortran number is refused") {
  for (const std::string_view text : {"", ".", "-", "nan", "inf", "1e", "1e+", "1.2.3", "1,5",
                                      "0x10", "1e400", "1e-400", "1.5mm", "--1", "1 2"}) {
    INFO(text);
    CHECK_FALSE(parse_fortran_number(text));
  }
}

TEST_CASE("Numbers stand anywhere within their columns, and empty columns are 0") {
  CHECK(fixed("                 1.5                 2.5         3") ==
        std::vector<double>{1.5, 2.5, 3.0});
  CHECK(fixed("1.5                 2.5                 3") == std::vector<double>{1.5, 2.5, 3.0});
  CHECK(fixed("                                     2.5") == std::vector<double>{0.0, 2.5, 0.0});
  CHECK(fixed("") == std::vector<double>{0.0, 0.0, 0.0});
  CHECK(fixed("1.5") == std::vector<double>{1.5, 0.0, 0.0});
}

TEST_CASE("Neighbouring numbers may fill their columns without a blank") {
  CHECK(fixed("1.23456789012345E+002.34567890123456E+01         7") ==
        std::vector<double>{1.23456789012345, 23.4567890123456, 7.0});
}

TEST_CASE("As many words as fields are free format where the columns do not fit") {
  const auto numbers = read_numbers("1.5 2.5 3", kThree, 0);
  REQUIRE(numbers);
  CHECK(numbers->free_format);
  CHECK(numbers->values == std::vector<double>{1.5, 2.5, 3.0});
  const auto tabs = read_numbers("1.5\t2.5\t3", kThree, 0);
  REQUIRE(tabs);
  CHECK(tabs->values == numbers->values);
}

TEST_CASE("Free format may lack the fields that may be missing, and no others") {
  CHECK(fault("1.5 2.5") == "wanted a, b, n in their columns, found 2 numbers elsewhere");
  const auto numbers = read_numbers("1.5 2.5", kThree, 2);
  REQUIRE(numbers);
  CHECK(numbers->values == std::vector<double>{1.5, 2.5, 0.0});
  CHECK(fault("1.5 2.5 3 4") == "wanted a, b, n in their columns, found 4 numbers elsewhere");
}

TEST_CASE("A field that must be blank is: a number in it is free format or a fault") {
  constexpr std::array kGap{DeckField{0, 10, "a", true}, DeckField{10, 10, {}, false},
                            DeckField{20, 10, "b", true}};
  const auto numbers = read_numbers("         1                   2", kGap, 0);
  REQUIRE(numbers);
  CHECK(numbers->values == std::vector<double>{1.0, 2.0});
  CHECK_FALSE(read_numbers("         1         9         2", kGap, 0));
}

TEST_CASE("A fault quotes the word it is about") {
  const std::string line = "                 1.5                 abc";
  const auto numbers = read_numbers(line, kThree, 0);
  REQUIRE_FALSE(numbers);
  CHECK(numbers.error().message == "wanted a number, found 'abc'");
  CHECK(numbers.error().text.data() == line.data() + 37);
  CHECK(fault("                 1.5                 2.5       3.5") ==
        "n: wanted an integer, found '3.5'");
  CHECK(fault("                 1.5                 2.5      9e99") ==
        "n: wanted an integer, found '9e99'");
  // A long one is cut, and not inside a character.
  CHECK(fault(std::string(200000, 'x')) ==
        "wanted a number, found '" + std::string(40, 'x') + "...'");
  CHECK(fault(std::string(39, 'x') + "\xC3\xA4" + std::string(99, 'y')) ==
        "wanted a number, found '" + std::string(39, 'x') + "...'");
  CHECK(fault("               1e999") == "a: the number '1e999' is beyond what a double holds");
}

}  // namespace
}  // namespace slipbench::driver::radioss
