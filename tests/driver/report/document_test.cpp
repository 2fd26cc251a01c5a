// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "driver/report/report.hpp"
#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver::report {
namespace {

std::string document_of(std::vector<CaseReport> reports, const std::string& title = "Title") {
  ReportCollection collection(reports.size());
  for (std::size_t i = 0; i < reports.size(); ++i) collection.put(i, std::move(reports[i]));
  return report_document(collection, title);
}

std::string text(const yaml::Node& node, const char* name) {
  const auto member = node.find(name);
  REQUIRE(member);
  return std::string(member->text());
}

TEST_CASE("the document has the totals, and of each case columns, events and checks") {
  const yaml::Tree tree = tree_of(
      document_of({report_of(read_slider("0.2"), "good"), report_of(read_slider("0.3"), "poor"),
                   not_run_report("bad", "", "bad.yaml:1:1: error\n")}));
  const yaml::Node root = tree.root();
  CHECK(text(root, "schema") == "1");
  const yaml::Node totals = *root.find("totals");
  CHECK(text(totals, "cases") == "3");
  CHECK(text(totals, "passed") == "1");
  CHECK(text(totals, "failed") == "1");
  CHECK(text(totals, "not_run") == "1");
  CHECK(text(totals, "checks") == "2");
  const yaml::Node cases = *root.find("cases");
  REQUIRE(cases.size() == 3);
  const yaml::Node good = cases[0];
  CHECK(text(good, "id") == "good");
  CHECK(text(good, "status") == "passed");
  CHECK(text(good, "details") == "true");
  const yaml::Node columns = *good.find("columns");
  const yaml::Node rows = *good.find("rows");
  REQUIRE(rows.size() == columns.size());
  CHECK(text(columns[0], "name") == "t");
  CHECK(text(columns[0], "unit") == "s");
  for (const yaml::Node column : rows.items()) CHECK(unpacked(column.text()).size() == 21);
  // 0.30000000000000004 and the like are told as far as a row is apart from the next.
  CHECK(unpacked(rows[0].text())[3] == 0.3);
  const yaml::Node definition = (*good.find("definitions"))[0];
  CHECK(text(definition, "force") == "CSF1");
  CHECK(definition.find("limit_below")->is_null());
  CHECK((*definition.find("spans"))[0][2].text() == "2");
  CHECK(text((*good.find("events"))[1], "to") == "stick");
  const yaml::Node poor = cases[1];
  const yaml::Node check = (*poor.find("checks"))[0];
  CHECK(text(check, "passed") == "false");
  CHECK(text(*check.find("worst"), "reference") == "30");
  const yaml::Node trace = *check.find("trace");
  CHECK(unpacked(text(*trace.find("value"), "x")).size() ==
        unpacked(text(*trace.find("reference"), "y")).size());
  CHECK(text(trace, "tube") == "0.5");
  const yaml::Node bad = cases[2];
  CHECK(text(bad, "status") == "not_run");
  CHECK(text(bad, "message") == "bad.yaml:1:1: error\n");
  CHECK(text(bad, "details") == "false");
  CHECK_FALSE(bad.find("rows"));
}

TEST_CASE("a short motion far away and late keeps its times and its shape") {
  // 1000 s of waiting, then 200 increments in a hundredth of a second, of 0.1 mm at 1000 mm.
  CaseReport report = report_of(read_slider("0.2"));
  const std::size_t columns = report.columns.size();
  const std::vector<double> row(
      report.drawn.rows.numbers.begin(),
      report.drawn.rows.numbers.begin() + static_cast<std::ptrdiff_t>(columns));
  report.drawn.rows.numbers.clear();
  std::size_t position = 0;
  while (report.columns[position].name != "CP1") ++position;
  for (int i = 0; i <= 200; ++i) {
    report.drawn.rows.index.resize(static_cast<std::size_t>(i) + 1);
    report.drawn.rows.numbers.insert(report.drawn.rows.numbers.end(), row.begin(), row.end());
    double* const added =
        report.drawn.rows.numbers.data() + report.drawn.rows.numbers.size() - columns;
    added[0] = i == 0 ? 0.0 : 1000.0 + 5e-5 * i;
    added[position] = i == 0 ? 0.0 : 1000.0 + 0.1 * std::sin(0.02 * i);
  }
  report.events[0].time = 1000.0 + 5e-5 * 10.25;
  report.checks[0].verdict.worst.time = 1000.0 + 5e-5 * 60;
  const yaml::Tree tree = tree_of(document_of({report}));
  const yaml::Node one = (*tree.root().find("cases"))[0];
  const auto distinct = [&](std::size_t column) {
    const auto numbers = unpacked((*one.find("rows"))[column].text());
    return std::set<double>(numbers.begin(), numbers.end()).size();
  };
  CHECK(distinct(0) == 201);
  // The sine turns at 1.57, so that a few of its numbers may come twice.
  CHECK(distinct(position) >= 195);
  const std::vector<double> times = unpacked((*one.find("rows"))[0].text());
  CHECK(times[10] == 1000.0005);
  CHECK(text((*one.find("events"))[0], "t") == "1000.0005125");
  CHECK(text(*(*one.find("checks"))[0].find("worst"), "time") == fmt::format("{}", times[60]));
}

TEST_CASE("spans that cover several regimes are marked") {
  CaseReport report = report_of(read_slider("0.2"));
  report.definitions[0].spans = {{0.2, 1.0, 2, false}, {1.4, 2.0, 2, true}};
  const yaml::Tree tree = tree_of(document_of({report}));
  const yaml::Node spans = *(*(*tree.root().find("cases"))[0].find("definitions"))[0].find("spans");
  CHECK(spans[0].size() == 3);
  REQUIRE(spans[1].size() == 4);
  CHECK(spans[1][3].text() == "true");
}

TEST_CASE("a thinned case says which rows there are, its extremes and its cycles") {
  const cases::Case problem = read_cycles(100, 100);
  const yaml::Tree tree = tree_of(document_of({report_of(problem, "case", 2500)}));
  const yaml::Node one = (*tree.root().find("cases"))[0];
  CHECK(text(one, "thinned") == "true");
  CHECK(text(one, "rows_total") == "10001");
  const auto index = unpacked(text(one, "index"));
  CHECK(index.front() == 0.0);
  CHECK(index.back() == 10000.0);
  CHECK(std::to_string(index.size()) == text(one, "rows_shown"));
  const yaml::Node pieces = *one.find("pieces");
  CHECK(pieces.find("low")->size() == one.find("columns")->size());
  // 10001 rows in pieces of 32.
  CHECK(text(pieces, "rows") == "32");
  CHECK(unpacked((*pieces.find("high"))[1].text()).size() == 313);
  const yaml::Node cycles = *one.find("cycles");
  CHECK(text(cycles, "of") == "CP1");
  CHECK(text(cycles, "total") == "100");
  const auto times = unpacked((*one.find("rows"))[0].text());
  for (const yaml::Node cycle : cycles.find("drawn")->items()) {
    if (cycle[0].text() == "0") continue;
    const auto first = static_cast<std::size_t>(std::stoi(std::string(cycle[1].text())));
    const auto last = static_cast<std::size_t>(std::stoi(std::string(cycle[2].text())));
    CHECK(last - first == 100);
    CHECK(times[last] - times[first] == Approx(1.0).epsilon(1e-9));
    CHECK(times[last] == Approx(std::stod(std::string(cycle[0].text()))).epsilon(1e-9));
  }
}

TEST_CASE("the same cases give the same bytes") {
  const auto document = [] { return document_of({report_of(read_slider("0.3"))}); };
  CHECK(document() == document());
}

TEST_CASE("hostile texts stay texts") {
  CaseReport report = not_run_report("</script>", "<!--\xE2\x80\xA8", "\"\\\n");
  const std::string document = document_of({report}, "</SCRIPT>");
  CHECK(document.find('<') == std::string::npos);
  CHECK(document.find("\xE2\x80\xA8") == std::string::npos);
  CHECK(document.find('\n') == std::string::npos);
  const yaml::Tree tree = tree_of(document);
  CHECK(text(tree.root(), "title") == "</SCRIPT>");
  CHECK(text((*tree.root().find("cases"))[0], "message") == "\"\\\n");
}

TEST_CASE("cases of one name get ids of their own") {
  const CaseReport same = not_run_report("a", "", "");
  const yaml::Tree tree = tree_of(document_of({same, not_run_report("a (2)", "", ""), same, same}));
  const yaml::Node cases = *tree.root().find("cases");
  CHECK(text(cases[0], "id") == "a");
  CHECK(text(cases[1], "id") == "a (2)");
  CHECK(text(cases[2], "id") == "a (3)");
  CHECK(text(cases[3], "id") == "a (4)");
}

TEST_CASE("results that draw the same columns are compared, cases are not") {
  CaseReport result = report_of(read_slider("0.2"), "old");
  const CaseReport of_case = result;
  result.is_result = true;
  CaseReport other = result;
  other.name = "new";
  CaseReport third = result;
  third.name = "another force";
  third.definitions[0].force = "CSF2";
  const yaml::Tree tree = tree_of(document_of({of_case, result, third, other}));
  const yaml::Node groups = *tree.root().find("compare");
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].size() == 2);
  CHECK(groups[0][0].text() == "old (2)");
  CHECK(groups[0][1].text() == "new");
}

TEST_CASE("what is only reported has no tolerance, what is not finite is null") {
  CaseReport report = report_of(read_slider("0.2"));
  check::Measure phase;
  phase.name = "phase";
  phase.unit = check::MeasureUnit::kNone;
  phase.tolerance = std::numeric_limits<double>::infinity();
  report.checks[0].verdict.measures = {phase};
  report.drawn.rows.numbers[1] = std::numeric_limits<double>::quiet_NaN();
  const yaml::Tree tree = tree_of(document_of({report}));
  const yaml::Node one = (*tree.root().find("cases"))[0];
  const yaml::Node measure = (*(*one.find("checks"))[0].find("measures"))[0];
  CHECK(measure.find("tolerance")->is_null());
  CHECK(text(measure, "passed") == "true");
  CHECK(std::isnan(unpacked((*one.find("rows"))[1].text())[0]));
}

}  // namespace
}  // namespace slipbench::driver::report
