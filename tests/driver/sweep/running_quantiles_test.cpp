// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/running_quantiles.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace slipbench::driver::sweep {
namespace {

RunningQuantiles quantiles_of(const std::vector<double>& values) {
  RunningQuantiles quantiles;
  for (const double value : values) quantiles.add(value);
  return quantiles;
}

/// The value of a rank, found by sorting.
double sorted_at(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

TEST_CASE("Quantiles are within 1 % of the sorted ones, in any order") {
  std::mt19937_64 dice(3);
  std::lognormal_distribution<double> wide(-1.5, 2.0);
  std::normal_distribution<double> both_signs(0.3, 1.0);
  for (const bool positive : {true, false}) {
    std::vector<double> values(5000);
    for (double& value : values) value = positive ? wide(dice) : both_signs(dice);
    for (int order = 0; order < 3; ++order) {
      if (order == 1) std::sort(values.begin(), values.end());
      if (order == 2) std::reverse(values.begin(), values.end());
      const RunningQuantiles found = quantiles_of(values);
      for (const double part : {0.0, 0.01, 0.05, 0.3, 0.5, 0.95, 0.999, 1.0}) {
        INFO("order " << order << ", part " << part);
        CHECK(found.at(part) == Approx(sorted_at(values, part)).epsilon(0.01));
        std::vector<RunningQuantiles> parts(3);
        for (std::size_t i = 0; i < values.size(); ++i) parts[i * i % 3].add(values[i]);
        parts[1].add(parts[0]);
        parts[1].add(parts[2]);
        CHECK(parts[1].at(part) == found.at(part));
      }
    }
  }
}

TEST_CASE("Quantiles of few different values are values that occur") {
  std::vector<double> values;
  values.reserve(1000);
  for (int i = 0; i < 1000; ++i) values.push_back(i % 5 < 3 ? 2.0 : 200.0);
  const RunningQuantiles found = quantiles_of(values);
  CHECK(found.at(0.05) == 2.0);
  CHECK(found.at(0.5) == 2.0);
  CHECK(found.at(0.6) == 2.0);
  CHECK(found.at(0.61) == 200.0);
  CHECK(quantiles_of({-3.0, 0.0, 11.0}).at(0.5) == 0.0);
  CHECK(quantiles_of({7.0}).at(0.95) == 7.0);
  CHECK(std::isnan(quantiles_of({}).at(0.5)));
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> extreme{-infinity, -1.7e308, 5e-324, 1.7e308, infinity};
  for (std::size_t i = 0; i < extreme.size(); ++i) {
    CHECK(quantiles_of(extreme).at(0.2 * static_cast<double>(i + 1)) == extreme[i]);
  }
}

}  // namespace
}  // namespace slipbench::driver::sweep
