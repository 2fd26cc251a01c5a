// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "driver/results/plot_data.hpp"

namespace slipbench::driver::plot {

/// Puts the regimes by the events beside a result (NAME.events.csv) in the place of those that its
/// rows tell, with the sums of the summary beside it (NAME.json). Files that are missing, cannot be
/// read or belong to another run change nothing.
/// \return whether the events were there
bool take_events_beside(const std::filesystem::path& result, results::PlotData& data);

}  // namespace slipbench::driver::plot
