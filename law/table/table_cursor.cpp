// SPDX-License-Identifier: Apache-2.0
#include "law/table/table_cursor.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace slipbench::law {

double TableCursor::value_elsewhere(const Ambient& ambient, SlipArguments slip) noexcept {
  const Table& table = function_->table();
  const auto independents = function_->independents();
  const std::array<Side*, 2> sides = {&along_, &across_};
  // Ends that are held or prolonged are left to the table.
  bool inside = independents.size() == 1 || table.is_grid();
  for (std::size_t k = 0; inside && k < independents.size(); ++k) {
    const auto knots = table.knots(static_cast<int>(k));
    const double x = argument(independents[k], ambient, slip);
    inside = x >= knots.front() && x < knots.back();
    if (!inside) continue;
    const auto next = std::upper_bound(knots.begin(), knots.end(), x);
    *sides[k] = {independents[k], next[-1], *next, *next - next[-1]};
  }
  if (!inside) {
    along_ = {};
    return function_->value(ambient, slip);
  }
  has_two_ = independents.size() == 2;
  const auto x = function_->arguments(ambient, slip);
  const TableMix mix = table.mix(std::span(x).first(independents.size()));
  const auto edge = [&](std::size_t i) {
    const double first = table.ordinate(mix.row[i]);
    return Edge{first, table.ordinate(mix.row[i + 1]) - first};
  };
  low_ = edge(0);
  high_ = edge(2);
  return value(ambient, slip);
}

}  // namespace slipbench::law
