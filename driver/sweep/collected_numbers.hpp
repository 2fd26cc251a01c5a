// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/units/expression.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/row_values.hpp"
#include "driver/results/cycles.hpp"
#include "driver/results/events.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// The numbers that are left of one run, collected from its rows.
class CollectedNumbers {
 public:
  /// \param sweep with \p problem it must outlive this
  CollectedNumbers(const Sweep& sweep, const cases::Case& problem);

  /// Says in a sentence what cannot be collected of this run, or nothing.
  const std::string& fault() const { return fault_; }

  /// Takes the next rows, the first of which is row 0; none after a fault.
  void add(std::span<const bench::Row> rows);

  /// Writes what was collected: nan for the extreme of a quantity that never was a number, for a
  /// level that was never passed, and for the energy of a loop where no cycle is whole.
  /// \param numbers as many as are collected, in their order
  void finish(std::span<double> numbers);

 private:
  /// A number on its way through the run.
  struct Running {
    std::optional<check::RowExpression> quantity = std::nullopt;
    double number = 0.0;
    double value = 0.0;                                    ///< of the row before
    double time = 0.0;                                     ///< of the row before [T]
    std::vector<std::pair<double, double>> weighted = {};  ///< values, and how long each lasts [T]
  };

  void take(const Collected& collected, const bench::Row& row, double value, Running& running);

  const Sweep* sweep_;
  std::vector<base::Expression> own_;  ///< an expression serves one thread at a time
  std::vector<Running> running_;
  std::optional<results::EventDetector> events_;
  std::optional<results::CycleCounter> cycles_;
  std::string fault_;
};

}  // namespace slipbench::driver::sweep
