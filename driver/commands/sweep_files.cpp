// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/sweep_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/results/provenance.hpp"
#include "driver/sweep/journal.hpp"
#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/report/sweep_page.hpp"
#include "driver/sweep/rows.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace fs = std::filesystem;

tl::expected<OpenSweep, int> open_sweep(const std::string& file,
                                        const std::vector<std::string>& settings,
                                        bool allow_outside) {
  const auto parsed = base::parse_settings(settings);
  if (!parsed) return tl::unexpected(terminal::refuse(base::kExitBadInput, parsed.error()));
  sweep::ReadSweep read = sweep::read_sweep(file, {*parsed, allow_outside});
  if (!read.value) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was run\n");
    return tl::unexpected(
        static_cast<int>(read.environment_failure ? base::kExitEnvironment : base::kExitBadInput));
  }
  if (!read.diagnostics.empty()) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
  }
  OpenSweep open{std::move(*read.value), std::move(read.data_files), {}};
  open.inputs.push_back(file);
  open.inputs.push_back(open.sweep.case_path);
  open.identity = sweep::identity_of(open.sweep, open.inputs);
  return open;
}

namespace {

/// The first members of the summary, by which it is known.
base::json::Value origin_of(const sweep::Sweep& sweep) {
  base::json::Value document;
  document["program"] = "slipbench";
  document["version"] = results::program_version();
  document["sweep"] = sweep::file_name(sweep);
  document["title"] = sweep.title;
  if (!sweep.settings.empty()) document["set"] = base::printable(sweep::settings_text(sweep));
  return document;
}

std::string json_text(const sweep::Sweep& sweep, const sweep::SweepSummary& summary) {
  base::json::Value document = origin_of(sweep);
  document["summary"] = summary.to_json();
  return document.dump(2) + "\n";
}

base::FileMark json_mark(const sweep::Sweep& sweep) {
  const std::string file = sweep::file_name(sweep);
  return {"a summary of " + file, "{\n  \"program\": \"slipbench\",",
          "\"sweep\": " + base::json::Value(file).dump() + ","};
}

}  // namespace

tl::expected<std::unique_ptr<SweepResult>, std::string> SweepResult::create(
    const OpenSweep& open, const SweepResultOptions& options) {
  std::unique_ptr<SweepResult> result(
      new SweepResult(open, sweep::result_name(open.sweep, options.part)));
  if (options.part) result->tally_.indices.reset();
  if (options.no_output) return result;
  const std::string file = sweep::file_name(open.sweep);
  const base::FileMark mark{"a result of " + file, "# slipbench ",
                            "\n# sweep: " + base::in_cells(file) + "\n", true};
  const base::Overwriting overwriting{open.inputs, options.force};
  // Makes one file; a sentence if it cannot be made.
  const auto make = [&](const fs::path& path, const base::FileMark& own,
                        std::optional<base::OutputFile>& target) -> std::string {
    auto made = base::OutputFile::create(path, own, overwriting);
    if (!made) return made.error();
    target.emplace(std::move(*made));
    return {};
  };
  std::string fault;
  if (result->tally_.indices) {
    fault = make(options.folder / (result->name_ + ".indices.csv"), mark, result->indices_file_);
  }
  if (fault.empty() && !options.part) {
    fault = make(options.folder / (result->name_ + ".json"), json_mark(open.sweep),
                 result->summary_file_);
  }
  if (fault.empty() && !options.report.empty()) {
    fault = make(options.report, sweep::sweep_page_mark(open.sweep), result->page_file_);
  }
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  if (options.no_rows) return result;
  const table::TableFormat format = *table::format_named(options.format);
  table::TableHead head = sweep::rows_head(open.sweep, open.identity, options.part);
  fault = make(options.folder / (result->name_ + "." + options.format),
               table::mark_of(format, head, mark), result->file_);
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  auto rows = table::TableWriter::create(format, std::move(head), *result->file_);
  if (!rows) return tl::unexpected(rows.error());
  result->rows_.emplace(std::move(*rows));
  return result;
}

void SweepResult::take(const sweep::SampleOutcome& outcome) {
  tally_.add(outcome);
  if (!rows_) return;
  row_.assign(1, static_cast<double>(outcome.id));
  row_.insert(row_.end(), outcome.values.begin(), outcome.values.end());
  row_.insert(row_.end(), outcome.numbers.begin(), outcome.numbers.end());
  rows_->write(row_);
}

int SweepResult::finish(const std::string& how, const fs::path& also) {
  const sweep::SweepSummary& summary = tally_.summary;
  std::string text = fmt::format(
      "{}: {} samples of {}, {}\n{}", base::printable(name_), summary.samples(),
      base::printable(fs::path(open_->sweep.case_path).filename().string()), how, summary.text());
  if (tally_.indices) text += tally_.indices->text();
  std::vector<base::OutputFile*> files;
  const auto add = [&](std::optional<base::OutputFile>& file, const auto& content) {
    if (!file) return;
    file->append(content());
    files.push_back(&*file);
  };
  if (file_) files.push_back(&*file_);
  add(indices_file_, [&] { return tally_.indices->csv(); });
  add(summary_file_, [&] { return json_text(open_->sweep, summary); });
  add(page_file_,
      [&] { return sweep::sweep_page(open_->sweep, summary, tally_.indices, tally_.kept); });
  auto completed = rows_ ? rows_->finish() : tl::expected<void, std::string>();
  if (completed) completed = base::commit(files);
  if (!completed) return terminal::refuse(base::kExitEnvironment, completed.error());
  for (const base::OutputFile* one : files) {
    text += "  " + one->target().lexically_normal().string() + "\n";
  }
  if (!also.empty()) text += "  " + also.lexically_normal().string() + "\n";
  terminal::print(text);
  return summary.failed() > 0 ? base::kExitNumerical : base::kExitOk;
}

}  // namespace slipbench::driver::commands
