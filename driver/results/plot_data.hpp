// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/history_error.hpp"
#include "driver/results/regime_history.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver::results {

/// Column of a result, as a picture needs it.
struct PlotColumn {
  std::string name;
  std::string unit;  ///< empty if there is none, or the result does not state it
};

/// A path whose rows are drawn as they follow one another.
struct DrawnLoop {
  std::int64_t cycle = 0;    ///< its number, from 1; 0: of a run without cycles, the run
  std::vector<double> rows;  ///< row after row, as many numbers as columns
};

/// One friction definition as it is drawn. Numbers count `PlotData::columns`; -1: not in the
/// result.
struct PlotDefinition {
  std::string name;
  bool several = false;         ///< whether the result has other definitions, too
  int total = -1;               ///< CSFC of a coupled definition
  std::vector<int> components;  ///< its friction forces
  std::vector<int> positions;   ///< the positions they go with, in the same order
  int limit = -1;
  int limit_below = -1;  ///< where it is not the limit's negative: of a belt
  int status = -1;
  int normal_force = -1;                      ///< of an orthotropic definition, like the next two
  std::array<int, 2> coefficients{-1, -1};    ///< along its directions
  std::array<double, 2> direction{1.0, 0.0};  ///< direction 1 in its two components
  int mu = -1;                                ///< of PlotDetail::kState, like the next three
  int dissipation = -1;
  int stored_energy = -1;
  int work = -1;
  RegimeHistory regimes;
  /// Of pictures with loops: those that are drawn, in their order.
  std::vector<DrawnLoop> loops;
  std::int64_t cycles = 0;       ///< in all; 0 of a run without cycles
  std::int64_t loop_rows = 0;    ///< of a run without cycles, the rows that its loop goes on for
  std::optional<double> energy;  ///< dissipated in the last full cycle
};

/// Quantities drawn of each definition.
enum class PlotDetail : std::uint8_t {
  kForces,  ///< forces, their motions and limits
  kState    ///< normal force, coefficient and energies, too
};

/// A result for drawing.
struct PlotData {
  std::string title;
  std::vector<PlotColumn> columns;  ///< the first is t
  std::vector<PlotDefinition> definitions;
  std::vector<double> rows;    ///< for drawing over time (PixelColumns), row after row
  std::vector<double> lowest;  ///< of each column, over all rows of the result
  std::vector<double> highest;
  std::int64_t rows_in_all = 0;  ///< of the result
};

/// Columns of pixels that a time axis has at the most.
inline constexpr std::size_t kDrawnPixels = 2000;

/// The columns of a result that are drawn, and what they are of each definition; no rows.
PlotData select_plot_columns(const ResultLayout& layout, PlotDetail detail = PlotDetail::kForces);

/// Reads a result of `slipbench run` for drawing over a time axis of so many `pixels`
/// (PixelColumns). Regimes are as the rows tell them: one from row to row. The memory does not grow
/// with the result.
///
/// Errors: those of CsvReader; a file without friction columns.
tl::expected<PlotData, base::HistoryError> read_plot_data(const std::filesystem::path& file,
                                                          const std::string& shown_name,
                                                          PlotDetail detail = PlotDetail::kForces,
                                                          std::size_t pixels = kDrawnPixels);

/// Gives `take` the rows of a CSV file, of these columns, with the number of rows before each.
///
/// Errors: those of CsvReader.
tl::expected<void, base::HistoryError> each_row(
    const std::filesystem::path& file, const std::string& shown_name,
    const std::vector<std::string>& columns,
    const std::function<void(std::span<const double>, std::int64_t)>& take);

}  // namespace slipbench::driver::results
