// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "driver/check/criteria/criteria.hpp"
#include "driver/report/json_text.hpp"
#include "driver/report/packed_numbers.hpp"
#include "driver/report/report.hpp"
#include "driver/report/series_digits.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::report {
namespace {

namespace fs = std::filesystem;

std::string_view word_of(ReportStatus status) {
  switch (status) {
    case ReportStatus::kPassed:
      return "passed";
    case ReportStatus::kFailed:
      return "failed";
    case ReportStatus::kNoChecks:
      return "no_checks";
    case ReportStatus::kNotRun:
      break;
  }
  return "not_run";
}

/// A member that is null where there is no such column.
void write_column(JsonText& json, std::string_view name, const std::string& column) {
  json.key(name);
  if (column.empty()) {
    json.null();
  } else {
    json.value(column);
  }
}

/// Writes times, all of a case with the same decimals, so that equal ones stay equal.
class TimeText {
 public:
  explicit TimeText(std::span<const double> times) {
    // Events lie within an increment: a hundred thousand parts of the shortest tell them apart.
    const double resolution = 1e-2 * time_resolution(times);
    const double largest = times.empty() ? 0.0 : std::max(-times.front(), times.back());
    decimals_ = decimals_within(resolution > 0.0 ? resolution : 1e-9 * largest, largest);
  }

  void value(JsonText& json, double time) const { json.exact(to_decimals(time, decimals_)); }
  void member(JsonText& json, std::string_view name, double time) const {
    json.key(name);
    value(json, time);
  }
  void member_if(JsonText& json, std::string_view name, const std::optional<double>& time) const {
    if (time) member(json, name, *time);
  }
  int decimals() const { return decimals_; }

 private:
  int decimals_ = 0;
};

/// A column of numbers that lie row after row.
std::vector<double> column_of(std::span<const double> rows, std::size_t columns, std::size_t c) {
  std::vector<double> numbers;
  numbers.reserve(columns == 0 ? 0 : rows.size() / columns);
  for (std::size_t i = c; i < rows.size(); i += columns) numbers.push_back(rows[i]);
  return numbers;
}
std::vector<double> column_of(const CaseReport& one, std::size_t c) {
  return column_of(one.drawn.rows.numbers, one.columns.size(), c);
}

/// Writes which rows of a thinned run there are, the extremes of its pieces, and its cycles.
void write_thinning(JsonText& json, const CaseReport& one) {
  const DrawnRows& drawn = one.drawn;
  const std::vector<double> index(drawn.rows.index.begin(), drawn.rows.index.end());
  json.member("index", packed_numbers(index, 0));
  json.key("pieces");
  json.begin_object();
  json.member("rows", drawn.piece);
  for (const auto& [name, rows] : {std::pair{"low", &drawn.low}, std::pair{"high", &drawn.high}}) {
    json.key(name);
    json.begin_array();
    for (std::size_t c = 0; c < one.columns.size(); ++c) {
      json.value(packed_series(column_of(*rows, one.columns.size(), c)));
    }
    json.end_array();
  }
  json.end_object();
  if (drawn.cycles.empty()) return;
  json.key("cycles");
  json.begin_object();
  json.member("of", one.columns[drawn.motion].name);
  json.member("total", drawn.cycles_total);
  json.key("drawn");
  json.begin_array();
  for (const DrawnCycle& cycle : drawn.cycles) {
    json.begin_array();
    json.value(cycle.number);
    json.value(static_cast<std::int64_t>(cycle.first));
    json.value(static_cast<std::int64_t>(cycle.last));
    json.end_array();
  }
  json.end_array();
  json.end_object();
}

void write_rows(JsonText& json, const CaseReport& one, const TimeText& time) {
  json.key("columns");
  json.begin_array();
  for (const ReportColumn& column : one.columns) {
    json.begin_object();
    json.member("name", column.name);
    json.member("unit", column.unit);
    json.member_if("text", column.text);
    json.end_object();
  }
  json.end_array();
  json.key("rows");
  json.begin_array();
  for (std::size_t c = 0; c < one.columns.size(); ++c) {
    const std::vector<double> numbers = column_of(one, c);
    json.value(c == 0 ? packed_numbers(numbers, time.decimals()) : packed_series(numbers));
  }
  json.end_array();
}

void write_definition(JsonText& json, const ReportDefinition& definition, const TimeText& time) {
  json.begin_object();
  json.member("name", definition.name);
  write_column(json, "force", definition.force);
  json.member_texts("forces", definition.forces);
  json.key("positions");
  json.begin_array();
  for (const std::string& position : definition.positions) {
    if (position.empty()) {
      json.null();
    } else {
      json.value(position);
    }
  }
  json.end_array();
  write_column(json, "limit", definition.limit);
  write_column(json, "limit_below", definition.limit_below);
  write_column(json, "status", definition.status);
  write_column(json, "normal_force", definition.normal_force);
  write_column(json, "mu", definition.mu);
  if (definition.filtered) json.member("filtered", true);
  if (definition.slip_share >= 0.0) json.member("slip_share", definition.slip_share);
  json.key("spans");
  json.begin_array();
  for (const results::RegimeSpan& span : definition.spans) {
    json.begin_array();
    time.value(json, span.from);
    time.value(json, span.to);
    json.value(std::int64_t{span.status});
    if (span.merged) json.value(true);
    json.end_array();
  }
  json.end_array();
  json.end_object();
}

void write_event(JsonText& json, const ReportEvent& event, const TimeText& time) {
  json.begin_object();
  time.member(json, "t", event.time);
  json.member("definition", event.definition);
  json.member("from", event.from);
  json.member("to", event.to);
  json.member("reversal", event.reversal);
  json.member("force", event.force);
  json.member("limit", event.limit);
  json.member("accumulated_slip", event.accumulated_slip);
  json.key("positions");
  json.begin_object();
  for (const auto& [name, value] : event.positions) json.member(name, value);
  json.end_object();
  json.end_object();
}

void write_visits(JsonText& json, std::span<const std::int64_t> visits) {
  json.begin_array();
  for (const std::int64_t count : visits) json.value(count);
  json.end_array();
}

void write_table(JsonText& json, const ReportTable& table) {
  json.begin_object();
  json.member("table", table.name);
  json.key("axes");
  json.begin_array();
  for (const ReportTable::Axis& axis : table.axes) {
    json.begin_object();
    json.member("name", axis.name);
    json.key("knots");
    json.series(axis.knots);
    json.member("below", axis.below);
    json.member("above", axis.above);
    json.end_object();
  }
  json.end_array();
  json.key("visits");
  if (table.visits.empty()) {
    json.null();
    json.key("marginals");
    json.begin_array();
    for (const ReportTable::Axis& axis : table.axes) write_visits(json, axis.visits);
    json.end_array();
  } else if (table.axes.size() == 1) {
    write_visits(json, table.visits);
  } else {
    const std::size_t across = table.axes[0].visits.size();
    json.begin_array();
    for (std::size_t i = 0; i < table.visits.size(); i += across) {
      write_visits(json, std::span(table.visits).subspan(i, across));
    }
    json.end_array();
  }
  json.member("increments", table.increments);
  json.member("outside", table.outside);
  json.member("coarser", table.coarser);
  json.end_object();
}

/// \param over_time whether x are times
/// \param thinned whether points were left out
void write_curve(JsonText& json, std::string_view name, const ReportCurve& curve, bool over_time,
                 bool thinned, const TimeText& time) {
  json.key(name);
  json.begin_object();
  json.member("x", over_time ? packed_numbers(curve.x, time.decimals()) : packed_series(curve.x));
  json.member("y", packed_series(curve.y));
  if (thinned) {
    const std::vector<double> index(curve.index.begin(), curve.index.end());
    json.member("index", packed_numbers(index, 0));
    json.member("piece", curve.piece);
    json.member("low", packed_series(curve.low));
    json.member("high", packed_series(curve.high));
  }
  json.end_object();
}

void write_measure(JsonText& json, const check::Measure& measure, const check::Verdict& verdict,
                   const TimeText& time) {
  json.begin_object();
  json.member("name", measure.name);
  json.member("unit", check::unit_of(measure, verdict));
  json.member("value", measure.value);
  json.member("reference", measure.reference);
  json.member("deviation", measure.deviation);
  json.member("tolerance", measure.tolerance);
  json.member("scale", measure.scale);
  json.member("passed", measure.passed());
  if (measure.where) {
    json.key("where");
    json.begin_object();
    time.member(json, "time", measure.where->time);
    json.key("abscissa");
    json.value(measure.where->abscissa, kMostDigits);
    json.member("value", measure.where->value);
    json.member("reference", measure.where->reference);
    json.end_object();
  }
  json.end_object();
}

void write_check(JsonText& json, const ReportCheck& check, const TimeText& time) {
  const check::Verdict& verdict = check.verdict;
  json.begin_object();
  json.member("name", verdict.name);
  json.member("criterion", check::info_of(verdict.criterion).word);
  json.member_if("quantity", check.quantity);
  json.member("unit", verdict.unit);
  json.member("passed", verdict.passed);
  json.member_if("message", verdict.message);
  json.member_if("likely_cause", verdict.likely_cause);
  json.member_texts("warnings", verdict.warnings);
  json.member("compared", verdict.compared);
  json.member("failing", verdict.failing);
  json.member("tolerance", verdict.tolerance);
  json.member("worst_fraction", verdict.worst_fraction());
  json.member_if("why", check.why);
  json.member_if("against", check.against);
  if (verdict.compared > 0) {
    json.key("worst");
    json.begin_object();
    time.member(json, "time", verdict.worst.time);
    json.key("abscissa");
    json.value(verdict.worst.abscissa, kMostDigits);
    json.member("value", verdict.worst.value);
    json.member("reference", verdict.worst.reference);
    json.end_object();
  }
  time.member_if(json, "first_failing", verdict.first_failing);
  time.member_if(json, "last_failing", verdict.last_failing);
  if (!verdict.measures.empty()) {
    json.key("measures");
    json.begin_array();
    for (const check::Measure& measure : verdict.measures)
      write_measure(json, measure, verdict, time);
    json.end_array();
  }
  if (!check.value.x.empty()) {
    json.key("trace");
    json.begin_object();
    json.member("abscissa", check.abscissa);
    json.member("abscissa_unit", check.abscissa_unit);
    const bool over_time = check.abscissa == "t";
    write_curve(json, "value", check.value, over_time, check.thinned, time);
    write_curve(json, "reference", check.reference, over_time, check.thinned, time);
    if (check.thinned && !check.difference.low.empty()) {
      json.member("difference_low", packed_series(check.difference.low));
      json.member("difference_high", packed_series(check.difference.high));
    }
    if (check.tube > 0.0) json.member("tube", check.tube);
    json.member("thinned", check.thinned);
    json.end_object();
  }
  json.end_object();
}

void write_run(JsonText& json, const WhatWasRun& run) {
  json.key("run");
  json.begin_object();
  json.key("facts");
  json.begin_array();
  for (const auto& [name, words] : run.facts) {
    json.begin_array();
    json.value(name);
    json.value(words);
    json.end_array();
  }
  json.end_array();
  json.key("tables");
  json.begin_array();
  for (const TextTable& table : run.tables) {
    json.begin_object();
    json.member("title", table.title);
    json.member_texts("head", table.head);
    json.key("rows");
    json.begin_array();
    for (const std::vector<std::string>& row : table.rows) {
      json.begin_array();
      for (const std::string& cell : row) json.value(cell);
      json.end_array();
    }
    json.end_array();
    json.member("left_out", static_cast<std::int64_t>(table.left_out));
    json.end_object();
  }
  json.end_array();
  json.member_if("text", run.text);
  json.end_object();
}

void write_case(JsonText& json, const CaseReport& one, const std::string& shown,
                const std::string& id) {
  const TimeText time(column_of(one, 0));
  json.begin_object();
  json.member("id", id);
  json.member("name", shown);
  json.member_if("title", one.title);
  json.member("kind", one.is_result ? "result" : "case");
  json.member("status", word_of(one.status));
  json.member_if("message", one.message);
  json.key("units");
  json.begin_object();
  for (const auto& [name, unit] : one.units) json.member(name, unit);
  json.end_object();
  json.key("parameters");
  json.begin_object();
  for (const auto& [name, number] : one.parameters) json.member(name, number);
  json.end_object();
  if (!one.run.facts.empty() || !one.run.text.empty()) write_run(json, one.run);
  json.member_texts("summary", one.summary);
  json.member_texts("warnings", one.warnings);
  json.member("increments", one.increments);
  json.member("details", one.has_details && !one.columns.empty());
  if (one.has_details && !one.columns.empty()) {
    json.member("rows_shown", static_cast<std::int64_t>(one.row_count()));
    json.member("rows_total", one.rows_total);
    json.member("thinned", one.drawn.thinned);
    write_rows(json, one, time);
    if (one.drawn.thinned) write_thinning(json, one);
    json.key("definitions");
    json.begin_array();
    for (const ReportDefinition& definition : one.definitions)
      write_definition(json, definition, time);
    json.end_array();
    json.key("events");
    json.begin_array();
    for (const ReportEvent& event : one.events) write_event(json, event, time);
    json.end_array();
    json.member("events_total", one.events_total);
    json.key("energy");
    json.begin_object();
    json.key("columns");
    json.begin_object();
    for (const auto& [kind, columns] : one.energies) json.member_texts(kind, columns);
    json.end_object();
    json.end_object();
    json.key("coverage");
    json.begin_array();
    for (const ReportTable& table : one.coverage) write_table(json, table);
    json.end_array();
  }
  json.key("checks");
  json.begin_array();
  for (const ReportCheck& check : one.checks) write_check(json, check, time);
  json.end_array();
  json.end_object();
}

/// Returns the cases' names for the page. It goes to other machines, so names that are whole paths
/// lose the folders they share.
std::vector<std::string> shown_names(std::span<const CaseReport> cases) {
  std::optional<fs::path> shared;
  for (const CaseReport& one : cases) {
    if (!fs::path(one.name).is_absolute()) continue;
    const fs::path folder = fs::path(one.name).parent_path();
    if (!shared) shared = folder;
    while (folder.lexically_relative(*shared).native().starts_with("..")) {
      shared = shared->parent_path();
    }
  }
  std::vector<std::string> names;
  for (const CaseReport& one : cases) {
    const fs::path path = one.name;
    names.push_back(path.is_absolute() ? path.lexically_relative(*shared).generic_string()
                                       : one.name);
  }
  return names;
}

/// Returns the names, each followed by a number where several cases have it.
std::vector<std::string> unique_ids(std::span<const std::string> names) {
  std::vector<std::string> ids;
  const std::set<std::string> taken(names.begin(), names.end());
  std::set<std::string> given;
  for (const std::string& name : names) {
    std::string id = name;
    for (int n = 2; given.contains(id) || (n > 2 && taken.contains(id)); ++n) {
      id = fmt::format("{} ({})", name, n);
    }
    given.insert(id);
    ids.push_back(std::move(id));
  }
  return ids;
}

/// Returns what two results have to share to be drawn in one picture: the force and motion of their
/// first definition.
std::string drawn_columns(const CaseReport& one) {
  if (!one.is_result || !one.has_details || one.definitions.empty()) return {};
  const ReportDefinition& first = one.definitions.front();
  return first.force + " " + (first.positions.empty() ? "" : first.positions.front());
}

/// Groups of two results and more that share what is drawn, in the order of their first ones.
std::vector<std::vector<std::string>> compared_groups(std::span<const CaseReport> cases,
                                                      std::span<const std::string> ids) {
  std::vector<std::string> keys;
  std::map<std::string, std::vector<std::string>> groups;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string key = drawn_columns(cases[i]);
    if (key.empty()) continue;
    if (!groups.contains(key)) keys.push_back(key);
    groups[key].push_back(ids[i]);
  }
  std::vector<std::vector<std::string>> result;
  for (const std::string& key : keys) {
    if (groups[key].size() > 1) result.push_back(groups[key]);
  }
  return result;
}

}  // namespace

std::string report_document(const ReportCollection& collection, const std::string& title) {
  const std::span<const CaseReport> cases = collection.cases();
  const std::vector<std::string> names = shown_names(cases);
  const std::vector<std::string> ids = unique_ids(names);
  const ReportTotals totals = collection.totals();
  JsonText json;
  json.begin_object();
  json.member("schema", std::int64_t{1});
  json.member("title", title);
  json.member("generator", "slipbench " + std::string(results::program_version()));
  json.key("totals");
  json.begin_object();
  for (const auto& [name, count] :
       {std::pair{"cases", totals.cases}, std::pair{"passed", totals.passed},
        std::pair{"failed", totals.failed}, std::pair{"not_run", totals.not_run},
        std::pair{"no_checks", totals.no_checks}, std::pair{"checks", totals.checks}}) {
    json.member(name, static_cast<std::int64_t>(count));
  }
  json.end_object();
  json.key("cases");
  json.begin_array();
  for (std::size_t i = 0; i < cases.size(); ++i) write_case(json, cases[i], names[i], ids[i]);
  json.end_array();
  json.key("compare");
  json.begin_array();
  for (const std::vector<std::string>& group : compared_groups(cases, ids)) {
    json.begin_array();
    for (const std::string& id : group) json.value(id);
    json.end_array();
  }
  json.end_array();
  json.end_object();
  return json.take();
}

}  // namespace slipbench::driver::report
