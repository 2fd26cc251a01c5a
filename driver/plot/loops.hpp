// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"
#include "driver/plot/script.hpp"
#include "driver/results/plot_data.hpp"

namespace slipbench::driver::plot {

/// More rows of one loop than this are not drawn.
inline constexpr std::size_t kMostLoopRows = 50000;

/// Reads the loops of each definition that is drawn from the result of `data`: of a cyclic motion
/// the cycles that drawn_cycles() names, each whole; of any other the run. The cycles are those of
/// the first of its motions that has a full one. Rows that cannot be told apart in a picture are
/// left out (PathRows), and a run without cycles ends where it has kMostLoopRows.
///
/// Errors: those of CsvReader.
tl::expected<void, base::HistoryError> add_loops(results::PlotData& data,
                                                 const std::filesystem::path& file,
                                                 const std::string& shown_name);

/// $LOOP_ROWS, an index for each loop, with FIRST_LOOP and LOOPS of each drawn definition, what
/// they are called (LOOP_NAMES, LIMIT_NAME), and NOTE: what of a long run they show.
void tell_loops(PlotScript& script, const results::PlotData& data);

}  // namespace slipbench::driver::plot
