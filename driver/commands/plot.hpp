// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/plot/options.hpp"

namespace slipbench::driver::commands {

/// `slipbench plot`: a picture drawn by gnuplot with a template of plots/. A case is run for it.
/// Long runs are thinned so that the picture stays small and still shows every extreme. Returns the
/// exit code.
/// \param size as typed, "800x500"; empty: that of the layout
int plot_command(const plot::PlotOptions& options, const std::string& size = {});

}  // namespace slipbench::driver::commands
