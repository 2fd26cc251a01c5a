// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/plot/options.hpp"

namespace slipbench::driver {

/// `slipbench plot`: a picture drawn by gnuplot with a template of plots/. A case is run for it.
/// Long runs are thinned so that the picture stays small and still shows every extreme. Returns the
/// exit code.
int plot_command(const PlotOptions& options);

}  // namespace slipbench::driver
