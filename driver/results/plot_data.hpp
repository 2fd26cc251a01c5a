// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/history/history_error.hpp"
#include "driver/results/regime_history.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver {

/// What a picture needs to know about one column of a result.
struct PlotColumn {
  std::string name;
  std::string unit;  ///< empty if there is none, or the result does not state it
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
  /// Rows of the last full cycle of its motion, none left out; empty if there is none, or nobody
  /// asked for it.
  std::vector<double> cycle;
};

/// What is drawn of each definition.
enum class PlotDetail : std::uint8_t {
  kForces,  ///< forces, their motions and limits
  kState    ///< normal force, coefficient and energies, too
};

/// A result, thinned for drawing.
struct PlotData {
  std::string title;
  std::vector<PlotColumn> columns;  ///< the first is t
  std::vector<PlotDefinition> definitions;
  std::vector<double> rows;    ///< row after row, as many numbers as columns
  std::vector<double> lowest;  ///< of each column, over all rows of the result
  std::vector<double> highest;
  std::int64_t rows_in_all = 0;  ///< of the result

  std::size_t row_count() const { return columns.empty() ? 0 : rows.size() / columns.size(); }
  bool thinned() const { return rows_in_all > static_cast<std::int64_t>(row_count()); }
};

/// As many rows of a long result show all that a picture can.
inline constexpr std::size_t kDrawnRows = 3000;

/// The columns of a result that are drawn, and what they are of each definition; no rows.
PlotData select_plot_columns(const ResultLayout& layout, PlotDetail detail = PlotDetail::kForces);

/// Reads a result of `slipbench run` for drawing. A long one is thinned to `most_rows`
/// (RowThinner): what is drawn over time looks the same, and the picture stays small. Regimes are
/// as the rows tell them: one from row to row. The memory does not grow with the result.
///
/// Errors: those of CsvReader; a file without friction columns.
tl::expected<PlotData, HistoryError> read_plot_data(const std::filesystem::path& file,
                                                    const std::string& shown_name,
                                                    std::size_t most_rows = kDrawnRows,
                                                    PlotDetail detail = PlotDetail::kForces);

}  // namespace slipbench::driver
