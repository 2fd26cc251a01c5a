// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/events.hpp"
#include "driver/results/plot_data.hpp"
#include "driver/results/regime_history.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::plot {

/// The regimes of a run by its events, with the sums that `run` tells, row by row.
class CaseRegimes {
 public:
  explicit CaseRegimes(const cases::Case& problem);
  void add(const bench::Row& row);
  /// Puts the regimes in the place of those that the rows tell. Once, at the end.
  void finish(results::PlotData& data);

 private:
  const cases::Case* case_;
  results::EventDetector detector_;
  results::Summary summary_;
  std::vector<results::RegimeRecorder> regimes_;
  double end_ = 0.0;
};

}  // namespace slipbench::driver::plot
