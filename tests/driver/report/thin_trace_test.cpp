// SPDX-License-Identifier: Apache-2.0
#include "driver/report/thin_trace.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace slipbench::driver::report {
namespace {

constexpr std::size_t kPoints = 25000;
constexpr std::size_t kWorst = 3217;

/// A wave against itself, off by 0.001 at one point: the difference does not show in either curve.
check::CheckTrace nearly_right() {
  check::CheckTrace trace;
  trace.abscissa_label = "t";
  trace.abscissa_unit = "s";
  trace.tube = 1e-4;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    trace.reference.abscissa.push_back(t);
    trace.reference.time.push_back(t);
    trace.reference.value.push_back(std::sin(t));
  }
  trace.value = trace.reference;
  trace.value.value.change()[kWorst] += 0.001;
  return trace;
}

ReportCheck check_of(const check::CheckTrace& trace, bool passed) {
  ReportCheck check;
  check.verdict.passed = passed;
  check.verdict.worst.time = trace.value.time[kWorst];
  check.verdict.worst.abscissa = trace.value.abscissa[kWorst];
  return check;
}

std::size_t count_near(const std::vector<double>& x, double place, double distance) {
  return static_cast<std::size_t>(std::count_if(
      x.begin(), x.end(), [&](double one) { return std::abs(one - place) < distance; }));
}

TEST_CASE("the worst point and its neighbours survive, in both curves at the same places") {
  const check::CheckTrace trace = nearly_right();
  ReportCheck check = check_of(trace, false);
  put_trace(check, trace, 1);
  CHECK(check.thinned);
  CHECK(check.tube == 1e-4);
  CHECK(check.abscissa == "t");
  CHECK(check.value.x.size() <= 10000);
  CHECK(check.value.x == check.reference.x);
  double largest = 0.0;
  for (std::size_t i = 0; i < check.value.y.size(); ++i) {
    largest = std::max(largest, std::abs(check.value.y[i] - check.reference.y[i]));
  }
  CHECK(*std::max_element(check.difference.high.begin(), check.difference.high.end()) ==
        Approx(0.001).epsilon(1e-9));
  CHECK(largest == Approx(0.001).epsilon(1e-9));  // of numbers about 1: cancellation
  CHECK(count_near(check.value.x, trace.value.abscissa[kWorst], 0.085) == 17);
}

TEST_CASE("a passed check has fewer points, one of many fewer still") {
  const check::CheckTrace trace = nearly_right();
  ReportCheck alone = check_of(trace, true);
  put_trace(alone, trace, 1);
  ReportCheck one_of_many = check_of(trace, true);
  put_trace(one_of_many, trace, 1000);
  CHECK(alone.value.x.size() <= 1000);
  CHECK(one_of_many.value.x.size() <= 300);
  CHECK(count_near(one_of_many.value.x, trace.value.abscissa[kWorst], 0.085) == 17);
}

TEST_CASE("curves with points of their own are thinned each for itself") {
  check::CheckTrace trace = nearly_right();
  trace.reference = {{0.0, 25.0, 50.0}, {1.0, 2.0, 3.0}, {}};
  trace.tube = 0.0;
  ReportCheck check = check_of(trace, false);
  put_trace(check, trace, 1);
  CHECK(check.reference.x == trace.reference.abscissa);
  CHECK(check.reference.y == trace.reference.value);
  CHECK(check.value.x.size() <= 10000);
  CHECK(count_near(check.value.x, trace.value.abscissa[kWorst], 0.085) == 17);
  CHECK(check.tube < 0.0);
}

TEST_CASE("a check that kept nothing has no curves") {
  ReportCheck check;
  put_trace(check, check::CheckTrace{}, 1);
  CHECK(check.value.x.empty());
  CHECK(check.reference.x.empty());
  CHECK_FALSE(check.thinned);
}

}  // namespace
}  // namespace slipbench::driver::report
