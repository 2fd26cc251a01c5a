// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/point_judge.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

namespace slipbench::driver::check {
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
  CHECK(judge.result().worst.point.time == 0.0);
}

TEST_CASE("what is told of a point has the distance to the nearer of its neighbours") {
  PointJudge judge({0.5, {}, ""});
  const double times[] = {0.0, 1.0, 1.25, 1.35, 3.0, 3.5};
  const double deviations[] = {0.0, 0.0, 1.0, 2.0, 0.0, 1.0};
  for (int i = 0; i < 6; ++i) judge.add(point(times[i], deviations[i], 0.0), 1);
  const PointJudge::Result result = judge.result();
  CHECK(result.worst.spacing.time == Approx(0.1));
  CHECK(result.worst.spacing.abscissa == Approx(0.1));
  CHECK(result.first->step == Approx(0.1));
  CHECK(result.last->step == Approx(0.5));
}

}  // namespace
}  // namespace slipbench::driver::check
