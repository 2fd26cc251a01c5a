// SPDX-License-Identifier: Apache-2.0
#include "reference/first_order_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using std::numbers::pi;

TEST_CASE("the filter's answer to a step has the printed values") {
  const auto rows = evaluate("filter_step_response", {{0.2}, {1e-3}, {100.0}, {0.5}},
                             {{0.5}, {0.501}, {0.505}, {0.51}, {0.52}, {0.3}});
  CHECK(rows[0][0] == 0.0);
  CHECK_THAT(rows[1][0], printed("20.0"));
  CHECK_THAT(rows[2][0], printed("67.232"));
  CHECK_THAT(rows[3][0], printed("89.26258176"));
  CHECK_THAT(rows[4][0], printed("98.8470784953932"));
  CHECK(rows[4][1] == 20.0);
  CHECK(rows[5][0] == 0.0);
}

TEST_CASE("a smoothing factor of 1 passes the step and one above 1 alternates about it") {
  CHECK(first_order_filter::step_response(1.0, 0.0) == 0.0);
  CHECK(first_order_filter::step_response(1.0, 1.0) == 1.0);
  CHECK(first_order_filter::step_response(1.5, 1.0) == 1.5);
  CHECK(first_order_filter::step_response(1.5, 2.0) == 0.75);
  CHECK(first_order_filter::step_response(2.0, 3.0) == 2.0);
}

TEST_CASE("gain and phase of a harmonic are those of the recursion's transfer function") {
  for (const double a : {0.01, 0.2, 0.5, 0.9, 1.0, 1.6}) {
    for (const double w : {0.01, 0.3, 1.0, 3.0}) {
      CAPTURE(a, w);
      const auto transfer = a / (1.0 - (1.0 - a) * std::polar(1.0, -w));
      // 1 - (1 - a) cos w loses the digits of the smaller of a and w.
      CHECK(first_order_filter::gain(a, w) == Approx(std::abs(transfer)).epsilon(1e-12));
      CHECK(first_order_filter::phase(a, w) == Approx(std::arg(transfer)).margin(1e-12));
    }
  }
}

TEST_CASE("the power is halved where the cosine formula says, and nowhere for weak filters") {
  for (const double a : {0.01, 0.2, 0.5, 0.8}) {
    const double w = first_order_filter::half_power_step(a).value();
    CHECK(std::cos(w) == Approx(1.0 - a * a / (2.0 * (1.0 - a))).epsilon(1e-14));
    CHECK(first_order_filter::gain(a, w) == Approx(std::sqrt(0.5)).epsilon(1e-14));
  }
  CHECK_FALSE(first_order_filter::half_power_step(0.8285).has_value());
  CHECK(first_order_filter::half_power_step(0.828427).has_value());
  // How far the nominal step, a, lies below the exact one; printed to two figures.
  const auto low = [](double a) { return 1.0 - a / *first_order_filter::half_power_step(a); };
  CHECK(low(0.01) == Approx(0.005).margin(5e-4));
  CHECK(low(0.2) == Approx(0.11).margin(5e-3));
  CHECK(low(0.5) == Approx(0.31).margin(5e-3));
}

TEST_CASE("sum and harmonic solve the recursion") {
  constexpr double kDt = 1e-3, kCycle = 0.05, kAmplitude = 30.0, kMean = 12.0, kBegin = 0.2;
  for (const double a : {0.1, 0.7, 1.3}) {
    CAPTURE(a);
    std::vector<std::vector<double>> times, forces;
    for (int n = 0; n <= 120; ++n) {
      times.push_back({kBegin + n * kDt});
      forces.push_back({kMean + kAmplitude * std::sin(2.0 * pi * n * kDt / kCycle), 50.0});
    }
    const auto harmonic =
        evaluate("filter_harmonic", {{a}, {kDt}, {kCycle}, {kAmplitude}, {kMean}, {kBegin}}, times);
    const auto sum = evaluate("filtered_force", {{a}}, forces);
    double recursion = 0.0;
    for (std::size_t n = 0; n < times.size(); ++n) {
      if (n > 0) recursion = a * forces[n][0] + (1.0 - a) * recursion;
      // Roundings of 120 terms of the size 40.
      CHECK(harmonic[n][0] == Approx(recursion).margin(1e-12));
      CHECK(sum[n][0] == Approx(recursion).margin(1e-12));
      CHECK(harmonic[n][2] == Approx(forces[n][0]).margin(1e-12));
    }
    // What is left of the start, 0.9^120 = 3e-6 of it at most.
    CHECK(harmonic.back()[0] == Approx(harmonic.back()[1]).margin(1e-4));
  }
}

TEST_CASE("the filtered force starts from nothing after a loss of contact") {
  const auto rows = evaluate("filtered_force", {{0.25}},
                             {{8.0, 1.0}, {8.0, 1.0}, {8.0, 1.0}, {8.0, 0.0}, {8.0, 1.0}});
  CHECK(rows[0][0] == 0.0);
  CHECK(rows[1][0] == 2.0);
  CHECK(rows[2][0] == 3.5);
  CHECK(rows[3][0] == 0.0);
  CHECK(rows[4][0] == 2.0);
}
