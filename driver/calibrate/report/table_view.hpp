// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Layout of a fitted table for drawing.
struct TableView {
  struct Axis {
    std::string name;           ///< "slip rate", "temperature", "CP1"
    std::string unit;           ///< of the case, empty if it states none
    std::vector<double> knots;  ///< ascending; of ragged blocks those of all of them
  };
  /// Rows of the same later independents: a curve over the first one.
  struct Block {
    std::string label;      ///< "temperature 20 degC", empty if there is only one block
    std::size_t first = 0;  ///< row of the table
    std::vector<double> abscissa;
    std::vector<double> place;  ///< where the abscissas are drawn, see `even`
  };
  std::vector<Axis> axes;
  std::vector<Block> blocks;
  /// Some knots of the first axis would hide each other: they are drawn equally far apart, at 0, 1,
  /// 2, ... What is straight between knots stays so.
  bool even = false;
  bool grid = false;       ///< every combination of knots is a row, the first axis fastest
  bool cell_grid = false;  ///< and FittedTable::cells are those between the knots, likewise
};

TableView table_view(const FittedTable& table);

}  // namespace slipbench::driver::calibrate
