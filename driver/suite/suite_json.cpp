// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/suite_json.hpp"

#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::suite {

namespace {

constexpr const char* kJsonStart = "{\"slipbench\": ";

}  // namespace

base::FileMark SuiteJson::mark() { return {"a JSON file of 'slipbench check'", kJsonStart, ""}; }

void SuiteJson::add(std::size_t place, const Candidate& candidate, const CaseOutcome& outcome) {
  base::json::Value one;
  one["case"] = base::printable(candidate.label);
  one["file"] = candidate.path;
  one["status"] = word_for(outcome.kind);
  one["exit_code"] = outcome.code;
  if (outcome.kind == CaseOutcome::Kind::kNotRun) {
    one["message"] = outcome.fault.message;
    if (outcome.fault.where.line > 0) {
      one["line"] = outcome.fault.where.line;
      one["column"] = outcome.fault.where.column;
    }
  }
  if (!outcome.warnings.empty()) {
    one["warnings"] = base::json::Array(outcome.warnings.begin(), outcome.warnings.end());
  }
  base::json::Array checks;
  for (const CheckOutcome& check : outcome.verdicts)
    checks.push_back(check::to_json(check.verdict));
  one["checks"] = std::move(checks);
  std::string text = one.dump();
  text.shrink_to_fit();
  cases_[place] = std::move(text);
}

void SuiteJson::write(const SuiteTotals& totals,
                      const std::function<void(std::string_view)>& take) const {
  base::json::Value sums;
  sums["cases"] = totals.passed + totals.failed + totals.no_checks + totals.not_run;
  sums["passed"] = totals.passed;
  sums["failed"] = totals.failed;
  sums["no_checks"] = totals.no_checks;
  sums["not_run"] = totals.not_run;
  sums["checks"] = totals.checks;
  sums["failed_checks"] = totals.failed_checks;
  sums["exit_code"] = totals.code;
  take(kJsonStart + base::json::Value(results::program_version()).dump() + ", \"cases\": [");
  std::string_view between = "\n  ";
  for (const auto& [place, text] : cases_) {
    take(between);
    take(text);
    between = ",\n  ";
  }
  take("\n], \"totals\": " + sums.dump() + "}\n");
}

}  // namespace slipbench::driver::suite
