// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/number.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::base {
namespace {

std::string reason(std::string_view text) {
  const auto number = parse_number(text);
  REQUIRE_FALSE(number.has_value());
  return number.error();
}

TEST_CASE("Numbers in decimal notation are read to the nearest double") {
  const std::vector<std::pair<std::string, double>> cases = {
      {"0", 0.0},     {"12", 12.0},  {"-0.5", -0.5},     {"+3", 3.0},          {".5", 0.5},
      {"5.", 5.0},    {"1e5", 1e5},  {"1.5E-3", 1.5e-3}, {"-2.5e+3", -2.5e3},  {"1e05", 1e5},
      {"0e999", 0.0}, {"0.10", 0.1}, {"5e-324", 5e-324}, {"1.7e308", 1.7e308}, {"1e-310", 1e-310}};
  for (const auto& [text, value] : cases) {
    CAPTURE(text);
    REQUIRE(parse_number(text).has_value());
    CHECK(*parse_number(text) == value);
  }
  CHECK(std::signbit(*parse_number("-0")));
  CHECK(std::signbit(*parse_number("-0e999")));
}

TEST_CASE("What is no number is refused with a reason and, if it can be guessed, what to write") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "nothing where a number is wanted"},
      {"1.0;", "'1.0;': nothing stands behind a number; write 1.0"},
      {"1.0 // s", "'1.0 // s': a comment begins with ' #'; write 1.0 # .."},
      {"2 ! s", "'2 ! s': a comment begins with ' #'; write 2 # .."},
      {".nan", "'.nan': a finite number is wanted"},
      {"NaN", "'NaN': a finite number is wanted"},
      {".inf", "'.inf': a finite number is wanted"},
      {"-.inf", "'-.inf': a finite number is wanted"},
      {"inf", "'inf': a finite number is wanted"},
      {"1e400", "'1e400' is too large for a double (at most 1.7e308)"},
      {"-1e400", "'-1e400' is too large for a double (at most 1.7e308)"},
      {"1e-400", "'1e-400' is too small for a double; write 0 or at least 2.3e-308"},
      {"1e99999999999999999999",
       "'1e99999999999999999999' is too large for a double (at most 1.7e308)"},
      {"1.2345678901234e-315",
       "'1.2345678901234e-315' loses digits as a double; below 2.3e-308 there are fewer than 16"},
      {"010", "'010' has a leading zero; write 10"},
      {"-00.5", "'-00.5' has a leading zero; write -0.5"},
      {"0x10", "'0x10': numbers are decimal; write 16"},
      {"-0o17", "'-0o17': numbers are decimal; write -15"},
      {"0b11", "'0b11': numbers are decimal; write 3"},
      {"1,5", "'1,5': the decimal mark is '.'; write 1.5"},
      {"1,000", "'1,000': a number has no ','; write 1.000 or 1000"},
      {"1,000,000", "'1,000,000': a number has no ','; write 1000000"},
      {"1.234,5", "'1.234,5': the decimal mark is '.'; write 1234.5"},
      {"1,234.5", "'1,234.5': a number has no ','; write 1234.5"},
      {"1,2,3", "'1,2,3' is not a number"},
      {"1,5 mm", "'1,5': the decimal mark is '.'; write 1.5"},
      {"5 %", "'5 %': write the fraction 0.05"},
      {"1_000", "'1_000': a number has digits only; write 1000"},
      {"1 2", "'1 2': a number has no blanks; write 12, or put ',' between two numbers"},
      {"1.5D3", "'1.5D3': write 1.5e3"},
      {"1.5d-3", "'1.5d-3': write 1.5e-3"},
      {"5%", "'5%': write the fraction 0.05"},
      {"1/2", "'1/2': an expression begins with '='; write '= 1/2'"},
      {"2*(3+1)", "'2*(3+1)': an expression begins with '='; write '= 2*(3+1)'"},
      {"= mu", "the expression '= mu' where a plain number is wanted"},
      {"1.5mm", "'1.5mm': a number without a unit is wanted here"},
      {"1.5 N", "'1.5 N': a number without a unit is wanted here"},
      {"5\xC2\xB0", "'5\xC2\xB0': a number without a unit is wanted here"},
      {"\xE2\x88\x92"
       "5",
       "'\xE2\x88\x92"
       "5': write the sign as '-'"},
      {"yes", "'yes' is a truth value where a number is wanted"},
      {"No", "'No' is a truth value where a number is wanted"},
      {"true", "'true' is a truth value where a number is wanted"},
      {"null", "'null' where a number is wanted"},
      {"~", "'~' where a number is wanted"},
      {"mu", "'mu' is not a number; a parameter is written '= mu'"},
      {"e5", "'e5' is not a number; a parameter is written '= e5'"},
      {"two words", "'two words' is not a number"},
      {"1e", "'1e': the exponent has no digits"},
      {"1.2.3", "'1.2.3' has two decimal points"},
      {"+-1", "'+-1' is not a number"},
      {"-", "'-' is not a number"},
      {".", "'.' is not a number"}};
  for (const auto& [text, expected] : cases) {
    CAPTURE(text);
    CHECK(reason(text) == expected);
  }
}

TEST_CASE("Numbers too small or too large are told apart without an exponent too") {
  CHECK(reason("0." + std::string(400, '0') + "1").find("too small") != std::string::npos);
  CHECK(reason(std::string(400, '9')).find("too large") != std::string::npos);
}

TEST_CASE("An integer is digits and a sign") {
  CHECK(*parse_integer("0") == 0);
  CHECK(*parse_integer("-12") == -12);
  CHECK(*parse_integer("+7") == 7);
  CHECK(*parse_integer("9223372036854775807") == std::numeric_limits<long long>::max());
  const auto why = [](std::string_view text) { return parse_integer(text).error(); };
  CHECK(why("2.5") == "'2.5' where an integer is wanted");
  CHECK(why("2.0") == "'2.0' where an integer is wanted; write 2");
  CHECK(why("1e3") == "'1e3' where an integer is wanted; write 1000");
  CHECK(why("010") == "'010' has a leading zero; write 10");
  CHECK(why("9223372036854775808") == "'9223372036854775808' is too large for an integer");
  CHECK(why("ten") == "'ten' is not a number; a parameter is written '= ten'");
}

TEST_CASE("A number is written as the shortest text that reads back to the same bits") {
  CHECK(format_number(0.1) == "0.1");
  CHECK(format_number(1.0) == "1");
  CHECK(format_number(-0.0) == "-0");
  CHECK(format_number(1e300) == "1e+300");
  CHECK(format_number(std::numeric_limits<double>::quiet_NaN()) == "nan");
  CHECK(format_number(-std::numeric_limits<double>::infinity()) == "-inf");
  std::mt19937_64 random(20240611);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = format_number(value);
    const auto back = parse_number(text);
    if (!back || std::bit_cast<std::uint64_t>(*back) != std::bit_cast<std::uint64_t>(value))
      FAIL("not read back: " << text);
  }
}

TEST_CASE("The smallest doubles are read back although they have few digits") {
  for (std::uint64_t bits = 1; bits < (std::uint64_t{1} << 52U); bits = bits * 3 + 1) {
    const auto value = std::bit_cast<double>(bits);
    CAPTURE(format_number(value));
    REQUIRE(parse_number(format_number(value)).has_value());
    CHECK(*parse_number(format_number(value)) == value);
  }
}

TEST_CASE("A locale with a decimal comma changes neither reading nor writing") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool has_comma = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  CAPTURE(has_comma);
  CHECK(format_number(0.5) == "0.5");
  CHECK(parse_number("0.5").value() == 0.5);
  CHECK_FALSE(parse_number("0,5").has_value());
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("a number is rounded to digits, also below the smallest with all of them") {
  CHECK(rounded_number(2.0 / 3.0, 3) == 0.667);
  CHECK(rounded_number(-123456.0, 2) == -120000.0);
  CHECK(rounded_number(0.1, 17) == 0.1);
  CHECK(rounded_number(0.0, 4) == 0.0);
  CHECK(rounded_number(1e-320, 12) == 1e-320);
  CHECK(rounded_number(std::numeric_limits<double>::max(), 2) ==
        std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace slipbench::driver::base
