// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::bench {

/// The number of increments of a case before it is run: those its steps ask for. Breakpoints of
/// profiles add to them. Of a measured history nothing is known, and all numbers are 0.
class RunLength {
 public:
  explicit RunLength(const cases::Case& problem);

  double increments() const { return increments_; }

  /// Counts the increments of a step (any if there is none) between two total times.
  double increments_between(const std::optional<std::string>& step, double from, double to) const;

  /// The part of the increments that lies behind a row of the run, 0 .. 1.
  double done(const Row& row) const;

 private:
  struct Part {
    std::string name;
    double duration = 0.0;    ///< of one pass [T]
    double begin = 0.0;       ///< total time [T]
    double end = 0.0;         ///< likewise, of the last pass
    double before = 0.0;      ///< increments before the step
    double increments = 0.0;  ///< of one pass
    double passes = 1.0;
  };
  std::vector<Part> parts_;
  double increments_ = 0.0;
};

}  // namespace slipbench::driver::bench
