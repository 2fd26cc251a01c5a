// SPDX-License-Identifier: Apache-2.0
// The curves of which a table is made, for what is wanted of their shape and smoothness.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "law/table/table.hpp"

namespace slipbench::driver::calibrate {

/// Rows of a table that differ in one independent only, ascending in it.
struct TableLine {
  int independent = 0;
  std::vector<std::size_t> rows;
  std::vector<double> abscissa;  ///< as many
};

/// All lines of at least two rows along one independent. Blocks of a ragged table give lines only
/// where they have the same points.
std::vector<TableLine> table_lines(const law::Table& table, int independent);

/// The rows' blocks along the first independent as blocks of unknowns that keep a shape, also one
/// that leaves them free. Rows that are alone in their block are in none.
/// \param first_unknown of the table's ordinates
std::vector<fit::ShapedBlock> shaped_blocks(const law::Table& table, const fit::Shape& shape,
                                            std::size_t first_unknown);

/// One row of smoothness: the sum of weight times ordinate over three neighbours,
///   d2 = f[x0, x1, x2] h^2/Y,  h the mean of both intervals, Y the largest |start ordinate|:
/// without a dimension, and the same whatever the units are.
struct SmoothnessRow {
  std::size_t unknown[3] = {};
  double weight[3] = {};
};
/// \param column the dependent that is fitted
std::vector<SmoothnessRow> smoothness_rows(const law::Table& table, int column,
                                           std::size_t first_unknown);

}  // namespace slipbench::driver::calibrate
