// SPDX-License-Identifier: Apache-2.0
#include "driver/report/collect.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver::report {
namespace {

TEST_CASE("a report tells what a picture of friction needs") {
  const CaseReport report = report_of(read_slider("0.2"), "folder/slider");
  CHECK(report.name == "folder/slider");
  CHECK(report.title == "Slider");
  CHECK(report.status == ReportStatus::kPassed);
  CHECK(report.increments == 20);
  CHECK_FALSE(report.drawn.thinned);
  REQUIRE(report.row_count() == 21);
  CHECK(number_at(report, 10, "t") == Approx(1.0).epsilon(1e-14));
  CHECK(number_at(report, 10, "CP1") == Approx(0.1).epsilon(1e-14));
  CHECK(number_at(report, 10, "CSF1") == Approx(20.0).epsilon(1e-14));
  REQUIRE(report.definitions.size() == 1);
  const ReportDefinition& sleeve = report.definitions[0];
  CHECK(sleeve.name == "sleeve");
  CHECK(sleeve.force == "CSF1");
  CHECK(sleeve.forces == std::vector<std::string>{"CSF1"});
  CHECK(sleeve.positions == std::vector<std::string>{"CP1"});
  CHECK(sleeve.limit == "FLIM");
  CHECK(sleeve.limit_below.empty());
  CHECK(sleeve.normal_force == "FN");
  CHECK(sleeve.mu == "MU");
  // Slip lasts from 0.02 to 0.1 mm at 0.1 mm/s, and back from 0.06 to 0 mm: 1.4 of 2 s. The onset
  // is located in its increment; what remains is rounding.
  CHECK(sleeve.slip_share == Approx(0.7).epsilon(1e-12));
  REQUIRE(sleeve.spans.size() == 2);
  CHECK(sleeve.spans[0].from == Approx(0.2).epsilon(1e-12));
  CHECK(sleeve.spans[0].to == Approx(1.0).epsilon(1e-12));
  CHECK(sleeve.spans[1].from == Approx(1.4).epsilon(1e-12));
  CHECK(sleeve.spans[1].to == Approx(2.0).epsilon(1e-12));
  REQUIRE(report.events.size() == 3);
  CHECK(report.events_total == 3);
  CHECK(report.events[1].from == "slip");
  CHECK(report.events[1].to == "stick");
  CHECK(report.events[2].reversal);
  CHECK(report.events[2].positions.front().first == "CP1");
  CHECK(report.events[2].positions.front().second == Approx(0.06).epsilon(1e-12));
  REQUIRE(report.energies.size() == 3);
  CHECK(report.energies[0].first == "work");
  CHECK(report.energies[1].second == std::vector<std::string>{"DISS"});
  CHECK(report.parameters.front().second == 0.2);
  CHECK(report.summary.front().starts_with("slips 70 % of the time"));
}

TEST_CASE("a failed check brings its curves, its tolerance and its worst point") {
  const CaseReport report = report_of(read_slider("0.3"));
  CHECK(report.status == ReportStatus::kFailed);
  REQUIRE(report.checks.size() == 1);
  const ReportCheck& check = report.checks[0];
  CHECK_FALSE(check.verdict.passed);
  CHECK(check.verdict.worst.value == Approx(20.0).epsilon(1e-14));
  CHECK(check.verdict.worst.reference == Approx(30.0).epsilon(1e-14));
  CHECK(check.quantity == "FLIM");
  CHECK(check.against.starts_with("expression "));
  CHECK(check.why == "a guess");
  CHECK(check.tube == 0.5);
  REQUIRE(check.value.x.size() == 21);
  CHECK(check.value.x == check.reference.x);
  CHECK(check.value.y[5] == Approx(20.0).epsilon(1e-14));
  CHECK(check.reference.y[5] == Approx(30.0).epsilon(1e-14));
}

TEST_CASE("a run of fifty thousand rows is there, a longer one is thinned and says so") {
  CHECK(report_of(read_slider("0.2", 20000)).row_count() == 40001);
  const CaseReport report = report_of(read_slider("0.2", 20000), "case", 2500);
  CHECK(report.drawn.thinned);
  CHECK(report.increments == 40000);
  CHECK(report.rows_total == 40001);
  CHECK(report.row_count() <= 2500);
  CHECK(report.row_count() > 600);
  CHECK(number_at(report, report.row_count() - 1, "t") == Approx(2.0).epsilon(1e-12));
  // The rows about each event stay, so that the corners of the loop are where they were: the
  // increments are 5e-6 mm long.
  const auto corner = [&](double place) {
    for (std::size_t i = 0; i < report.row_count(); ++i) {
      if (std::abs(number_at(report, i, "CP1") - place) < 1.01e-5) return true;
    }
    return false;
  };
  CHECK(corner(0.02));
  CHECK(corner(0.1));
  CHECK(corner(0.06));
  CHECK(report.checks[0].thinned);
  CHECK(report.checks[0].value.x.size() <= 1000);
}

/// The row of the report nearest to a time, the places of its neighbours being those beside it.
std::size_t whole_row_at(const CaseReport& report, double time) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < report.row_count(); ++i) {
    const auto off = [&](std::size_t row) { return std::abs(number_at(report, row, "t") - time); };
    if (off(i) < off(best)) best = i;
  }
  REQUIRE(best > 0);
  REQUIRE(best + 1 < report.row_count());
  CHECK(report.drawn.rows.index[best] == report.drawn.rows.index[best - 1] + 1);
  CHECK(report.drawn.rows.index[best] == report.drawn.rows.index[best + 1] - 1);
  return best;
}

TEST_CASE("the row where a check is worst and its neighbours stay, however long the run") {
  const CaseReport report = report_of(read_cycles(100, 100), "case", 2500);
  REQUIRE(report.drawn.thinned);
  REQUIRE(report.checks[0].verdict.failing == 1);
  const double worst = report.checks[0].verdict.worst.time;
  CHECK(worst == Approx(39.37).epsilon(1e-9));
  const std::size_t row = whole_row_at(report, worst);
  CHECK(number_at(report, row, "t") == worst);
  // On its way down from 0.1 mm, where it had 20 N, it still sticks; the rest is rounding.
  const double way = 0.1 - number_at(report, row, "CP1");
  CHECK(way == Approx(0.1 - 0.1 * std::sin(0.74 * 3.14159265358979324)).epsilon(1e-9));
  CHECK(number_at(report, row, "STATUS") == 1.0);
  CHECK(number_at(report, row, "CSF1") == Approx(20.0 - 1000.0 * way).epsilon(1e-9));
}

TEST_CASE("of many events the first and the last are told, with their rows") {
  const CaseReport report = report_of(read_cycles(100, 100), "case", 2500);
  CHECK(report.events_total == 401);
  REQUIRE(report.events.size() == 200);
  CHECK(report.events[0].time < 0.1);
  CHECK(report.events[99].time < 25.1);
  CHECK(report.events[100].time > 74.9);
  CHECK(report.events[199].time > 99.5);
  CHECK(report.row_count() <= 2500);
  for (const std::size_t event : {0U, 1U, 2U, 3U, 10U, 198U, 199U}) {
    CAPTURE(event);
    const double time = report.events[event].time;
    bool beside = false;
    for (std::size_t i = 1; i < report.row_count(); ++i) {
      beside = beside || (report.drawn.rows.index[i] == report.drawn.rows.index[i - 1] + 1 &&
                          number_at(report, i - 1, "t") <= time * (1.0 + 1e-12) &&
                          number_at(report, i, "t") >= time * (1.0 - 1e-12));
    }
    CHECK(beside);
  }
}

TEST_CASE("energies are told in the unit of the summary") {
  const CaseReport report = report_of(read_slider("0.2"));
  int energies = 0;
  for (const ReportColumn& column : report.columns) {
    if (column.name == "WORK" || column.name == "DISS" || column.name == "STRAIN_E") {
      CHECK(column.unit == "mJ");
      ++energies;
    }
  }
  CHECK(energies == 3);
  CHECK(report.units.back() == std::pair<std::string, std::string>("energy", "mJ"));
}

TEST_CASE("the definitions of a coupled connection are drawn with their own columns") {
  const cases::Case problem =
      bench::puck_case({bench::step("slide", 20, cases::kFirstMotion + 1, history::LinearTo{0.1})});
  const CaseReport report = report_of(problem);
  REQUIRE(report.definitions.size() == 2);
  CHECK(report.definitions[0].force == "CSFC");
  CHECK(report.definitions[0].forces == std::vector<std::string>{"CSF2", "CSF3"});
  CHECK(report.definitions[0].positions == std::vector<std::string>{"CP2", "CP3"});
  CHECK(report.definitions[1].limit == "FLIM." + problem.definitions[1].name);
  CHECK(report.status == ReportStatus::kNoChecks);
  CHECK(report.columns.size() <= 24);
  for (const ReportDefinition& definition : report.definitions) {
    CHECK_NOTHROW(number_at(report, 0, definition.status));
  }
}

TEST_CASE("what the reader noted and warned of is told") {
  CaseReport report;
  base::Diagnostics diagnostics;
  diagnostics.note("a.yaml", {}, "friction[0]", "1 mm used", "give 'length'");
  diagnostics.warning("a.yaml", {}, "", "odd");
  add_remarks(report, diagnostics);
  CHECK(report.summary == std::vector<std::string>{"note: friction[0]: 1 mm used; give 'length'"});
  CHECK(report.warnings == std::vector<std::string>{"odd"});
}

}  // namespace
}  // namespace slipbench::driver::report
