// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/verdict_table.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "driver/results/provenance.hpp"
#include "driver/suite/trailing_notes.hpp"
#include "tests/driver/suite/outcomes_for_test.hpp"

namespace slipbench::driver::suite {
namespace {

const std::vector<Candidate> kCases = {{"a/short.yaml", "a/short"}, {"a/longer.yaml", "a/longer"}};

TEST_CASE("the lines of a table stand under each other") {
  const VerdictTable table(kCases, false, false);
  CHECK(table.lines(kCases[0], outcome_of(passed_check("x"))) ==
        "  PASS  a/short      1 check   worst 0.1 of its tolerance\n");
  CHECK(table.lines(kCases[1], outcome_of(failed_check("x", "off"), passed_check("y"),
                                          failed_check("z", "far off"))) ==
        "  FAIL  a/longer   check 'x': off\n  FAIL  a/longer   check 'z': far off\n");
  CHECK(table.lines(kCases[0], outcome_of()) == "  ----  a/short    no checks\n");
  CHECK(table.lines(kCases[0], outcome_not_run(base::kExitNumerical, "m")) ==
        "  FAIL  a/short    numerical failure, see below\n");
  CHECK(table.lines(kCases[0], outcome_not_run(base::kExitBadInput, "m")) ==
        "  FAIL  a/short    cannot be run, see below\n");
}

TEST_CASE("a quiet table tells what does not pass only") {
  const VerdictTable table(kCases, true, false);
  CHECK(table.lines(kCases[0], outcome_of(passed_check("x"))).empty());
  CHECK(table.lines(kCases[0], outcome_of()).empty());
  CHECK_FALSE(table.lines(kCases[0], outcome_of(failed_check("x", "off"))).empty());
  CHECK_FALSE(table.lines(kCases[0], outcome_not_run(base::kExitBadInput, "m")).empty());
}

TEST_CASE("names cannot break a table or colour a terminal") {
  const std::vector<Candidate> cases = {{"x", "a\nb\033[31m"}};
  const std::string lines =
      VerdictTable(cases, false, false).lines(cases[0], outcome_of(failed_check("c\nd", "off")));
  CHECK(lines ==
        "  FAIL  a\xEF\xBF\xBD"
        "b\xEF\xBF\xBD[31m   check 'c\xEF\xBF\xBD"
        "d': off\n");
}

TEST_CASE("a colour is the verdict's only") {
  CHECK(VerdictTable(kCases, false, true).lines(kCases[0], outcome_of(failed_check("x", "off"))) ==
        "  \033[31mFAIL\033[0m  a/short    check 'x': off\n");
}

TEST_CASE("head and totals fill the width of the table") {
  const std::string head = table_head(24, 61, "2 cores");
  CHECK(head.find("slipbench " + std::string(results::program_version()) +
                  "   24 cases, 61 checks   ") == 0);
  CHECK(head.size() == 73);
  CHECK(head.ends_with(" 2 cores\n"));
  CHECK(table_head(1, std::nullopt, "1 thread").find("   1 case   ") != std::string::npos);
  SuiteTotals totals;
  totals.add(outcome_of(passed_check("x")));
  CHECK(table_totals(totals, false, std::chrono::milliseconds(210))
            .find("  1 case passed, 0 failed  ") == 0);
  totals.add(outcome_of());
  totals.add(outcome_not_run(base::kExitNumerical, "m"));
  const std::string text = table_totals(totals, true, std::chrono::milliseconds(210));
  CHECK(text.find("  1 case passed, 0 failed, 1 not run, 1 without checks; 1 check   ") == 0);
  CHECK(text.ends_with(" 0.21 s\n"));
  CHECK(totals.code == base::kExitNumerical);
}

TEST_CASE("doubts and messages below the table are told, but no flood of them") {
  TrailingNotes notes;
  CHECK(notes.text().empty());
  CheckOutcome doubtful = passed_check("limit");
  doubtful.verdict.warnings = {"loose"};
  notes.add(kCases[0], outcome_not_run(base::kExitBadInput, "unknown key"));
  notes.add(kCases[0], outcome_of(doubtful));
  CHECK(notes.text() ==
        "  warning: a/short  check 'limit': loose\na/broken.yaml:3:9: error: unknown key\n");
  for (int i = 0; i < 120; ++i) {
    notes.add(kCases[0], outcome_not_run(base::kExitBadInput, "unknown key"));
    notes.add(kCases[0], outcome_of(doubtful));
  }
  const std::string text = notes.text();
  CHECK(text.find("\n  ... and 101 more warnings\na/broken") != std::string::npos);
  CHECK(text.ends_with("key\n... and 21 more cases that were not run\n"));
}

}  // namespace
}  // namespace slipbench::driver::suite
