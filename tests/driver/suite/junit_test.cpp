// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/junit.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "driver/suite/xml_text.hpp"
#include "tests/driver/suite/outcomes_for_test.hpp"

namespace slipbench::driver::suite {
namespace {

TEST_CASE("each folder is a suite, each check a test, and the counts and times add up") {
  JunitReport report;
  report.add(0, {"a/belt.yaml", "a/belt"},
             outcome_of(passed_check("limit"), failed_check("pull", "CSF2 off by 3.1 N")));
  report.add(1, {"cases/./top.yaml", "top"}, outcome_of());
  report.add(2, {"a/broken.yaml", "a/broken"}, outcome_not_run(base::kExitBadInput, "unknown key"));
  CHECK(report.text() == R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="slipbench" tests="4" failures="1" errors="1" time="1.250000">
  <testsuite name="a" tests="3" failures="1" errors="1" time="0.750000" skipped="0">
    <testcase classname="a/belt" name="limit" file="a/belt.yaml" line="7" time="0.250000"/>
    <testcase classname="a/belt" name="pull" file="a/belt.yaml" line="7" time="0.250000">
      <failure type="check failed" message="CSF2 off by 3.1 N">check 'pull': CSF2 off by 3.1 N</failure>
    </testcase>
    <testcase classname="a/broken" name="case" file="a/broken.yaml" line="3" time="0.250000">
      <error type="bad input" message="unknown key">a/broken.yaml:3:9: error: unknown key
</error>
    </testcase>
  </testsuite>
  <testsuite name="cases" tests="1" failures="0" errors="0" time="0.500000" skipped="1">
    <testcase classname="top" name="case" file="cases/top.yaml" time="0.500000">
      <skipped message="the case has no checks"/>
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST_CASE("a file is named from the current folder, and its line is no line of a data file") {
  JunitReport report;
  const std::string here = std::filesystem::current_path().string();
  report.add(0, {here + "/a/x.yaml", here + "/a/x"}, outcome_of(passed_check("limit")));
  report.add(1, {"/elsewhere/y.yaml", "/elsewhere/y"}, outcome_of(passed_check("limit")));
  report.add(2, {"z.yaml", "z"},
             outcome_not_run(base::kExitBadInput, "a/broken.yaml is the data's"));
  const std::string text = report.text();
  CHECK(text.find(" file=\"a/x.yaml\" line=\"7\"") != std::string::npos);
  CHECK(text.find(" file=\"/elsewhere/y.yaml\" line=\"7\"") != std::string::npos);
  CHECK(text.find(" file=\"z.yaml\" time=") != std::string::npos);
  // A case in the current folder is in a suite of that folder's name.
  CHECK(text.find("<testsuite name=\"" + std::filesystem::current_path().filename().string()) !=
        std::string::npos);
}

TEST_CASE("doubts about a check that passed are in its output") {
  CheckOutcome doubtful = passed_check("limit");
  doubtful.verdict.warnings = {"the tolerance is 1e6 times the deviation"};
  JunitReport report;
  report.add(0, {"a.yaml", "a"}, outcome_of(doubtful));
  CHECK(report.text().find("      <system-out>warning: the tolerance is 1e6 times the deviation\n"
                           "</system-out>\n") != std::string::npos);
}

TEST_CASE("the order is that of the suite, in whatever order its cases were run") {
  const std::vector<Candidate> cases = {
      {"b/x.yaml", "b/x"}, {"a/x.yaml", "a/x"}, {"b/y.yaml", "b/y"}};
  const auto text = [&](const std::vector<std::size_t>& order) {
    JunitReport report;
    for (const std::size_t i : order) report.add(i, cases[i], outcome_of(passed_check("limit")));
    return report.text();
  };
  CHECK(text({2, 1, 0}) == text({0, 1, 2}));
}

TEST_CASE("every suite has a name, that of the root of the file system, too") {
  JunitReport report;
  report.add(0, {"/x.yaml", "/x"}, outcome_of());
  CHECK(report.text().find("<testsuite name=\"/\" ") != std::string::npos);
}

TEST_CASE("an empty suite is a report all the same") {
  CHECK(JunitReport().text() ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"slipbench\" tests=\"0\" "
        "failures=\"0\" errors=\"0\" time=\"0.000000\">\n</testsuites>\n");
}

TEST_CASE("markup and line ends are escaped where they would be misread") {
  CHECK(xml_text("a < b && c > \"d\"\n\te") == "a &lt; b &amp;&amp; c &gt; &quot;d&quot;\n\te");
  CHECK(xml_attribute("a\n\tb\r") == "a&#10;&#9;b&#13;");
}

TEST_CASE("what XML cannot hold is replaced, and what it can is kept") {
  const std::string replaced = "\xEF\xBF\xBD";
  CHECK(xml_text(std::string_view("a\0b\x1B[31m\x08", 9)) ==
        "a" + replaced + "b" + replaced + "[31m" + replaced);
  CHECK(xml_text("\xFF\xC3(") == replaced + replaced + "(");
  CHECK(xml_text("\xEF\xBF\xBE\xEF\xBF\xBF") == replaced + replaced);
  CHECK(xml_text("größe \xF0\x9F\x94\xA7") == "größe \xF0\x9F\x94\xA7");
}

}  // namespace
}  // namespace slipbench::driver::suite
