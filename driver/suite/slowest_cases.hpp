// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// The cases of a suite that took longest, the slowest first.
class SlowestCases {
 public:
  struct Entry {
    double seconds = 0.0;  ///< to read, run and judge
    std::string label;
  };

  explicit SlowestCases(std::size_t most) : most_(most) {}

  void add(const Candidate& candidate, const CaseOutcome& outcome);

  /// At most as many as were asked for.
  const std::vector<Entry>& entries() const { return entries_; }

  /// A line a case below a heading; empty if none were asked for.
  std::string text() const;

 private:
  std::size_t most_;
  std::vector<Entry> entries_;
};

/// "0.21 s", "3.4 ms".
std::string seconds_text(double seconds);

}  // namespace slipbench::driver::suite
