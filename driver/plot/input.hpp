// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/plot/case_regimes.hpp"
#include "driver/plot/gnuplot.hpp"
#include "driver/plot/options.hpp"
#include "driver/results/plot_data.hpp"

namespace slipbench::driver::plot {

/// Tells whether the input is a result of 'run', not a case.
bool is_result(const PlotOptions& options);

/// The case of `options`, or its faults as they are told to the user.
tl::expected<cases::Case, PlotFailure> read_for_plot(const PlotOptions& options);

/// A result of `run`, and of a case what it was written from: then the file is gone with it.
struct ResultRows {
  std::filesystem::path file;
  std::string shown_name;
  std::optional<base::OutputFile> temporary;
  std::unique_ptr<cases::Case> problem;
  std::unique_ptr<CaseRegimes> regimes;
};

/// The rows of one input: a result as it is, or those of a case, which is run for them.
tl::expected<ResultRows, PlotFailure> rows_for_plot(const PlotOptions& options,
                                                    const std::filesystem::path& picture);

/// A result that cannot be read, as it is told to the user.
tl::unexpected<PlotFailure> unreadable(const std::string& shown_name,
                                       const base::HistoryError& error);

/// Runs a case to its end: `take` sees every row, row 0 first.
tl::expected<void, PlotFailure> follow_for_plot(
    const cases::Case& problem, const std::function<void(const bench::Simulation&)>& take);

/// Returns what a picture of a case is called: its title, or the file's stem.
std::string picture_title(const cases::Case& problem);

/// Need of a picture for loops (PlotDefinition::loops).
enum class WithLoops : std::uint8_t { kNo, kYes };

/// The result that is drawn: the one given, or that of the case, which is run for it. Its title is
/// never empty. Its regimes are those of the events, of a result without a file of events beside it
/// those of its rows. Files that are needed meanwhile stand beside `picture`.
tl::expected<results::PlotData, PlotFailure> result_for_plot(const PlotOptions& options,
                                                             const std::filesystem::path& picture,
                                                             results::PlotDetail detail,
                                                             WithLoops loops = WithLoops::kNo);

}  // namespace slipbench::driver::plot
