// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver {

struct PlotOptions {
  std::string input;                  ///< a case, or a result if it ends in .csv
  std::string output;                 ///< .svg, .png or .pdf; empty: <stem of the input>.svg
  std::vector<std::string> settings;  ///< --set, as typed; for a case only
  bool allow_outside = false;
};

/// `slipbench plot`: friction force against time and against motion, drawn by gnuplot with the
/// template plots/friction.gp. A case is run for it. Long runs are thinned so that the picture
/// stays small and still shows every extreme. Returns the exit code.
int plot_command(const PlotOptions& options);

}  // namespace slipbench::driver
