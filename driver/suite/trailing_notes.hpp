// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// Notes below the table: doubts about checks, and why cases were not run. A flood is cut:
/// of each kind the first are told and the others counted.
class TrailingNotes {
 public:
  void add(const Candidate& candidate, const CaseOutcome& outcome);

  /// Lines, doubts first; empty if there is nothing to tell.
  std::string text() const;

 private:
  static constexpr std::size_t kMostWarnings = 20;
  static constexpr std::size_t kMostCases = 100;

  std::string warnings_;
  std::string messages_;
  std::size_t warning_count_ = 0;
  std::size_t message_count_ = 0;
};

}  // namespace slipbench::driver::suite
