// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/identifiability.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/unseen_combinations.hpp"
#include "driver/calibrate/unvisited_ranges.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/calibrate/calibration_for_test.hpp"

using namespace slipbench::driver;
using namespace slipbench::driver::calibrate;

namespace {

bool any_contains(const std::vector<std::string>& notes, const std::string& part) {
  for (const std::string& note : notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the compared points that depend on an unknown are counted") {
  calibrate::Calibration c = calibration_of({{"mu", 0.2}, {"k", 4.0}}, {1.0, 0.0,    //
                                                                        2.0, 1e-14,  //
                                                                        0.0, 1.0});
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[0].visits == 2);
  CHECK(c.unknowns[1].visits == 1);  // 1e-14 of the largest is rounding
  CHECK(c.unknowns[0].identifiability == Identifiability::kGood);
  CHECK(c.unknowns[0].why.empty());
}

TEST_CASE("what no compared point depends on is never visited, even if smoothness ties it") {
  calibrate::Calibration c =
      calibration_of({{"mu", 0.2}, {"a", 1.0}, {"b", 1.0}}, {1.0, 0.0, 0.0,  //
                                                             2.0, 0.0, 0.0,  //
                                                             0.0, 0.0, 1.0});
  c.problem.data_rows = 2;
  c.fit.frozen = {0, 1, 0};
  c.unknowns[2].range.start = 0.9;
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[1].identifiability == Identifiability::kNeverVisited);
  CHECK(c.unknowns[1].why == "no compared point depends on it: kept at its start");
  CHECK(c.unknowns[2].identifiability == Identifiability::kNeverVisited);
  CHECK(c.unknowns[2].why ==
        "no compared point depends on it: moved from 0.9 to 1 by `smoothness`");
  const auto notes = calibrate::identifiability_notes(calibrate::fit_of({"mu", "a", "b"}), c);
  CHECK(any_contains(notes, "a is not identifiable: no compared point depends on it"));
}

TEST_CASE("an interval wider than the value or its bounds is weak") {
  calibrate::Calibration c =
      calibration_of({{"mu", 0.2}, {"x", 0.001}, {"k", 5.0}}, {1.0, 1.0, 1.0});
  c.statistics.lower = {0.05, -0.01, 0.5};
  c.statistics.upper = {0.35, 0.012, 12.0};
  c.unknowns[1].range.lower = -1.0;
  c.unknowns[1].range.upper = 1.0;
  c.unknowns[2].range.lower = 1.0;
  c.unknowns[2].range.upper = 10.0;
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[0].why == "its interval, 0.05 .. 0.35, is wider than the value itself");
  // An offset near zero is well known if its interval is a small part of its bounds.
  CHECK(c.unknowns[1].identifiability == Identifiability::kGood);
  CHECK(c.unknowns[2].why == "its interval, 0.5 .. 12, is wider than its bounds");
  CHECK(any_contains(calibrate::identifiability_notes(calibrate::fit_of({"mu", "x", "k"}), c),
                     "mu is only weakly known"));
}

TEST_CASE("of two unknowns that are seen together it is said what is seen of them") {
  const auto sentence = [](double a, double b, double slope_a, double slope_b) {
    calibrate::Calibration c = calibration_of({{"mu", a}, {"N", b}}, {slope_a, slope_b,  //
                                                                      -2 * slope_a, -2 * slope_b});
    c.statistics.identifiable = {0, 0};
    calibrate::judge_identifiability(&c);
    CHECK(c.unknowns[0].identifiability == Identifiability::kWeak);
    const auto found = calibrate::unseen_combinations(c);
    REQUIRE(found.size() == 1);
    CHECK(found[0].unknowns == std::vector<std::size_t>{0, 1});
    CHECK(c.unknowns[1].why == found[0].sentence);
    return found[0].sentence;
  };
  // r = mu N: dr/dmu = N, dr/dN = mu; and so on.
  CHECK(sentence(0.2, 50.0, 50.0, 0.2) == "only the product of mu and N is seen");
  CHECK(sentence(0.2, 50.0, 1.0 / 50.0, -0.2 / 2500.0) == "only the quotient of mu and N is seen");
  CHECK(sentence(0.2, 50.0, 3.0, 3.0) == "only the sum of mu and N is seen");
  CHECK(sentence(0.2, 50.0, 3.0, -3.0) == "only the difference of mu and N is seen");
  CHECK(sentence(0.2, 50.0, 3.0, 7.0) == "only one combination of mu and N is seen");
  CHECK(sentence(2.0, 2.0, 2.0, 2.0) == "only the product or the sum of mu and N is seen");
}

TEST_CASE("a combination of three unknowns is named as such") {
  // Columns a, b, a + b, and an unknown that is well seen.
  calibrate::Calibration c =
      calibration_of({{"a", 1.0}, {"b", 2.0}, {"c", 3.0}, {"d", 4.0}}, {1.0, 0.0, 1.0, 0.0,  //
                                                                        0.0, 1.0, 1.0, 0.0,  //
                                                                        1.0, 1.0, 2.0, 0.0,  //
                                                                        0.0, 0.0, 0.0, 1.0});
  c.statistics.identifiable = {0, 0, 0, 1};
  calibrate::judge_identifiability(&c);
  const auto found = calibrate::unseen_combinations(c);
  REQUIRE(found.size() == 1);
  CHECK(found[0].unknowns == std::vector<std::size_t>{0, 1, 2});
  CHECK(found[0].sentence == "a, b and c are seen in fewer combinations than they are");
  CHECK(c.unknowns[3].identifiability == Identifiability::kGood);
}

TEST_CASE("pairs that move together are told with digits that differ from 1") {
  calibrate::Calibration c =
      calibration_of({{"mu", 0.2}, {"N", 50.0}, {"k", 1.0}}, {1, 2, 3, 4, 5, 6});
  c.statistics.correlation = {1.0, -0.99991, 0.3, -0.99991, 1.0, 0.96, 0.3, 0.96, 1.0};
  const auto notes = calibrate::identifiability_notes(calibrate::fit_of({"mu", "N", "k"}), c);
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].starts_with("mu and N move together (correlation -0.99991)"));
  CHECK(notes[1].starts_with("N and k move together (correlation 0.96)"));
}

TEST_CASE("whole ranges that were never visited are told as ranges") {
  calibrate::FittedTable table =
      calibrate::grid_table({0, 1, 10}, {20, 50, 80, 120}, 0);  // 2 x 3 cells
  CHECK(calibrate::unvisited_ranges(table).empty());
  table.cells[4].visits = table.cells[5].visits = 0;
  CHECK(calibrate::unvisited_ranges(table) == "with temperature above 80 degC");
  table.cells[0].visits = 0;
  CHECK(
      calibrate::unvisited_ranges(table) ==
      "with temperature above 80 degC, nor with slip_rate 0 .. 1 mm/s, temperature 20 .. 50 degC");
  table.cells[2].visits = 0;
  CHECK(calibrate::unvisited_ranges(table) ==
        "with slip_rate below 1 mm/s, nor with temperature above 80 degC");
  for (auto& cell : table.cells) cell.visits = 0;
  CHECK(calibrate::unvisited_ranges(table) == "anywhere");
}

TEST_CASE("a cell whose edge only was met counts as never visited, everywhere") {
  // Increments at exactly 80 degC are counted in the cells above, where no ordinate is seen.
  std::vector<std::pair<std::string, double>> unknowns;
  for (int i = 0; i < 12; ++i) unknowns.push_back({"c[" + std::to_string(i) + "].mu", 0.2});
  calibrate::Calibration c = calibration_of(unknowns, {1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0});
  c.fit.frozen = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1};
  c.tables.push_back(calibrate::grid_table({0, 1, 10}, {20, 50, 80, 120}, 0));
  calibrate::judge_identifiability(&c);
  CHECK(calibrate::unvisited_ranges(c.tables[0]) == "with temperature above 80 degC");
  const std::vector<calibrate::FittedTable::Cell>& cells = c.tables[0].cells;
  REQUIRE(cells.size() == 6);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    CAPTURE(i);
    CHECK(cells[i].visits == 10);
    CHECK(cells[i].visited() == (i < 4));
  }
  c.fit.jacobian[8] = 0.0;
  c.fit.frozen[8] = 1;
  calibrate::judge_identifiability(&c);
  CHECK(
      calibrate::unvisited_ranges(c.tables[0]) ==
      "with temperature above 80 degC, nor with slip_rate 1 .. 10 mm/s, temperature 50 .. 80 degC");
  CHECK_FALSE(c.tables[0].cells[3].visited());
}

TEST_CASE("what moved to where no compared point depends on it was not kept at its start") {
  calibrate::Calibration c = calibration_of({{"mu", 0.3}, {"k", 4.0}}, {0.0, 1.0,  //
                                                                        0.0, 2.0});
  c.unknowns[0].range.start = 0.25;
  c.statistics.identifiable = {0, 1};
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[0].identifiability == Identifiability::kWeak);
  CHECK(c.unknowns[0].why ==
        "moved from 0.25 to 0.3, where no compared point depends on it: other values may fit as "
        "well");
  CHECK(any_contains(calibrate::identifiability_notes(calibrate::fit_of({"mu", "k"}), c),
                     "mu is only weakly known: moved from 0.25 to 0.3"));
  CHECK(calibrate::estimate_text(c, 0).remark == "weak");
}

TEST_CASE("a note on ordinates names them by their knots") {
  calibrate::Calibration c = calibration_of(
      {{"sleeve.coefficient[0].mu", 0.2}, {"sleeve.coefficient[1].mu", 0.3}}, {1, 2, 3, 4});
  c.statistics.correlation = {1.0, 0.97, 0.97, 1.0};
  calibrate::FittedTable table;
  table.columns = {"slip_rate"};
  table.units = {"mm/s"};
  table.points = {{0.0}, {3.5}};
  table.count = 2;
  c.tables = {table};
  calibrate::Fit fit = calibrate::fit_of({});
  fit.tables.resize(1);
  CHECK(any_contains(calibrate::identifiability_notes(fit, c),
                     "mu at slip_rate 0 mm/s and mu at slip_rate 3.5 mm/s move together"));
  // One of several tables is named.
  c.tables.emplace_back();
  c.tables.back().first_unknown = 2;
  CHECK(calibrate::told_name(c, 1) == "sleeve.coefficient.mu at slip_rate 3.5 mm/s");
}

TEST_CASE("an ordinate counts between its neighbours in its own block") {
  calibrate::FittedTable table;
  table.columns = {"slip_rate", "temperature"};
  table.points = {{0, 20}, {1, 20}, {5, 20}, {0, 80}, {3, 80}};
  CHECK(calibrate::neighbours(table, 1, 0) == std::pair{0.0, 5.0});
  CHECK(calibrate::neighbours(table, 3, 0) == std::pair{0.0, 3.0});
  CHECK(calibrate::neighbours(table, 2, 0) == std::pair{1.0, 5.0});
  CHECK(calibrate::neighbours(table, 2, 1) == std::pair{20.0, 80.0});
}

TEST_CASE("a note on a table names what was never visited and what became of its ordinates") {
  std::vector<std::pair<std::string, double>> unknowns;
  for (int i = 0; i < 6; ++i)
    unknowns.push_back({"sleeve.coefficient[" + std::to_string(i) + "].mu", 0.2});
  calibrate::Calibration c = calibration_of(unknowns, {1, 1, 1, 1, 0, 0});
  c.fit.frozen = {0, 0, 0, 0, 1, 1};
  c.tables.push_back(calibrate::grid_table({0, 10}, {20, 80, 120}, 0));
  c.tables[0].cells[1].visits = 0;
  calibrate::Fit fit = calibrate::fit_of({});
  fit.tables.emplace_back();
  fit.tables[0].name = "sleeve.coefficient";
  for (calibrate::FittedUnknown& unknown : c.unknowns) unknown.range.start = 0.2;
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[5].why == "its cells were never visited: kept at its start");
  CHECK(any_contains(calibrate::identifiability_notes(fit, c),
                     "table 'sleeve.coefficient': never visited with temperature above 80 degC; 2 "
                     "of 6 ordinates kept at their start; measure there to know them"));
  CHECK(calibrate::estimate_text(c, 5).remark == "never visited, kept");
  // An ordinate that gave way to its neighbour is not kept.
  c.unknowns[5].range.start = 0.3;
  c.tables[0].shape.monotone = fit::Shape::Monotone::kDecreasing;
  calibrate::judge_identifiability(&c);
  CHECK(c.unknowns[5].why ==
        "its cells were never visited: moved from 0.3 to 0.2 by `monotone: decreasing`");
  CHECK(any_contains(calibrate::identifiability_notes(fit, c),
                     "1 of 6 ordinates kept at their start, 1 moved by `monotone: decreasing`; "
                     "measure there to know them"));
}

TEST_CASE("the increments of runs are added up over the cells of a table") {
  const base::SourceText source("t.yaml", R"(slipbench: 1
units: {length: mm, force: N, time: s, temperature: degC}
connector: {type: SLOT}
friction:
  - name: sleeve
    component: 1
    internal_contact_force: 100
    coefficient:
      columns: [mu, slip_rate, temperature]
      rows: [[0.3, 0, 20], [0.2, 10, 20], [0.2, 0, 80], [0.1, 10, 80],
             [0.1, 0, 120], [0.1, 10, 120]]
    stick: {elastic_slip: 1e-3}
history:
  - {step: pull, duration: 1, increments: 10, motion: {CP1: {to: 5}}, temperature: 40}
)");
  const read::ReadCase read = read::read_case_text(source, ".");
  REQUIRE(read.value);
  calibrate::VariedTable varied;
  varied.definition = "sleeve";
  calibrate::FittedTable table = calibrate::grid_table({0, 10}, {20, 80, 120}, 0);
  table.cells.clear();
  table.units.clear();
  for (int run = 1; run <= 2; ++run) {
    results::Coverage coverage(*read.value);
    auto simulation = bench::Simulation::start(*read.value);
    REQUIRE(simulation);
    while (simulation->advance().value()) coverage.add(simulation->row());
    calibrate::add_visits(varied, *read.value, coverage, &table);
    REQUIRE(table.cells.size() == 2);
    CHECK(table.cells[0].visits == 10 * run);
    CHECK(table.cells[1].visits == 0);
  }
  CHECK(table.units == std::vector<std::string>{"mm/s", "degC"});
  varied.use = calibrate::VariedTable::Use::kInternalContactForce;
  calibrate::FittedTable other;
  results::Coverage coverage(*read.value);
  calibrate::add_visits(varied, *read.value, coverage, &other);
  CHECK(other.cells.empty());
}
