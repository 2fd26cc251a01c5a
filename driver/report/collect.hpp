// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/check.hpp"
#include "driver/report/case_report.hpp"

namespace slipbench::driver::report {

/// Gathers what the page tells about a case while it runs. The memory has a bound that
/// does not depend on the number of rows. Of a case that is thinned, the rows where its checks are
/// worst are known at its end only: up to the last of them it is run once more. A command that
/// judges checks anyway uses it so:
///
///     CaseCollector collector(problem);
///     // CheckProgress(problem, check, Trace::kKeep) for the checks' curves
///     run_case(problem, [&](const Row& row) { collector.add(row); /* checks */ });
///     collection.put(place, collector.finish(name, checks, jumps));
class CaseCollector {
 public:
  /// `problem` must outlive it.
  /// \param most_rows of a run that is not thinned (RowChoice)
  explicit CaseCollector(const cases::Case& problem, std::size_t most_rows = kMostRows);
  CaseCollector(CaseCollector&&) noexcept;
  ~CaseCollector();

  /// Takes the next row, row 0 first.
  void add(const bench::Row& row);

  /// Returns what there is to tell; to be called once, at the end.
  /// \param name what the case is called in the table
  /// \param checks those of the case, in its order, at the end of the run
  /// \param jumps what the run returned
  CaseReport finish(const std::string& name, std::span<const check::CheckProgress> checks,
                    std::span<const bench::MotionJump> jumps);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A case that could not be read or run, with the reader's or the run's message.
CaseReport not_run_report(const std::string& name, const std::string& title, std::string message);

/// The times at which the checks of a report are worst, as far as they have one.
std::vector<double> worst_times(const CaseReport& report);

/// Adds what the reader of a case noted and warned of.
void add_remarks(CaseReport& report, const base::Diagnostics& diagnostics);

}  // namespace slipbench::driver::report
