// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver {

struct PlotOptions {
  std::string input;   ///< a case, or a result if it ends in .csv
  std::string output;  ///< .svg, .png or .pdf; empty: <stem of the input>.svg, .law.svg, .KIND.svg
  std::vector<std::string> settings;  ///< --set, as typed; for a case only
  bool allow_outside = false;
  bool law = false;  ///< draw the coefficients of a case, not its forces
  std::string kind;  ///< one of plot_kinds(); empty: force over time and over motion
};

/// The pictures there are besides the one of friction.gp; each has a template of its name in
/// plots/.
std::vector<std::string> plot_kinds();

/// `slipbench plot`: a picture drawn by gnuplot with a template of plots/. A case is run for it.
/// Long runs are thinned so that the picture stays small and still shows every extreme. Returns the
/// exit code.
int plot_command(const PlotOptions& options);

}  // namespace slipbench::driver
