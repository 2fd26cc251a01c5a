// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_fields.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace slipbench::driver::base {
namespace {

/// Holds a number, with a line end behind it, against std::from_chars.
void check_number(const std::string& text) {
  const std::string line = text + "\n";
  double wanted = 0.0;
  const auto known = std::from_chars(line.data(), line.data() + line.size(), wanted);
  double found = 0.0;
  const char* const stop = read_number(line.data(), line.data() + line.size(), '.', found);
  if (stop != known.ptr ||
      std::bit_cast<std::uint64_t>(found) != std::bit_cast<std::uint64_t>(wanted)) {
    FAIL(text << " is read as " << found);
  }
}

TEST_CASE("a number is the nearest double, whatever its digits") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i) {
    std::string digits = std::to_string(random() >> (random() % 24));
    digits.resize(std::min(digits.size(), std::size_t{1} + random() % 21));
    const std::size_t point = random() % (digits.size() + 1);
    check_number(digits);
    digits.insert(point, point == 0 ? "0." : ".");
    check_number(digits);
    check_number("-" + digits);
    std::array<char, 400> shortest{};
    const double number =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 160);
    check_number({shortest.data(),
                  std::to_chars(shortest.data(), shortest.data() + shortest.size(), number).ptr});
    check_number({shortest.data(), std::to_chars(shortest.data(), shortest.data() + shortest.size(),
                                                 number, std::chars_format::fixed)
                                       .ptr});
  }
  for (const char* text : {"0.0000000000000000", "-0.00000000000000000", "0.0000000000000000001"}) {
    check_number(text);
  }
}

TEST_CASE("a number halfway between two doubles goes to the even one") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i) {
    // An odd integer of 54 bits and its halves; over 2^k it has k decimals.
    std::uint64_t digits = (std::uint64_t{1} << 53U) | (random() >> 11U) | 1U;
    std::size_t decimals = random() % 4;
    for (std::size_t k = 0; k < decimals; ++k) digits *= 5;
    std::string text = std::to_string(digits);
    if (decimals > 0) text.insert(text.size() - decimals, ".");
    check_number(text);
    check_number(text + (decimals > 0 ? "" : ".") + "1");
  }
}

}  // namespace
}  // namespace slipbench::driver::base
