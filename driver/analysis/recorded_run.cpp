// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/recorded_run.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <span>
#include <utility>

#include "driver/bench/run_case.hpp"
#include "driver/check/check.hpp"
#include "driver/check/run_document.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::analysis {
namespace {

/// End of a run that is not wanted any more.
struct Interrupted {};

/// Increments that the steps of a case say; where motions break there are a few more.
std::size_t expected_rows(const cases::Case& problem, int every) {
  std::size_t rows = 2;
  for (const cases::Step& step : problem.steps) {
    rows += static_cast<std::size_t>(step.increments) * static_cast<std::size_t>(step.repeat);
  }
  return rows / static_cast<std::size_t>(every) + 64;
}

/// Columns of rows as they come.
class ColumnRecorder {
 public:
  ColumnRecorder(const cases::Case& problem, int every, RecordedRun& run)
      : problem_(problem), every_(every), run_(run) {
    make_room(expected_rows(problem, every));
  }

  void add(std::span<const bench::Row> block) {
    kept_.clear();
    for (const bench::Row& row : block) {
      if (row.index % every_ == 0) kept_.push_back(&row);
    }
    keep();
  }
  void add(const bench::Row& row) {
    kept_.assign(1, &row);
    keep();
  }

 private:
  /// A column at a time: its function and its place stay in the caches.
  void keep() {
    if (run_.rows + kept_.size() > run_.stride) make_room(2 * (run_.rows + kept_.size()));
    double* to = run_.numbers.get() + run_.rows;
    for (const results::Column& column : run_.columns) {
      results::column_values(column, problem_, kept_, to);
      to += run_.stride;
    }
    run_.rows += kept_.size();
  }

  void make_room(std::size_t rows) {
    // Pages that nothing is written to cost nothing. Many rows are worth large pages: with small
    // ones the system takes a third of the time.
    constexpr std::size_t kLargePage = std::size_t{1} << 21U;
    const std::size_t bytes = rows * run_.columns.size() * sizeof(double);
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    const bool large = bytes >= 4 * kLargePage;
    std::unique_ptr<double[], decltype(&std::free)> wider(
        static_cast<double*>(large ? std::aligned_alloc(kLargePage, whole) : std::malloc(bytes)),
        &std::free);
    if (!wider) throw std::bad_alloc();
    if (large) madvise(wider.get(), whole, MADV_HUGEPAGE);
    for (std::size_t c = 0; c < run_.columns.size(); ++c) {
      const double* const from = run_.numbers.get() + c * run_.stride;
      if (run_.rows > 0) std::copy(from, from + run_.rows, wider.get() + c * rows);
    }
    run_.numbers = std::move(wider);
    run_.stride = rows;
  }

  const cases::Case& problem_;
  int every_;
  RecordedRun& run_;
  std::vector<const bench::Row*> kept_;
};

}  // namespace

tl::expected<RecordedRun, bench::SimulationFailure> record_run(const cases::Case& problem,
                                                               const base::Diagnostics& reading,
                                                               const RecordOptions& options) {
  RecordedRun run;
  run.columns = options.columns.empty() ? results::output_columns(problem)
                                        : results::chosen_columns(problem, options.columns);
  std::vector<results::Column> positions;
  for (results::Column& column : results::result_columns(problem)) {
    if (!results::is_position(column) || !column.name.starts_with("CP")) continue;
    run.positions.push_back(column.name);
    positions.push_back(std::move(column));
  }
  ColumnRecorder rows(problem, options.every, run);
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
    rows.add(block);
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
  for (const check::CheckProgress& check : checks) run.verdicts.push_back(check.verdict());
  run.warnings = summary.warnings(*ended);
  run.document = check::run_document(problem, summary, reading, run.warnings, run.verdicts);
  return run;
}

}  // namespace slipbench::driver::analysis
