// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/point_judge.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

namespace slipbench::driver {
namespace {

CurvePoint point(double time, double value, double reference) {
  return {time, value, reference, time};
}

TEST_CASE("the sample for the cause stays small, in order, and has the few points that fail") {
  PointJudge judge({1e-3, {}, ""});
  constexpr int kPoints = 100000;
  for (int i = 0; i < kPoints; ++i) {
    const bool fails = i == 70001 || i == 70003;
    judge.add(point(i, fails ? 2.0 : 1.0, 1.0), fails ? 2 : 1);
  }
  const auto sample = judge.sample();
  CHECK(sample.size() <= 2050);
  CHECK(sample.size() >= 500);
  int failing = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (i > 0) CHECK(sample[i].point.time > sample[i - 1].point.time);
    CHECK(sample[i].failing == (sample[i].status == 2));
    failing += sample[i].failing ? 1 : 0;
  }
  CHECK(failing == 2);
  CHECK(judge.result().failing == 2);
  CHECK(judge.result().first->time == 70001.0);
  CHECK(judge.result().last->time == 70003.0);
}

TEST_CASE("a sample is evenly spread however many points there are") {
  PointSample sample;
  for (std::int64_t i = 0; i < 10000; ++i) sample.offer(i, {}, 0);
  const auto points = sample.points();
  REQUIRE(points.size() > 500);
  CHECK(points.size() <= 1024);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(points[i].index == static_cast<std::int64_t>(i) * points[1].index);
  }
}

TEST_CASE("points that only failed while the range was small do not fail in the end") {
  PointJudge judge({{}, 0.1, ""});
  judge.add(point(0, 0.5, 0.0), 1);
  judge.add(point(1, 1.0, 1.0), 1);
  CHECK(judge.result().failing == 1);
  judge.add(point(2, 10.0, 10.0), 1);
  CHECK(judge.result().tolerance == Approx(1.0));
  CHECK(judge.result().failing == 0);
  CHECK(judge.result().worst.time == 0.0);
}

}  // namespace
}  // namespace slipbench::driver
