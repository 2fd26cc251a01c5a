// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/measurements.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/driver/calibrate/fit_files_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

using Numbers = std::vector<double>;

/// The measurements of the only experiment of a fit whose data and first experiment are given.
Measurements measured(const FitFolder& folder, const std::string& experiment) {
  const Fit fit = folder.sound(
      changed_fit({{"{case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: load}}",
                    "{case: slider.yaml, data: rig.csv, " + experiment + "}"}}));
  auto result = read_measurements(fit.experiments[0]);
  INFO((result ? std::string() : result.error().message));
  REQUIRE(result.has_value());
  return std::move(*result);
}

base::HistoryError refused(const FitFolder& folder, const std::string& experiment) {
  const Fit fit = folder.sound(
      changed_fit({{"{case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: load}}",
                    "{case: slider.yaml, data: rig.csv, " + experiment + "}"}}));
  const auto result = read_measurements(fit.experiments[0]);
  REQUIRE_FALSE(result.has_value());
  return result.error();
}

/// Rows of a sinusoidal motion at 200 Hz from 0 to 4 s, the force a hundredth higher each cycle.
std::string sinusoidal_rig() {
  std::string text = "t,stroke,load,speed\n";
  for (int i = 0; i <= 800; ++i) {
    const double t = i / 200.0;
    const double phase = 2.0 * std::numbers::pi * t;
    text += fmt::format("{},{},{},{}\n", t, std::sin(phase),
                        std::cos(phase) + 0.01 * std::floor(t + 1e-9), std::cos(phase));
  }
  return text;
}

TEST_CASE("The numbers of a data file become those of the case") {
  const FitFolder folder;
  const Measurements data = measured(
      folder,
      "time: {column: t, unit: ms, factor: 2, offset: 1}, compare: {CSF1: {column: load, unit: kN, "
      "factor: -1, offset: 0.5, over: {quantity: CP1, column: stroke, unit: cm}}, CP1: stroke}");
  REQUIRE(data.responses.size() == 2);
  CHECK(data.responses[0].time == Numbers{1.0, 1.001, 1.002});
  CHECK(data.responses[0].value == Numbers{0.5, -2.5, -2.5});
  CHECK(data.responses[0].over[2] == Approx(0.4).epsilon(1e-15));
  CHECK(data.responses[1].value == Numbers{0.0, 0.02, 0.04});
  CHECK(data.responses[1].over.empty());
  CHECK(data.rows_read == 3);
  CHECK(data.rows_used == 3);
  CHECK(data.hash == "86b8e3fb9cfff38e7701989c5aedbcd40241ab234ca70ff248aaaa3e75fffe26");
  CHECK(data.cleaning ==
        std::vector<std::string>{"'t' times 2 plus 1", "'load' times -1 plus 0.5"});
}

TEST_CASE("Without provenance nobody needs the hash") {
  const FitFolder folder;
  const Fit fit = folder.sound(kSoundFit);
  CHECK(read_measurements(fit.experiments[0], false)->hash.empty());
}

TEST_CASE("Ranges keep the rows at their ends, each response its own") {
  const FitFolder folder;
  folder.write("rig.csv", "t,stroke,load,speed\n0,0,1,0\n1,0,2,0\n2,0,3,0\n3,0,4,0\n4,0,5,0\n");
  const Measurements data =
      measured(folder,
               "time: t, from: 1, to: 3, compare: {CSF1: {column: load, from: 2}, "
               "CP1: {column: stroke, to: 1.5}}");
  CHECK(data.responses[0].value == Numbers{3.0, 4.0});
  CHECK(data.responses[1].time == Numbers{1.0});
  CHECK(data.rows_read == 5);
  CHECK(data.rows_used == 2);
  CHECK(data.cleaning == std::vector<std::string>{"3 of 5 rows lie within 1 .. 3 s",
                                                  "CSF1 is compared from 2 s on: 2 rows",
                                                  "CP1 is compared up to 1.5 s: 1 row"});
  CHECK(refused(folder, "time: t, from: 7, compare: {CSF1: load}").message ==
        "no row lies from 7 s on");
  CHECK(refused(folder, "time: t, compare: {CSF1: {column: load, from: 7}}").message ==
        "no row lies from 7 s on, where CSF1 is compared");
}

TEST_CASE("The cycles of a steady loop become their mean") {
  const FitFolder folder;
  folder.write("rig.csv", sinusoidal_rig());
  const Measurements data =
      measured(folder,
               "time: t, from: 2, to: 4, average_cycles: {period: 1, points: 100}, "
               "compare: {CSF1: {column: load, unit: kN}}");
  const MeasuredSeries& loop = data.responses[0];
  REQUIRE(loop.time.size() == 100);
  CHECK(loop.time.front() == 2.0);
  CHECK(loop.time.back() == Approx(2.99).epsilon(1e-14));
  for (std::size_t i = 0; i < 100; ++i) {
    const double wave = std::cos(2.0 * std::numbers::pi * 0.01 * static_cast<double>(i));
    // Every phase is a row: rounding of numbers of 16 digits.
    CHECK(loop.value[i] == Approx(1000.0 * (wave + 0.025)).margin(1e-9));
  }
  CHECK(data.cleaning ==
        std::vector<std::string>{"401 of 801 rows lie within 2 .. 4 s",
                                 "2 of 4 cycles averaged to 100 rows; they differ by 5 N rms"});
  const base::HistoryError error =
      refused(folder, "time: t, from: 3.5, average_cycles: {period: 1}, compare: {CSF1: load}");
  CHECK(error.message == "there is no whole cycle of 1 s from 3.5 to 4 s");
  CHECK(error.file == "rig.csv");
}

TEST_CASE("Of several quantities each has its own scatter") {
  const FitFolder folder;
  folder.write("rig.csv", sinusoidal_rig());
  const Measurements data =
      measured(folder,
               "time: t, to: 1.999, average_cycles: {period: 1}, "
               "compare: {CSF1: {column: load, over: {quantity: CP1, column: stroke}}, "
               "CP1: stroke, \"= CSF1 + 1\": load}");
  CHECK(data.responses[0].over.size() == 200);
  REQUIRE(data.cleaning.size() == 2);
  CHECK(contains(data.cleaning[1],
                 "2 of 4 cycles averaged to 200 rows; they differ by CSF1 by "
                 "0.005 N, CP1 by "));
  CHECK(contains(data.cleaning[1], "= CSF1 + 1 by 0.005 rms"));
}

TEST_CASE("The dead band of a measured speed and that of a position's slope agree") {
  const FitFolder folder;
  folder.write("rig.csv", sinusoidal_rig());
  const Measurements speed =
      measured(folder, "time: t, dead_band: {column: speed, below: 0.5}, compare: {CSF1: load}");
  const double share = static_cast<double>(speed.rows_used) / 801.0;
  CHECK(share == Approx(2.0 / 3.0).margin(0.01));  // |cos| >= 1/2; a row an edge
  CHECK(contains(speed.cleaning[0], "rows with a speed below 0.5 mm/s left out"));
  const Measurements slope = measured(
      folder, "time: t, dead_band: {position: stroke, below: 3.14159}, compare: {CSF1: load}");
  CHECK(std::abs(static_cast<double>(slope.rows_used) - static_cast<double>(speed.rows_used)) <=
        16.0);
  CHECK(refused(folder, "time: t, dead_band: {column: speed, below: 5}, compare: {CSF1: load}")
            .message == "every row is in the dead band");
}

TEST_CASE("Neither mean cycle nor resampling invents rows inside a dead band") {
  const FitFolder folder;
  folder.write("rig.csv", sinusoidal_rig());
  const Measurements data =
      measured(folder,
               "time: t, dead_band: {column: speed, below: 0.5}, average_cycles: "
               "{period: 1, points: 100}, resample: {every: 0.01}, compare: {CSF1: load}");
  CHECK(data.responses[0].time.size() > 60);
  CHECK(data.responses[0].time.size() < 70);
  for (const double t : data.responses[0].time) {
    CHECK(std::abs(std::cos(2.0 * std::numbers::pi * t)) > 0.49);
  }
  REQUIRE(data.cleaning.size() == 3);
  CHECK(contains(data.cleaning[1], "4 cycles averaged to 6"));
  CHECK(contains(data.cleaning[2], "resampled to "));
}

TEST_CASE("Resampling by a step and by a number of rows") {
  const FitFolder folder;
  const Measurements every =
      measured(folder, "time: t, resample: {every: 0.25}, compare: {CSF1: load}");
  CHECK(every.responses[0].time == Numbers{0.0, 0.25, 0.5, 0.75, 1.0});
  CHECK(every.responses[0].value[1] == Approx(0.0015).epsilon(1e-14));
  CHECK(every.cleaning == std::vector<std::string>{"resampled to 5 rows, one every 0.25 s"});
  const Measurements points =
      measured(folder, "time: t, resample: {points: 2}, compare: {CSF1: load}");
  CHECK(points.responses[0].time == Numbers{0.0, 1.0});
  CHECK(points.cleaning == std::vector<std::string>{"resampled to 2 rows"});
}

TEST_CASE("Tabs, blanks in names, other columns of words and notes between rows are no obstacle") {
  const FitFolder folder;
  folder.write("rig.csv",
               "# derived from a logger: in->mm x25.4, lbf->N x4.448\r\n"
               "Time(s)\tDispl (microns)\tFriction force\tState\r\n"
               "20086.207000\t5753.577000\t0.455250\trun\r\n"
               "# a pause\r\n"
               "20086.343000\t5753.253000\t0.454816\thold, then run\r\n");
  const Measurements data = measured(
      folder,
      "time: {column: Time(s), offset: -20086.207}, compare: {CSF1: Friction force, CP1: {column: "
      "Displ (microns), unit: micrometer}}");
  CHECK(data.responses[0].time[0] == Approx(0.0).margin(1e-9));
  CHECK(data.responses[0].time[1] == Approx(0.136).margin(1e-9));  // digits of the long times
  CHECK(data.responses[0].value == Numbers{0.455250, 0.454816});
  CHECK(data.responses[1].value[0] == Approx(5.753577).epsilon(1e-14));
}

TEST_CASE("Faults of the data are told with their line") {
  const FitFolder folder;
  folder.write("rig.csv", "t,stroke,load,speed\n0,0,0,0\n1,0,0,0\n1,0,0,0\n");
  base::HistoryError error = refused(folder, "time: t, compare: {CSF1: load}");
  CHECK(error.line == 4);
  CHECK(error.message == "the time 't' does not increase: 1 after 1 in line 3");
  folder.write("rig.csv", "t,stroke,load,speed\n0,0,0,0\n1,0,bad,0\n");
  error = refused(folder, "time: t, compare: {CSF1: load}");
  CHECK(error.line == 3);
  CHECK(error.message == "column 'load' holds 'bad', which is not a number");
  folder.write("rig.csv", "t,stroke,load,speed\n0,0,0,0\n1,0,1e308,0\n");
  error = refused(folder, "time: t, compare: {CSF1: {column: load, unit: kN}}");
  CHECK(error.line == 3);
  CHECK(contains(error.message, "exceeds the range of a double"));
}

}  // namespace
}  // namespace slipbench::driver::calibrate
