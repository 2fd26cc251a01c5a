// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/likely_cause.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace slipbench::driver::check {
namespace {

constexpr int kStick = 1, kSlip = 2, kUnknown = -1;

/// The force of an elastic slider along a path of positions.
struct Slider {
  double stiffness = 1000.0;
  double limit = 20.0;
  double force = 0.0;
  double position = 0.0;

  int move_to(double to) {
    const double trial = force + stiffness * (to - position);
    position = to;
    force = std::clamp(trial, -limit, limit);
    return std::abs(trial) > limit ? kSlip : kStick;
  }
};

double ramp(double t) { return 0.1 * t; }
/// To and fro between +-0.1, corners on rows.
double triangle(double t) {
  const double phase = t - std::floor(t);
  return phase < 0.25 ? 0.4 * phase : phase < 0.75 ? 0.2 - 0.4 * phase : 0.4 * phase - 0.4;
}

/// Runs a slider of other numbers on a path, against 20 N and 1000 N/mm; the status is that
/// of the result.
std::vector<CausePoint> sliders(Slider result, const std::function<double(double)>& path,
                                double duration, int rows, double tolerance) {
  Slider reference;
  std::vector<CausePoint> points;
  for (int i = 0; i <= rows; ++i) {
    const double t = duration * i / rows;
    const int status = result.move_to(path(t));
    reference.move_to(path(t));
    points.push_back({{t, result.force, reference.force, t},
                      status,
                      std::abs(result.force - reference.force) > tolerance});
  }
  return points;
}

/// f against r over time, status unknown.
std::vector<CausePoint> curves(const std::function<double(double)>& f,
                               const std::function<double(double)>& r, int rows, double tolerance,
                               int status = kUnknown) {
  std::vector<CausePoint> points;
  for (int i = 0; i <= rows; ++i) {
    const double t = static_cast<double>(i) / rows;
    points.push_back({{t, f(t), r(t), t}, status, std::abs(f(t) - r(t)) > tolerance});
  }
  return points;
}

std::string cause(const std::vector<CausePoint>& points, double tolerance) {
  return likely_cause(points,
                      {.tolerance = tolerance, .unit = "N", .over_time = true, .time_unit = "s"});
}

TEST_CASE("a ratio in slip is the coefficient, in a pull and in loops") {
  CHECK(cause(sliders({.limit = 21.4}, ramp, 1.0, 100, 0.5), 0.5) ==
        "looks like the coefficient (or the normal force): ratio 1.07 everywhere in slip");
  CHECK(cause(sliders({.limit = 18.0}, ramp, 1.0, 100, 0.5), 0.5) ==
        "looks like the coefficient (or the normal force): ratio 0.9 everywhere in slip");
  CHECK(cause(sliders({.limit = 21.4}, triangle, 2.0, 400, 0.5), 0.5) ==
        "looks like the coefficient (or the normal force): ratio 1.07 everywhere in slip");
  CHECK(cause(sliders({.limit = 18.6}, triangle, 2.0, 400, 0.5), 0.5) ==
        "looks like the coefficient (or the normal force): ratio 0.93 everywhere in slip");
  CHECK(cause(sliders({.limit = 20.006}, triangle, 2.0, 400, 1e-4), 1e-4) ==
        "looks like the coefficient (or the normal force): ratio 1.0003 everywhere in slip");
}

TEST_CASE("a ratio in slip is told whatever the sign of the force, and if every row slips") {
  const auto points =
      curves([](double) { return -21.4; }, [](double) { return -20.0; }, 30, 0.5, kSlip);
  CHECK(cause(points, 0.5) ==
        "looks like the coefficient (or the normal force): ratio 1.07 everywhere in slip");
}

TEST_CASE("a ratio in stick is the stiffness, in a pull and in loops") {
  CHECK(cause(sliders({.stiffness = 900.0}, ramp, 1.0, 500, 0.1), 0.1) ==
        "looks like the stick stiffness (or the motion): ratio 0.9 everywhere in stick");
  CHECK(cause(sliders({.stiffness = 1100.0}, ramp, 1.0, 500, 0.1), 0.1) ==
        "looks like the stick stiffness (or the motion): ratio 1.1 everywhere in stick");
  CHECK(cause(sliders({.stiffness = 900.0}, triangle, 2.0, 4000, 0.1), 0.1) ==
        "looks like the stick stiffness (or the motion): ratio 0.9 everywhere in stick");
  CHECK(cause(sliders({.stiffness = 1100.0}, triangle, 2.0, 4000, 0.1), 0.1) ==
        "looks like the stick stiffness (or the motion): ratio 1.1 everywhere in stick");
}

TEST_CASE("coefficient and stiffness at once are neither") {
  const auto points = sliders({.stiffness = 800.0, .limit = 22.0}, triangle, 2.0, 1000, 0.1);
  CHECK(cause(points, 0.1) == "");
  // A limit that is off by less than the tolerance is not the stiffness's doing either.
  CHECK(cause(sliders({.stiffness = 1050.0, .limit = 19.7}, triangle, 2.0, 1000, 0.5), 0.5) == "");
}

double wave(double t) { return 20.0 * std::sin(7.0 * t) + 5.0 * std::cos(17.0 * t); }

TEST_CASE("the negative of the reference is a wrong sign") {
  CHECK(cause(curves([](double t) { return -wave(t); }, wave, 200, 0.1), 0.1) ==
        "looks like the sign: the negative of the reference everywhere");
  CHECK(cause(sliders({.stiffness = -1000.0}, ramp, 1.0, 100, 0.1), 0.1) ==
        "looks like the sign: the negative of the reference everywhere");
}

TEST_CASE("one difference everywhere is an offset") {
  CHECK(cause(curves([](double t) { return wave(t) - 0.31; }, wave, 200, 0.1), 0.1) ==
        "looks like an offset: -0.31 N everywhere");
  CHECK(cause(curves([](double) { return 3.0; }, [](double) { return 0.0; }, 200, 0.1), 0.1) ==
        "looks like an offset: +3 N everywhere");
}

TEST_CASE("one ratio everywhere is a factor, or a unit") {
  CHECK(cause(curves([](double t) { return 1.5 * wave(t); }, wave, 200, 0.1), 0.1) ==
        "looks like a factor: ratio 1.5 everywhere");
  CHECK(cause(curves([](double t) { return 1e-3 * wave(t); }, wave, 200, 0.1), 0.1) ==
        "looks like a unit: ratio 0.001 everywhere");
  CHECK(cause(curves([](double) { return 0.0; }, wave, 200, 0.1), 0.1) ==
        "looks like no load at all: the result is zero everywhere");
}

TEST_CASE("a curve that comes later or earlier is a delay, over time only") {
  const auto late = curves([](double t) { return wave(t - 0.02); }, wave, 1000, 0.1);
  CHECK(cause(late, 0.1) == "looks like a delay: the result is 0.02 s late");
  CHECK(cause(curves([](double t) { return wave(t + 0.05); }, wave, 1000, 0.1), 0.1) ==
        "looks like a delay: the result is 0.05 s early");
  CHECK(likely_cause(late, {.tolerance = 0.1, .unit = "N", .over_time = false, .time_unit = "s"}) ==
        "");
  // Plateaus, where every delay fits, between ramps.
  const auto flat = [](double t) {
    return std::clamp(100.0 * (std::abs(t - 0.5) - 0.25), -10.0, 10.0);
  };
  CHECK(cause(curves([&](double t) { return flat(t - 0.031); }, flat, 500, 0.1), 0.1) ==
        "looks like a delay: the result is 0.031 s late");
}

TEST_CASE("a few points of their own do not hide a cause") {
  auto points = sliders({.limit = 21.4}, ramp, 1.0, 200, 0.5);
  points[60].point.value = 35.0;
  points[120].point.value = -3.0;
  points[150].point.value = 22.0;
  CHECK(cause(points, 0.5) ==
        "looks like the coefficient (or the normal force): ratio 1.07 everywhere in slip");
  for (std::size_t i = 160; i < 190; ++i) points[i].point.value = 23.0;
  CHECK(cause(points, 0.5) == "");
}

TEST_CASE("deviations without one cause are not explained") {
  CHECK(cause(curves([](double t) { return wave(t) + 0.5 * std::sin(40.0 * t); }, wave, 300, 0.1),
              0.1) == "");
  CHECK(cause(curves([](double t) { return wave(t) + 3.0 * t; }, wave, 300, 0.1), 0.1) == "");
  CHECK(cause(curves([](double t) { return wave(1.1 * t); }, wave, 300, 0.1), 0.1) == "");
  // Right in one half, a ratio in the other one.
  CHECK(cause(curves([](double t) { return t < 0.5 ? wave(t) : 1.1 * wave(t); }, wave, 300, 0.1),
              0.1) == "");
  CHECK(cause(curves([](double t) { return t < 0.5 ? wave(t) : wave(t) + 1.0; }, wave, 300, 0.1),
              0.1) == "");
  // A ratio that wanders by an eighth of the deviation.
  const auto limit = [](double t) { return 20.0 + 5.0 * std::sin(4.0 * t); };
  CHECK(cause(curves([&](double t) { return (1.08 + 0.01 * std::sin(9.0 * t)) * limit(t); }, limit,
                     300, 0.01, kSlip),
              0.01) == "");
  // A ratio in half of the stick.
  auto sticking = sliders({.stiffness = 900.0}, triangle, 2.0, 4000, 0.1);
  for (std::size_t i = 0; i < 2000; ++i) {
    sticking[i].point.value = sticking[i].point.reference;
    sticking[i].failing = false;
  }
  CHECK(cause(sticking, 0.1) == "");
  // A ratio in half of the slip.
  auto half = sliders({.limit = 21.4}, ramp, 1.0, 200, 0.5);
  for (std::size_t i = 120; i < half.size(); ++i) {
    half[i].point.value = half[i].point.reference;
    half[i].failing = false;
  }
  CHECK(cause(half, 0.5) == "");
}

TEST_CASE("a reference of one level does not tell a ratio from an offset") {
  const auto level = [](int status) {
    return cause(curves([](double) { return 21.4; }, [](double) { return 20.0; }, 30, 0.5, status),
                 0.5);
  };
  CHECK(level(kUnknown) == "");
  CHECK(level(kStick) == "");
  CHECK(level(kSlip) ==
        "looks like the coefficient (or the normal force): ratio 1.07 everywhere in slip");
}

TEST_CASE("one or two failing points, or none, explain nothing") {
  CHECK(cause({}, 0.5) == "");
  CHECK(cause(curves(wave, wave, 100, 0.5), 0.5) == "");
  auto points = curves(wave, wave, 100, 0.5);
  for (const std::size_t i : {30u, 31u}) {
    points[i].point.value *= 1.1;
    points[i].failing = true;
  }
  CHECK(cause(points, 0.5) == "");
  for (CausePoint& p : points) p.point.value = std::numeric_limits<double>::quiet_NaN();
  CHECK(cause(points, 0.5) == "");
}

/// The points of a pull that first rests for ten rows, whose result becomes what `change` makes of
/// it.
std::vector<CausePoint> pull(const Slider& slider, const std::function<double(double)>& change,
                             const std::function<double(double)>& path, double duration) {
  auto points = sliders(
      slider, [&](double t) { return path(std::max(0.0, t - 0.05)); }, duration, 200, 0.1);
  for (CausePoint& p : points) {
    p.point.value = change(p.point.value);
    p.failing = std::abs(p.point.value - p.point.reference) > 0.1;
  }
  return points;
}

TEST_CASE(
    "an offset is not told as the coefficient, for before the first slip that changes nothing") {
  const auto told = [](double limit, double offset) {
    return cause(pull(
                     {.limit = limit}, [&](double f) { return f + offset; },
                     [](double t) { return t; }, 1.0),
                 0.1);
  };
  CHECK(told(20.0, 1.0) == "looks like an offset: +1 N everywhere");
  CHECK(told(20.0, -5.0) == "looks like an offset: -5 N everywhere");
  CHECK(told(22.0, 1.0) == "");
  CHECK(told(22.0, 0.0) ==
        "looks like the coefficient (or the normal force): ratio 1.1 everywhere in slip");
  CHECK(told(16.0, 0.0) ==
        "looks like the coefficient (or the normal force): ratio 0.8 everywhere in slip");
}

TEST_CASE("the first stick may be off where only the reference has reached its limit") {
  // Slow enough that a tenth of the points sticks while the reference slips.
  CHECK(cause(sliders({.limit = 30.0}, ramp, 0.5, 200, 0.5), 0.5) ==
        "looks like the coefficient (or the normal force): ratio 1.5 everywhere in slip");
}

TEST_CASE("a factor or a unit is not told as the coefficient, in pulls and in loops") {
  const auto told = [](double factor, const std::function<double(double)>& path, double duration,
                       double limit = 20.0) {
    return cause(pull(
                     {.limit = limit}, [&](double f) { return factor * f; }, path, duration),
                 0.1);
  };
  const auto slow = [](double t) { return 0.2 * t; };
  CHECK(told(4.448, slow, 1.0) == "looks like a factor: ratio 4.45 everywhere");
  CHECK(told(1.05, slow, 1.0) == "looks like a factor: ratio 1.05 everywhere");
  CHECK(told(4.448, triangle, 2.0) == "looks like a factor: ratio 4.45 everywhere");
  CHECK(told(1.05, triangle, 2.0) == "looks like a factor: ratio 1.05 everywhere");
  CHECK(told(1000.0, triangle, 2.0) == "looks like a unit: ratio 1e+03 everywhere");
  CHECK(told(1000.0, triangle, 2.0, 22.0) == "");
  // Nothing but stick: the stiffness and a factor are one.
  CHECK(told(
            1.05, [](double t) { return 0.01 * t; }, 1.0) ==
        "looks like the stick stiffness (or the motion), or a factor: ratio 1.05 everywhere");
}

TEST_CASE("where the stick stiffness follows the limit, the coefficient is a factor") {
  const auto points = pull(
      {.stiffness = 1100.0, .limit = 22.0}, [](double f) { return f; }, triangle, 2.0);
  CHECK(likely_cause(points, {.tolerance = 0.1,
                              .unit = "N",
                              .over_time = true,
                              .time_unit = "s",
                              .stiffness_follows_limit = true}) ==
        "looks like the coefficient (or the normal force), or a factor: ratio 1.1 everywhere");
  CHECK(cause(points, 0.1) == "looks like a factor: ratio 1.1 everywhere");
}

TEST_CASE("a factor that the first stick contradicts is none") {
  // Coefficient and stiffness at once, in a pull of few stick rows.
  CHECK(cause(pull(
                  {.stiffness = 1200.0, .limit = 22.0}, [](double f) { return f; },
                  [](double t) { return 0.9 * t; }, 1.0),
              0.1) == "");
}

}  // namespace
}  // namespace slipbench::driver::check
