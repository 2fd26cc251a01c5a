// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/table_view.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace slipbench::driver::calibrate {
namespace {

std::string block_label(const TableView& view, const std::vector<double>& point) {
  std::string label;
  for (std::size_t k = 1; k < point.size() && k < view.axes.size(); ++k) {
    const TableView::Axis& axis = view.axes[k];
    label += fmt::format("{}{} {:.6g}{}{}", label.empty() ? "" : ", ", axis.name, point[k],
                         axis.unit.empty() ? "" : " ", axis.unit);
  }
  return label;
}

bool same_block(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && !a.empty() && std::equal(a.begin() + 1, a.end(), b.begin() + 1);
}

/// Tells whether the largest step between knots is many times the smallest; of many knots none can
/// be told by its number, equally far apart or not.
bool is_uneven(const std::vector<double>& knots) {
  constexpr std::size_t kMostTold = 12;
  constexpr double kRatio = 15.0;
  if (knots.size() < 3 || knots.size() > kMostTold) return false;
  double least = knots[1] - knots[0];
  double most = least;
  for (std::size_t i = 2; i < knots.size(); ++i) {
    least = std::min(least, knots[i] - knots[i - 1]);
    most = std::max(most, knots[i] - knots[i - 1]);
  }
  return most > kRatio * least;
}

double place_of(const std::vector<double>& knots, double x) {
  const auto found = std::lower_bound(knots.begin(), knots.end(), x);
  return static_cast<double>(found - knots.begin());
}

bool is_grid(const TableView& view, const FittedTable& table) {
  std::size_t rows = 1;
  for (const TableView::Axis& axis : view.axes) rows *= axis.knots.size();
  if (rows != table.points.size()) return false;
  for (std::size_t row = 0; row < rows; ++row) {
    std::size_t rest = row;
    for (std::size_t k = 0; k < view.axes.size(); ++k) {
      const std::vector<double>& knots = view.axes[k].knots;
      if (table.points[row][k] != knots[rest % knots.size()]) return false;
      rest /= knots.size();
    }
  }
  return true;
}

}  // namespace

TableView table_view(const FittedTable& table) {
  TableView view;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    TableView::Axis axis;
    axis.name = table.columns[k];
    if (k < table.units.size()) axis.unit = table.units[k];
    std::replace(axis.name.begin(), axis.name.end(), '_', ' ');
    for (const std::vector<double>& point : table.points) axis.knots.push_back(point[k]);
    std::sort(axis.knots.begin(), axis.knots.end());
    axis.knots.erase(std::unique(axis.knots.begin(), axis.knots.end()), axis.knots.end());
    view.axes.push_back(std::move(axis));
  }
  view.even = !view.axes.empty() && is_uneven(view.axes[0].knots);
  for (std::size_t row = 0; row < table.points.size() && !view.axes.empty(); ++row) {
    const std::vector<double>& point = table.points[row];
    if (row == 0 || !same_block(point, table.points[row - 1])) {
      view.blocks.push_back({block_label(view, point), row, {}, {}});
    }
    TableView::Block& block = view.blocks.back();
    block.abscissa.push_back(point[0]);
    block.place.push_back(view.even ? place_of(view.axes[0].knots, point[0]) : point[0]);
  }
  if (view.blocks.size() == 1) view.blocks.front().label.clear();
  view.grid = !view.axes.empty() && is_grid(view, table);
  std::size_t cells = 1;
  for (const TableView::Axis& axis : view.axes) cells *= axis.knots.size() - 1;
  view.cell_grid = view.grid && cells == table.cells.size();
  return view;
}

}  // namespace slipbench::driver::calibrate
