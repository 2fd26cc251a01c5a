// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/table_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace slipbench::driver::calibrate {

std::vector<TableLine> table_lines(const law::Table& table, int independent) {
  const auto along = static_cast<std::size_t>(independent);
  std::map<std::vector<double>, TableLine> lines;
  std::vector<std::vector<double>> order;  // as they appear in the table
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<double> others = table.point(row);
    const double x = others[along];
    others.erase(others.begin() + independent);
    const auto [found, is_new] = lines.try_emplace(others);
    if (is_new) order.push_back(others);
    found->second.independent = independent;
    found->second.rows.push_back(row);
    found->second.abscissa.push_back(x);
  }
  std::vector<TableLine> result;
  for (const std::vector<double>& others : order) {
    TableLine& line = lines.at(others);
    if (line.rows.size() > 1) result.push_back(std::move(line));
  }
  return result;
}

std::vector<fit::ShapedBlock> shaped_blocks(const law::Table& table, const fit::Shape& shape,
                                            std::size_t first_unknown) {
  std::vector<fit::ShapedBlock> blocks;
  for (TableLine& line : table_lines(table, 0)) {
    // The first independent varies fastest: the rows of a line are neighbours.
    blocks.push_back({.first = first_unknown + line.rows.front(),
                      .count = line.rows.size(),
                      .abscissa = std::move(line.abscissa),
                      .shape = shape});
  }
  return blocks;
}

std::vector<SmoothnessRow> smoothness_rows(const law::Table& table, int column,
                                           std::size_t first_unknown) {
  double largest = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    largest = std::max(largest, std::abs(table.ordinate(row, column)));
  }
  if (largest == 0.0) largest = 1.0;
  std::vector<SmoothnessRow> rows;
  for (int k = 0; k < table.independents(); ++k) {
    for (const TableLine& line : table_lines(table, k)) {
      for (std::size_t i = 0; i + 2 < line.rows.size(); ++i) {
        const double left = line.abscissa[i + 1] - line.abscissa[i];
        const double right = line.abscissa[i + 2] - line.abscissa[i + 1];
        const double mean = 0.5 * (left + right);
        const double scale = mean * mean / ((left + right) * largest);
        SmoothnessRow row;
        for (std::size_t j = 0; j < 3; ++j) row.unknown[j] = first_unknown + line.rows[i + j];
        row.weight[0] = scale / left;
        row.weight[1] = -scale * (1.0 / left + 1.0 / right);
        row.weight[2] = scale / right;
        rows.push_back(row);
      }
    }
  }
  return rows;
}

}  // namespace slipbench::driver::calibrate
