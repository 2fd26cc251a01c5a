// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/events.hpp"
#include "driver/results/plot_data.hpp"
#include "driver/results/regime_history.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver {

/// The regimes of a run by its events, with the sums that `run` tells, row by row.
class CaseRegimes {
 public:
  explicit CaseRegimes(const Case& problem);
  void add(const Row& row);
  /// Puts the regimes in the place of those that the rows tell. Once, at the end.
  void finish(PlotData& data);

 private:
  const Case* case_;
  EventDetector detector_;
  Summary summary_;
  std::vector<RegimeRecorder> regimes_;
  double end_ = 0.0;
};

}  // namespace slipbench::driver
