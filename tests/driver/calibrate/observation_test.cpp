// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/observation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace slipbench::driver::calibrate {
namespace {

std::vector<double> values_at(const std::vector<double>& column, const Observations& found) {
  std::vector<double> values(found.points.size());
  read_points(column, found.points, values);
  return values;
}

}  // namespace

TEST_CASE(
    "measured times lie between rows, rows are met exactly, and what is outside is left out") {
  const std::vector<double> run{0.0, 0.1, 0.2, 0.4};
  const std::vector<double> value{0.0, 1.0, 3.0, 7.0};
  const Observations found =
      observe_times(run, std::vector<double>{-0.1, 0.0, 0.1, 0.15, 0.4, 0.5});
  CHECK(found.fault.empty());
  CHECK(found.kept == std::vector<std::size_t>{1, 2, 3, 4});
  const std::vector<double> read = values_at(value, found);
  CHECK(read[0] == 0.0);
  CHECK(read[1] == 1.0);
  CHECK(read[2] == Approx(2.0));
  CHECK(read[3] == 7.0);
  CHECK(found.points[3].row == 3);
}

TEST_CASE("a time that is a row but for rounding is that row") {
  const std::vector<double> run{0.0, 0.1, 0.1 + 0.2};
  const Observations found = observe_times(run, std::vector<double>{0.3, 0.1});
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].row == 2);
  CHECK(found.points[0].fraction == 0.0);
}

TEST_CASE("measured times before and behind the run have nothing in common with it") {
  const Observations found = observe_times(std::vector<double>{0, 1}, std::vector<double>{5, 6});
  CHECK(found.fault.find("nothing in common") != std::string::npos);
}

TEST_CASE("positions are met on their own branch") {
  // Up to 1, down to -1, up to 1; the value tells the branch.
  std::vector<double> time, position, value;
  for (int i = 0; i <= 50; ++i) {
    time.push_back(0.1 * i);
    const double t = 0.1 * i;
    position.push_back(t <= 1 ? t : t <= 3 ? 2 - t : t - 4);
    value.push_back(t);
  }
  MeasuredSeries measured;
  for (const double t : {0.25, 0.75, 1.35, 2.75, 3.35, 4.75}) {
    measured.time.push_back(t);
    measured.over.push_back(t <= 1 ? t : t <= 3 ? 2 - t : t - 4);
  }
  const Observations found = observe_positions(time, position, measured);
  CHECK(found.fault.empty());
  REQUIRE(found.kept.size() == 6);
  const std::vector<double> read = values_at(value, found);
  for (std::size_t i = 0; i < read.size(); ++i) CHECK(read[i] == Approx(measured.time[i]));
}

TEST_CASE("noise of positions makes no branches, and points beyond a turn are left out") {
  std::vector<double> time, position;
  MeasuredSeries measured;
  for (int i = 0; i <= 200; ++i) {
    time.push_back(0.01 * i);
    position.push_back(std::sin(M_PI * 0.01 * i));
    measured.time.push_back(0.01 * i);
    measured.over.push_back(1.002 * position.back() + (i % 2 == 0 ? 4e-4 : -4e-4));
  }
  const Observations found = observe_positions(time, position, measured);
  CHECK(found.fault.empty());
  CHECK(found.kept.size() < 201);
  CHECK(found.kept.size() > 180);
}

TEST_CASE("points just behind a turn are on the branch behind it, however near") {
  // Up to 1, down to -1, up to 0; the run has no row where it turns. The value tells the branch.
  const auto path = [](double t) { return t <= 1.0 ? t : t <= 3.0 ? 2.0 - t : t - 4.0; };
  std::vector<double> time, position;
  for (int i = 0; i <= 4000; ++i) time.push_back(0.001 * i + 0.0004);
  for (const double t : time) position.push_back(path(t));
  for (const double shift : {0.0, 0.3, 0.5, 0.8}) {
    CAPTURE(shift);
    MeasuredSeries measured;
    for (std::size_t i = 5; i + 5 < time.size(); ++i) {
      measured.time.push_back(time[i] + shift * (time[i + 1] - time[i]));
      measured.over.push_back(position[i] + shift * (position[i + 1] - position[i]));
    }
    const Observations found = observe_positions(time, position, measured);
    CHECK(found.fault.empty());
    // Of measured turns that are none of the run, its time tells the side.
    CHECK(found.kept.size() == measured.time.size());
    const std::vector<double> read = values_at(time, found);
    // Rounding of positions.
    for (std::size_t i = 0; i < read.size(); ++i) {
      if (std::abs(read[i] - measured.time[found.kept[i]]) > 1e-9) {
        FAIL_CHECK(measured.time[found.kept[i]] << " is met at " << read[i]);
      }
    }
  }
}

TEST_CASE(
    "of a measured turn that is none of the run nothing tells the side if its clock is late") {
  std::vector<double> time, position;
  MeasuredSeries measured;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.01 * i;
    time.push_back(t);
    position.push_back(t <= 1.0 ? t : 2.0 - t);
    if (i < 10 || i > 190) continue;
    measured.time.push_back(t + 0.02);
    measured.over.push_back(t + 0.003 <= 1.0 ? t + 0.003 : 2.0 - t - 0.003);
  }
  const Observations found = observe_positions(time, position, measured);
  CHECK(found.fault.empty());
  // The turn, and what the run had before the first measured time.
  CHECK(found.kept.size() + 3 >= measured.time.size());
  CHECK(std::count(found.kept.begin(), found.kept.end(), 90) == 0);
  const std::vector<double> read = values_at(time, found);
  // Rounding of positions.
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i] == Approx(measured.time[found.kept[i]] - 0.017).epsilon(1e-12));
  }
}

TEST_CASE("points as near to a turn as the noise of the positions are left out") {
  std::vector<double> time, position;
  MeasuredSeries measured;
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.01 * i;
    time.push_back(t);
    // Up to 1, a rest, and down again.
    position.push_back(t <= 1.0 ? t : t <= 2.0 ? 1.0 : 3.0 - t);
    measured.time.push_back(t);
    measured.over.push_back(position.back() + (i % 3 == 0 ? 3e-4 : -2e-4));
  }
  const Observations found = observe_positions(time, position, measured);
  CHECK(found.fault.empty());
  CHECK(found.kept.size() < 305);  // nothing of the rest
  CHECK(found.kept.size() > 290);
  const std::vector<double> read = values_at(time, found);
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i] == Approx(measured.time[found.kept[i]]).margin(4e-4));
  }
}

TEST_CASE("branches that differ in number or direction are a fault") {
  const std::vector<double> time{0, 1, 2, 3, 4};
  const std::vector<double> position{0, 1, 0, 1, 0};
  MeasuredSeries measured;
  measured.time = {0, 2, 4};
  measured.over = {0, 1, 0};
  CHECK(observe_positions(time, position, measured)
            .fault.find("in 2 branches, those of the run in "
                        "4") != std::string::npos);
  measured.time = {0, 1, 2, 3, 4};
  measured.over = {0, -1, 0, -1, 0};
  CHECK(observe_positions(time, position, measured).fault.find("opposite") != std::string::npos);
}

}  // namespace slipbench::driver::calibrate
