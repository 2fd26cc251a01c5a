// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/unvisited_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Cells of a grid, the first independent fastest.
class Grid {
 public:
  explicit Grid(const FittedTable& table) : knots_(knots_of(table)) {
    for (const auto& axis : knots_) {
      strides_.push_back(cells_);
      cells_ *= std::max<std::size_t>(1, axis.size() - 1);
    }
  }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] const std::vector<double>& knots(std::size_t k) const { return knots_[k]; }
  [[nodiscard]] std::size_t axes() const { return knots_.size(); }
  [[nodiscard]] std::size_t intervals(std::size_t k) const {
    return std::max<std::size_t>(1, knots_[k].size() - 1);
  }
  [[nodiscard]] std::size_t index(std::size_t cell, std::size_t k) const {
    return cell / strides_[k] % intervals(k);
  }

 private:
  std::vector<std::vector<double>> knots_;
  std::vector<std::size_t> strides_;
  std::size_t cells_ = 1;
};

std::string with_unit(const FittedTable& table, std::size_t k) {
  return k < table.units.size() && !table.units[k].empty() ? " " + table.units[k] : "";
}

std::string cell_text(const FittedTable& table, const Grid& grid, std::size_t cell) {
  std::string text;
  for (std::size_t k = 0; k < grid.axes(); ++k) {
    const std::vector<double>& knots = grid.knots(k);
    const std::size_t i = grid.index(cell, k);
    text += (text.empty() ? "" : ", ") + table.columns[k] + " " + base::format_number(knots[i]);
    if (knots.size() > 1) text += " .. " + base::format_number(knots[i + 1]);
    text += with_unit(table, k);
  }
  return text;
}

bool has_unseen_corner(const FittedTable& table, const Grid& grid, std::size_t cell,
                       const std::vector<char>& seen) {
  for (std::size_t r = 0; r < std::min(seen.size(), table.points.size()); ++r) {
    if (seen[r] != 0) continue;
    bool corner = true;
    for (std::size_t k = 0; k < grid.axes() && corner; ++k) {
      const std::vector<double>& knots = grid.knots(k);
      const std::size_t i = grid.index(cell, k);
      const double x = table.points[r][k];
      corner = x == knots[i] || (knots.size() > 1 && x == knots[i + 1]);
    }
    if (corner) return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<double>> knots_of(const FittedTable& table) {
  std::vector<std::vector<double>> knots(table.columns.size());
  for (std::size_t k = 0; k < knots.size(); ++k) {
    for (const std::vector<double>& point : table.points) knots[k].push_back(point[k]);
    std::sort(knots[k].begin(), knots[k].end());
    knots[k].erase(std::unique(knots[k].begin(), knots[k].end()), knots[k].end());
  }
  return knots;
}

std::size_t count_cells(const std::vector<std::vector<double>>& knots) {
  std::size_t cells = 1;
  for (const auto& axis : knots) cells *= std::max<std::size_t>(1, axis.size() - 1);
  return cells;
}

std::pair<double, double> neighbours(const FittedTable& table, std::size_t row, std::size_t k) {
  const std::vector<double>& here = table.points[row];
  std::pair<double, double> ends{here[k], here[k]};
  for (const std::vector<double>& point : table.points) {
    // The block: all rows with the same later independents.
    const bool same_block =
        std::equal(point.begin() + static_cast<std::ptrdiff_t>(k) + 1, point.end(),
                   here.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    if (!same_block) continue;
    if (point[k] < here[k] && (ends.first == here[k] || point[k] > ends.first)) {
      ends.first = point[k];
    }
    if (point[k] > here[k] && (ends.second == here[k] || point[k] < ends.second)) {
      ends.second = point[k];
    }
  }
  return ends;
}

void mark_edge_cells(const std::vector<char>& seen, FittedTable* table) {
  if (table->cells.empty() || table->columns.empty()) return;
  const Grid grid(*table);
  if (grid.cells() != table->cells.size()) return;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    FittedTable::Cell& one = table->cells[cell];
    one.edge_only = one.visits > 0 && has_unseen_corner(*table, grid, cell, seen);
  }
}

std::string unvisited_ranges(const FittedTable& table) {
  constexpr std::size_t kMostCells = 3;
  if (table.cells.empty() || table.columns.empty()) return {};
  const Grid grid(table);
  if (grid.cells() != table.cells.size()) return {};
  std::vector<char> untold(grid.cells(), 0);
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    untold[cell] = table.cells[cell].visited() ? 0 : 1;
  }
  const std::vector<char> unvisited = untold;
  const auto left = [&] {
    return static_cast<std::size_t>(std::count(untold.begin(), untold.end(), 1));
  };
  if (left() == 0) return {};
  if (left() == grid.cells()) return "anywhere";
  std::string text;
  const auto tell = [&](const std::string& range) {
    text += (text.empty() ? "with " : ", nor with ") + range;
  };
  // Whole slabs at the ends of an independent are told as one.
  for (std::size_t k = 0; k < grid.axes(); ++k) {
    const std::size_t count = grid.intervals(k);
    std::vector<char> visited(count, 0);
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
      if (unvisited[cell] == 0) visited[grid.index(cell, k)] = 1;
    }
    const auto first =
        static_cast<std::size_t>(std::find(visited.begin(), visited.end(), 1) - visited.begin());
    const auto past =
        static_cast<std::size_t>(visited.rend() - std::find(visited.rbegin(), visited.rend(), 1));
    const std::string unit = with_unit(table, k);
    if (first > 0) {
      tell(table.columns[k] + " below " + base::format_number(grid.knots(k)[first]) + unit);
    }
    if (past < count) {
      tell(table.columns[k] + " above " + base::format_number(grid.knots(k)[past]) + unit);
    }
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
      const std::size_t i = grid.index(cell, k);
      if (i < first || i >= past) untold[cell] = 0;
    }
  }
  std::size_t told = 0;
  for (std::size_t cell = 0; cell < grid.cells() && told < kMostCells; ++cell) {
    if (untold[cell] == 0) continue;
    ++told;
    untold[cell] = 0;
    tell(cell_text(table, grid, cell));
  }
  if (left() > 0) text += fmt::format(" and in {} more cell{}", left(), left() == 1 ? "" : "s");
  return text;
}

}  // namespace slipbench::driver::calibrate
