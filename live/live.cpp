// SPDX-License-Identifier: Apache-2.0
// The functions that a page calls. What they return stays until the next call.
#include <charconv>
#include <string>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/json.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/read_case.hpp"
#include "driver/report/report.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/row_writer.hpp"
#include "driver/suite/check_case.hpp"

namespace {

using namespace slipbench::driver;
using base::json::Value;

constexpr const char* kFolder = ".";  // where the page puts data files

Value messages(const base::Diagnostics& diagnostics) {
  constexpr const char* kWords[] = {"error", "warning", "note"};
  Value all = base::json::Array{};
  for (const base::Diagnostic& one : diagnostics.sorted()) {
    Value message;
    message["severity"] = kWords[static_cast<std::size_t>(one.severity)];
    message["file"] = one.file;
    message["line"] = one.where.line;
    message["column"] = one.where.column;
    message["length"] = one.where.length;
    message["path"] = one.path;
    message["message"] = one.message;
    message["hint"] = one.hint;
    all.push_back(std::move(message));
  }
  return all;
}

/// Lists the parameters that are plain numbers, and where the text has them.
Value parameters(const base::SourceText& source) {
  Value all = base::json::Array{};
  const auto parsed = read::ParsedCase::parse(source, kFolder);
  const auto map = parsed ? parsed->root().find("parameters") : std::nullopt;
  if (!map) return all;
  for (const auto& [key, node] : map->entries()) {
    double value = 0.0;
    const std::string_view text = node.text();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (!node.is_scalar() || node.quoted() || error != std::errc{} ||
        end != text.data() + text.size()) {
      continue;
    }
    Value one;
    one["name"] = key.text();
    one["value"] = value;
    one["line"] = node.where().line;
    one["column"] = node.where().column;
    one["length"] = text.size();
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

extern "C" {

/// Makes no file: standard input, which is kept in such a one, is nothing that a page has.
int memfd_create(const char*, unsigned) { return -1; }

/// Reads and runs a case: {"messages": .., "parameters": .., "document": that of a report}.
const char* slipbench_run(const char* name, const char* text) {
  static std::string answer;
  const base::SourceText source(name, text);
  suite::Reading reading;
  reading.read = read::read_case_text(source, kFolder);
  Value around;
  around["messages"] = messages(reading.read->diagnostics);
  around["parameters"] = parameters(source);
  report::ReportCollection collection(1);
  suite::CheckCaseOptions options;
  options.report = [&](report::CaseReport&& report) { collection.put(0, std::move(report)); };
  suite::check_case({name, name}, reading, options);
  answer = around.dump();
  answer.back() = ',';
  answer += "\"document\":" + report::report_document(collection, name) + "}";
  return answer.c_str();
}

/// Returns the rows of a case as `slipbench run` writes them; nothing for one that does not run.
const char* slipbench_csv(const char* name, const char* text) {
  static std::string rows;
  rows.clear();
  const auto read = read::read_case_text(base::SourceText(name, text), kFolder);
  if (!read.value) return rows.c_str();
  const cases::Case& problem = *read.value;
  const std::vector<results::Column> columns = results::output_columns(problem);
  rows = table::csv_head(results::row_head(problem, columns));
  std::vector<double> numbers(columns.size());
  bench::Row last;
  const auto put = [&](const bench::Row& row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      numbers[c] = results::column_value(columns[c], problem, row);
    }
    base::append_numbers(rows, numbers);
    rows.back() = '\n';
  };
  const auto ended = bench::run_in_blocks(problem, [&](std::span<const bench::Row> block) {
    for (const bench::Row& row : block) {
      if (row.index % problem.output_every == 0) put(row);
    }
    last = block.back();
  });
  if (!ended) rows.clear();
  // The end of the run is always in the result.
  if (ended && last.index % problem.output_every != 0) put(last);
  return rows.c_str();
}

/// Returns the JSON schema of cases.
const char* slipbench_schema() {
  static const std::string schema = read::case_schema().dump();
  return schema.c_str();
}

}  // extern "C"
