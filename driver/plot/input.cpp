// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/input.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/plot/loops.hpp"
#include "driver/plot/result_regimes.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/row_writer.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::plot {
namespace fs = std::filesystem;
namespace {

/// Runs a case and writes its rows to `rows`.
tl::expected<void, PlotFailure> write_rows(const cases::Case& problem, const fs::path& picture,
                                           std::optional<base::OutputFile>& rows,
                                           CaseRegimes& regimes) {
  auto created = base::OutputFile::create(fs::path(picture).concat(".rows"), {}, base::kNeverNamed);
  if (!created) return failed(base::kExitEnvironment, created.error());
  rows.emplace(std::move(*created));
  auto writer = results::RowWriter::create(problem, results::result_columns(problem),
                                           table::TableFormat::kCsv, *rows);
  if (!writer) return failed(base::kExitEnvironment, writer.error());
  auto ended = follow_for_plot(problem, [&](const bench::Simulation& simulation) {
    (*writer)->write(simulation.row());
    regimes.add(simulation.row());
  });
  if (!ended) return ended;
  auto closed = (*writer)->finish();
  if (closed) closed = rows->close();
  if (!closed) return failed(base::kExitEnvironment, closed.error());
  return {};
}

}  // namespace

tl::unexpected<PlotFailure> unreadable(const std::string& shown_name,
                                       const base::HistoryError& error) {
  const bool input = error.kind == base::HistoryError::Kind::kInput;
  const std::string line = error.line > 0 ? fmt::format(":{}", error.line) : "";
  return failed(input ? base::kExitBadInput : base::kExitEnvironment,
                fmt::format("{}{}: {}", shown_name, line, error.message));
}

bool is_result(const PlotOptions& options) { return fs::path(options.input).extension() == ".csv"; }

tl::expected<cases::Case, PlotFailure> read_for_plot(const PlotOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return failed(base::kExitBadInput, settings.error());
  read::ReadCase read = read::read_case(options.input, {*settings, options.allow_outside});
  if (!read.value || read.diagnostics.has_errors()) {
    return tl::unexpected(
        PlotFailure{read.environment_failure ? base::kExitEnvironment : base::kExitBadInput,
                    base::render(read.diagnostics, read.sources) + base::summary(read.diagnostics) +
                        ", nothing was drawn\n"});
  }
  return std::move(*read.value);
}

tl::expected<void, PlotFailure> follow_for_plot(
    const cases::Case& problem, const std::function<void(const bench::Simulation&)>& take) {
  const auto ended = [&] {
    terminal::Progress progress(results::case_stem(problem));
    return bench::follow_case(problem, [&](const bench::Simulation& simulation) {
      take(simulation);
      progress.step(simulation.row().index, simulation.row().time);
    });
  }();
  if (!ended) {
    return tl::unexpected(
        PlotFailure{bench::exit_code(ended.error()), bench::failure_text(problem, ended.error())});
  }
  return {};
}

std::string picture_title(const cases::Case& problem) {
  return problem.title.empty() ? results::case_stem(problem) : problem.title;
}

tl::expected<ResultRows, PlotFailure> rows_for_plot(const PlotOptions& options,
                                                    const fs::path& picture) {
  ResultRows rows;
  rows.file = options.input;
  rows.shown_name = options.input;
  if (is_result(options)) return rows;
  auto read = read_for_plot(options);
  if (!read) return tl::unexpected(std::move(read.error()));
  rows.problem = std::make_unique<cases::Case>(std::move(*read));
  rows.regimes = std::make_unique<CaseRegimes>(*rows.problem);
  if (auto written = write_rows(*rows.problem, picture, rows.temporary, *rows.regimes); !written) {
    return tl::unexpected(std::move(written.error()));
  }
  rows.file = rows.temporary->temporary();
  return rows;
}

tl::expected<results::PlotData, PlotFailure> result_for_plot(const PlotOptions& options,
                                                             const fs::path& picture,
                                                             results::PlotDetail detail,
                                                             WithLoops loops) {
  const auto rows = rows_for_plot(options, picture);
  if (!rows) return tl::unexpected(rows.error());
  auto data = results::read_plot_data(rows->file, options.input, detail);
  if (!data) return unreadable(options.input, data.error());
  if (rows->regimes) {
    rows->regimes->finish(*data);
  } else {
    take_events_beside(rows->file, *data);
  }
  if (loops == WithLoops::kYes) {
    if (auto added = add_loops(*data, rows->file, options.input); !added) {
      return unreadable(options.input, added.error());
    }
  }
  if (rows->problem) data->title = picture_title(*rows->problem);
  if (data->title.empty()) data->title = rows->file.stem().string();
  return std::move(*data);
}

}  // namespace slipbench::driver::plot
