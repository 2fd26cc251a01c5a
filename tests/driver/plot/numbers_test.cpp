// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/numbers.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>
#include <string>

namespace slipbench::driver::plot {
namespace {

std::size_t different(double from, double step, int count, int digits) {
  std::set<std::string> texts;
  for (int i = 0; i < count; ++i) texts.insert(fmt::format("{:.{}g}", from + i * step, digits));
  return texts.size();
}

TEST_CASE("digits tell the rows of a short time late in a run apart") {
  // 200 increments of 5e-5 s after 1000 s, alone and behind a wait of 1000 s.
  CHECK(different(1000.0, 5e-5, 200, drawn_digits(1000.0, 1000.01)) == 200);
  CHECK(different(1000.0, 5e-5, 200, drawn_digits(0.0, 1000.01)) == 200);
  CHECK(different(1e6, 1e-9, 200, drawn_digits(1e6, 1e6 + 2e-7)) == 200);
}

TEST_CASE("a constant, and what is no number, have digits, too") {
  CHECK(drawn_digits(0.0, 0.0) == 9);
  CHECK(drawn_digits(7.0, 7.0) == 9);
  CHECK(drawn_digits(1.0, 1.0 + 1e-16) <= 17);
  CHECK(drawn_digits(1.0, 1.0 + 4e-16) == 17);
}

TEST_CASE("tics that six digits tell apart keep gnuplot's own format") {
  CHECK(tic_format(0.0, 2.5) == "% h");
  CHECK(tic_format(-0.1, 1000.0) == "% h");
  CHECK(tic_format(1000.0, 1000.01) == "%.8g");
  CHECK(different(1000.0, 0.002, 6, 8) == 6);
}

}  // namespace
}  // namespace slipbench::driver::plot
