// SPDX-License-Identifier: Apache-2.0
#include "driver/results/columns.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

std::vector<std::string> names(const std::vector<Column>& columns) {
  std::vector<std::string> all;
  for (const Column& column : columns) all.push_back(column.name);
  return all;
}

double value(const cases::Case& problem, const bench::Row& row, const std::string& name) {
  const std::vector<Column> columns = result_columns(problem);
  const auto column = find_column(problem, columns, name);
  REQUIRE(column);
  return column_value(*column, problem, row);
}

TEST_CASE("a connector has the columns of its components and of its definition") {
  const cases::Case problem =
      bench::slider_case({bench::step("slide", 2, 0, history::LinearTo{0.1})});
  CHECK(names(result_columns(problem)) ==
        std::vector<std::string>{"t",     "CP1",    "CU1",      "CCU1", "CV1",  "CSF1",
                                 "CTF1",  "CRF2",   "CTF2",     "CRF3", "CTF3", "CNF1",
                                 "CASU1", "STATUS", "MU",       "FN",   "FLIM", "PHI",
                                 "SEL",   "DISS",   "STRAIN_E", "WORK"});
}

TEST_CASE("temperature and fields have columns only where they are driven") {
  cases::Case problem = bench::slider_case(
      {bench::step("heat", 2, cases::kTemperatureQuantity, history::LinearTo{100.0})});
  problem.steps[0].drives.push_back({cases::kFirstField + 1, history::Constant{7.0}});
  const std::vector<std::string> all = names(result_columns(problem));
  CHECK(std::vector<std::string>(all.end() - 2, all.end()) ==
        std::vector<std::string>{"temperature", "field2"});
  CHECK(value(problem, bench::rows_of(problem)[2], "temperature") == 100.0);
  CHECK(value(problem, bench::rows_of(problem)[0], "field2") == 7.0);
}

TEST_CASE("with several definitions each has its own columns, named after it") {
  const cases::Case problem =
      bench::puck_case({bench::step("slide", 10, 1, history::LinearTo{0.1})});
  const std::vector<std::string> all = names(result_columns(problem));
  for (const char* name : {"CSF2", "CSF3", "CSM1", "CRF1", "CRM2", "CRM3", "CSFC", "CNFC", "CASUC",
                           "CIVC", "CNM1", "CASUR1", "FLIM.sliding", "FLIM.spinning"}) {
    INFO(name);
    CHECK(std::count(all.begin(), all.end(), name) == 1);
  }
  CHECK(std::count(all.begin(), all.end(), "FLIM") == 0);
  const bench::Row last = bench::rows_of(problem).back();
  // By hand: sliding F_N 140, spinning M_N 46.3333; mu = 0.2.
  CHECK(value(problem, last, "FLIM.sliding") == Approx(28.0).epsilon(1e-14));
  CHECK(value(problem, last, "CNFC") == Approx(140.0).epsilon(1e-14));
  CHECK(value(problem, last, "FN.spinning") == Approx(46.0 + 1.0 / 3.0).epsilon(1e-14));
  CHECK(value(problem, last, "CSF2") == Approx(28.0).epsilon(1e-14));
  CHECK(value(problem, last, "CSFC") == value(problem, last, "CSF2"));
  CHECK(value(problem, last, "CTF2") == value(problem, last, "CSF2"));
  CHECK(value(problem, last, "CRM3") == 8.0);
  // All motion of the last increment is along the slip direction: 0.1 in 1 s.
  CHECK(value(problem, last, "CIVC") == Approx(0.1).epsilon(1e-12));
  CHECK(value(problem, last, "STATUS.sliding") == 2.0);
  CHECK(value(problem, last, "STATUS.spinning") == 1.0);
}

TEST_CASE("names that carry their definition are understood, foreign ones are not") {
  const cases::Case problem =
      bench::puck_case({bench::step("slide", 2, 1, history::LinearTo{0.1})});
  const std::vector<Column> columns = result_columns(problem);
  CHECK(find_column(problem, columns, "CSF2.sliding"));
  CHECK_FALSE(find_column(problem, columns, "CSF2.spinning"));
  CHECK_FALSE(find_column(problem, columns, "CSF9.sliding"));
  CHECK_FALSE(find_column(problem, columns, "CRF1.sliding"));
  // A held position can be read, but is no column of the result.
  CHECK(find_column(problem, columns, "CP1"));
  const cases::Case single = bench::slider_case({});
  const std::vector<Column> all = result_columns(single);
  CHECK(find_column(single, all, "FLIM.sleeve"));
  CHECK_FALSE(find_column(single, all, "FLIM.other"));
  const std::vector<std::string> offered = column_names(single);
  CHECK(std::count(offered.begin(), offered.end(), "CSF1.sleeve") == 1);
}

TEST_CASE("displacements count from the initial and from the reference position") {
  cases::Case problem = bench::slider_case({bench::step("slide", 2, 0, history::LinearTo{0.9})});
  problem.initial[0] = 0.5;
  problem.reference[0] = 0.2;
  const std::vector<bench::Row> rows = bench::rows_of(problem);
  CHECK(value(problem, rows[2], "CP1") == 0.9);
  CHECK(value(problem, rows[2], "CU1") == Approx(0.4));
  CHECK(value(problem, rows[2], "CCU1") == Approx(0.7));
  CHECK(value(problem, rows[2], "CV1") == Approx(0.4));
  CHECK(value(problem, rows[0], "CV1") == 0.0);
}

TEST_CASE("a case may select its output, which then follows t") {
  cases::Case problem = bench::slider_case({});
  problem.output_columns = {"FLIM", "CSF1.sleeve"};
  CHECK(names(output_columns(problem)) == std::vector<std::string>{"t", "FLIM", "CSF1.sleeve"});
}

TEST_CASE("moments have their own dimension, forces scaled by a lever do not") {
  const cases::Case puck = bench::puck_case({});
  CHECK_FALSE(is_rotational(puck.definitions[0].law));
  CHECK(is_rotational(puck.definitions[1].law));
  law::FrictionDefinition ball;
  ball.slip = law::slip_space({4, 5, 6}, 0.3);
  CHECK_FALSE(is_rotational(ball));
}

}  // namespace
}  // namespace slipbench::driver::results
