// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

void SuiteTotals::add(const CaseOutcome& outcome) {
  switch (outcome.kind) {
    case CaseOutcome::Kind::kPassed:
      ++passed;
      break;
    case CaseOutcome::Kind::kFailed:
      ++failed;
      break;
    case CaseOutcome::Kind::kNoChecks:
      ++no_checks;
      break;
    case CaseOutcome::Kind::kNotRun:
      ++not_run;
      break;
  }
  checks += outcome.checks;
  failed_checks += outcome.failed;
  code = base::worse(code, outcome.code);
}

}  // namespace slipbench::driver::suite
