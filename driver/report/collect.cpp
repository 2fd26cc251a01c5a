// SPDX-License-Identifier: Apache-2.0
#include "driver/report/collect.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/one_line.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/report/drawn_columns.hpp"
#include "driver/report/drawn_coverage.hpp"
#include "driver/report/row_choice.hpp"
#include "driver/report/thin_trace.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/events.hpp"
#include "driver/results/result_layout.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::report {
namespace {

/// "expression 2*CP1", "closed form coulomb_slider", "curve golden/belt.csv".
std::string reference_text(const cases::Check& check) {
  if (const auto* form = std::get_if<cases::ClosedFormReference>(&check.against)) {
    return "closed form " + form->name;
  }
  if (const auto* curve = std::get_if<cases::CurveReference>(&check.against)) {
    return "curve " + curve->shown_name;
  }
  return "expression " + std::get<cases::ExpressionReference>(check.against).expression.text();
}

/// The lines of a text without the blanks they are indented by.
std::vector<std::string> unindented_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty()) lines.emplace_back(line);
  }
  return lines;
}

}  // namespace

struct CaseCollector::State {
  State(const cases::Case& the_case, std::size_t most_rows)
      : problem(the_case),
        columns(results::result_columns(the_case)),
        layout(results::layout_of(the_case, columns)),
        drawn(drawn_columns(layout)),
        rows(drawn.names.size(), most_rows, drawn.motions),
        detector(the_case),
        summary(the_case),
        spans(the_case.definitions.size()),
        regimes(the_case.definitions.size()),
        numbers(drawn.names.size()) {
    for (const std::string& name : drawn.names) {
      shown.push_back(*results::find_column(problem, columns, name));
    }
    for (const results::Column& column : columns) {
      if (results::is_position(column) && column.name.starts_with("CP")) {
        positions.push_back(column);
      }
    }
  }

  void add(const bench::Row& row);
  void note(const results::Event& event, const bench::Row& row);
  void take_numbers(const bench::Row& row, std::span<double> to) const;
  IndexedRows rows_at(std::vector<double> times) const;

  const cases::Case& problem;
  std::vector<results::Column> columns;
  results::ResultLayout layout;
  DrawnColumns drawn;
  std::vector<results::Column> shown;  ///< in the order of drawn.names
  std::vector<results::Column> positions;
  RowChoice rows;
  results::EventDetector detector;
  results::Summary summary;
  ReportEvents events;
  std::vector<results::RegimeSpans> spans;
  struct Since {
    int status = 1;
    double time = 0.0;
  };
  std::vector<Since> regimes;    ///< of each definition, now
  std::vector<double> numbers;   ///< of the row before
  bool numbers_changed = false;  ///< there was an event on the way to it
  bool started = false;
  double start = 0.0;
  double end = 0.0;
};

void CaseCollector::State::note(const results::Event& event, const bench::Row& row) {
  if (!event.jump) {
    Since& since = regimes[event.definition];
    spans[event.definition].add(since.status, since.time, event.time);
    since = {static_cast<int>(event.to), event.time};
  }
  ReportEvent one{event.time,
                  problem.definitions[event.definition].name,
                  results::regime_name(event.from),
                  results::goal_name(event),
                  event.reversal,
                  event.force,
                  event.limit,
                  event.accumulated_slip,
                  {}};
  for (const results::Column& position : positions) {
    one.positions.emplace_back(position.name,
                               results::position_at(event, row, position.index) - position.offset);
  }
  events.add(std::move(one));
}

void CaseCollector::State::add(const bench::Row& row) {
  summary.add(row);
  const std::span<const results::Event> changes = detector.take(row);
  end = row.time;
  // The corner that an event makes lies between two rows: both stay.
  if (started) {
    rows.add(numbers, numbers_changed || !changes.empty());
  } else {
    start = row.time;
    for (std::size_t d = 0; d < regimes.size(); ++d) {
      regimes[d] = {static_cast<int>(row.definitions[d].update.state.regime), row.time};
    }
  }
  started = true;
  for (const results::Event& event : changes) note(event, row);
  numbers_changed = !changes.empty();
  take_numbers(row, numbers);
}

void CaseCollector::State::take_numbers(const bench::Row& row, std::span<double> to) const {
  for (std::size_t k = 0; k < shown.size(); ++k)
    to[k] = results::column_value(shown[k], problem, row);
}

/// The worst rows are known when all is over, and their numbers are gone by then: the case is
/// walked through once more, up to the last of them. A case that cannot be (its measured history is
/// gone) has its other rows.
IndexedRows CaseCollector::State::rows_at(std::vector<double> times) const {
  RowsAtTimes wanted(std::move(times));
  std::vector<double> here(shown.size());
  if (!wanted.done()) {
    static_cast<void>(
        bench::follow_cases({&problem, 1}, [&](std::span<const bench::Simulation> runs) {
          take_numbers(runs.front().row(), here);
          wanted.add(here);
          return !wanted.done();
        }));
  }
  return wanted.rows();
}

CaseCollector::CaseCollector(const cases::Case& problem, std::size_t most_rows)
    : state_(std::make_unique<State>(problem, most_rows)) {}
CaseCollector::CaseCollector(CaseCollector&&) noexcept = default;
CaseCollector::~CaseCollector() = default;

void CaseCollector::add(const bench::Row& row) { state_->add(row); }

CaseReport CaseCollector::finish(const std::string& name,
                                 std::span<const check::CheckProgress> checks,
                                 std::span<const bench::MotionJump> jumps) {
  State& state = *state_;
  const cases::Case& problem = state.problem;
  if (state.started) state.rows.add(state.numbers, state.numbers_changed);

  CaseReport report;
  report.name = name;
  report.title = base::printable(problem.title);
  report.run = what_was_run(problem);
  report.units = state.layout.units;
  report.units.emplace_back("energy", base::energy_unit(problem.units));
  report.parameters.assign(problem.parameters.begin(), problem.parameters.end());
  report.summary = unindented_lines(state.summary.text());
  report.warnings = state.summary.warnings(jumps);
  report.increments = state.summary.increments();
  for (const results::Column& column : state.shown) {
    report.columns.push_back(
        {column.name, base::unit_text(column.dimension, problem.units), column.text});
  }
  report.definitions = std::move(state.drawn.definitions);
  const double duration = state.end - state.start;
  for (ReportDefinition& definition : report.definitions) {
    const auto sums = state.summary.definitions();
    const auto own = std::find_if(
        sums.begin(), sums.end(),
        [&](const results::DefinitionSummary& sum) { return sum.name == definition.name; });
    if (own == sums.end()) continue;
    const auto d = static_cast<std::size_t>(own - sums.begin());
    if (duration > 0.0) definition.slip_share = own->slip_time / duration;
    state.spans[d].add(state.regimes[d].status, state.regimes[d].time, state.end);
    definition.spans = state.spans[d].spans();
  }
  report.events_total = state.events.total();
  report.events = state.events.take();
  report.energies = std::move(state.drawn.energies);
  use_energy_unit(report, base::energy_unit(problem.units));
  for (const results::TableCoverage& table : state.summary.tables()) {
    report.coverage.push_back(drawn_coverage(table, problem.definitions[table.definition].name));
  }

  report.status = ReportStatus::kNoChecks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const cases::Check& check = problem.checks[i];
    ReportCheck one;
    one.verdict = checks[i].verdict();
    one.verdict.name = check.name;
    one.quantity = check.quantity_text;
    one.against = reference_text(check);
    one.why = check.tolerance.why;
    put_trace(one, checks[i].trace(), checks.size());
    if (!one.verdict.passed) {
      report.status = ReportStatus::kFailed;
    } else if (report.status == ReportStatus::kNoChecks) {
      report.status = ReportStatus::kPassed;
    }
    report.checks.push_back(std::move(one));
  }
  IndexedRows worst;
  if (state.rows.thinned() && !report.checks.empty()) worst = state.rows_at(worst_times(report));
  report.rows_total = state.rows.count();
  report.drawn = state.rows.finish(worst);
  return report;
}

std::vector<double> worst_times(const CaseReport& report) {
  std::vector<double> times;
  for (const ReportCheck& check : report.checks) {
    const check::Measure* measure = check::worst_measure(check.verdict);
    if (check.verdict.compared > 0) times.push_back(check.verdict.worst.time);
    if (measure != nullptr && measure->where) times.push_back(measure->where->time);
  }
  std::erase_if(times, [](double time) { return !std::isfinite(time); });
  return times;
}

void add_remarks(CaseReport& report, const base::Diagnostics& diagnostics) {
  for (const std::string& note : base::lines_of(diagnostics, base::Severity::kNote)) {
    report.summary.push_back("note: " + note);
  }
  for (std::string& warning : base::lines_of(diagnostics, base::Severity::kWarning)) {
    report.warnings.push_back(std::move(warning));
  }
}

CaseReport not_run_report(const std::string& name, const std::string& title, std::string message) {
  CaseReport report;
  report.name = name;
  report.title = base::printable(title);
  report.status = ReportStatus::kNotRun;
  report.message = std::move(message);
  return report;
}

}  // namespace slipbench::driver::report
