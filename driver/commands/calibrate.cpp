// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/calibrate.hpp"

#include <fmt/format.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/shell_word.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/calibrate/calibrate.hpp"
#include "driver/calibrate/calibrated_case.hpp"
#include "driver/calibrate/calibration_json.hpp"
#include "driver/calibrate/fit_summary.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "driver/calibrate/report/fit_pictures.hpp"
#include "driver/calibrate/report/fit_report.hpp"
#include "driver/case/input_files.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/plot/picture_mark.hpp"
#include "driver/report/page.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// A fit takes and gives back the same megabytes many times over. What was given back stays with
/// the process: the system hands out new pages more slowly than the law fills them.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kLargest = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, 4 * kLargest);
#endif
}

std::string stem_of(const calibrate::Fit& fit) { return fs::path(fit.file).stem().string(); }

std::string file_name(const calibrate::Fit& fit) { return fs::path(fit.file).filename().string(); }

std::string shown(const fs::path& path) { return path.lexically_normal().string(); }

/// The notes, each with its file.
std::string remarks(const base::Diagnostics& diagnostics) {
  std::string text;
  for (const base::Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity != base::Severity::kNote) continue;
    text += fmt::format("  note: {}: {}{}{}{}{}\n", diagnostic.file, diagnostic.path,
                        diagnostic.path.empty() ? "" : ": ", diagnostic.message,
                        diagnostic.hint.empty() ? "" : "; ", diagnostic.hint);
  }
  return text;
}

base::Diagnostics warnings_of(const base::Diagnostics& diagnostics) {
  base::Diagnostics warnings;
  for (base::Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity == base::Severity::kWarning) warnings.add(std::move(diagnostic));
  }
  return warnings;
}

/// Files written, and the words about them.
struct Written {
  std::vector<fs::path> files;
  std::vector<std::string> remarks;
};

/// Numbers, cases and the page, all or none of them; then pictures, as many as can be drawn.
tl::expected<Written, std::string> write_results(const calibrate::Fit& fit,
                                                 const calibrate::Calibration& calibration,
                                                 const CalibrateOptions& options,
                                                 const fs::path& page,
                                                 const base::Overwriting& overwriting) {
  Written written;
  const fs::path folder = options.folder;
  std::vector<base::OutputFile> files;
  const auto add = [&](const fs::path& target, const base::FileMark& mark,
                       const std::string& text) -> tl::expected<void, std::string> {
    auto file = base::OutputFile::create(target, mark, overwriting);
    if (!file) return tl::unexpected(file.error());
    file->append(text);
    files.push_back(std::move(*file));
    written.files.push_back(target);
    return {};
  };
  const base::json::Value document = calibrate::calibration_json(fit, calibration);
  if (auto done = add(folder / (stem_of(fit) + ".json"), calibrate::calibration_mark(fit),
                      document.dump(2) + "\n");
      !done) {
    return tl::unexpected(done.error());
  }
  const calibrate::CalibratedCases cases = calibrate::calibrated_cases(fit, calibration, folder);
  for (const calibrate::CalibratedCase& one : cases.cases) {
    if (auto done = add(folder / one.file_name, calibrate::calibrated_case_mark(fit),
                        base::sealed(one.text));
        !done) {
      return tl::unexpected(done.error());
    }
    written.remarks.insert(written.remarks.end(), one.notes.begin(), one.notes.end());
  }
  written.remarks.insert(written.remarks.end(), cases.faults.begin(), cases.faults.end());
  std::vector<base::OutputFile*> together;
  together.reserve(files.size());
  for (base::OutputFile& file : files) together.push_back(&file);
  if (auto size = calibrate::write_fit_report(fit, calibration, page, overwriting, together);
      !size) {
    return tl::unexpected(size.error());
  }
  written.files.push_back(page);
  // Afterwards: what was found in hours is not to hang on gnuplot.
  const calibrate::FitPictures pictures =
      calibrate::draw_fit_pictures(fit, calibration, page.parent_path(), stem_of(fit), overwriting);
  written.files.insert(written.files.end(), pictures.written.begin(), pictures.written.end());
  written.remarks.insert(written.remarks.end(), pictures.notes.begin(), pictures.notes.end());
  return written;
}

/// Tells whether all results can be written, as a sentence where one cannot: that is known before
/// the work.
std::string fault_of_targets(const calibrate::Fit& fit, const CalibrateOptions& options,
                             const fs::path& page, const base::Overwriting& overwriting) {
  const fs::path folder = options.folder;
  std::vector<std::pair<fs::path, base::FileMark>> targets = {
      {folder / (stem_of(fit) + ".json"), calibrate::calibration_mark(fit)}};
  for (const std::string& name : calibrate::calibrated_case_names(fit)) {
    targets.emplace_back(folder / name, calibrate::calibrated_case_mark(fit));
  }
  for (const std::string& name : calibrate::fit_picture_names(fit, stem_of(fit))) {
    targets.emplace_back(page.parent_path() / name, plot::picture_mark(fit.file));
  }
  for (const auto& [target, mark] : targets) {
    if (std::string fault = base::target_fault(target, mark, overwriting); !fault.empty())
      return fault;
    if (base::is_same_file(page, target)) {
      return fmt::format("--report {}: is another result of this fit; choose another name",
                         page.string());
    }
  }
  // That a folder takes files is known once one is there.
  const auto page_probe =
      base::OutputFile::create(page, report::fit_page_mark(file_name(fit)), overwriting);
  if (!page_probe) return page_probe.error();
  const auto probe = base::OutputFile::create(targets[0].first, targets[0].second, overwriting);
  return probe ? "" : probe.error();
}

/// Offers the values found as a block for the model they came from.
std::string way_home(const std::vector<fs::path>& files) {
  constexpr std::string_view kEnding = ".calibrated.yaml";
  for (const fs::path& file : files) {
    if (!file.string().ends_with(kEnding)) continue;
    return "  into your model: slipbench export " + base::shell_word(shown(file)) +
           " --to abaqus --part behaviour\n";
  }
  return {};
}

}  // namespace

int calibrate_command(const CalibrateOptions& options) {
  if (options.no_output && !options.report.empty()) {
    return terminal::refuse(base::kExitBadInput,
                            "--no-output writes no files: leave it out, or leave out --report");
  }
  if (const std::string fault = folder_fault(options.folder, "fit"); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  keep_freed_memory();
  calibrate::ReadFit read = calibrate::read_fit(options.file, {*settings, options.allow_outside});
  if (!read.value || read.diagnostics.has_errors()) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was fitted\n");
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  if (const base::Diagnostics warnings = warnings_of(read.diagnostics); !warnings.empty()) {
    terminal::print_error(base::render(warnings, read.sources));
  }
  calibrate::Fit& fit = *read.value;
  if (options.bootstrap) fit.bootstrap = *options.bootstrap;
  fit.profile = fit.profile || options.profile;

  std::vector<std::string> inputs = read.data_files;
  inputs.push_back(options.file);
  for (const calibrate::ExperimentFit& experiment : fit.experiments) {
    inputs.push_back(experiment.case_path.string());
    inputs.push_back(experiment.data_path.string());
    for (std::string& file : cases::input_files(experiment.base)) inputs.push_back(std::move(file));
  }
  const fs::path page = options.report.empty() ? fs::path(options.folder) / (stem_of(fit) + ".html")
                                               : fs::path(options.report);
  const base::Overwriting overwriting{inputs, options.force};
  if (!options.no_output) {
    const std::string fault = fault_of_targets(fit, options, page, overwriting);
    if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  }

  if (options.ready && !options.ready(read.data_files)) {
    return terminal::refuse(
        base::kExitEnvironment,
        "the ranks do not all read the same files: they must see the same folder");
  }
  const auto calibration = [&] {
    terminal::Progress line(stem_of(fit));
    calibrate::CalibrateProgress progress;
    progress.step = [&](const calibrate::CalibrateStep& step) {
      line.say(
          fmt::format("{}, {} evaluations, cost {:.6g}", step.stage, step.evaluations, step.cost));
    };
    return calibrate::calibrate(
        fit, progress,
        {.threads = options.threads, .with_hashes = !options.no_output, .items = options.items});
  }();
  if (!calibration) {
    terminal::print_error(
        fmt::format("{}: error: {}\n", base::printable(options.file), calibration.error().message));
    return calibration.error().code;
  }
  std::string text = calibrate::fit_summary(fit, *calibration) + remarks(read.diagnostics);
  int code = calibration->fit.converged ? base::kExitOk : base::kExitNumerical;
  if (!options.no_output) {
    const auto written = write_results(fit, *calibration, options, page, overwriting);
    if (!written) {
      terminal::print(text);
      return terminal::refuse(base::kExitEnvironment, written.error());
    }
    for (const std::string& remark : written->remarks) text += "  note: " + remark + "\n";
    for (const fs::path& file : written->files) text += "  " + shown(file);
    text += "\n";
    if (calibration->fit.converged) text += way_home(written->files);
  }
  terminal::print(text);
  return code;
}

}  // namespace slipbench::driver::commands
