// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "driver/base/files/file_mark.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// The verdicts of a suite as JSON: {"slipbench": version, "cases": [..], "totals": {..}}, one case
/// a line, in the order of the suite, whatever the order in which they were run. No times: the same
/// verdicts give the same bytes.
class SuiteJson {
 public:
  /// The outcome must hold the verdicts of all its checks.
  /// \param place of the case in the suite
  void add(std::size_t place, const Candidate& candidate, const CaseOutcome& outcome);

  /// Hands on the file's text piece by piece: of a large suite it is long.
  void write(const SuiteTotals& totals, const std::function<void(std::string_view)>& take) const;

  /// The mark of every such file.
  static base::FileMark mark();

 private:
  std::map<std::size_t, std::string> cases_;  ///< by their places
};

}  // namespace slipbench::driver::suite
