// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// The distinct coordinates of a fitted table's rows, ascending, for each independent.
std::vector<std::vector<double>> knots_of(const FittedTable& table);

/// Cells between them, over all independents; an independent with one coordinate counts as one.
std::size_t count_cells(const std::vector<std::vector<double>>& knots);

/// Coordinates along independent `k` between which a row's ordinate counts: those of its neighbours
/// in its own block, its own coordinate where it is the first or the last.
std::pair<double, double> neighbours(const FittedTable& table, std::size_t row, std::size_t k);

/// Marks the cells of which increments only met the edge, as they do at exactly a knot: an ordinate
/// at one of their corners is unseen. All that is told of cells goes by FittedTable::Cell::visited.
/// \param seen rows of the table on whose ordinates a compared point depends
void mark_edge_cells(const std::vector<char>& seen, FittedTable* table);

/// Returns where no compared point lies: "with temperature above 80 degC, nor with slip_rate
/// 0 .. 10 mm/s, temperature 20 .. 90 degC"; empty if there is none such cell, or the cells were
/// not counted.
std::string unvisited_ranges(const FittedTable& table);

}  // namespace slipbench::driver::calibrate
