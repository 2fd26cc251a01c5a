// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver {

/// The verdicts of a suite as JSON: {"slipbench": version, "cases": [..], "totals": {..}}, one case
/// a line, in the order of the suite. No times: the same verdicts give the same bytes.
class SuiteJson {
 public:
  /// The outcome must hold the verdicts of all its checks.
  void add(const Candidate& candidate, const CaseOutcome& outcome);

  std::string text(const SuiteTotals& totals) const;

 private:
  std::string cases_;
};

}  // namespace slipbench::driver
