// SPDX-License-Identifier: Apache-2.0
#include "driver/results/coverage.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

law::TableFunction table_of(const std::vector<std::vector<double>>& rows,
                            std::vector<law::Independent> independents) {
  law::Table table;
  law::TableError error;
  const int count = static_cast<int>(independents.size());
  REQUIRE(law::Table::build(rows, 1, count, law::Extrapolation::kConstant, &table, &error));
  return {table, std::move(independents)};
}

/// mu over temperature 0 .. 10 .. 30 and field1 0 .. 1; a run from 5 to 45 degrees in 8 increments
/// at field1 = 0.5.
cases::Case warming_case() {
  cases::Case problem = bench::slider_case(
      {bench::step("warm", 8, cases::kTemperatureQuantity, history::LinearTo{45.0})});
  problem.definitions[0].law.law = law::TabularCoefficient{
      table_of({{0.3, 0, 0}, {0.2, 10, 0}, {0.1, 30, 0}, {0.3, 0, 1}, {0.2, 10, 1}, {0.1, 30, 1}},
               {{law::IndependentKind::kTemperature}, {law::IndependentKind::kField}})};
  problem.steps[0].drives.push_back({cases::kFirstField, history::Constant{0.5}});
  cases::Step first = bench::step("start", 1, cases::kTemperatureQuantity, history::Constant{5.0});
  problem.steps.insert(problem.steps.begin(), first);
  problem.steps[0].drives.push_back({cases::kFirstField, history::Constant{2.0}});
  return problem;
}

Coverage coverage_of(const cases::Case& problem) {
  Coverage coverage(problem);
  for (const bench::Row& row : bench::rows_of(problem)) coverage.add(row);
  return coverage;
}

TEST_CASE("the cells of a table are counted, those outside for themselves") {
  const cases::Case problem = warming_case();
  const Coverage coverage = coverage_of(problem);
  REQUIRE(coverage.tables().size() == 1);
  const TableCoverage& table = coverage.tables()[0];
  // Step 'start': field1 = 2 is above. 'warm': 10 (right-hand cell), 15, 20, 25, 30 (its end), then
  // 35, 40, 45 above.
  CHECK(table.increments == 9);
  CHECK(table.visits == std::vector<std::int64_t>{0, 5});
  CHECK(table.outside == 4);
  CHECK(table.axes[0].above == 3);
  CHECK(table.axes[0].below == 0);
  CHECK(table.axes[1].above == 1);
  CHECK(table.unvisited() == 1);
  CHECK(table.cell_text(0) == "temperature 0 .. 10, field1 0 .. 1");
  CHECK(coverage.text() ==
        "  table 'coefficient' of 'sleeve': 1 of 2 cells used, outside in 4 of 9 increments "
        "(temperature above 30, field1 above 1), where the end value is held\n");
  const std::string json = coverage.to_json().dump();
  CHECK(json.find("\"cells_never_visited\": 1") != std::string::npos);
  CHECK(json.find("temperature 0 .. 10, field1 0 .. 1") != std::string::npos);
}

TEST_CASE("a table that was used up and never left says nothing on the terminal") {
  cases::Case problem = bench::slider_case({bench::step("slide", 10, 0, history::LinearTo{1.0})});
  problem.definitions[0].law.internal_contact_force =
      table_of({{100, 0}, {90, 0.5}, {80, 1.0}}, {{law::IndependentKind::kPosition, 0}});
  const Coverage coverage = coverage_of(problem);
  REQUIRE(coverage.tables().size() == 1);
  // 0.1 .. 0.4 in the first, 0.5 .. 1.0 in the second.
  CHECK(coverage.tables()[0].visits == std::vector<std::int64_t>{4, 6});
  CHECK(coverage.text().empty());
}

TEST_CASE("a case without tables has no coverage") {
  const cases::Case problem =
      bench::slider_case({bench::step("slide", 10, 0, history::LinearTo{1.0})});
  CHECK(coverage_of(problem).tables().empty());
}

TEST_CASE("the table of a changed friction counts from its step on, the old one up to there") {
  cases::Case problem = bench::slider_case({bench::step("before", 3, 0, history::LinearTo{0.1}),
                                            bench::step("after", 5, 0, history::LinearTo{0.0})});
  problem.definitions[0].law.law =
      law::TabularCoefficient{table_of({{0.3, 0}, {0.2, 10}}, {{law::IndependentKind::kSlipRate}})};
  cases::FrictionChange change;
  change.law =
      law::TabularCoefficient{table_of({{0.1, 0}, {0.2, 10}}, {{law::IndependentKind::kSlipRate}})};
  change.stick = problem.definitions[0].law.stick;
  problem.steps[1].friction_changes.push_back(change);
  const Coverage coverage = coverage_of(problem);
  REQUIRE(coverage.tables().size() == 2);
  CHECK(coverage.tables()[0].increments == 3);
  CHECK(coverage.tables()[1].increments == 5);
  CHECK(coverage.tables()[1].what == "coefficient of step 'after'");
}

/// A case whose friction is changed to the same table over slip rate at the start of each step.
cases::Case changing_case(std::size_t steps, const law::TableFunction& table) {
  cases::FrictionChange change;
  change.law = law::TabularCoefficient{table};
  cases::Step step = bench::step("slide", 1, 0, history::LinearTo{0.1});
  step.friction_changes.push_back(std::move(change));
  cases::Case problem = bench::slider_case(std::vector<cases::Step>(steps, step));
  for (cases::Step& one : problem.steps) {
    one.friction_changes[0].stick = problem.definitions[0].law.stick;
  }
  return problem;
}

/// Counts the places at which a text stands in another.
std::size_t count_of(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

TEST_CASE("cells are counted for as long as all tables together have not too many") {
  // Blocks of two points each: 1399 cells along the rate, 699 along the force.
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < 700; ++i) {
    rows.push_back({0.1, 2.0 * i, i + 1.0});
    rows.push_back({0.2, 2.0 * i + 1.0, i + 1.0});
  }
  const law::TableFunction table =
      table_of(rows, {{law::IndependentKind::kSlipRate}, {law::IndependentKind::kContactForce}});
  const cases::Case problem = changing_case(3, table);
  const Coverage coverage = coverage_of(problem);
  REQUIRE(coverage.tables().size() == 3);
  std::size_t cells = 0;
  for (const TableCoverage& one : coverage.tables()) cells += one.visits.size();
  CHECK(cells == std::size_t{1399} * 699);
  CHECK(coverage.tables()[2].increments == 1);
  CHECK(coverage.text().find("the cells of 2 tables are not counted: more than 1048576 in all") !=
        std::string::npos);
  CHECK(count_of("cells_listed", coverage.to_json().dump()) == 1);
}

TEST_CASE("an increment is counted without a look at the tables of other steps") {
  constexpr std::size_t kSteps = 20000;
  const law::TableFunction table =
      table_of({{0.1, 0}, {0.2, 10}}, {{law::IndependentKind::kSlipRate}});
  const cases::Case problem = changing_case(kSteps, table);
  Coverage coverage(problem);
  bench::Row row = bench::rows_of(changing_case(1, table)).back();
  row.step = kSteps - 1;
  for (int i = 0; i < 1000000; ++i) coverage.add(row);
  CHECK(coverage.tables().back().increments == 1000000);
  // Rows of another run may begin anew.
  row.step = 3;
  coverage.add(row);
  for (const std::size_t step : {2U, 3U, 4U}) {
    CHECK(coverage.tables()[step].increments == (step == 3 ? 1 : 0));
  }
}

TEST_CASE("the cells of very many tables are not all named") {
  std::vector<std::vector<double>> rows(1002);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = {0.1, static_cast<double>(i)};
  const cases::Case problem =
      changing_case(150, table_of(rows, {{law::IndependentKind::kSlipRate}}));
  const std::string json = Coverage(problem).to_json().dump();
  CHECK(count_of("\"cells\": 1001", json) == 150);
  CHECK(count_of("\"cells_listed\": 1000", json) == 100);
  CHECK(count_of("\"cells_listed\": 0", json) == 50);
  CHECK(count_of("slip_rate 7 .. 8", json) == 100);
}

}  // namespace
}  // namespace slipbench::driver::results
