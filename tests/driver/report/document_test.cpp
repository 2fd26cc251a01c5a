// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "driver/report/report.hpp"
#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver {
namespace {

std::string document_of(std::vector<CaseReport> reports, const std::string& title = "Title") {
  ReportCollection collection(reports.size());
  for (std::size_t i = 0; i < reports.size(); ++i) collection.put(i, std::move(reports[i]));
  return report_document(collection, title);
}

std::string text(const Node& node, const char* name) {
  const auto member = node.find(name);
  REQUIRE(member);
  return std::string(member->text());
}

TEST_CASE("the document has the totals, and of each case columns, events and checks") {
  const Tree tree = tree_of(
      document_of({report_of(read_slider("0.2"), "good"), report_of(read_slider("0.3"), "poor"),
                   not_run_report("bad", "", "bad.yaml:1:1: error\n")}));
  const Node root = tree.root();
  CHECK(text(root, "schema") == "1");
  const Node totals = *root.find("totals");
  CHECK(text(totals, "cases") == "3");
  CHECK(text(totals, "passed") == "1");
  CHECK(text(totals, "failed") == "1");
  CHECK(text(totals, "not_run") == "1");
  CHECK(text(totals, "checks") == "2");
  const Node cases = *root.find("cases");
  REQUIRE(cases.size() == 3);
  const Node good = cases[0];
  CHECK(text(good, "id") == "good");
  CHECK(text(good, "status") == "passed");
  CHECK(text(good, "details") == "true");
  const Node columns = *good.find("columns");
  const Node rows = *good.find("rows");
  REQUIRE(rows.size() == columns.size());
  CHECK(text(columns[0], "name") == "t");
  CHECK(text(columns[0], "unit") == "s");
  for (const Node column : rows.items()) CHECK(column.size() == 21);
  // 0.30000000000000004 and the like have six digits.
  CHECK(rows[0][3].text() == "0.3");
  const Node definition = (*good.find("definitions"))[0];
  CHECK(text(definition, "force") == "CSF1");
  CHECK(definition.find("limit_below")->is_null());
  CHECK((*definition.find("spans"))[0][2].text() == "2");
  CHECK(text((*good.find("events"))[1], "to") == "stick");
  const Node poor = cases[1];
  const Node check = (*poor.find("checks"))[0];
  CHECK(text(check, "passed") == "false");
  CHECK(text(*check.find("worst"), "reference") == "30");
  const Node trace = *check.find("trace");
  CHECK(trace.find("value")->find("x")->size() == trace.find("reference")->find("y")->size());
  CHECK(text(trace, "tube") == "0.5");
  const Node bad = cases[2];
  CHECK(text(bad, "status") == "not_run");
  CHECK(text(bad, "message") == "bad.yaml:1:1: error\n");
  CHECK(text(bad, "details") == "false");
  CHECK_FALSE(bad.find("rows"));
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
  const Tree tree = tree_of(document);
  CHECK(text(tree.root(), "title") == "</SCRIPT>");
  CHECK(text((*tree.root().find("cases"))[0], "message") == "\"\\\n");
}

TEST_CASE("cases of one name get ids of their own") {
  const CaseReport same = not_run_report("a", "", "");
  const Tree tree = tree_of(document_of({same, not_run_report("a (2)", "", ""), same, same}));
  const Node cases = *tree.root().find("cases");
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
  const Tree tree = tree_of(document_of({of_case, result, third, other}));
  const Node groups = *tree.root().find("compare");
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].size() == 2);
  CHECK(groups[0][0].text() == "old (2)");
  CHECK(groups[0][1].text() == "new");
}

TEST_CASE("what is only reported has no tolerance, what is not finite is null") {
  CaseReport report = report_of(read_slider("0.2"));
  Measure phase;
  phase.name = "phase";
  phase.unit = MeasureUnit::kNone;
  phase.tolerance = std::numeric_limits<double>::infinity();
  report.checks[0].verdict.measures = {phase};
  report.rows[1] = std::numeric_limits<double>::quiet_NaN();
  const Tree tree = tree_of(document_of({report}));
  const Node one = (*tree.root().find("cases"))[0];
  const Node measure = (*(*one.find("checks"))[0].find("measures"))[0];
  CHECK(measure.find("tolerance")->is_null());
  CHECK(text(measure, "passed") == "true");
  CHECK((*one.find("rows"))[1][0].is_null());
}

}  // namespace
}  // namespace slipbench::driver
