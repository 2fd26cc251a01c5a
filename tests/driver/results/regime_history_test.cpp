// SPDX-License-Identifier: Apache-2.0
#include "driver/results/regime_history.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::results {
namespace {

TEST_CASE("regimes are recorded with their spans, sums and instants") {
  RegimeRecorder recorder;
  recorder.begin(1, 0.0);
  recorder.change(2, 1.0);
  recorder.change(2, 2.0);
  recorder.change(1, 3.0);
  recorder.change(0, 3.5);
  recorder.change(2, 4.0);
  const RegimeHistory history = recorder.end(6.0);
  REQUIRE(history.spans.size() == 3);
  CHECK(history.spans[0].from == 1.0);
  CHECK(history.spans[0].to == 3.0);
  CHECK(history.spans[1].status == 0);
  CHECK(history.slip_time == 4.0);
  CHECK(history.open_time == 0.5);
  CHECK(history.slip_begins == 2);
  REQUIRE(history.marks.size() == 5);
  CHECK(history.marks[1].turns);
  CHECK_FALSE(history.marks[4].turns);
  CHECK(history.all_marked);
}

TEST_CASE("stick while slip turns is no slip, and no event either") {
  RegimeRecorder recorder;
  recorder.begin(2, 0.0);
  recorder.pause(1.0, 1.5);
  recorder.change(2, 1.5);
  const RegimeHistory history = recorder.end(2.0);
  CHECK(history.slip_time == 1.5);
  CHECK(history.slip_begins == 0);
  REQUIRE(history.spans.size() == 2);
  CHECK(history.spans[0].to == 1.0);
  CHECK(history.spans[1].from == 1.5);
  REQUIRE(history.marks.size() == 1);
  CHECK(history.marks[0].turns);
}

TEST_CASE("a run that chatters keeps its sums but not all of its marks") {
  RegimeRecorder recorder;
  recorder.begin(1, 0.0);
  for (int i = 0; i < 100000; ++i) recorder.change(i % 2 == 0 ? 2 : 1, i + 0.5);
  const RegimeHistory history = recorder.end(1e5);
  CHECK(history.slip_time == 50000.0);
  CHECK(history.slip_begins == 50000);
  CHECK(history.marks.size() <= 4000);
  CHECK(history.marks.size() > 500);
  CHECK_FALSE(history.all_marked);
  CHECK(history.spans.size() <= 1600);
}

TEST_CASE("marks are thinned where times do not rise, too") {
  for (const double step : {0.0, -1.0}) {
    CAPTURE(step);
    RegimeRecorder recorder;
    recorder.begin(1, 0.0);
    for (int i = 1; i <= 200000; ++i) recorder.change(i % 2 == 0 ? 1 : 2, step * i);
    const RegimeHistory history = recorder.end(step * 200000);
    CHECK(history.marks.size() <= 4000);
    CHECK(history.marks.size() > 500);
    CHECK_FALSE(history.all_marked);
  }
}

}  // namespace
}  // namespace slipbench::driver::results
