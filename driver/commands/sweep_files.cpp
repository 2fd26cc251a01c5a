// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/sweep_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/sweep/journal.hpp"
#include "driver/sweep/read_sweep.hpp"
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
  OpenSweep open{std::move(*read.value), std::move(read.data_files), {}};
  open.inputs.push_back(file);
  open.inputs.push_back(open.sweep.case_path);
  open.identity = sweep::identity_of(open.sweep, open.inputs);
  return open;
}

tl::expected<std::unique_ptr<SweepResult>, std::string> SweepResult::create(
    const OpenSweep& open, const SweepResultOptions& options) {
  std::unique_ptr<SweepResult> result(
      new SweepResult(open, sweep::result_name(open.sweep, options.part)));
  if (open.sweep.sobol_indices && !options.part) result->indices_.emplace(open.sweep);
  if (options.no_output) return result;
  const std::string file = sweep::file_name(open.sweep);
  const base::FileMark mark{"a result of " + file, "# slipbench ", "\n# sweep: " + file + "\n",
                            true};
  if (result->indices_) {
    auto indices = base::OutputFile::create(options.folder / (result->name_ + ".indices.csv"), mark,
                                            {open.inputs, options.force});
    if (!indices) return tl::unexpected(indices.error());
    result->indices_file_.emplace(std::move(*indices));
  }
  const table::TableFormat format = *table::format_named(options.format);
  table::TableHead head = sweep::rows_head(open.sweep, open.identity, options.part);
  auto made =
      base::OutputFile::create(options.folder / (result->name_ + "." + options.format),
                               table::mark_of(format, head, mark), {open.inputs, options.force});
  if (!made) return tl::unexpected(made.error());
  result->file_.emplace(std::move(*made));
  auto rows = table::TableWriter::create(format, std::move(head), *result->file_);
  if (!rows) return tl::unexpected(rows.error());
  result->rows_.emplace(std::move(*rows));
  return result;
}

void SweepResult::take(const sweep::SampleOutcome& outcome) {
  ++samples_;
  summary_.add(outcome);
  if (indices_) indices_->add(outcome);
  if (!rows_) return;
  row_.assign(1, static_cast<double>(outcome.id));
  row_.insert(row_.end(), outcome.values.begin(), outcome.values.end());
  row_.insert(row_.end(), outcome.numbers.begin(), outcome.numbers.end());
  rows_->write(row_);
}

int SweepResult::finish(const std::string& how) {
  std::string text = fmt::format(
      "{}: {} samples of {}, {}\n{}", base::printable(name_), samples_,
      base::printable(fs::path(open_->sweep.case_path).filename().string()), how, summary_.text());
  if (indices_) text += indices_->text();
  if (file_) {
    std::vector<base::OutputFile*> files{&*file_};
    if (indices_file_) {
      indices_file_->append(indices_->csv());
      files.push_back(&*indices_file_);
    }
    if (auto finished = rows_->finish(); !finished) {
      return terminal::refuse(base::kExitEnvironment, finished.error());
    }
    if (auto committed = base::commit(files); !committed) {
      return terminal::refuse(base::kExitEnvironment, committed.error());
    }
    for (const base::OutputFile* one : files) {
      text += "  " + one->target().lexically_normal().string() + "\n";
    }
  }
  terminal::print(text);
  return summary_.failed() > 0 ? base::kExitNumerical : base::kExitOk;
}

}  // namespace slipbench::driver::commands
