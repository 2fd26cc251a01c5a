// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/amplitudes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace slipbench::driver::plot {
namespace {

double sine(double amplitude, double frequency, double t) {
  return amplitude * std::sin(2.0 * std::numbers::pi * frequency * t + 0.4);
}

TEST_CASE("a sine has its amplitude at its frequency, wherever that lies between the lines") {
  for (const double frequency : {12.5, 12.53, 12.57, 41.0 / 3.0}) {
    std::vector<double> times;
    std::vector<double> signal;
    for (int i = 0; i <= 2000; ++i) {
      // Increments of two lengths, and a mean that is not 0.
      times.push_back(i < 1000 ? 0.001 * i : 1.0 + 0.0015 * (i - 1000));
      signal.push_back(7.0 + sine(3.0, frequency, times.back()) + sine(0.5, 60.0, times.back()));
    }
    const Amplitudes found = amplitudes_of(times, signal);
    INFO(frequency);
    CHECK(found.peak == Approx(3.0).epsilon(0.01));
    CHECK(found.peak_frequency == Approx(frequency).epsilon(1e-3));
    CHECK(found.values[0] == 0.0);
    const auto second = static_cast<std::size_t>(std::lround(60.0 / found.step));
    CHECK(found.values[second] == Approx(0.5).epsilon(0.03));
  }
}

TEST_CASE("what does not vibrate has no peak") {
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) times.push_back(0.1 * i);
  CHECK(amplitudes_of(times, std::vector<double>(100, 5.0)).peak == Approx(0.0).margin(1e-12));
  CHECK(amplitudes_of({}, {}).values.empty());
  const std::vector<double> same(10, 1.0);
  CHECK(amplitudes_of(same, same).values.empty());
}

}  // namespace
}  // namespace slipbench::driver::plot
