// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/commands/gnuplot.hpp"

namespace slipbench::driver {

struct PlotOptions {
  std::string input;   ///< a case, or a result if it ends in .csv
  std::string output;  ///< .svg, .png or .pdf; empty: <stem of the input>.svg, or .law.svg
  std::vector<std::string> settings;  ///< --set, as typed; for a case only
  bool allow_outside = false;
  bool law = false;  ///< draw the coefficients of a case, not its forces
  std::string kind;  ///< one of plot_kinds(); empty: force over time and over motion
};

/// The pictures there are besides the one of friction.gp; each has a template of its name in
/// plots/.
std::vector<std::string> plot_kinds();

/// The case of `options`, or its faults as they are told to the user.
tl::expected<Case, PlotFailure> read_for_plot(const PlotOptions& options);

/// `slipbench plot`: friction force against time and against motion, drawn by gnuplot with the
/// template plots/friction.gp. A case is run for it. Long runs are thinned so that the picture
/// stays small and still shows every extreme. Returns the exit code.
int plot_command(const PlotOptions& options);

}  // namespace slipbench::driver
