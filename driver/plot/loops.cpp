// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "driver/plot/cycle_finder.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/path_rows.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

/// The loop that rows `first` to `last` make.
struct Stretch {
  std::int64_t cycle = 0;
  std::int64_t first = 0;
  std::int64_t last = 0;
  PathRows path;
};

/// The loops of one definition while their rows come.
struct Loops {
  std::vector<Stretch> stretches;
  std::int64_t cycles = 0;
  std::optional<std::array<std::int64_t, 2>> full;
};

/// Returns what a definition's loops are drawn over and up.
std::vector<PathRows::Column> path_columns(const results::PlotData& data,
                                           const results::PlotDefinition& definition) {
  std::vector<int> numbers = definition.positions;
  numbers.insert(numbers.end(), definition.components.begin(), definition.components.end());
  numbers.insert(numbers.end(), {definition.limit, definition.limit_below});
  std::vector<PathRows::Column> columns;
  for (const int number : numbers) {
    if (!moves(data, number)) continue;
    const auto k = static_cast<std::size_t>(number);
    columns.push_back({k, data.highest[k] - data.lowest[k]});
  }
  return columns;
}

/// The cycles of each definition that is drawn: of the first of its motions that has a full one.
tl::expected<std::vector<MotionCycles>, base::HistoryError> find_cycles(
    const results::PlotData& data, const fs::path& file, const std::string& shown_name) {
  struct Motion {
    std::size_t definition;
    std::size_t place;
    CycleFinder finder;
  };
  std::vector<Motion> motions;
  std::vector<std::string> columns;
  for (std::size_t d = 0; d < drawn_definitions(data); ++d) {
    for (const int position : data.definitions[d].positions) {
      if (!moves(data, position)) continue;
      const auto k = static_cast<std::size_t>(position);
      // Two definitions may move along the same position; a reader wants each column once.
      const auto known = std::find(columns.begin(), columns.end(), data.columns[k].name);
      motions.push_back({d, static_cast<std::size_t>(known - columns.begin()),
                         CycleFinder(data.highest[k] - data.lowest[k])});
      if (known == columns.end()) columns.push_back(data.columns[k].name);
    }
  }
  std::vector<MotionCycles> found(drawn_definitions(data));
  if (motions.empty()) return found;
  auto read =
      results::each_row(file, shown_name, columns, [&](std::span<const double> row, std::int64_t) {
        for (Motion& motion : motions) motion.finder.add(row[motion.place]);
      });
  if (!read) return tl::unexpected(std::move(read.error()));
  for (const Motion& motion : motions) {
    MotionCycles& cycles = found[motion.definition];
    if (!cycles.full) cycles = motion.finder.cycles();
  }
  return found;
}

Loops choose_loops(const results::PlotData& data, const results::PlotDefinition& definition,
                   const MotionCycles& cycles) {
  const std::vector<PathRows::Column> columns = path_columns(data, definition);
  Loops loops;
  if (!cycles.full) {
    loops.stretches.push_back({0, 0, data.rows_in_all, {columns, kMostLoopRows}});
    return loops;
  }
  loops.full = cycles.full;
  loops.cycles = static_cast<std::int64_t>(cycles.ends.size());
  for (const std::int64_t number : drawn_cycles(loops.cycles)) {
    const auto i = static_cast<std::size_t>(number - 1);
    loops.stretches.push_back(
        {number, i == 0 ? 0 : cycles.ends[i - 1], cycles.ends[i], {columns, kMostLoopRows}});
  }
  return loops;
}

/// "loops: 7 of 100 cycles", or how far a run without cycles is drawn; empty if all is.
std::string note_of(const results::PlotData& data) {
  std::string note;
  for (std::size_t i = 0; i < drawn_definitions(data); ++i) {
    const results::PlotDefinition& definition = data.definitions[i];
    std::string one;
    if (static_cast<std::int64_t>(definition.loops.size()) < definition.cycles) {
      one = fmt::format("{} of {} cycles", definition.loops.size(), definition.cycles);
    } else if (definition.cycles == 0 && definition.loop_rows < data.rows_in_all) {
      one = fmt::format("the first {} of {} rows", definition.loop_rows, data.rows_in_all);
    }
    if (!one.empty() && note.find(one) == std::string::npos) {
      note += (note.empty() ? "loops: " : "; ") + one;
    }
  }
  return note;
}

}  // namespace

tl::expected<void, base::HistoryError> add_loops(results::PlotData& data, const fs::path& file,
                                                 const std::string& shown_name) {
  const auto cycles = find_cycles(data, file, shown_name);
  if (!cycles) return tl::unexpected(cycles.error());
  std::vector<Loops> all;
  for (std::size_t d = 0; d < drawn_definitions(data); ++d) {
    all.push_back(choose_loops(data, data.definitions[d], (*cycles)[d]));
  }
  std::vector<std::string> names;
  for (const results::PlotColumn& column : data.columns) names.push_back(column.name);
  auto read =
      results::each_row(file, shown_name, names, [&](std::span<const double> row, std::int64_t at) {
        for (std::size_t d = 0; d < all.size(); ++d) {
          for (Stretch& one : all[d].stretches) {
            if (at >= one.first && at <= one.last) one.path.add(row);
          }
          results::PlotDefinition& definition = data.definitions[d];
          if (!all[d].full || definition.dissipation < 0) continue;
          const double energy = row[static_cast<std::size_t>(definition.dissipation)];
          if (at == (*all[d].full)[0]) definition.energy = -energy;
          if (at == (*all[d].full)[1]) *definition.energy += energy;
        }
      });
  if (!read) return read;
  for (std::size_t d = 0; d < all.size(); ++d) {
    results::PlotDefinition& definition = data.definitions[d];
    definition.cycles = all[d].cycles;
    for (Stretch& one : all[d].stretches) {
      definition.loop_rows = one.path.taken();
      definition.loops.push_back({one.cycle, one.path.finish()});
    }
  }
  return {};
}

void tell_loops(PlotScript& script, const results::PlotData& data) {
  std::string rows;
  int count = 0;
  for (std::size_t i = 0; i < drawn_definitions(data); ++i) {
    const results::PlotDefinition& definition = data.definitions[i];
    script.add("FIRST_LOOP", count);
    script.add("LOOPS", static_cast<int>(definition.loops.size()));
    std::string names;
    for (const results::DrawnLoop& loop : definition.loops) {
      rows += rows_text(data, loop.rows) + "\n\n";
      // gnuplot's word() takes the double-quoted parts of a text as words.
      names += loop.cycle == 0 ? "\"force\"" : fmt::format("\"cycle {}\" ", loop.cycle);
      ++count;
    }
    script.add("LOOP_NAMES", names);
    script.add("LIMIT_NAME", definition.loops.size() > 1
                                 ? fmt::format("limit, cycle {}", definition.cycles)
                                 : "limit");
  }
  script.block("LOOP_ROWS", std::move(rows));
  script.set("NOTE", note_of(data));
}

}  // namespace slipbench::driver::plot
