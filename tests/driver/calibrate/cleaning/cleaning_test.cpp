// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "driver/calibrate/cleaning/average_cycles.hpp"
#include "driver/calibrate/cleaning/dead_band.hpp"
#include "driver/calibrate/cleaning/resample.hpp"

namespace slipbench::driver::cleaning {
namespace {

using Numbers = std::vector<double>;

/// Rows every `step` from `first` on, with the columns' values.
template <class... Function>
DataRows rows_of(double first, double step, int count, Function... column) {
  DataRows rows;
  rows.columns.resize(sizeof...(column));
  for (int i = 0; i < count; ++i) {
    const double t = first + step * i;
    rows.time.push_back(t);
    std::size_t c = 0;
    ((rows.columns[c++].push_back(column(t))), ...);
  }
  return rows;
}

TEST_CASE("Resampling goes linearly between the rows and meets their ends") {
  DataRows rows;
  rows.time = {0.0, 1.0, 3.0};
  rows.columns = {{0.0, 10.0, 30.0}, {5.0, 5.0, 1.0}};
  const DataRows every = resampled(rows, 0.5);
  CHECK(every.time == Numbers{0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0});
  CHECK(every.columns[0] == Numbers{0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0});
  CHECK(every.columns[1] == Numbers{5.0, 5.0, 5.0, 4.0, 3.0, 2.0, 1.0});
  CHECK(every.gap.empty());
  const DataRows points = resampled(rows, 4);
  CHECK(points.time == Numbers{0.0, 1.0, 2.0, 3.0});
  CHECK(points.columns[0] == Numbers{0.0, 10.0, 20.0, 30.0});
  // A step that does not divide the range stops before its end.
  CHECK(resampled(rows, 2.0).time == Numbers{0.0, 2.0});
  CHECK(resampled(rows, 100.0).time == Numbers{0.0});
  // 0.1 is no binary number: the last row is there all the same.
  CHECK(resampled(rows_of(0.0, 0.25, 5, [](double t) { return t; }), 0.1).size() == 11);
}

TEST_CASE("Resampling leaves out what lies in a gap, but not its ends") {
  DataRows rows;
  rows.time = {0.0, 1.0, 2.0, 3.0};
  rows.columns = {{0.0, 1.0, 20.0, 30.0}};
  rows.gap = {0, 0, 1, 0};
  const DataRows result = resampled(rows, 0.5);
  CHECK(result.time == Numbers{0.0, 0.5, 1.0, 2.0, 2.5, 3.0});
  CHECK(result.columns[0] == Numbers{0.0, 0.5, 1.0, 20.0, 25.0, 30.0});
  CHECK(result.gap == std::vector<char>{0, 0, 0, 1, 0, 0});
}

TEST_CASE("The mean of equal cycles is one of them, without scatter") {
  const auto wave = [](double t) { return t - std::floor(t); };  // exact at the rows
  const DataRows rows = rows_of(2.0, 0.125, 8 * 4 + 1, wave);
  const MeanCycle mean = mean_cycle(rows, 2.0, 1.0, 4, 8);
  CHECK(mean.rows.time == Numbers{2.0, 2.125, 2.25, 2.375, 2.5, 2.625, 2.75, 2.875});
  CHECK(mean.rows.columns[0] == Numbers{0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875});
  CHECK(mean.scatter == Numbers{0.0});
}

TEST_CASE("The mean of cycles and their scatter, each column by itself") {
  // Three cycles that are 1, 2 and 6 higher than one another: mean 3, deviations -2, -1, 3.
  const auto offset = [](double t) { return t < 1.0 ? 1.0 : t < 2.0 ? 2.0 : 6.0; };
  const DataRows rows = rows_of(0.0, 0.25, 12, offset, [](double) { return 7.0; });
  const MeanCycle mean = mean_cycle(rows, 0.0, 1.0, 3, 4);
  CHECK(mean.rows.columns[0] == Numbers(4, 3.0));
  CHECK(mean.rows.columns[1] == Numbers(4, 7.0));
  // Rounding of a few operations.
  CHECK(mean.scatter[0] == Approx(std::sqrt((4.0 + 1.0 + 9.0) / 3.0)).epsilon(1e-14));
  CHECK(mean.scatter[1] == 0.0);
}

TEST_CASE("Phases between the rows are interpolated, and a last broken cycle is left out") {
  const auto line = [](double t) { return std::abs(std::fmod(t, 2.0) - 1.0); };
  const DataRows rows = rows_of(0.0, 0.5, 13, line);  // 0 .. 6: three cycles and their end
  REQUIRE(whole_cycles(0.0, 6.0, 2.0, 0.5) == 3);
  const MeanCycle mean = mean_cycle(rows, 0.0, 2.0, 3, 10);
  REQUIRE(mean.rows.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    // The kinks of the curve stand on rows, so that only rounding is left.
    CHECK(mean.rows.columns[0][i] == Approx(line(0.2 * static_cast<double>(i))).margin(1e-14));
  }
  CHECK(whole_cycles(0.0, 5.5, 2.0, 0.5) == 3);  // the row at 6 would begin the next one
  CHECK(whole_cycles(0.0, 5.0, 2.0, 0.5) == 2);
}

TEST_CASE("A phase in a gap of one cycle comes from the others, in a gap of all it is missing") {
  DataRows rows = rows_of(0.0, 0.25, 8, [](double t) { return t < 1.0 ? 1.0 : 3.0; });
  // The rows at 0.5 and, in both cycles, at 0.75 are missing.
  DataRows kept;
  kept.columns.resize(1);
  bool gap = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 2 || i == 3 || i == 7) {
      gap = true;
      continue;
    }
    kept.time.push_back(rows.time[i]);
    kept.columns[0].push_back(rows.columns[0][i]);
    kept.gap.push_back(gap ? 1 : 0);
    gap = false;
  }
  const MeanCycle mean = mean_cycle(kept, 0.0, 1.0, 2, 4);
  CHECK(mean.rows.time == Numbers{0.0, 0.25, 0.5});
  CHECK(mean.rows.columns[0] == Numbers{2.0, 2.0, 3.0});
}

TEST_CASE("Whole cycles are counted up to the row before the next one") {
  CHECK(whole_cycles(0.0, 0.999, 1.0, 0.001) == 1);
  CHECK(whole_cycles(0.0, 0.99, 1.0, 0.001) == 0);
  CHECK(whole_cycles(3.0, 5.0, 1.0, 0.001) == 2);
  CHECK(whole_cycles(0.0, 0.7, 0.1, 0.0) == 7);  // though 7 * 0.1 > 0.7 in binary numbers
  CHECK(whole_cycles(0.0, -1.0, 1.0, 0.0) == 0);
}

TEST_CASE("The slope of a straight line is exact, evenly measured or not, up to its ends") {
  const Numbers time = {0.0, 0.1, 0.3, 0.35, 0.7, 1.1, 1.2, 1.9, 2.0, 2.4, 3.0};
  Numbers values;
  for (const double t : time) values.push_back(5.0 - 3.0 * t);
  for (const double slope : slopes(time, values)) {
    CHECK(slope == Approx(-3.0).epsilon(1e-12));  // rounding
  }
  CHECK(slopes(Numbers{1.0}, Numbers{2.0}).empty());
}

TEST_CASE("The noise of a position hardly moves its slope") {
  const auto noisy = [](int i) { return 0.01 * i + (i % 2 == 0 ? 0.001 : -0.001); };
  Numbers time, values;
  for (int i = 0; i < 41; ++i) {
    time.push_back(0.001 * i);
    values.push_back(noisy(i));
  }
  const Numbers slope = slopes(time, values);
  // A difference of neighbours would be 10 +- 2; alternating noise cancels in nine rows.
  for (std::size_t i = 4; i < 37; ++i) CHECK(slope[i] == Approx(10.0).margin(0.05));
}

TEST_CASE("Slow rows are left out, with a gap where they were") {
  const DataRows rows = rows_of(0.0, 1.0, 7, [](double t) { return 10.0 * t; });
  const Numbers speed = {0.1, -2.0, 2.0, 0.5, -0.5, -1.0, 0.0};
  const DataRows kept = without_slow_rows(rows, speed, 1.0);
  CHECK(kept.time == Numbers{1.0, 2.0, 5.0});
  CHECK(kept.columns[0] == Numbers{10.0, 20.0, 50.0});
  CHECK(kept.gap == std::vector<char>{0, 0, 1});
  CHECK(without_slow_rows(rows, Numbers(7, 1.0), 1.0).gap.empty());
  CHECK(without_slow_rows(rows, Numbers(7, 0.0), 1.0).size() == 0);
}

TEST_CASE("The dead band of a sinusoidal motion is what its cosine says") {
  constexpr double kOmega = 2.0 * std::numbers::pi;
  const DataRows rows = rows_of(0.0, 0.001, 1000, [](double t) { return std::sin(kOmega * t); });
  const DataRows kept = without_slow_rows(rows, slopes(rows.time, rows.columns[0]), 0.5 * kOmega);
  // |cos| >= 1/2 holds for two thirds of the period; a row or two an edge.
  CHECK(std::abs(static_cast<double>(kept.size()) - 2000.0 / 3.0) < 8.0);
  for (const double t : kept.time) CHECK(std::abs(std::cos(kOmega * t)) > 0.49);
}

}  // namespace
}  // namespace slipbench::driver::cleaning
