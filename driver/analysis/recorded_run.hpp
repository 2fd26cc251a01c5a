// SPDX-License-Identifier: Apache-2.0
// A run in memory, for programs that hold the bench as a library.
#pragma once

#include <cstdlib>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/verdict.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/events.hpp"

namespace slipbench::driver::analysis {

/// Event with the free positions at it, in the order of RecordedRun::positions.
struct RecordedEvent {
  results::Event event;
  std::vector<double> positions;
};

/// Numbers of a run, a column after another.
struct RecordedRun {
  std::vector<results::Column>
      columns;  ///< those of the result file, or the ones that were asked for
  std::size_t rows = 0;
  std::size_t stride = 0;  ///< from a column to the next
  std::unique_ptr<double[], decltype(&std::free)> numbers{nullptr, &std::free};  ///< [c stride + r]
  std::vector<std::string> positions;  ///< columns of the free positions
  std::vector<RecordedEvent> events;
  std::vector<check::Verdict> verdicts;
  std::vector<std::string> warnings;  ///< of the run
  base::json::Value document;         ///< as the JSON file of a result
};

struct RecordOptions {
  int every = 1;  ///< rows that are kept: each of so many, and the last
  bool with_checks = true;
  std::span<const std::string> columns = {};  ///< besides the time; none: those of the result file
  /// Called from time to time; the run ends where it returns false.
  std::function<bool()> go_on = {};
};

/// Runs a case. Errors: those of the run; "interrupted" as one of the environment.
/// \param reading messages of the case's text, which stand in the document
tl::expected<RecordedRun, bench::SimulationFailure> record_run(const cases::Case& problem,
                                                               const base::Diagnostics& reading,
                                                               const RecordOptions& options);

}  // namespace slipbench::driver::analysis
