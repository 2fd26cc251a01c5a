// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/outliers.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/dice.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::vector<double> noise(test::Dice& dice, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    // Box and Muller.
    const double size = std::sqrt(-2.0 * std::log(1.0 - dice.between(0.0, 1.0)));
    values.push_back(size * std::cos(2.0 * std::numbers::pi * dice.between(0.0, 1.0)));
  }
  return values;
}

TEST_CASE("of normal noise fewer than 1 of 100 series have an outlier, however long they are") {
  test::Dice dice(11);
  for (const std::size_t count : {20U, 21U, 26U, 40U, 100U, 400U, 2001U}) {
    CAPTURE(count);
    const int series = count > 1000 ? 500 : 2000;
    int alarms = 0;
    for (int i = 0; i < series; ++i)
      alarms += !find_outliers(noise(dice, count), 0.0).points.empty();
    CHECK(alarms <= series / 100);
  }
}

TEST_CASE("the scale is that of the noise, whatever the outliers are") {
  test::Dice dice(5);
  std::vector<double> values = noise(dice, 2001);
  CHECK(robust_scale(values) == Approx(1.0).epsilon(0.05));
  for (const std::size_t i : {7U, 500U, 501U, 1400U, 2000U}) values[i] = 1e6;
  CHECK(robust_scale(values) == Approx(1.0).epsilon(0.05));
  CHECK(find_outliers(values, 0.0).points == std::vector<std::size_t>{7, 500, 501, 1400, 2000});
  CHECK(other_residuals(values, find_outliers(values, 0.0)).size() == 1996);
}

TEST_CASE("outliers of a few sigma beyond the limit are found, each of them") {
  test::Dice dice(3);
  std::vector<double> values = noise(dice, 2001);
  for (const std::size_t i : {100U, 700U, 1500U}) values[i] = i == 700U ? -8.0 : 8.0;
  CHECK(find_outliers(values, 0.0).points == std::vector<std::size_t>{100, 700, 1500});
}

TEST_CASE("a spike on a trend is an outlier, a trend has none") {
  test::Dice dice(9);
  std::vector<double> values = noise(dice, 1000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    // What a model leaves that lacks something at each reversal: flanks, steep but no leaps.
    const auto t = static_cast<double>(i);
    values[i] += 40.0 * std::exp(-std::pow(std::fmod(t, 125.0) - 60.0, 2) / 200.0);
  }
  CHECK(find_outliers(values, 0.0).points.empty());
  values[350] += 100.0;
  CHECK(find_outliers(values, 0.0).points == std::vector<std::size_t>{350});
}

TEST_CASE("what is scattered in two ways, is exact or is short has no outliers") {
  test::Dice dice(2);
  std::vector<double> values = noise(dice, 1000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= i / 100 % 2 == 0 ? 0.1 : 1.0;
  CHECK(find_outliers(values, 0.0).points.empty());
  // Most are met exactly, so that there is no noise to compare with.
  std::vector<double> exact(100, 0.0);
  exact[3] = 1.0;
  CHECK(find_outliers(exact, 0.0).points.empty());
  for (double& value : values) value *= 1e-12;
  values[3] = 1e-9;
  CHECK(find_outliers(values, 1e-9).points.empty());
  std::vector<double> few = noise(dice, 19);
  few[3] = 1e3;
  CHECK(find_outliers(few, 0.0).points.empty());
  CHECK(std::isnan(robust_scale({})));
}

}  // namespace
}  // namespace slipbench::driver::calibrate
