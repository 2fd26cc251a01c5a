// SPDX-License-Identifier: Apache-2.0
#include "driver/results/events.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

struct Found {
  Event event;
  double place = 0.0;  ///< CP1
};

std::vector<Found> events_of(const cases::Case& problem) {
  std::vector<Found> all;
  EventDetector detector(problem);
  for (const bench::Row& row : bench::rows_of(problem)) {
    for (const Event& event : detector.take(row)) {
      all.push_back({event, position_at(event, row, 0)});
    }
  }
  return all;
}

/// Reference cases, J2: 0 -> A -> -A -> A with A = 0.1 mm, limit 20 N, elastic slip 0.02 mm.
cases::Case j2(int increments, law::StickStiffness stick) {
  cases::Case problem =
      bench::slider_case({bench::step("out", increments, 0, history::LinearTo{0.1}),
                          bench::step("back", increments, 0, history::LinearTo{-0.1}),
                          bench::step("again", increments, 0, history::LinearTo{0.1})});
  problem.definitions[0].law.stick = stick;
  return problem;
}

TEST_CASE("events of an elastic slider are where its closed form has them, at any increment") {
  const auto stick = GENERATE(law::StickStiffness{law::StickStiffness::Mode::kStiffness, 1000.0},
                              law::StickStiffness{law::StickStiffness::Mode::kElasticSlip, 0.02});
  const int increments = GENERATE(3, 7, 64, 101);
  const auto found = events_of(j2(increments, stick));
  // Corners (0.02, 20), (0.06, -20), (-0.06, 20) and the turns at +-A; increments that do not fit
  // the corners. Rounding only.
  const double time[] = {0.2, 1.0, 1.2, 2.0, 2.2};
  const double place[] = {0.02, 0.1, 0.06, -0.1, -0.06};
  const double force[] = {20.0, 20.0, -20.0, -20.0, 20.0};
  const double slip[] = {0.0, 0.08, 0.08, 0.24, 0.24};
  const bool turns[] = {false, false, true, false, true};
  std::vector<Found> kept;
  // Within one increment from slip to slip the other way: one event, the stick on the way is not
  // one of the increment's ends.
  for (const Found& one : found) kept.push_back(one);
  if (increments == 3) {
    REQUIRE(kept.size() == 3);
    CHECK(kept[1].event.from == law::Regime::kSlip);
    CHECK(kept[1].event.to == law::Regime::kSlip);
    CHECK(kept[1].event.reversal);
    CHECK(kept[1].event.time == Approx(1.2).margin(1e-13));
    CHECK(kept[1].place == Approx(0.06).margin(1e-14));
    CHECK(kept[1].event.force == Approx(-20.0).margin(1e-11));
    return;
  }
  REQUIRE(kept.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    INFO("event " << i << ", " << increments << " increments");
    CHECK(kept[i].event.time == Approx(time[i]).margin(1e-12));
    CHECK(kept[i].place == Approx(place[i]).margin(1e-13));
    CHECK(kept[i].event.force == Approx(force[i]).margin(1e-11));
    CHECK(kept[i].event.limit == Approx(20.0).margin(1e-12));
    CHECK(kept[i].event.accumulated_slip == Approx(slip[i]).margin(1e-13));
    CHECK(kept[i].event.reversal == turns[i]);
    CHECK(kept[i].event.to == (i % 2 == 0 ? law::Regime::kSlip : law::Regime::kStick));
  }
}

TEST_CASE("a slip that goes on in another direction is no event, one that turns back is") {
  cases::Case problem = bench::slider_case({bench::step("out", 10, 0, history::LinearTo{1.0})});
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions[0].coupled = true;
  problem.definitions[0].law.slip = law::slip_space({2, 3});
  const auto drive = [](std::string name, double x, double y) {
    cases::Step one = bench::step(std::move(name), 5, 1, history::LinearTo{x});
    one.drives.push_back({2, history::LinearTo{y}});
    return one;
  };
  problem.steps = {drive("out", 1.0, 0.0), drive("right angle", 1.0, 1.0), drive("back", 1.0, 0.0)};
  std::vector<Event> all;
  EventDetector detector(problem);
  for (const bench::Row& row : bench::rows_of(problem)) {
    for (const Event& event : detector.take(row)) all.push_back(event);
  }
  REQUIRE(all.size() == 2);
  CHECK(all[0].to == law::Regime::kSlip);
  CHECK_FALSE(all[0].reversal);
  CHECK(all[1].reversal);
  // 0.04 mm of the way back, as in one dimension: the force has turned into it within 1e-9.
  CHECK(all[1].time == Approx(2.04).margin(1e-9));
}

TEST_CASE("exactly integrated slip that turns far is no event, in one increment or many") {
  // West, then north with a little east while the normal force falls from 100 N to 10 N: the limit
  // comes down on the force and slip never ceases, though its direction turns by over 90 degrees.
  const int increments = GENERATE(1, 7);
  cases::Case problem =
      bench::slider_case({bench::step("west", 1, 1, history::LinearTo{-1.0}),
                          bench::step("north", increments, 1, history::LinearTo{-0.99})});
  problem.steps[0].drives.push_back({cases::kFirstForce, history::Constant{100.0}});
  problem.steps[1].drives.push_back({2, history::LinearTo{0.0995}});
  problem.steps[1].drives.push_back({cases::kFirstForce, history::LinearTo{10.0}});
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions[0].coupled = true;
  problem.definitions[0].law.slip = law::slip_space({2, 3});
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{0};
  problem.integration.method = cases::IntegrationMethod::kExact;
  const auto found = events_of(problem);
  REQUIRE(found.size() == 1);
  CHECK(found[0].event.time == Approx(0.02).margin(1e-12));
}

TEST_CASE("contact is lost where the increment ends and found where it begins") {
  cases::Case problem = bench::slider_case({bench::step("slide", 4, 0, history::LinearTo{0.1})});
  law::Table table;
  law::TableError error;
  const std::vector<std::vector<double>> rows = {{100, 0.0}, {0, 0.05}, {0, 0.06}, {100, 0.1}};
  REQUIRE(law::Table::build(rows, 1, 1, law::Extrapolation::kConstant, &table, &error));
  problem.definitions[0].law.internal_contact_force =
      law::TableFunction(table, {{law::IndependentKind::kPosition, 0}});
  const auto found = events_of(problem);
  REQUIRE(found.size() == 3);
  CHECK(found[1].event.to == law::Regime::kOpen);
  CHECK(found[1].event.time == 0.5);
  CHECK(found[2].event.from == law::Regime::kOpen);
  CHECK(found[2].event.time >= 0.5);
  CHECK(found[2].event.time <= 0.75);
}

TEST_CASE("where the integration located the changes, they are the events") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 1, 0, history::LinearTo{0.1})});
  std::vector<bench::Row> rows = bench::rows_of(problem);
  bench::DefinitionRow& here = rows[1].definitions[0];
  here.changes.count = 3;
  here.changes.at[0] = {0.25, law::Regime::kSlip, 20.0, 20.0, 0.0};
  here.changes.at[1] = {0.5, law::Regime::kStick, 20.0, 20.0, 0.1};
  here.changes.at[2] = {0.75, law::Regime::kSlip, -20.0, 20.0, 0.1};
  EventDetector detector(problem);
  CHECK(detector.take(rows[0]).empty());
  const auto events = detector.take(rows[1]);
  REQUIRE(events.size() == 3);
  CHECK(events[0].time == 0.25);
  CHECK(events[1].from == law::Regime::kSlip);
  CHECK(events[1].accumulated_slip == 0.1);
  CHECK(events[2].reversal);
  CHECK(events[2].force == -20.0);
}

}  // namespace
}  // namespace slipbench::driver::results
