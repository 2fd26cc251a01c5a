// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/drawn_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/calibrate/report/made_fits.hpp"

namespace slipbench::driver::calibrate {
namespace {

TEST_CASE("few points are all drawn") {
  const MadeFit made = made_slider_fit();
  const FittedResponse& response = made.calibration.experiments[0].responses[0];
  const DrawnPoints drawn = drawn_points(response, 3000);
  CHECK_FALSE(drawn.thinned);
  CHECK(drawn.time == response.time);
  CHECK(drawn.position == response.positions);
  CHECK(drawn.measured == response.measured);
  CHECK(drawn.before == response.before);
  CHECK(drawn.after == response.after);
}

TEST_CASE("of many points the extremes of every curve and of the residuals stay") {
  const MadeFit made = made_large_fit();
  const FittedResponse& response = made.calibration.experiments[0].responses[0];
  const DrawnPoints drawn = drawn_points(response, 1000);
  CHECK(drawn.thinned);
  CHECK(drawn.time.size() <= 1000);
  CHECK(drawn.time.size() > 200);
  CHECK(drawn.time.front() == response.time.front());
  CHECK(drawn.time.back() == response.time.back());
  CHECK(std::is_sorted(drawn.time.begin(), drawn.time.end()));
  const auto extremes = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return std::pair(*low, *high);
  };
  CHECK(extremes(drawn.measured) == extremes(response.measured));
  const auto residuals = [](const auto& of) {
    std::vector<double> values;
    for (std::size_t i = 0; i < of.after.size(); ++i)
      values.push_back(of.after[i] - of.measured[i]);
    return values;
  };
  CHECK(extremes(residuals(drawn)) == extremes(residuals(response)));
}

TEST_CASE("a model that could not be run leaves gaps, no picture fails for it") {
  const MadeFit made = made_slider_fit();
  FittedResponse response = made.calibration.experiments[0].responses[0];
  response.before.clear();
  const DrawnPoints drawn = drawn_points(response, 3000);
  REQUIRE(drawn.before.size() == response.measured.size());
  CHECK(std::isnan(drawn.before[5]));
  CHECK(drawn.after == response.after);
}

TEST_CASE("loops are drawn over what is compared over, else over the position") {
  const MadeFit over_time = made_slider_fit();
  CHECK(loop_axis(over_time.calibration.experiments[0].responses[0]).name == "CP1");
  const MadeFit over_position = made_large_fit();
  const FittedResponse& response = over_position.calibration.experiments[0].responses[0];
  CHECK(loop_axis(response).name == "CP1");
  CHECK(loop_axis(response).unit == "mm");
  CHECK(drawn_points(response, 500).position.size() == drawn_points(response, 500).time.size());
  FittedResponse without = over_time.calibration.experiments[0].responses[0];
  without.positions.clear();
  CHECK(loop_axis(without).name.empty());
  CHECK(drawn_points(without, 500).position.empty());
}

}  // namespace
}  // namespace slipbench::driver::calibrate
