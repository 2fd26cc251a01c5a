// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

inline CheckOutcome passed_check(std::string name) {
  CheckOutcome check;
  check.verdict.name = std::move(name);
  check.verdict.passed = true;
  check.text = "check '" + check.verdict.name + "': worst 0.1 of its tolerance";
  check.where = {7, 5, 1};
  return check;
}

inline CheckOutcome failed_check(std::string name, std::string message) {
  CheckOutcome check = passed_check(std::move(name));
  check.verdict.passed = false;
  check.verdict.message = std::move(message);
  check.text = "check '" + check.verdict.name + "': " + check.verdict.message;
  return check;
}

/// A case with these checks, in 0.5 s.
template <class... Checks>
CaseOutcome outcome_of(const Checks&... checks) {
  CaseOutcome outcome;
  outcome.seconds = 0.5;
  outcome.verdicts = {checks...};
  outcome.checks = outcome.verdicts.size();
  for (const CheckOutcome& check : outcome.verdicts) outcome.failed += check.verdict.passed ? 0 : 1;
  outcome.code = outcome.failed > 0 ? base::kExitCheckFailed : base::kExitOk;
  outcome.kind = outcome.failed > 0   ? CaseOutcome::Kind::kFailed
                 : outcome.checks > 0 ? CaseOutcome::Kind::kPassed
                                      : CaseOutcome::Kind::kNoChecks;
  outcome.remark = "worst 0.1 of its tolerance";
  return outcome;
}

inline CaseOutcome outcome_not_run(int code, const std::string& message) {
  CaseOutcome outcome;
  outcome.seconds = 0.25;
  outcome.code = code;
  outcome.fault = {"a/broken.yaml", {3, 9, 1}, message};
  outcome.messages = "a/broken.yaml:3:9: error: " + message + "\n";
  return outcome;
}

}  // namespace slipbench::driver::suite
