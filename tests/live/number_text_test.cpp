// SPDX-License-Identifier: Apache-2.0
#include "live/number_text.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>

namespace slipbench::live {
namespace {

std::string written(double value, decltype(write_number)* write) {
  std::array<char, 400> text{};
  const auto [end, error] = write(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::string(text.data(), end) : "no room";
}

std::string standard(double value) {
  return written(value, [](char* first, char* last, double number) {
    return std::to_chars(first, last, number);
  });
}

TEST_CASE("numbers of the page have the text that the program's have, and read back") {
  std::mt19937_64 random(1);
  const auto agree = [](double value) {
    const std::string text = written(value, write_number);
    if (text != standard(value)) FAIL(text << " is not " << standard(value));
    double back = 0.0;
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), back);
    const bool same = back == value || (back != back && value != value);
    if (error != std::errc{} || end != text.data() + text.size() || !same) FAIL(text);
  };
  for (int i = 0; i < 200000; ++i) agree(std::bit_cast<double>(std::uint64_t{random()}));
  for (int power = -25; power <= 25; ++power) {
    const double scale = std::stod("1e" + std::to_string(power));
    for (int i = 0; i < 2000; ++i) {
      agree(scale * static_cast<double>(random() % 100000));
      agree(-scale * static_cast<double>(random() >> 11U));
    }
  }
  for (double value : {0.0, -0.0, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 1e22, 1e23}) {
    agree(value);
  }
}

TEST_CASE("what is no number is refused where std::from_chars refuses it") {
  for (const std::string text :
       {"",      "-",      "+1",     " 1",    "1 ",   ".",   ".5",        "5.",       "-.5e1",
        "1e",    "1e+",    "1e5x",   "1.2.3", "0x10", "inf", "-Infinity", "nan",      "infinit",
        "1e400", "-1e400", "1e-400", "0e5",   "e5",   "1,5", "00012.50",  "1e0000005"}) {
    INFO(text);
    double one = 7.0, other = 7.0;
    const auto here = read_number(text.data(), text.data() + text.size(), one);
    const auto there = std::from_chars(text.data(), text.data() + text.size(), other);
    CHECK(here.ec == there.ec);
    CHECK(here.ptr == there.ptr);
    CHECK((one == other || (one != one && other != other)));
  }
}

}  // namespace
}  // namespace slipbench::live
