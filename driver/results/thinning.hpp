// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slipbench::driver::results {

/// Chooses the rows of a table that are drawn, and returns their numbers in ascending order.
///
/// Of at most `limit` rows all are. Of more, these are: the first and the last row; for each column
/// the first row in which it is lowest and in which it is highest; and, of as many pieces of equal
/// numbers of rows as `limit` allows, the first and the last row and those in which a watched
/// column is lowest or highest. What is drawn of the watched columns then covers the same area as
/// the whole table would. Numbers that are not comparable (NaN) are never an extreme.
///
/// \param table row after row
/// \param columns numbers in a row, at least 1
/// \param limit how many rows are drawn at most; one too small for the ends and the extremes is
///   raised to 2 + 2 columns
/// \param watched columns that are drawn, by number; empty: all
std::vector<std::size_t> thinned_rows(std::span<const double> table, std::size_t columns,
                                      std::size_t limit, std::span<const std::size_t> watched = {});

}  // namespace slipbench::driver::results
