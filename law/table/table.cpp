// SPDX-License-Identifier: Apache-2.0
#include "law/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slipbench::law {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Tells whether all blocks of entries first[b] .. first[b + 1] - 1 of x hold the same.
bool has_equal_blocks(std::span<const double> x, std::span<const std::uint32_t> first) {
  const auto block = [&](std::size_t b) { return x.subspan(first[b], first[b + 1] - first[b]); };
  for (std::size_t b = 1; b + 1 < first.size(); ++b) {
    if (!std::ranges::equal(block(b), block(0))) return false;
  }
  return true;
}

}  // namespace

bool Table::build(std::span<const std::vector<double>> rows, int dependents, int independents,
                  Extrapolation extrapolation, Table* table, TableError* error) {
  const auto fail = [&](TableError e) {
    *error = e;
    return false;
  };
  if (rows.empty()) return fail({TableError::Kind::kNoRows});
  if (independents > kMaxIndependents) return fail({TableError::Kind::kTooManyIndependents});

  const int width = dependents + independents;
  const int count = static_cast<int>(rows.size());
  for (int r = 0; r < count; ++r) {
    if (static_cast<int>(rows[at(r)].size()) != width) {
      return fail({TableError::Kind::kRowLength, r});
    }
    for (int c = 0; c < width; ++c) {
      if (!std::isfinite(rows[at(r)][at(c)])) {
        return fail({TableError::Kind::kNotFinite, r, -1, c});
      }
    }
  }
  if (independents == 0 && count > 1) return fail({TableError::Kind::kRepeatedPoint, 1, 0});

  Table built;
  built.dependents_ = dependents;
  built.extrapolation_ = extrapolation;
  built.levels_.resize(at(independents));
  for (const auto& row : rows) {
    built.ordinates_.insert(built.ordinates_.end(), row.begin(), row.begin() + dependents);
  }

  built.largest_.resize(at(dependents));
  for (int c = 0; c < dependents; ++c) built.find_largest(c);

  // A row opens a new entry on every level up to the slowest independent that changed.
  for (int r = 0; r < count; ++r) {
    const double* now = rows[at(r)].data() + dependents;
    int changed = independents - 1;  // the slowest level that gets a new entry
    if (r > 0) {
      const double* before = rows[at(r - 1)].data() + dependents;
      while (changed >= 0 && now[changed] == before[changed]) --changed;
      if (changed < 0) return fail({TableError::Kind::kRepeatedPoint, r, r - 1});
      if (now[changed] < before[changed]) {
        return fail({TableError::Kind::kNotAscending, r, r - 1, dependents + changed});
      }
    }
    for (int k = changed; k >= 0; --k) {
      Level& level = built.levels_[at(k)];
      const bool opens_block = r == 0 || k < changed;
      if (opens_block) level.first.push_back(static_cast<std::uint32_t>(level.x.size()));
      level.x.push_back(now[k]);
    }
  }
  for (int k = 0; k < independents; ++k) {
    Level& level = built.levels_[at(k)];
    level.first.push_back(static_cast<std::uint32_t>(level.x.size()));
    level.knots = level.x;
    std::sort(level.knots.begin(), level.knots.end());
    level.knots.erase(std::unique(level.knots.begin(), level.knots.end()), level.knots.end());
    if (extrapolation == Extrapolation::kLinear) {
      for (std::size_t b = 0; b + 1 < level.first.size(); ++b) {
        if (level.first[b + 1] - level.first[b] < 2) {
          std::uint32_t row = level.first[b];
          for (int below = k - 1; below >= 0; --below) row = built.levels_[at(below)].first[row];
          return fail({TableError::Kind::kOneRowLinear, static_cast<int>(row), -1, dependents + k});
        }
      }
    }
  }
  constexpr int kFew = 4;
  int corners = 0;
  if (independents >= kFew && !built.for_each_corner(independents - 1, [&](const auto&, double) {
        return ++corners <= kMostCorners;
      })) {
    return fail({TableError::Kind::kTooManyCorners});
  }
  built.is_grid_ =
      independents == 2 && has_equal_blocks(built.levels_[0].x, built.levels_[0].first);
  *table = std::move(built);
  return true;
}

template <bool kSlopes>
double Table::line(std::uint32_t first, std::uint32_t count, double v, double weight, double* slope,
                   int column) const noexcept {
  const double* grid = levels_[0].x.data() + first;
  const auto ordinate = [&](std::uint32_t i) { return ordinates_[this->index(first + i, column)]; };
  if (extrapolation_ == Extrapolation::kConstant || count == 1) {
    if (count == 1 || v < grid[0]) return ordinate(0);
    if (v >= grid[count - 1]) return ordinate(count - 1);
  }
  const std::uint32_t i = segment(grid, count, v);
  const double width = grid[i + 1] - grid[i];
  const double low = ordinate(i);
  const double rise = ordinate(i + 1) - low;
  if constexpr (kSlopes) *slope += weight * rise / width;
  return low + (v - grid[i]) / width * rise;
}

template <bool kSlopes>
double Table::block(int level, std::uint32_t index, const double* x, double weight, double* slopes,
                    int column) const noexcept {
  if (level < 0) return ordinates_[this->index(index, column)];
  const Level& here = levels_[at(level)];
  const std::uint32_t first = here.first[index];
  const std::uint32_t count = here.first[index + 1] - first;
  if (level == 0) return line<kSlopes>(first, count, x[0], weight, slopes, column);
  const double* grid = here.x.data() + first;
  const double v = x[level];

  if (extrapolation_ == Extrapolation::kConstant || count == 1) {
    if (count == 1 || v < grid[0]) {
      return block<kSlopes>(level - 1, first, x, weight, slopes, column);
    }
    if (v >= grid[count - 1]) {
      return block<kSlopes>(level - 1, first + count - 1, x, weight, slopes, column);
    }
  }
  const std::uint32_t i = segment(grid, count, v);
  const double width = grid[i + 1] - grid[i];
  const double w = (v - grid[i]) / width;
  const double low =
      block<kSlopes>(level - 1, first + i, x, kSlopes ? weight * (1.0 - w) : 0.0, slopes, column);
  const double high =
      block<kSlopes>(level - 1, first + i + 1, x, kSlopes ? weight * w : 0.0, slopes, column);
  if constexpr (kSlopes) slopes[level] += weight * (high - low) / width;
  return low + w * (high - low);
}

double Table::ragged_value(std::span<const double> x, int column) const noexcept {
  return block<false>(independents() - 1, 0, x.data(), 1.0, nullptr, column);
}

double Table::value_and_slopes(std::span<const double> x, std::span<double> slopes, int column,
                               double weight) const noexcept {
  if (levels_.size() == 1) {  // as most tables are
    const auto count = static_cast<std::uint32_t>(levels_[0].x.size());
    return line<true>(0, count, x[0], weight, slopes.data(), column);
  }
  return block<true>(independents() - 1, 0, x.data(), weight, slopes.data(), column);
}

TableMix Table::mix(std::span<const double> x) const noexcept {
  TableMix result;
  // The ends of the last independent are blocks of the first.
  const Bracket last =
      x.size() == 2 ? bracket(1, 0, x[1]) : Bracket{.low = 0, .high = 0, .fraction = 0.0};
  const Bracket low = bracket(0, last.low, x[0]);
  const Bracket high = bracket(0, last.high, x[0]);
  result.row = {low.low, low.high, high.low, high.high};
  result.fraction = {low.fraction, high.fraction, last.fraction};
  return result;
}

std::vector<double> Table::point(std::size_t row) const {
  std::vector<double> x;
  std::size_t entry = row;
  for (const Level& level : levels_) {
    x.push_back(level.x[entry]);
    // An entry of the next level is a block of this one: the one that holds the entry.
    const auto block = std::upper_bound(level.first.begin(), level.first.end(), entry);
    entry = static_cast<std::size_t>(block - level.first.begin()) - 1;
  }
  return x;
}

bool Table::same_grid(const Table& other) const {
  const auto same = [](const Level& a, const Level& b) { return a.x == b.x && a.first == b.first; };
  return dependents_ == other.dependents_ && extrapolation_ == other.extrapolation_ &&
         rows() == other.rows() && levels_.size() == other.levels_.size() &&
         std::equal(levels_.begin(), levels_.end(), other.levels_.begin(), same);
}

TableInterval Table::interval(int level, std::uint32_t index, double v) const noexcept {
  const Level& here = levels_[at(level)];
  const std::uint32_t first = here.first[index];
  const std::uint32_t count = here.first[index + 1] - first;
  const double* grid = here.x.data() + first;
  TableInterval result{grid[0], grid[0]};
  if (v < grid[0]) result.place = TableInterval::Place::kBelow;
  if (v > grid[count - 1]) result.place = TableInterval::Place::kAbove;
  if (count == 1) return result;
  const std::uint32_t i = segment(grid, count, v);
  result.lower = grid[i];
  result.upper = grid[i + 1];
  result.fraction = (v - result.lower) / (result.upper - result.lower);
  if (extrapolation_ == Extrapolation::kConstant) {
    result.fraction = std::clamp(result.fraction, 0.0, 1.0);
  }
  return result;
}

void Table::find_cell(int level, std::uint32_t index, const double* x,
                      TableCell* cell) const noexcept {
  if (level < 0) return;
  const Level& here = levels_[at(level)];
  const TableInterval found = interval(level, index, x[level]);
  cell->along[at(level)] = found;
  std::uint32_t low = here.first[index];
  while (here.x[low] < found.lower) ++low;
  const bool one = found.lower == found.upper;
  const std::uint32_t nearer = !one && found.fraction > 0.5 ? low + 1 : low;
  find_cell(level - 1, nearer, x, cell);
  if (one || found.fraction == 0.0 || found.fraction == 1.0) return;
  TableCell other = *cell;
  find_cell(level - 1, nearer == low ? low + 1 : low, x, &other);
  cell->ragged = cell->ragged || other.ragged;
  for (int k = 0; k < level; ++k) {
    const TableInterval& a = cell->along[at(k)];
    const TableInterval& b = other.along[at(k)];
    cell->ragged = cell->ragged || a.lower != b.lower || a.upper != b.upper;
  }
}

TableCell Table::cell(std::span<const double> x) const noexcept {
  TableCell result;
  result.independents = independents();
  find_cell(independents() - 1, 0, x.data(), &result);
  return result;
}

double Table::smallest(int column) const {
  double result = ordinates_[at(column)];
  for (std::size_t i = at(column); i < ordinates_.size(); i += at(dependents_)) {
    result = std::min(result, ordinates_[i]);
  }
  return result;
}

void Table::find_largest(int column) {
  double& result = largest_[at(column)];
  result = ordinates_[at(column)];
  for (std::size_t i = at(column); i < ordinates_.size(); i += at(dependents_)) {
    result = std::max(result, ordinates_[i]);
  }
}

void Table::set_ordinate(std::size_t row, int column, double value) {
  const double before = std::exchange(ordinates_[index(row, column)], value);
  double& largest = largest_[at(column)];
  if (value >= largest) {
    largest = value;
  } else if (before == largest) {
    find_largest(column);
  }
}

template <class Visit>
bool Table::descend(int level, int k, std::vector<Front>& fronts, std::vector<double>& x,
                    double next, Visit& visit) const {
  if (level < 0) return visit(x, next);
  const Level& here = levels_[at(level)];
  Front& front = fronts[at(level)];
  front.knots.clear();
  for (const std::uint32_t block : front.blocks) {
    front.knots.insert(front.knots.end(), here.x.begin() + here.first[block],
                       here.x.begin() + here.first[block + 1]);
  }
  // Prolonged end segments reach to the ends of the other blocks.
  if (extrapolation_ == Extrapolation::kLinear) {
    front.knots.push_back(here.knots.front());
    front.knots.push_back(here.knots.back());
  }
  std::sort(front.knots.begin(), front.knots.end());
  front.knots.erase(std::unique(front.knots.begin(), front.knots.end()), front.knots.end());
  for (std::size_t i = 0; i < front.knots.size(); ++i) {
    x[at(level)] = front.knots[i];
    if (level == k) {
      next =
          i + 1 < front.knots.size() ? front.knots[i + 1] : std::numeric_limits<double>::infinity();
    }
    if (level > 0) {
      std::vector<std::uint32_t>& inner = fronts[at(level - 1)].blocks;
      inner.clear();
      for (const std::uint32_t block : front.blocks) {
        const Bracket b = bracket(level, block, front.knots[i]);
        if (b.fraction != 1.0) inner.push_back(b.low);
        if (b.high != b.low && (b.fraction != 0.0 || level == k)) inner.push_back(b.high);
      }
      std::sort(inner.begin(), inner.end());
      inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    }
    if (!descend(level - 1, k, fronts, x, next, visit)) return false;
  }
  return true;
}

template <class Visit>
bool Table::for_each_corner(int k, Visit visit) const {
  std::vector<Front> fronts(levels_.size());
  if (!fronts.empty()) fronts.back().blocks = {0};
  std::vector<double> x(levels_.size());
  return descend(independents() - 1, k, fronts, x, std::numeric_limits<double>::infinity(), visit);
}

double Table::steepest_fall(int k, int column, double* knot) const {
  double steepest = 0.0;
  std::vector<double> slopes(levels_.size());
  for_each_corner(k, [&](const std::vector<double>& x, double /*next*/) {
    std::fill(slopes.begin(), slopes.end(), 0.0);
    value_and_slopes(x, slopes, column);
    if (!(slopes[at(k)] < steepest)) return true;
    steepest = slopes[at(k)];
    if (knot != nullptr) *knot = x[at(k)];
    return true;
  });
  return steepest;
}

double Table::largest_growth(int k, int column, double* knot) const {
  double growth = 0.0;
  std::vector<double> slopes(levels_.size());
  for_each_corner(k, [&](const std::vector<double>& x, double next) {
    std::fill(slopes.begin(), slopes.end(), 0.0);
    const double y = value_and_slopes(x, slopes, column);
    const double slope = slopes[at(k)];
    const double here = x[at(k)];
    // Within a cell y + x dy/dx is linear in x: its extremes are at the ends of the cell.
    double largest = std::max(y, y + here * slope);
    if (std::isfinite(next)) largest = std::max(largest, y + (2.0 * next - here) * slope);
    if (!(largest > growth)) return true;
    growth = largest;
    if (knot != nullptr) *knot = here;
    return true;
  });
  return growth;
}

bool Table::outside(std::span<const double> x) const noexcept {
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const auto& knots = levels_[k].knots;
    if (x[k] < knots.front() || x[k] > knots.back()) return true;
  }
  return false;
}

}  // namespace slipbench::law
