// SPDX-License-Identifier: Apache-2.0
#include "driver/report/read_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"
#include "driver/check/criteria/criteria.hpp"
#include "driver/report/collect.hpp"
#include "driver/report/drawn_columns.hpp"
#include "driver/report/row_choice.hpp"
#include "driver/results/regime_history.hpp"
#include "driver/results/result_layout.hpp"
#include "driver/results/run_files.hpp"
#include "driver/results/summary.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::report {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& result, const char* extension) {
  return fs::path(result).replace_extension(extension);
}

std::optional<double> number_of(const yaml::Node& node) {
  if (!node.is_scalar()) return std::nullopt;
  const auto number = base::parse_number(node.text());
  return number ? std::optional(*number) : std::nullopt;
}

std::optional<double> number_in(const yaml::Node& node, std::string_view name) {
  const auto member = node.find(name);
  return member ? number_of(*member) : std::nullopt;
}

double number_or_nan(const yaml::Node& node, std::string_view name) {
  return number_in(node, name).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::int64_t count_in(const yaml::Node& node, std::string_view name) {
  return static_cast<std::int64_t>(std::llround(number_in(node, name).value_or(0.0)));
}

std::string text_in(const yaml::Node& node, std::string_view name) {
  const auto member = node.find(name);
  return member && member->is_scalar() ? std::string(member->text()) : std::string();
}

std::vector<std::string> texts_in(const yaml::Node& node, std::string_view name) {
  std::vector<std::string> texts;
  if (const auto list = node.find(name)) {
    for (const yaml::Node item : list->items()) texts.emplace_back(item.text());
  }
  return texts;
}

/// Returns what the unit of a measure's number is, told by its text; keeps the text in the verdict.
check::MeasureUnit measure_unit(const std::string& unit, check::Verdict& verdict) {
  if (unit.empty()) return check::MeasureUnit::kNone;
  if (unit == verdict.unit) return check::MeasureUnit::kQuantity;
  if (verdict.abscissa.ends_with("[" + unit + "]")) {
    verdict.abscissa_unit = unit;
    return check::MeasureUnit::kAbscissa;
  }
  verdict.product_unit = unit;
  return check::MeasureUnit::kProduct;
}

check::Measure read_measure(const yaml::Node& node, check::Verdict& verdict) {
  check::Measure measure;
  measure.name = text_in(node, "name");
  measure.unit = measure_unit(text_in(node, "unit"), verdict);
  measure.value = number_or_nan(node, "value");
  measure.reference = number_or_nan(node, "reference");
  measure.deviation = number_or_nan(node, "deviation");
  measure.scale = number_or_nan(node, "scale");
  // A measure that is only reported has an infinite tolerance, which JSON has no number for.
  measure.tolerance =
      number_in(node, "tolerance").value_or(std::numeric_limits<double>::infinity());
  if (const auto where = node.find("where"); where && where->is_map()) {
    measure.where = {number_or_nan(*where, "abscissa"), number_or_nan(*where, "value"),
                     number_or_nan(*where, "reference"), number_or_nan(*where, "time")};
  }
  return measure;
}

ReportCheck read_check(const yaml::Node& node) {
  ReportCheck check;
  check::Verdict& verdict = check.verdict;
  verdict.name = text_in(node, "name");
  const std::string criterion = text_in(node, "criterion");
  for (std::size_t i = 0; i < check::kCriteria.size(); ++i) {
    if (check::kCriteria[i].word == criterion) verdict.criterion = static_cast<cases::Criterion>(i);
  }
  verdict.passed = text_in(node, "passed") == "true";
  verdict.message = text_in(node, "message");
  verdict.likely_cause = text_in(node, "likely_cause");
  verdict.warnings = texts_in(node, "warnings");
  verdict.unit = text_in(node, "unit");
  verdict.abscissa = text_in(node, "abscissa");
  verdict.compared = count_in(node, "compared");
  verdict.failing = count_in(node, "failing");
  verdict.tolerance = number_or_nan(node, "tolerance");
  verdict.scale = number_or_nan(node, "scale");
  verdict.worst = {number_or_nan(node, "worst_time"), number_or_nan(node, "worst_value"),
                   number_or_nan(node, "worst_reference"), number_or_nan(node, "worst_abscissa")};
  verdict.first_failing = number_in(node, "first_failing");
  verdict.last_failing = number_in(node, "last_failing");
  if (const auto measures = node.find("measures")) {
    for (const yaml::Node measure : measures->items()) {
      verdict.measures.push_back(read_measure(measure, verdict));
    }
  }
  return check;
}

/// "slips 62 % of the time, 8 stick-slip events" and the range of the force, as `run` tells it.
std::string summary_line(const yaml::Node& node, bool several, double duration,
                         const std::string& force, const base::UnitSystem& units) {
  const double slip = number_in(node, "slip_time").value_or(0.0);
  const std::int64_t events = count_in(node, "stick_slip_events");
  return fmt::format(
      "{}slips {:.0f} % of the time, {} stick-slip event{}; friction {} .. {}, dissipated {}",
      several ? text_in(node, "name") + ": " : "", duration > 0.0 ? 100.0 * slip / duration : 0.0,
      events, events == 1 ? "" : "s", base::rounded(number_in(node, "lowest_force").value_or(0.0)),
      base::with_unit(base::rounded(number_in(node, "highest_force").value_or(0.0)), force),
      base::energy_text(number_in(node, "dissipation").value_or(0.0), units));
}

const ReportColumn* find(const CaseReport& report, const std::string& name) {
  const auto found = std::find_if(report.columns.begin(), report.columns.end(),
                                  [&](const ReportColumn& column) { return column.name == name; });
  return found == report.columns.end() ? nullptr : &*found;
}

/// Reason not to show a file that a killed program left beside a result, or a user brought there.
constexpr const char* kOtherRun = "it is of another run than the rows";

/// A file beside a result that is there but tells nothing must not look like one that is missing.
void warn_of(const fs::path& file, const std::string& why, const char* lost, CaseReport& report) {
  report.warnings.push_back(
      fmt::format("{} is not shown ({}): {}", file.filename().string(), why, lost));
}

/// Tells whether a JSON is of the run that rows with these lines are of: of its case, with its
/// parameters. One without an origin may be.
bool is_of_run(const yaml::Node& root, const std::set<std::string>& lines,
               const CaseReport& report) {
  const auto origin = root.find("provenance");
  if (!origin || !origin->is_map()) return true;
  const std::string line = "# case: " + base::printable(text_in(*origin, "case"));
  std::map<std::string_view, std::optional<double>> numbers;
  if (const auto parameters = origin->find("parameters"); parameters && parameters->is_map()) {
    for (const yaml::Entry one : parameters->entries()) {
      numbers.emplace(one.key.text(), number_of(one.value));
    }
  }
  return lines.contains(base::in_cells(line)) &&
         std::all_of(report.parameters.begin(), report.parameters.end(), [&](const auto& one) {
           const auto number = numbers.find(one.first);
           return number != numbers.end() && number->second == one.second;
         });
}

/// Statements of a JSON on the files beside it.
struct Written {
  std::optional<std::int64_t> rows;  ///< how many were written
  bool events = true;                ///< no other run's than the rows, as far as it knows
};

/// Takes what the JSON beside a result tells; one that is missing tells nothing, and one that is
/// broken, or of another run, is warned of.
Written add_summary(const fs::path& result, const base::UnitSystem& units,
                    const std::set<std::string>& lines, CaseReport& report) {
  constexpr const char* kLost = "the verdicts of the checks are unknown";
  const fs::path file = beside(result, ".json");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  // JSON is YAML; the reader of cases is strict and has its limits.
  const auto source = base::read_source(file.string());
  if (!source) {
    warn_of(file, source.error().diagnostic.message, kLost, report);
    return {};
  }
  const auto tree = yaml::parse_yaml(*source);
  if (!tree) {
    const auto faults = tree.error().sorted();
    warn_of(file, faults.empty() ? "no JSON" : faults.front().message, kLost, report);
    return {};
  }
  const yaml::Node root = tree->root();
  const bool listed = results::is_listed(root, result);
  Written written{{}, listed && results::is_listed(root, beside(result, ".events.csv"))};
  const bool of_case = is_of_run(root, lines, report);
  if (of_case && number_in(root, "rows")) written.rows = count_in(root, "rows");
  if (!of_case || !listed) {
    warn_of(file, kOtherRun, kLost, report);
    return written;
  }
  if (const auto summary = root.find("summary")) {
    const double duration = number_in(*summary, "end_time").value_or(0.0) -
                            number_in(*summary, "start_time").value_or(0.0);
    if (const auto count = number_in(*summary, "increments")) {
      report.increments = static_cast<std::int64_t>(std::llround(*count));
    }
    const auto list = summary->find("definitions");
    std::map<std::string_view, ReportDefinition*> untold;
    for (ReportDefinition& one : report.definitions) untold.emplace(one.name, &one);
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      const yaml::Node node = (*list)[i];
      const auto own = untold.find(text_in(node, "name"));
      if (own == untold.end()) continue;
      ReportDefinition& definition = *own->second;
      untold.erase(own);
      const auto slip = number_in(node, "slip_time");
      if (slip && duration > 0.0) definition.slip_share = *slip / duration;
      const ReportColumn* force = find(report, definition.force);
      report.summary.push_back(summary_line(node, list->size() > 1, duration,
                                            force == nullptr ? "" : force->unit, units));
    }
  }
  for (std::string& warning : texts_in(root, "warnings")) {
    report.warnings.push_back(std::move(warning));
  }
  if (const auto checks = root.find("checks")) {
    for (const yaml::Node check : checks->items()) report.checks.push_back(read_check(check));
  }
  if (report.checks.empty()) return written;
  const bool passed = std::all_of(report.checks.begin(), report.checks.end(),
                                  [](const ReportCheck& check) { return check.verdict.passed; });
  report.status = passed ? ReportStatus::kPassed : ReportStatus::kFailed;
  return written;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find(',');
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// Takes the events beside a result, if they are of its run; lines that are none are passed over.
void add_events(const fs::path& file, bool of_run, const std::set<std::string>& lines,
                CaseReport& report) {
  constexpr const char* kNoEvents = "there is no list of events";
  constexpr std::size_t kFirstPosition = 7;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return;
  if (!of_run) {
    warn_of(file, kOtherRun, kNoEvents, report);
    return;
  }
  std::ifstream in(file);
  std::string line;
  std::vector<std::string> header;
  ReportEvents events;
  while (std::getline(in, line)) {
    if (in.eof()) {
      warn_of(file, "it is cut off", kNoEvents, report);
      return;
    }
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with('#')) {
      if (lines.contains(line)) continue;
      warn_of(file, kOtherRun, kNoEvents, report);
      return;
    }
    const std::vector<std::string_view> fields = fields_of(line);
    if (header.empty()) {
      if (!line.starts_with("t,definition,from,to,force,limit,accumulated_slip")) {
        warn_of(file, "it is no list of events", kNoEvents, report);
        return;
      }
      header.assign(fields.begin(), fields.end());
      continue;
    }
    if (fields.size() != header.size()) continue;
    const auto number = [&](std::size_t i) {
      return base::parse_number(fields[i]).value_or(std::numeric_limits<double>::quiet_NaN());
    };
    ReportEvent event{number(0),
                      std::string(fields[1]),
                      std::string(fields[2]),
                      std::string(fields[3]),
                      fields[2] == fields[3],
                      number(4),
                      number(5),
                      number(6),
                      {}};
    for (std::size_t i = kFirstPosition; i < header.size(); ++i) {
      event.positions.emplace_back(header[i], number(i));
    }
    events.add(std::move(event));
  }
  report.events_total = events.total();
  report.events = events.take();
}

ReadResult unreadable(const std::string& name, const base::HistoryError& error) {
  std::string place = error.file;
  if (error.line > 0) place += fmt::format(":{}", error.line);
  ReadResult result;
  result.report = not_run_report(name, "", place + ": error: " + error.message + "\n");
  result.report.is_result = true;
  result.code = error.kind == base::HistoryError::Kind::kEnvironment ? base::kExitEnvironment
                                                                     : base::kExitBadInput;
  return result;
}

}  // namespace

ReadResult read_result(const std::string& path, const std::string& name, std::size_t most_rows) {
  auto opened = base::CsvReader::open(path, std::vector<std::string>{"t"});
  if (!opened) return unreadable(name, opened.error());
  const results::ResultLayout layout = results::read_layout(path, opened->header());
  if (std::string fault = results::result_fault(layout, path); !fault.empty()) {
    return unreadable(name, {base::HistoryError::Kind::kInput, path, 0, 0, std::move(fault)});
  }
  DrawnColumns drawn = drawn_columns(layout);
  if (drawn.definitions.empty()) {
    return unreadable(name, {base::HistoryError::Kind::kInput, path, 0, 0,
                             "has no friction force to draw (a result of 'slipbench run' has a "
                             "line '# friction:')"});
  }
  auto reader = base::CsvReader::open(path, drawn.names);
  if (!reader) return unreadable(name, reader.error());

  ReadResult result;
  CaseReport& report = result.report;
  report.name = name;
  report.title = layout.title;
  report.is_result = true;
  report.units = layout.units;
  for (const std::string& column : drawn.names) {
    const auto unit = layout.column_units.find(column);
    report.columns.push_back({column, unit == layout.column_units.end() ? "" : unit->second, ""});
  }
  for (const auto& [parameter, text] : layout.parameters) {
    if (const auto number = base::parse_number(text))
      report.parameters.emplace_back(parameter, *number);
  }
  report.definitions = std::move(drawn.definitions);
  report.energies = std::move(drawn.energies);

  base::UnitSystem units;
  for (const auto& [what, unit] : layout.units) {
    if (what == "length") units.length = unit;
    if (what == "force") units.force = unit;
  }
  report.units.emplace_back("energy", base::energy_unit(units));
  use_energy_unit(report, base::energy_unit(units));
  const auto comments = base::comment_lines(path);
  const std::set<std::string> lines(comments.begin(), comments.end());
  const Written written = add_summary(path, units, lines, report);
  add_events(beside(path, ".events.csv"), written.events, lines, report);

  std::vector<std::size_t> status;  // of each definition, its column; the number of columns if none
  for (const ReportDefinition& definition : report.definitions) {
    status.push_back(static_cast<std::size_t>(
        std::find(drawn.names.begin(), drawn.names.end(), definition.status) -
        drawn.names.begin()));
  }
  RowChoice rows(drawn.names.size(), most_rows, drawn.motions);
  RowsAtTimes worst(worst_times(report));
  std::vector<results::RegimeSpans> spans(report.definitions.size());
  std::vector<double> row(drawn.names.size());
  std::vector<double> before(drawn.names.size());
  bool changed = false;
  const auto regime_changes = [&] {
    return std::any_of(status.begin(), status.end(), [&](std::size_t column) {
      return column < row.size() && row[column] != before[column];
    });
  };
  for (std::int64_t count = 0;; ++count) {
    auto more = reader->next(row);
    if (!more) return unreadable(name, more.error());
    const bool changes = *more && count > 0 && regime_changes();
    if (count > 0) rows.add(before, changed || changes);
    if (!*more) break;
    worst.add(row);
    changed = changes;
    for (std::size_t d = 0; d < spans.size() && count > 0; ++d) {
      if (status[d] >= row.size()) continue;
      const auto regime = results::regime_of(row[status[d]]);
      if (!regime) {
        return unreadable(name,
                          reader->error_here(results::no_regime(row[status[d]], row[0])).value());
      }
      spans[d].add(*regime, before[0], row[0]);
    }
    before = row;
  }
  report.rows_total = rows.count();
  if (written.rows && *written.rows != rows.count()) {
    return unreadable(
        name, {base::HistoryError::Kind::kInput, path, 0, 0,
               fmt::format(
                   "its rows are {} in number, and {} were written with {}: it is cut off, edited, "
                   "or of another run; run the case again",
                   rows.count(), *written.rows, beside(path, ".json").filename().string())});
  }
  report.drawn = rows.finish(worst.rows());
  if (report.increments == 0) report.increments = std::max<std::int64_t>(rows.count() - 1, 0);
  for (std::size_t d = 0; d < spans.size(); ++d) report.definitions[d].spans = spans[d].spans();
  return result;
}

}  // namespace slipbench::driver::report
