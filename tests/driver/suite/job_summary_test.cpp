// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/job_summary.hpp"

#include <catch2/catch.hpp>

#include "driver/results/provenance.hpp"
#include "tests/driver/suite/outcomes_for_test.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::suite {
namespace {

const std::string kHead = "### slipbench " + std::string(results::program_version()) + ": ";

TEST_CASE("the summary of a job tells what did not pass, where and why, and the slowest cases") {
  JobSummary summary;
  SuiteTotals totals;
  const auto add = [&](const Candidate& candidate, const CaseOutcome& outcome) {
    summary.add(candidate, outcome);
    totals.add(outcome);
  };
  add({"a/belt.yaml", "a/belt"},
      outcome_of(passed_check("limit"), failed_check("p|ll", "CSF2 off by <3> N")));
  add({"a/broken.yaml", "a/broken"}, outcome_not_run(base::kExitBadInput, "unknown key"));
  add({"top.yaml", "top"}, outcome_of());
  CHECK(summary.text(totals) == kHead +
                                    "0 cases passed, 1 failed, 1 not run, 1 without checks\n\n"
                                    "| place | check | message |\n|---|---|---|\n"
                                    "| a/belt.yaml&#58;7 | p&#124;ll | CSF2 off by "
                                    "&#60;3&#62; N |\n"
                                    "| a/broken.yaml&#58;3 | not run | unknown key |\n\n"
                                    "| slowest | time |\n|---|---|\n"
                                    "| a/belt | 0.50 s |\n| top | 0.50 s |\n"
                                    "| a/broken | 0.25 s |\n\n");
}

TEST_CASE("the summary of a job is cut where it is a flood") {
  JobSummary summary;
  for (int i = 0; i < 120; ++i) {
    summary.add({"a.yaml", "a"}, outcome_of(failed_check("pull", std::string(5000, 'x'))));
  }
  const std::string text = summary.text({});
  CHECK(text.find("... and 20 more\n") != std::string::npos);
  CHECK(text.size() < 200000);
}

TEST_CASE("the summary of a job is appended, and a place that cannot be written to is told") {
  const TemporaryFolder folder;
  folder.write("summary.md", "before\n");
  const std::string file = (folder.path() / "summary.md").string();
  JobSummary summary;
  CHECK(summary.append_to(file, {}).empty());
  const std::string text = file_text(file);
  CHECK(text.find("before\n" + kHead + "0 cases passed") == 0);
  const std::string missing = (folder.path() / "no/summary.md").string();
  CHECK(summary.append_to(missing, {}) ==
        "the summary of the job is not written to " + missing + ": No such file or directory");
}

TEST_CASE("the slowest cases are told slowest first, and no more than were asked for") {
  SlowestCases slowest(2);
  for (const double seconds : {0.5, 2.0, 0.25, 1.0}) {
    CaseOutcome outcome = outcome_of();
    outcome.seconds = seconds;
    slowest.add({"", "case " + std::to_string(seconds).substr(0, 4)}, outcome);
  }
  CHECK(slowest.text() == "  slowest:\n     2.00 s  case 2.00\n     1.00 s  case 1.00\n");
  CHECK(SlowestCases(0).text().empty());
}

}  // namespace
}  // namespace slipbench::driver::suite
