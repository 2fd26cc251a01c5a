// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/samples.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

using Kind = Distribution::Kind;

std::vector<double> all_samples(const Sweep& sweep) {
  std::vector<double> values(sweep.samples * sweep.varied.size());
  Samples samples(sweep);
  REQUIRE(samples.take(values) == sweep.samples);
  std::vector<double> none(sweep.varied.size());
  CHECK(samples.take(none) == 0);
  return values;
}

constexpr Sampler kAll[] = {Sampler::kSobol, Sampler::kHalton, Sampler::kLatinHypercube,
                            Sampler::kRandom};

TEST_CASE("Quantiles are those of the distributions") {
  CHECK(Distribution{Kind::kUniform, {2.0, 6.0}}.at(0.25) == 3.0);
  CHECK(Distribution{Kind::kLogUniform, {1.0, 1e4}}.at(0.25) == Approx(10.0).epsilon(1e-14));
  // 84.13 % of a normal distribution lie below one standard deviation.
  CHECK(Distribution{Kind::kNormal, {20.0, 5.0}}.at(0.841344746068543) ==
        Approx(25.0).epsilon(1e-12));
  const Distribution list{Kind::kList, {7.0, 8.0, 9.0}};
  CHECK(list.at(0.0) == 7.0);
  CHECK(list.at(0.34) == 8.0);
  CHECK(list.at(1.0) == 9.0);
}

TEST_CASE("A grid has every combination once, the last parameter fastest") {
  Sweep sweep = sweep_of({{Kind::kList, {1.0, 2.0}}, {Kind::kList, {10.0, 20.0, 30.0}}}, 6);
  sweep.sampler = Sampler::kGrid;
  CHECK(all_samples(sweep) == std::vector<double>{1, 10, 1, 20, 1, 30, 2, 10, 2, 20, 2, 30});
}

TEST_CASE("Samples are the same in whatever pieces they are taken, and depend on the seed") {
  for (const Sampler sampler : kAll) {
    Sweep sweep = sweep_of({{Kind::kUniform, {0.0, 1.0}}, {Kind::kNormal, {5.0, 2.0}}}, 100);
    sweep.sampler = sampler;
    const std::vector<double> whole = all_samples(sweep);
    Samples late(sweep);
    late.skip(37);
    std::vector<double> piece(80);
    REQUIRE(late.take(piece) == 40);
    CHECK(std::equal(piece.begin(), piece.end(), whole.begin() + 74));
    sweep.seed = 2;
    CHECK(all_samples(sweep) != whole);
  }
}

TEST_CASE("Every sampler fills the unit interval evenly") {
  constexpr std::size_t kCount = 1000;
  for (const Sampler sampler : kAll) {
    Sweep sweep = sweep_of({{Kind::kUniform, {0.0, 1.0}}, {Kind::kUniform, {0.0, 1.0}}}, kCount);
    sweep.sampler = sampler;
    const std::vector<double> values = all_samples(sweep);
    for (std::size_t p = 0; p < 2; ++p) {
      std::vector<double> one;
      for (std::size_t i = p; i < values.size(); i += 2) one.push_back(values[i]);
      std::sort(one.begin(), one.end());
      CHECK(one.front() > 0.0);
      CHECK(one.back() < 1.0);
      double farthest = 0.0;  // Kolmogorov and Smirnov's distance
      for (std::size_t i = 0; i < kCount; ++i) {
        farthest = std::max(farthest, std::abs(one[i] - (static_cast<double>(i) + 0.5) / kCount));
      }
      // Random numbers stay below 1.63/sqrt(n) in 99 of 100 sets; the others are more even.
      CHECK(farthest < (sampler == Sampler::kRandom ? 1.63 / std::sqrt(1.0 * kCount) : 0.005));
    }
  }
}

TEST_CASE("A Latin hypercube meets every part of every range once") {
  Sweep sweep = sweep_of({{Kind::kUniform, {0.0, 50.0}}, {Kind::kUniform, {0.0, 50.0}}}, 50);
  sweep.sampler = Sampler::kLatinHypercube;
  const std::vector<double> values = all_samples(sweep);
  for (std::size_t p = 0; p < 2; ++p) {
    std::vector<int> met(50, 0);
    for (std::size_t i = p; i < values.size(); i += 2) ++met[static_cast<std::size_t>(values[i])];
    CHECK(std::all_of(met.begin(), met.end(), [](int count) { return count == 1; }));
  }
}

}  // namespace
}  // namespace slipbench::driver::sweep
