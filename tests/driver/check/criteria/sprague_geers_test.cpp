// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/sprague_geers.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace slipbench::driver::check {
namespace {

constexpr double kPi = std::numbers::pi;

Series sampled(const std::function<double(double)>& f, double from, double to, int pieces) {
  Series curve;
  for (int i = 0; i <= pieces; ++i) {
    const double x = from + (to - from) * i / pieces;
    curve.abscissa.push_back(x);
    curve.value.push_back(f(x));
  }
  return curve;
}

cases::Tolerance within(double absolute) {
  return {.absolute = absolute, .relative = {}, .why = ""};
}

struct Errors {
  double comprehensive;
  double magnitude;
  double phase;
};
Errors errors(const Series& result, const Series& reference) {
  const CurveComparison found = compare_sprague_geers(result, reference, within(0.1));
  REQUIRE(found.fault == "");
  REQUIRE(found.measures.size() == 3);
  CHECK(found.measures[0].name == "comprehensive error");
  CHECK(found.measures[1].name == "magnitude error");
  CHECK(found.measures[2].name == "phase error");
  return {found.measures[0].value, found.measures[1].value, found.measures[2].value};
}

TEST_CASE("a curve and itself have no error of magnitude or phase, exactly") {
  const Series sine = sampled([](double t) { return 3.0 * std::sin(t); }, 0.0, 7.0, 173);
  const Errors found = errors(sine, sine);
  CHECK(found.comprehensive == 0.0);
  CHECK(found.magnitude == 0.0);
  CHECK(found.phase == 0.0);
}

TEST_CASE("a scaled curve has the error of magnitude of its factor") {
  const Series sine = sampled([](double t) { return std::sin(t) - 0.3; }, 0.0, 7.0, 100);
  const Series more = sampled([](double t) { return 1.25 * (std::sin(t) - 0.3); }, 0.0, 7.0, 100);
  const Series less = sampled([](double t) { return 0.8 * (std::sin(t) - 0.3); }, 0.0, 7.0, 100);
  // Both are linear between the same rows: only rounding is left.
  CHECK(errors(more, sine).magnitude == Approx(0.25).epsilon(1e-13));
  CHECK(errors(more, sine).phase == Approx(0.0).margin(1e-14));
  CHECK(errors(less, sine).magnitude == Approx(-0.2).epsilon(1e-13));
  CHECK(errors(less, sine).comprehensive == Approx(0.2).epsilon(1e-13));
}

TEST_CASE("a sine that is late by a part of its period has that phase error") {
  const double delay = 0.3;  // rad; cos(P pi) = cos(0.3) over whole periods
  const Series sine = sampled([](double t) { return std::sin(t); }, 0.0, 4.0 * kPi, 4000);
  const Series late = sampled([&](double t) { return std::sin(t - delay); }, 0.0, 4.0 * kPi, 4000);
  const Errors found = errors(late, sine);
  // The chords of a sine, h^2/12 with h = pi/1000, are common to both curves but for the phase.
  CHECK(found.phase == Approx(delay / kPi).epsilon(1e-6));
  CHECK(found.magnitude == Approx(0.0).margin(1e-9));
  CHECK(found.comprehensive == Approx(std::hypot(found.phase, found.magnitude)).epsilon(1e-15));
}

TEST_CASE("opposite curves have the whole phase error, and no result half of it") {
  const Series ramp = sampled([](double t) { return t; }, 0.0, 1.0, 10);
  const Series down = sampled([](double t) { return -t; }, 0.0, 1.0, 10);
  const Series zero = sampled([](double) { return 0.0; }, 0.0, 1.0, 10);
  CHECK(errors(down, ramp).phase == Approx(1.0).epsilon(1e-14));
  CHECK(errors(zero, ramp).magnitude == -1.0);
  CHECK(errors(zero, ramp).phase == 0.5);
}

TEST_CASE("integrals of products are exact between rows that do not coincide") {
  // f = t and r = 1 - t on [0, 1]: Int f^2 = Int r^2 = 1/3, Int f r = 1/6, angle acos(1/2).
  const Series f = sampled([](double t) { return t; }, 0.0, 1.0, 3);
  const Series r = sampled([](double t) { return 1.0 - t; }, 0.0, 1.0, 7);
  const Errors found = errors(f, r);
  CHECK(found.magnitude == Approx(0.0).margin(1e-15));
  CHECK(found.phase == Approx(1.0 / 3.0).epsilon(1e-14));
}

TEST_CASE("the same straight pieces with more rows are the same curve") {
  const auto saw = [](double t) { return std::abs(std::fmod(t, 2.0) - 1.0); };
  const Series coarse = sampled(saw, 0.0, 4.0, 4);
  const Series fine = sampled(saw, 0.0, 4.0, 4000);
  // Rounding of 4000 rows; the phase is the square root of an integral.
  CHECK(errors(fine, coarse).comprehensive < 1e-13);
  CHECK(errors(coarse, fine).comprehensive < 1e-13);
}

TEST_CASE("only the common range counts, and units do not") {
  const auto wave = [](double t) { return std::sin(5.0 * t) + 0.2; };
  const auto other = [](double t) { return 1.1 * std::sin(5.0 * t - 0.1) + 0.2; };
  const Errors plain = errors(sampled(wave, 0.0, 1.0, 100), sampled(other, 0.0, 1.0, 100));
  Series longer = sampled(wave, 0.0, 1.0, 100);
  longer.abscissa.push_back(2.0);
  longer.value.push_back(1e6);
  const Errors cut = errors(longer, sampled(other, 0.0, 1.0, 100));
  CHECK(cut.comprehensive == Approx(plain.comprehensive).epsilon(1e-13));

  Series f = sampled(wave, 0.0, 1.0, 100), r = sampled(other, 0.0, 1.0, 100);
  for (Series* curve : {&f, &r}) {
    for (double& x : curve->abscissa.change()) x *= 1e3;
    for (double& y : curve->value.change()) y *= 1e-6;
  }
  const Errors scaled = errors(f, r);
  CHECK(scaled.magnitude == Approx(plain.magnitude).epsilon(1e-12));
  CHECK(scaled.phase == Approx(plain.phase).epsilon(1e-12));
}

TEST_CASE("an abscissa that decreases throughout is compared as one that increases") {
  const auto f = [](double x) { return x * x; };
  const auto r = [](double x) { return 1.2 * x * x; };
  const Errors up = errors(sampled(f, 0.0, 1.0, 50), sampled(r, 0.0, 1.0, 50));
  const Errors down = errors(sampled(f, 1.0, 0.0, 50), sampled(r, 1.0, 0.0, 50));
  CHECK(down.comprehensive == Approx(up.comprehensive).epsilon(1e-13));
}

TEST_CASE("jumps stand where they are") {
  const Series step{{0.0, 1.0, 1.0, 2.0}, {1.0, 1.0, 3.0, 3.0}, {}};
  const Series constant{{0.0, 2.0}, {1.0, 1.0}, {}};
  // Int f^2 = 1 + 9, Int r^2 = 2, Int f r = 1 + 3.
  const Errors found = errors(step, constant);
  CHECK(found.magnitude == Approx(std::sqrt(5.0) - 1.0).epsilon(1e-14));
  CHECK(found.phase == Approx(std::acos(4.0 / std::sqrt(20.0)) / kPi).epsilon(1e-13));
}

TEST_CASE("the tolerance bounds the comprehensive error only") {
  const Series sine = sampled([](double t) { return std::sin(t); }, 0.0, 7.0, 100);
  const Series more = sampled([](double t) { return 1.25 * std::sin(t); }, 0.0, 7.0, 100);
  const CurveComparison narrow = compare_sprague_geers(more, sine, within(0.2));
  CHECK_FALSE(narrow.measures[0].passed());
  CHECK(narrow.measures[1].passed());
  const cases::Tolerance relative{.absolute = {}, .relative = 0.3, .why = ""};
  CHECK(compare_sprague_geers(more, sine, relative).measures[0].passed());
  CHECK(narrow.compared == 101);
}

TEST_CASE("no errors of magnitude and phase without a reference, a range or numbers") {
  const Series ramp = sampled([](double t) { return t; }, 0.0, 1.0, 10);
  const Series zero = sampled([](double) { return 0.0; }, 0.0, 1.0, 10);
  const auto fault = [](const Series& f, const Series& r) {
    const CurveComparison found = compare_sprague_geers(f, r, within(1e9));
    CHECK(found.measures.empty());
    return found.fault;
  };
  CHECK_THAT(fault(ramp, zero), Catch::Contains("zero throughout"));
  CHECK(fault(ramp, Series{}) != "");
  CHECK(fault(Series{}, ramp) != "");
  CHECK(fault(ramp, sampled([](double t) { return t; }, 2.0, 3.0, 10)) != "");
  CHECK(fault(ramp, sampled([](double t) { return t; }, 1.0, 3.0, 10)) != "");
  Series broken = ramp;
  broken.value.change()[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(fault(broken, ramp) != "");
  CHECK(fault(ramp, broken) != "");
  const Series loop{{0.0, 1.0, 0.0}, {0.0, 1.0, 2.0}, {}};
  CHECK_THAT(fault(loop, ramp), Catch::Contains("result goes back and forth"));
  CHECK_THAT(fault(ramp, loop), Catch::Contains("reference goes back and forth"));
}

}  // namespace
}  // namespace slipbench::driver::check
