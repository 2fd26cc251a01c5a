// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/full_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "driver/compare/branches.hpp"
#include "driver/history/csv_reader.hpp"
#include "driver/history/step_grid.hpp"
#include "driver/results/thinning.hpp"

namespace slipbench::driver {
namespace {

/// Turning points that differ by less, as a part of the motion's range, are one place.
constexpr double kSamePlace = 1e-3;
constexpr double kSmallestCycle = 0.02;

/// The rows of a file, one after the other; `take` sees their numbers and how many came before.
template <typename Take>
tl::expected<void, HistoryError> each_row(const std::filesystem::path& file,
                                          const std::string& shown_name,
                                          const std::vector<std::string>& columns, Take take) {
  auto reader = CsvReader::open(file, columns, shown_name);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  std::vector<double> row(columns.size());
  for (std::int64_t index = 0;; ++index) {
    auto more = reader->next(row);
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) return {};
    take(row, index);
  }
}

}  // namespace

bool FullCycleFinder::full(const Turn& first, const Turn& middle, const Turn& end) const {
  return std::abs(end.position - middle.position) >= kSmallestCycle * range_ &&
         std::abs(end.position - first.position) <= kSamePlace * range_;
}

void FullCycleFinder::add(double position) {
  const double smallest_turn = kSmallestTurn * range_;
  const std::int64_t row = count_++;
  position_ = position;
  if (row == 0) start_ = position;
  if (direction_ == 0.0) {
    if (!(std::abs(position - start_) > smallest_turn)) return;
    direction_ = position > start_ ? 1.0 : -1.0;
    furthest_ = position;
    dwells_ = row;
    return;
  }
  const double advance = direction_ * (position - furthest_);
  if (advance > 0.0) {
    furthest_ = position;
    dwells_ = row;
  } else if (dwells_ == row - 1 && -advance <= kSameTime * range_) {
    dwells_ = row;
  }
  if (advance >= -smallest_turn) return;
  const Turn turn{dwells_, furthest_};
  if (turns_ >= 2 && full(before_[0], before_[1], turn)) last_ = {before_[0].row, turn.row};
  before_ = {before_[1], turn};
  ++turns_;
  direction_ = -direction_;
  furthest_ = position;
  dwells_ = row;
}

std::optional<std::array<std::int64_t, 2>> FullCycleFinder::last() const {
  const Turn end{count_ - 1, position_};
  if (turns_ >= 2 && full(before_[0], before_[1], end)) return std::array{before_[0].row, end.row};
  return last_;
}

tl::expected<void, HistoryError> add_full_cycles(PlotData& data, const std::filesystem::path& file,
                                                 const std::string& shown_name) {
  struct Motion {
    std::size_t definition;
    FullCycleFinder finder;
  };
  std::vector<Motion> motions;
  std::vector<std::string> columns;
  for (std::size_t d = 0; d < data.definitions.size(); ++d) {
    for (const int position : data.definitions[d].positions) {
      if (position < 0) continue;
      const auto k = static_cast<std::size_t>(position);
      if (!(data.highest[k] > data.lowest[k])) continue;
      motions.push_back({d, FullCycleFinder(data.highest[k] - data.lowest[k])});
      columns.push_back(data.columns[k].name);
    }
  }
  if (motions.empty()) return {};
  // Two definitions may move along the same position; a reader wants each column once.
  std::vector<std::string> once = columns;
  std::sort(once.begin(), once.end());
  once.erase(std::unique(once.begin(), once.end()), once.end());
  std::vector<std::size_t> place;
  for (const std::string& column : columns) {
    place.push_back(static_cast<std::size_t>(std::lower_bound(once.begin(), once.end(), column) -
                                             once.begin()));
  }
  auto read = each_row(file, shown_name, once, [&](const std::vector<double>& row, std::int64_t) {
    for (std::size_t m = 0; m < motions.size(); ++m) motions[m].finder.add(row[place[m]]);
  });
  if (!read) return read;

  struct Cycle {
    std::array<std::int64_t, 2> rows;
    RowThinner thinner;
  };
  std::vector<std::optional<Cycle>> cycles(data.definitions.size());
  for (const Motion& motion : motions) {
    const auto found = motion.finder.last();
    auto& cycle = cycles[motion.definition];
    if (found && !cycle) cycle.emplace(Cycle{*found, {data.columns.size(), kMostCycleRows}});
  }
  std::vector<std::string> all;
  for (const PlotColumn& column : data.columns) all.push_back(column.name);
  read = each_row(file, shown_name, all, [&](const std::vector<double>& row, std::int64_t index) {
    for (auto& cycle : cycles) {
      if (cycle && index >= cycle->rows[0] && index <= cycle->rows[1]) cycle->thinner.add(row);
    }
  });
  if (!read) return read;
  for (std::size_t d = 0; d < cycles.size(); ++d) {
    if (cycles[d]) data.definitions[d].cycle = cycles[d]->thinner.rows();
  }
  return {};
}

}  // namespace slipbench::driver
