// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/recorded_run.hpp"

#include <algorithm>
#include <utility>

#include "driver/bench/run_case.hpp"
#include "driver/check/check.hpp"
#include "driver/check/run_document.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::analysis {
namespace {

/// End of a run that is not wanted any more.
struct Interrupted {};

/// Rows of a run, turned into columns at its end: their number is not known before.
class Rows {
 public:
  Rows(const cases::Case& problem, const std::vector<results::Column>& columns)
      : problem_(problem), columns_(columns) {}

  void add(const bench::Row& row) {
    for (const results::Column& column : columns_) {
      numbers_.push_back(results::column_value(column, problem_, row));
    }
    ++rows_;
  }
  std::size_t count() const { return rows_; }

  std::vector<double> by_columns() const {
    const std::size_t width = columns_.size();
    std::vector<double> turned(numbers_.size());
    // Blocks of rows stay in the cache for all columns.
    constexpr std::size_t kTogether = 64;
    for (std::size_t first = 0; first < rows_; first += kTogether) {
      const std::size_t end = std::min(first + kTogether, rows_);
      for (std::size_t c = 0; c < width; ++c) {
        for (std::size_t r = first; r < end; ++r) turned[c * rows_ + r] = numbers_[r * width + c];
      }
    }
    return turned;
  }

 private:
  const cases::Case& problem_;
  const std::vector<results::Column>& columns_;
  std::vector<double> numbers_;
  std::size_t rows_ = 0;
};

}  // namespace

tl::expected<RecordedRun, bench::SimulationFailure> record_run(const cases::Case& problem,
                                                               const base::Diagnostics& reading,
                                                               const RecordOptions& options) {
  RecordedRun run;
  run.columns = results::output_columns(problem);
  std::vector<results::Column> positions;
  for (results::Column& column : results::result_columns(problem)) {
    if (!results::is_position(column) || !column.name.starts_with("CP")) continue;
    run.positions.push_back(column.name);
    positions.push_back(std::move(column));
  }
  Rows rows(problem, run.columns);
  results::Summary summary(problem);
  results::EventDetector detector(problem);
  std::vector<check::CheckProgress> checks;
  if (options.with_checks) {
    checks.reserve(problem.checks.size());
    for (const cases::Check& check : problem.checks) checks.emplace_back(problem, check);
  }
  bench::Row last;
  const auto take = [&](std::span<const bench::Row> block) {
    if (options.go_on && !options.go_on()) throw Interrupted{};
    summary.add(block);
    for (const results::Event& event : detector.take(block)) {
      RecordedEvent& one = run.events.emplace_back(RecordedEvent{event, {}});
      for (const results::Column& position : positions) {
        one.positions.push_back(results::position_at(event, block[event.row], position.index) -
                                position.offset);
      }
    }
    for (check::CheckProgress& check : checks) check.add(block);
    for (const bench::Row& row : block) {
      if (row.index % options.every == 0) rows.add(row);
    }
    if (block.back().index % options.every != 0) last = block.back();
  };
  const auto ended = [&]() -> decltype(bench::run_in_blocks(problem, take)) {
    try {
      return bench::run_in_blocks(problem, take);
    } catch (const Interrupted&) {
      return tl::unexpected(bench::SimulationFailure{bench::SimulationFailure::Kind::kEnvironment,
                                                     "interrupted", -1});
    }
  }();
  if (!ended) return tl::unexpected(ended.error());
  // The end of the run is always in the result.
  if (last.index == summary.increments() && last.index > 0) rows.add(last);
  run.rows = rows.count();
  run.numbers = rows.by_columns();
  for (const check::CheckProgress& check : checks) run.verdicts.push_back(check.verdict());
  run.warnings = summary.warnings(*ended);
  run.document = check::run_document(problem, summary, reading, run.warnings, run.verdicts);
  return run;
}

}  // namespace slipbench::driver::analysis
