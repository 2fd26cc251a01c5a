// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/history/history_error.hpp"

namespace slipbench::driver {

/// What a picture needs to know about one column of a result.
struct PlotColumn {
  std::string name;
  std::string unit;  ///< empty if there is none, or the result does not state it
};

/// Time spent in one regime without a break, as far as the picture can tell.
struct RegimeSpan {
  double from = 0.0;
  double to = 0.0;
  int status = 1;  ///< 0 open, 1 stick, 2 slip
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
  std::vector<RegimeSpan> spans;              ///< of slip and of no contact; the rest is stick
};

/// A result, thinned for drawing.
struct PlotData {
  std::string title;
  std::vector<PlotColumn> columns;  ///< the first is t
  std::vector<PlotDefinition> definitions;
  std::vector<double> rows;    ///< row after row, as many numbers as columns
  std::vector<double> lowest;  ///< of each column, over all rows of the result
  std::vector<double> highest;

  std::size_t row_count() const { return columns.empty() ? 0 : rows.size() / columns.size(); }
};

/// Reads a result of `slipbench run` for drawing. A long one is divided into `buckets` pieces of
/// equal time, of which the first and the last row stay, and those in which a column is lowest or
/// highest: what is drawn looks the same, and the picture stays small. Spans of a regime that are
/// less than a bucket apart become one. The memory does not grow with the result.
///
/// Errors: those of CsvReader; a file without friction columns.
tl::expected<PlotData, HistoryError> read_plot_data(const std::filesystem::path& file,
                                                    const std::string& shown_name,
                                                    int buckets = 400);

}  // namespace slipbench::driver
