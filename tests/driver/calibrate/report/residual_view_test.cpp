// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/residual_view.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "tests/driver/calibrate/report/made_fits.hpp"
#include "tests/support/dice.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// A response whose model is zero: the residuals are the negatives of what is measured.
FittedResponse response_of(std::vector<double> measured) {
  FittedResponse response;
  response.unit = "N";
  response.range = 10.0;
  response.after.assign(measured.size(), 0.0);
  response.measured = std::move(measured);
  return response;
}

ResidualView view_of(std::vector<double> residuals) {
  for (double& value : residuals) value = -value;
  const FittedResponse response = response_of(std::move(residuals));
  return residual_view(response, response.after);
}

std::vector<double> noise(std::size_t count, double shift) {
  test::Dice dice(7);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(dice.between(-1.0, 1.0) + shift);
  return values;
}

TEST_CASE("residuals are the model less the measurement, with mean and deviation") {
  const ResidualView view = view_of({1.0, 2.0, 3.0, 4.0});
  CHECK(view.residuals == std::vector<double>{1.0, 2.0, 3.0, 4.0});
  CHECK(view.mean == Approx(2.5));
  CHECK(view.deviation == Approx(std::sqrt(5.0 / 3.0)));
}

TEST_CASE("a histogram counts every residual once, the largest in the last bin") {
  const ResidualView view = view_of(noise(1000, 0.0));
  REQUIRE(view.counts.size() >= 8);
  REQUIRE(view.counts.size() <= 40);
  CHECK(std::accumulate(view.counts.begin(), view.counts.end(), std::int64_t{0}) == 1000);
  CHECK(view.counts.back() > 0);
  CHECK(view.lowest < -0.9);
  CHECK(view.highest > 0.9);
}

TEST_CASE("independent numbers look like noise") {
  const ResidualView view = view_of(noise(2000, 0.0));
  REQUIRE(view.autocorrelation.size() == 40);
  CHECK(view.noise_band == Approx(1.96 / std::sqrt(2000.0)));
  CHECK_FALSE(view.trend);
  CHECK(view.words.find("Looks like noise") == 0);
  CHECK(view.words.find("On average") == std::string::npos);
}

TEST_CASE("a slow swing is a trend, with the warning that errors are too small") {
  std::vector<double> swing;
  for (int i = 0; i < 400; ++i) swing.push_back(std::sin(2.0 * std::numbers::pi * i / 100.0));
  const ResidualView view = view_of(swing);
  // The sum over neighbours has one product fewer than that of the squares: 1/400 and less.
  CHECK(view.autocorrelation[0] == Approx(std::cos(2.0 * std::numbers::pi / 100.0)).margin(0.003));
  // A quarter of a period apart; of the 400 products 25 are missing.
  CHECK(view.autocorrelation[24] == Approx(0.0).margin(0.05));
  CHECK(view.trend);
  CHECK(view.words.find("A trend, no noise") == 0);
  CHECK(view.words.find("standard errors are too small") != std::string::npos);
}

TEST_CASE("numbers that change their sign from point to point are told apart from a trend") {
  std::vector<double> saw;
  for (int i = 0; i < 100; ++i) saw.push_back(i % 2 == 0 ? 1.0 : -1.0);
  const ResidualView view = view_of(saw);
  CHECK(view.autocorrelation[0] == Approx(-0.99));
  CHECK(view.words.find("differ in sign") != std::string::npos);
}

TEST_CASE("a mean beyond chance is told with its sign and unit") {
  const ResidualView above = view_of(noise(500, 0.5));
  CHECK(above.trend);
  CHECK(above.words.find("On average the model is 0.") != std::string::npos);
  CHECK(above.words.find(" N above the measurement.") != std::string::npos);
  const ResidualView below = view_of(noise(500, -0.5));
  CHECK(below.words.find(" N below the measurement.") != std::string::npos);
}

TEST_CASE("few points, no residuals and numbers that are none are told as such") {
  CHECK(view_of({1.0}).words == "1 point: too few to tell noise from a trend.");
  CHECK(view_of({}).counts.empty());
  const ResidualView exact = view_of(std::vector<double>(50, 0.0));
  CHECK(exact.words == "Nothing is left but rounding.");
  CHECK_FALSE(exact.trend);
  std::vector<double> holes = noise(100, 0.0);
  holes[3] = std::numeric_limits<double>::quiet_NaN();
  const ResidualView view = view_of(holes);
  CHECK(std::isfinite(view.deviation));
  CHECK(std::accumulate(view.counts.begin(), view.counts.end(), std::int64_t{0}) == 99);
}

TEST_CASE("what a made fit leaves is what was put into it") {
  const MadeFit made = made_slider_fit();
  const FittedResponse& fitted = made.calibration.experiments[0].responses[0];
  CHECK_FALSE(residual_view(fitted, fitted.after).trend);
  CHECK(residual_view(fitted, fitted.before).trend);
  const FittedResponse& held_out = made.calibration.experiments[2].responses[0];
  CHECK(residual_view(held_out, held_out.after).trend);
}

}  // namespace
}  // namespace slipbench::driver::calibrate
