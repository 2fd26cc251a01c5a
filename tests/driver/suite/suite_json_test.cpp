// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/suite_json.hpp"

#include <catch2/catch.hpp>

#include "driver/results/provenance.hpp"
#include "tests/driver/suite/outcomes_for_test.hpp"

namespace slipbench::driver::suite {
namespace {

std::string text_of(const SuiteJson& suite, const SuiteTotals& totals) {
  std::string all;
  suite.write(totals, [&](std::string_view text) { all += text; });
  return all;
}

TEST_CASE("the JSON of a suite has a line for each case, and the totals") {
  SuiteJson suite;
  SuiteTotals totals;
  std::size_t place = 0;
  const auto add = [&](const Candidate& candidate, const CaseOutcome& outcome) {
    suite.add(place++, candidate, outcome);
    totals.add(outcome);
  };
  add({"a/b\".yaml", "a/b\""}, outcome_of());
  add({"a/broken.yaml", "a/broken"}, outcome_not_run(base::kExitNumerical, "no solution"));
  add({"c.yaml", "c"}, outcome_of(passed_check("x"), failed_check("y", "off")));
  const std::string text = text_of(suite, totals);
  CHECK(text.find("{\"slipbench\": \"" + std::string(results::program_version()) +
                  "\", \"cases\": [\n  {") == 0);
  CHECK(text.find(R"(
  {"case": "a/b\"", "file": "a/b\".yaml", "status": "no_checks", "exit_code": 0, "checks": []},
)") != std::string::npos);
  CHECK(text.find(R"("status": "not_run", "exit_code": 3, "message": "no solution", "line": 3, )"
                  R"("column": 9, "checks": []})") != std::string::npos);
  CHECK(text.find(R"("status": "failed", "exit_code": 1, "checks": [{"name": "x")") !=
        std::string::npos);
  CHECK(text.ends_with(R"(
], "totals": {"cases": 3, "passed": 0, "failed": 1, "no_checks": 1, "not_run": 1, "checks": 2, )"
                       R"("failed_checks": 1, "exit_code": 3}}
)"));
}

TEST_CASE("the cases stand in the order of the suite, in whatever order they were run") {
  const std::vector<Candidate> cases = {{"a.yaml", "a"}, {"b.yaml", "b"}, {"c.yaml", "c"}};
  const auto text = [&](const std::vector<std::size_t>& order) {
    SuiteJson suite;
    for (const std::size_t i : order) suite.add(i, cases[i], outcome_of(passed_check("limit")));
    return text_of(suite, {});
  };
  CHECK(text({2, 0, 1}) == text({0, 1, 2}));
}

}  // namespace
}  // namespace slipbench::driver::suite
