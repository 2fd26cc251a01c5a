// SPDX-License-Identifier: Apache-2.0
// The columns of a result that a picture is asked for by name.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/plot/gnuplot.hpp"
#include "driver/plot/input.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver::plot {

/// Returns what the header and the heading of an input's rows say. Errors: those of CsvReader.
tl::expected<results::ResultLayout, PlotFailure> layout_for_plot(const ResultRows& rows);

/// A column that an input must have. The error names the nearest ones, and where all are listed.
tl::expected<results::PlotColumn, PlotFailure> chosen_column(const ResultRows& rows,
                                                             const results::ResultLayout& layout,
                                                             const std::string& name);

/// The columns of a result that belong together: the first friction force of the first definition,
/// the position it goes with if that moves, and the velocity of that. Empty for what is not there.
struct UsualColumns {
  std::string force;
  std::string position;
  std::string velocity;
};
tl::expected<UsualColumns, PlotFailure> usual_columns(const ResultRows& rows,
                                                      const results::ResultLayout& layout);

/// "friction force CSF1 [N]", "time t [s]": a column as an axis names it.
std::string column_label(const results::PlotColumn& column);

}  // namespace slipbench::driver::plot
