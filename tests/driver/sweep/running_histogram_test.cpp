// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/running_histogram.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace slipbench::driver::sweep {
namespace {

RunningHistogram histogram_of(const std::vector<double>& values) {
  RunningHistogram histogram;
  for (const double value : values) histogram.add(value);
  return histogram;
}

TEST_CASE("A histogram counts every value where it is, whatever the order") {
  std::mt19937_64 dice(1);
  for (const double scale : {1e-9, 1.0, 3e7}) {
    INFO("scale " << scale);
    std::vector<double> values;
    values.reserve(3000);
    std::normal_distribution<double> normal(-2.0 * scale, scale);
    for (int i = 0; i < 3000; ++i) values.push_back(normal(dice));
    const RunningHistogram found = histogram_of(values);
    REQUIRE(found.width() > 0.0);
    CHECK(std::exp2(std::round(std::log2(found.width()))) == found.width());
    const auto counts = found.counts();
    CHECK(counts.size() <= RunningHistogram::kMost);
    CHECK(counts.size() >= RunningHistogram::kMost / 2 - 2);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double from = found.begin() + found.width() * static_cast<double>(i);
      CHECK(counts[i] == static_cast<std::uint64_t>(
                             std::count_if(values.begin(), values.end(), [&](double value) {
                               return value >= from && value < from + found.width();
                             })));
    }
    for (int turn = 0; turn < 20; ++turn) {
      std::shuffle(values.begin(), values.end(), dice);
      const RunningHistogram other = histogram_of(values);
      CHECK(other.width() == found.width());
      CHECK(other.begin() == found.begin());
      CHECK(std::equal(counts.begin(), counts.end(), other.counts().begin(), other.counts().end()));
    }
    std::sort(values.begin(), values.end());
    CHECK(histogram_of(values).begin() == found.begin());
  }
}

TEST_CASE("Histograms of parts make that of the whole") {
  std::mt19937_64 dice(2);
  const auto draw = [&](int kind) {
    if (kind == 0) return std::normal_distribution<double>(5.0, 1e-6)(dice);
    if (kind == 1) return 3.0 + static_cast<double>(dice() % 2);
    return std::ldexp(1.0 + static_cast<double>(dice() % 5),
                      static_cast<int>(dice() % 2000) - 1000);
  };
  for (int turn = 0; turn < 300; ++turn) {
    std::vector<double> values;
    const auto count = static_cast<std::size_t>(1 + dice() % 30);
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(draw(turn % 3));
    const RunningHistogram whole = histogram_of(values);
    std::vector<RunningHistogram> parts(3);
    for (const double value : values) parts[dice() % 3].add(value);
    parts[0].add(parts[1]);
    parts[2].add(parts[0]);
    CHECK(parts[2].width() == whole.width());
    CHECK(parts[2].begin() == whole.begin());
    CHECK(std::equal(whole.counts().begin(), whole.counts().end(), parts[2].counts().begin(),
                     parts[2].counts().end()));
  }
}

TEST_CASE("A histogram has bins of any two values") {
  CHECK(histogram_of({}).width() == 0.0);
  CHECK(histogram_of({3.0, 3.0, 3.0}).width() == 0.0);
  CHECK(histogram_of({0.0, -0.0}).width() == 0.0);
  for (const std::vector<double>& values : {std::vector{5.0, 5.0, 7.0},
                                            {1.0, 1.0 + 1e-14},
                                            {-1.7e308, 1.7e308, 0.0},
                                            {5e-324, 0.0, -1e-310}}) {
    const RunningHistogram found = histogram_of(values);
    CHECK(found.width() > 0.0);
    CHECK(std::accumulate(found.counts().begin(), found.counts().end(), std::uint64_t{0}) ==
          values.size());
    CHECK(histogram_of({values.rbegin(), values.rend()}).begin() == found.begin());
  }
}

}  // namespace
}  // namespace slipbench::driver::sweep
