// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <tl/expected.hpp>

#include "driver/plot/gnuplot.hpp"
#include "driver/plot/options.hpp"

namespace slipbench::driver::plot {

/// The picture of `slipbench plot --law`: for each coefficient of a case that depends on the slip
/// rate or the normal force, mu over the slip rate at several normal forces (pressures, for a law
/// of the pressure), mu over these at several slip rates, and mu as a map over both; on all of them
/// the states that the run visited. Drawn by gnuplot with the template plots/coefficient.gp.
///
/// Tables of temperature and fields are drawn at their values at the end of the run. Of a case that
/// cannot run, and of the name of a law, they are drawn without states, and the picture says so.
/// Errors: a result in place of a case, friction that is faulty, no coefficient that depends on the
/// slip rate or the normal force.
tl::expected<void, PlotFailure> draw_laws(const PlotOptions& options,
                                          const std::filesystem::path& picture);

}  // namespace slipbench::driver::plot
