// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/iso18571.hpp"

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

constexpr double kPi = std::numbers::pi;
constexpr int kParts = 1000;  // of the rating

using Function = std::function<double(double)>;

Series sampled(const Function& f, int pieces, double length = 1.0) {
  Series curve;
  for (int i = 0; i <= pieces; ++i) {
    const double x = length * i / pieces;
    curve.abscissa.push_back(x);
    curve.value.push_back(f(x));
  }
  return curve;
}

/// Constant in each of the rating's parts, so that it has these samples exactly.
Series stairs(const std::vector<double>& samples) {
  Series curve;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const std::size_t end : {i, i + 1}) {
      curve.abscissa.push_back(static_cast<double>(end) / static_cast<double>(samples.size()));
      curve.value.push_back(samples[i]);
    }
  }
  return curve;
}

std::vector<double> samples(const Function& f) {
  std::vector<double> out;
  out.reserve(kParts);
  for (int i = 0; i < kParts; ++i) out.push_back(f((i + 0.5) / kParts));
  return out;
}

/// Four periods of +-1, jumps between the samples.
std::vector<double> square_wave() {
  std::vector<double> out;
  out.reserve(kParts);
  for (int i = 0; i < kParts; ++i) out.push_back(i / 125 % 2 == 0 ? 1.0 : -1.0);
  return out;
}
std::vector<double> changed(std::vector<double> samples, double factor, double offset) {
  for (double& x : samples) x = factor * x + offset;
  return samples;
}

cases::Tolerance within(double absolute) {
  return {.absolute = absolute, .relative = {}, .why = ""};
}

struct Rating {
  double r, z, phase, magnitude, slope, delay;
};
Rating rating(const Series& result, const Series& reference) {
  const CurveComparison found = compare_iso18571(result, reference, within(0.1));
  REQUIRE(found.fault == "");
  REQUIRE(found.measures.size() == 6);
  const auto value = [&](std::size_t i, const std::string& name) {
    CHECK(found.measures[i].name == name);
    return found.measures[i].value;
  };
  const Rating out{value(0, "rating"),          value(1, "corridor score"), value(2, "phase score"),
                   value(3, "magnitude score"), value(4, "slope score"),    value(5, "delay")};
  CHECK(found.measures[0].deviation == Approx(1.0 - out.r).margin(1e-15));
  CHECK(out.r == Approx(0.4 * out.z + 0.2 * (out.phase + out.magnitude + out.slope)).margin(1e-14));
  return out;
}

double wave(double t) { return std::sin(12.0 * t * t + 3.0 * t) + 0.4 * std::cos(31.0 * t); }

TEST_CASE("equal curves are rated 1, exactly") {
  const Series curve = sampled(wave, 777);
  const CurveComparison found = compare_iso18571(curve, curve, within(0.0));
  REQUIRE(found.fault == "");
  CHECK(found.measures[0].value == 1.0);
  CHECK(found.measures[0].deviation == 0.0);
  CHECK(found.measures[0].passed());
  CHECK(found.measures[5].value == 0.0);
  CHECK(found.compared == 778);
}

TEST_CASE("a constant offset within the inner corridor costs magnitude only") {
  const Rating found = rating(stairs(changed(square_wave(), 1.0, 0.04)), stairs(square_wave()));
  CHECK(found.z == 1.0);
  CHECK(found.phase == 1.0);
  // No warping path avoids the offset, so the shortest one is taken: e = 0.04 of the limit 0.5.
  CHECK(found.magnitude == Approx(0.92).epsilon(1e-12));
  CHECK(found.slope == Approx(1.0).epsilon(1e-12));
  CHECK(found.r == Approx(0.984).epsilon(1e-12));
}

TEST_CASE("the corridor falls with the square between 5 and 50 percent of the largest value") {
  const auto z = [](double offset) {
    return rating(stairs(changed(square_wave(), 1.0, offset)), stairs(square_wave())).z;
  };
  CHECK(z(0.049999) == 1.0);
  CHECK(z(0.275) == Approx(0.25).epsilon(1e-12));
  CHECK(z(-0.14) == Approx(0.64).epsilon(1e-12));
  CHECK(z(0.499999) == Approx(0.0).margin(1e-10));
  CHECK(z(0.51) == 0.0);
  CHECK(z(7.0) == 0.0);
}

TEST_CASE("a scaled curve has the ratings that follow from its factor") {
  const Rating found = rating(stairs(changed(square_wave(), 1.1, 0.0)), stairs(square_wave()));
  const double corridor = std::pow((0.5 - 0.1) / 0.45, 2);
  CHECK(found.z == Approx(corridor).epsilon(1e-12));
  CHECK(found.phase == 1.0);
  CHECK(found.magnitude == Approx(1.0 - 0.1 / 0.5).epsilon(1e-12));
  CHECK(found.slope == Approx(1.0 - 0.1 / 2.0).epsilon(1e-12));
  CHECK(found.r == Approx(0.4 * corridor + 0.2 * (1.0 + 0.8 + 0.95)).epsilon(1e-12));
  // Twice as large: the error of magnitude 1 is beyond its limit, that of slope half of its own.
  const Rating twice = rating(stairs(changed(square_wave(), 2.0, 0.0)), stairs(square_wave()));
  CHECK(twice.magnitude == 0.0);
  CHECK(twice.slope == Approx(0.5).epsilon(1e-12));
  const Rating thrice = rating(stairs(changed(square_wave(), 3.5, 0.0)), stairs(square_wave()));
  CHECK(thrice.slope == 0.0);
  CHECK(thrice.r == Approx(0.2).epsilon(1e-12));
}

TEST_CASE("where the curves agree on a plateau, warping does not count it more than once") {
  std::vector<double> result = square_wave();
  for (std::size_t i = 500; i < result.size(); ++i) result[i] *= 1.1;
  // Half of the samples are off by 0.1: e = 0.05 of the limit 0.5.
  CHECK(rating(stairs(result), stairs(square_wave())).magnitude == Approx(0.9).epsilon(1e-12));
}

TEST_CASE(
    "a pure shift of p percent costs p/20 of the phase score, and neither magnitude nor slope") {
  for (const int steps : {1, 10, 100, 150}) {
    CAPTURE(steps);
    const double shift = static_cast<double>(steps) / kParts;
    const Series reference = stairs(samples(wave));
    const Series late = stairs(samples([&](double t) { return wave(t - shift); }));
    const Series early = stairs(samples([&](double t) { return wave(t + shift); }));
    const double phase = 1.0 - shift / 0.2;
    const Rating of_late = rating(late, reference);
    CHECK(of_late.phase == Approx(phase).epsilon(1e-12));
    CHECK(of_late.delay == Approx(shift).epsilon(1e-12));
    // The samples of the shifted curve differ from those of the other one by rounding.
    CHECK(of_late.magnitude == Approx(1.0).epsilon(1e-11));
    CHECK(of_late.slope == Approx(1.0).epsilon(1e-11));
    const Rating of_early = rating(early, reference);
    CHECK(of_early.phase == Approx(phase).epsilon(1e-12));
    CHECK(of_early.delay == Approx(-shift).epsilon(1e-12));
    CHECK(of_early.magnitude == Approx(1.0).epsilon(1e-11));
  }
  const auto pulse = [](double t) { return std::exp(-std::pow((t - 0.4) / 0.03, 2)); };
  CHECK(rating(stairs(samples([&](double t) { return pulse(t - 0.2); })), stairs(samples(pulse)))
            .phase == Approx(0.0).margin(1e-12));
}

TEST_CASE("of shifts that fit equally well the smallest counts") {
  // 10 periods of 100 samples: a shift by 30 late is one of 70 early as well.
  const auto sine = [](double t) { return std::sin(20.0 * kPi * t); };
  const Rating found =
      rating(stairs(samples([&](double t) { return sine(t - 0.03); })), stairs(samples(sine)));
  CHECK(found.delay == Approx(0.03).epsilon(1e-12));
  CHECK(found.phase == Approx(0.85).epsilon(1e-12));
  // A ramp correlates with a ramp at every shift.
  const Rating ramp =
      rating(sampled([](double t) { return 1.3 * t; }, 1), sampled([](double t) { return t; }, 1));
  CHECK(ramp.phase == 1.0);
}

TEST_CASE("rows that are close or far apart do not change the rating") {
  const auto loop = [](double t) {  // straight between multiples of 1/8
    return std::clamp(4.0 * std::abs(std::fmod(t, 0.5) - 0.25) * 2.0 - 1.0, -0.5, 0.5);
  };
  const auto other = [&](double t) { return 1.08 * loop(t) + 0.02; };
  const Rating coarse = rating(sampled(other, 16), sampled(loop, 16));
  const Rating fine = rating(sampled(other, 16), sampled(loop, 48000));
  const Rating finer = rating(sampled(other, 80000), sampled(loop, 16));
  CHECK(coarse.z < 0.999);
  CHECK(coarse.magnitude < 0.999);
  // Rounding of up to 80 rows in each part.
  for (const Rating& found : {fine, finer}) {
    CHECK(found.r == Approx(coarse.r).epsilon(1e-10));
    CHECK(found.z == Approx(coarse.z).epsilon(1e-10));
    CHECK(found.magnitude == Approx(coarse.magnitude).epsilon(1e-10));
    CHECK(found.slope == Approx(coarse.slope).epsilon(1e-10));
  }
  CHECK(rating(sampled(loop, 48000), sampled(loop, 16)).r == Approx(1.0).epsilon(1e-10));
}

TEST_CASE("the rating does not depend on the units") {
  const Function other = [](double t) { return 0.9 * wave(t - 0.02) + 0.1; };
  const Rating plain = rating(sampled(other, 500), sampled(wave, 500));
  CHECK(plain.r < 0.97);
  Series f = sampled(other, 500), r = sampled(wave, 500);
  for (Series* curve : {&f, &r}) {
    for (double& x : curve->abscissa.change()) x *= 1e-6;
    for (double& y : curve->value.change()) y *= 1e3;
  }
  const Rating scaled = rating(f, r);
  CHECK(scaled.r == Approx(plain.r).epsilon(1e-10));
  CHECK(scaled.delay == Approx(1e-6 * plain.delay).epsilon(1e-10));
}

TEST_CASE("mirrored curves and an abscissa that decreases are rated alike") {
  const Function other = [](double t) { return 0.9 * wave(t) + 0.1; };
  const Rating plain = rating(sampled(other, 500), sampled(wave, 500));
  const Rating mirrored = rating(sampled([&](double t) { return -other(t); }, 500),
                                 sampled([](double t) { return -wave(t); }, 500));
  CHECK(mirrored.r == Approx(plain.r).epsilon(1e-12));
  Series f = sampled(other, 500), r = sampled(wave, 500);
  for (Series* curve : {&f, &r}) {
    std::reverse(curve->abscissa.change().begin(), curve->abscissa.change().end());
    std::reverse(curve->value.change().begin(), curve->value.change().end());
  }
  CHECK(rating(f, r).r == Approx(plain.r).epsilon(1e-12));
}

/// The scores as their public descriptions read, with whole tables and no thought of speed.
struct PlainRating {
  double z = 0.0, phase = 0.0, magnitude = 0.0, slope = 0.0;
};
PlainRating plain_rating(const std::vector<double>& f, const std::vector<double>& r) {
  PlainRating out;
  const int n = static_cast<int>(f.size());
  const auto at = [](const std::vector<double>& x, int i) {
    return x[static_cast<std::size_t>(i)];
  };
  double norm = 0.0;
  for (const double x : r) norm = std::max(norm, std::abs(x));
  for (int i = 0; i < n; ++i) {
    const double apart = std::abs(at(f, i) - at(r, i)) / norm;
    out.z += (apart < 0.05 ? 1.0 : apart > 0.5 ? 0.0 : std::pow((0.5 - apart) / 0.45, 2)) / n;
  }
  const auto pearson = [&](int shift) {  // of f[i + shift] and r[i]
    const int begin = std::max(0, -shift), end = std::min(n, n - shift);
    double sf = 0, sr = 0, sff = 0, srr = 0, sfr = 0;
    for (int i = begin; i < end; ++i) {
      const double a = at(f, i + shift), b = at(r, i);
      sf += a, sr += b, sff += a * a, srr += b * b, sfr += a * b;
    }
    const double m = end - begin;
    return (m * sfr - sf * sr) / std::sqrt((m * sff - sf * sf) * (m * srr - sr * sr));
  };
  int best = 0;
  for (int shift = -n / 5; shift <= n / 5; ++shift) {
    if (pearson(shift) > pearson(best)) best = shift;
  }
  out.phase = 1.0 - std::abs(best) / (0.2 * n);
  std::vector<double> a, b;
  for (int i = std::max(0, -best); i < std::min(n, n - best); ++i) {
    a.push_back(at(f, i + best));
    b.push_back(at(r, i));
  }
  const int m = static_cast<int>(a.size()), window = (m + 9) / 10;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> cost(a.size(), std::vector<double>(a.size(), kFar));
  const auto cell = [&](int i, int j) -> double& {
    return cost[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  const auto known = [&](int i, int j) { return i < 0 || j < 0 ? kFar : cell(i, j); };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) {
      if (std::abs(i - j) >= window) continue;
      const double before = std::min({known(i - 1, j), known(i, j - 1), known(i - 1, j - 1)});
      cell(i, j) = std::pow(at(a, i) - at(b, j), 2) + (i == 0 && j == 0 ? 0.0 : before);
    }
  }
  double apart = 0.0, size = 0.0;
  for (int i = m - 1, j = m - 1; i >= 0 && j >= 0;) {
    apart += std::abs(at(a, i) - at(b, j));
    size += std::abs(at(b, j));
    const double up = known(i - 1, j), left = known(i, j - 1), both = known(i - 1, j - 1);
    const bool i_moves = both <= left || up <= left, j_moves = both <= up || left < up;
    if (i == 0 && j == 0) break;
    if (i_moves) --i;
    if (j_moves) --j;
  }
  out.magnitude = std::max(0.0, 1.0 - apart / size / 0.5);
  const auto slopes = [&](const std::vector<double>& x) {
    std::vector<double> raw(x.size()), mean(x.size());
    for (int i = 0; i < m; ++i) {
      const int lo = std::max(0, i - 1), hi = std::min(m - 1, i + 1);
      raw[static_cast<std::size_t>(i)] = (at(x, hi) - at(x, lo)) / (hi - lo);
    }
    for (int i = 0; i < m; ++i) {
      const int half = std::min({4, i, m - 1 - i});
      for (int k = i - half; k <= i + half; ++k) {
        mean[static_cast<std::size_t>(i)] += at(raw, k) / (2 * half + 1);
      }
    }
    return mean;
  };
  const std::vector<double> da = slopes(a), db = slopes(b);
  apart = size = 0.0;
  for (int i = 0; i < m; ++i) {
    apart += std::abs(at(da, i) - at(db, i));
    size += std::abs(at(db, i));
  }
  out.slope = std::max(0.0, 1.0 - apart / size / 2.0);
  return out;
}

TEST_CASE("general curves are rated as by the plain formulas") {
  const std::vector<double> reference = samples(wave);
  const std::vector<std::vector<double>> results{
      samples([](double t) { return 0.85 * wave(t - 0.013) + 0.07 * std::sin(90.0 * t); }),
      samples([](double t) { return 1.2 * wave(0.97 * t + 0.031); }),
      samples([](double t) { return wave(t) + 0.3 * t; })};
  for (const std::vector<double>& result : results) {
    const Rating found = rating(stairs(result), stairs(reference));
    const PlainRating plain = plain_rating(result, reference);
    CHECK(found.z == Approx(plain.z).epsilon(1e-9));
    CHECK(found.phase == Approx(plain.phase).epsilon(1e-9));
    CHECK(found.magnitude == Approx(plain.magnitude).epsilon(1e-9));
    CHECK(found.slope == Approx(plain.slope).epsilon(1e-9));
    CHECK(found.magnitude > 0.1);
    CHECK(found.magnitude < 0.999);
  }
}

TEST_CASE("a result that does not move has no phase score") {
  const Rating found =
      rating(sampled([](double) { return 0.3; }, 10), sampled([](double t) { return t; }, 10));
  CHECK(found.phase == 0.0);
  CHECK(found.r < 0.6);
  // And one that is off by the largest numbers there are is rated, not a NaN.
  const auto step = [](double size) {
    return sampled([=](double t) { return t < 0.5 ? -size : size; }, 2000);
  };
  const auto sine = [](double size) {
    return sampled([=](double t) { return -size * std::sin(2.0 * kPi * t); }, 90);
  };
  const Rating far = rating(step(1e308), sine(1e-300));
  CHECK(far.z == 0.0);
  // The jump itself leaves the range of numbers: one part, of 200.
  CHECK(far.phase == Approx(rating(step(1e3), sine(1.0)).phase).margin(0.0051));
  CHECK(far.phase > 0.8);
  CHECK(far.magnitude == 0.0);
  CHECK(far.slope == 0.0);
}

TEST_CASE("no rating without a reference that moves, a range or numbers") {
  const Series curve = sampled(wave, 100);
  const auto fault = [](const Series& f, const Series& r) {
    const CurveComparison found = compare_iso18571(f, r, within(1e9));
    CHECK(found.measures.empty());
    return found.fault;
  };
  CHECK_THAT(fault(curve, sampled([](double) { return 5.0; }, 100)),
             Catch::Contains("the reference is constant"));
  CHECK_THAT(fault(curve, sampled([](double) { return 0.0; }, 100)),
             Catch::Contains("the reference is constant"));
  CHECK_THAT(fault(curve, sampled([](double t) { return 5.0 + 1e-12 * t; }, 100)),
             Catch::Contains("the reference is constant"));
  CHECK(fault(curve, Series{}) != "");
  CHECK(fault(Series{}, curve) != "");
  Series broken = curve;
  broken.value.change()[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK(fault(broken, curve) != "");
  CHECK(fault(curve, broken) != "");
  Series elsewhere = curve;
  for (double& x : elsewhere.abscissa.change()) x += 1.0;
  CHECK(fault(curve, elsewhere) != "");
  const Series loop{{0.0, 1.0, 0.0}, {0.0, 1.0, 2.0}, {}};
  CHECK_THAT(fault(loop, curve), Catch::Contains("goes back and forth"));
}

}  // namespace
}  // namespace slipbench::driver::check
