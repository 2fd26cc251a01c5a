// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::results {

/// Dissipated energy of the whole cycles of a run, for one definition [F L].
struct CycleEnergy {
  std::int64_t count = 0;
  double first = 0.0;
  double before_last = 0.0;  ///< 0 of a single cycle
  double last = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
};

/// The length of a cycle in a step [T]: the longest period of its waves, of motions or of anything
/// else, if all the others fit into it a whole number of times; the step's duration if it has no
/// waves and is repeated; 0 if neither, or if the step is shorter than a period.
double cycle_length(const cases::Step& step);

/// Adds up the energy of each cycle. Cycles are counted from the start of each pass of a step; what
/// a step has left over after its last whole cycle does not count. Where no row ends with a cycle,
/// the energy is interpolated between rows. Nothing grows with the number of rows.
class CycleCounter {
 public:
  explicit CycleCounter(const cases::Case& problem);
  void add(std::span<const bench::Row> rows);
  void add(const bench::Row& row) { add({&row, 1}); }
  /// One for each definition of the case.
  std::span<const CycleEnergy> energies() const { return energies_; }
  /// Returns what made the cycles: "period of the waves", "repeated step", both, or empty.
  std::string found_by() const;

 private:
  /// End of the cycle that goes on [T], after the begin of the step; infinity if none does.
  double end_of_next() const;
  bool is_over(const bench::Row& row) const;
  void end_cycles(const bench::Row& row);
  /// Energy dissipated by a definition up to a part of the increment that ends with `row` [F L].
  double dissipation(std::size_t index, double fraction, const bench::Row& row) const;
  void end_cycle(double fraction, const bench::Row& row);
  void remember(const bench::Row& row);

  struct StepCycle {
    double length = 0.0;
    bool wave = false;
  };
  std::vector<StepCycle> steps_;
  std::vector<CycleEnergy> energies_;
  std::vector<double> start_;   ///< dissipation where the cycle began
  std::vector<double> before_;  ///< at the last row, but within add()
  double step_time_ = 0.0;      ///< of the last row
  std::int64_t ends_ = 0;       ///< cycles of this pass that are over
  double end_ = 0.0;            ///< end_of_next()
  int step_ = 0;
  int pass_ = 0;
  bool waves_ = false;
  bool repeats_ = false;
};

}  // namespace slipbench::driver::results
