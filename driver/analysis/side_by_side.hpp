// SPDX-License-Identifier: Apache-2.0
// Two runs of one case that differ in how they are integrated, held against each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// Failure of a command: a message with a line feed, and the exit code.
struct CommandFailure {
  int code = 0;
  std::string message;
};

/// Distance between the friction of one definition in two runs, over the rows they share.
struct ForceDistance {
  double most = 0.0;     ///< largest |y_a - y_b| [F]
  double sum = 0.0;      ///< of |y_a - y_b| over the rows [F]
  double largest = 0.0;  ///< largest |y_a| [F]
  std::size_t rows = 0;
  double time = 0.0;  ///< total time of `most`
  int step = 0;

  /// Takes the row of the one, and the other's state at the same time.
  void add(const bench::Row& row, std::size_t definition, const law::FrictionState& other);
  double mean() const { return rows == 0 ? 0.0 : sum / static_cast<double>(rows); }
  /// A distance as a part of the largest force; 0 where there is none.
  double relative(double distance) const { return largest > 0.0 ? distance / largest : 0.0; }
};

/// "0.17 %" or "2.1e-13 %".
std::string percent_text(double part);

/// ", step 'cycle'" of a case with steps.
std::string step_text(const cases::Case& problem, int step);

}  // namespace slipbench::driver::analysis
