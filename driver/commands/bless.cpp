// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/bless.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/case/curve_file.hpp"
#include "driver/case/input_files.hpp"
#include "driver/check/check.hpp"
#include "driver/check/golden.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/provenance.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// A golden curve on its way into its file.
struct Writing {
  check::GoldenCurve curve;
  check::GoldenHeader before;
  check::GoldenHeader header;
  bool was_there = false;
  bool unchanged = false;  ///< all but the blessings stay as they were
  std::string text;        ///< the row of names, and the rows of numbers
  std::optional<base::OutputFile> file;
};

/// A check against a golden curve, held against the old and against the new one.
struct Held {
  cases::Check fresh;
  std::optional<check::CheckProgress> old;
  std::optional<check::CheckProgress> now;
};

std::vector<Writing> prepare(std::vector<check::GoldenCurve> curves) {
  std::vector<Writing> all;
  for (check::GoldenCurve& curve : curves) {
    Writing& one = all.emplace_back();
    std::error_code ignored;
    one.was_there = fs::exists(curve.file, ignored);
    one.text = check::names_row(curve);
    one.curve = std::move(curve);
  }
  return all;
}

/// Runs the case. Error: what to tell, with the exit code.
struct Failure {
  int code;
  std::string message;  ///< whole, with its line feed
};
tl::expected<std::int64_t, Failure> follow(const cases::Case& problem,
                                           std::vector<Writing>& writings,
                                           std::vector<Held>& checks) {
  std::string fault;
  std::int64_t increments = 0;
  terminal::Progress progress(results::case_stem(problem));
  const auto ended = bench::run_case(problem, [&](const bench::Row& row) {
    progress.step(row.index, row.time);
    increments = row.index;
    for (Held& check : checks) {
      if (check.old) check.old->add(row);
      check.now->add(row);
    }
    for (Writing& one : writings) {
      const auto appended = check::append_golden_row(one.curve, row, one.text);
      if (!appended && fault.empty()) fault = appended.error();
    }
  });
  if (!ended) {
    return tl::unexpected(
        Failure{bench::exit_code(ended.error()), bench::failure_text(problem, ended.error())});
  }
  if (!fault.empty()) {
    return tl::unexpected(Failure{base::kExitBadInput, "slipbench: error: " + fault + "\n"});
  }
  return increments;
}

/// Refuses a file that must not be replaced, which may have come while the case ran.
tl::expected<base::OutputFile, Failure> create_file(const Writing& one,
                                                    std::span<const std::string> inputs) {
  if (one.was_there && !cases::is_golden_curve(one.curve.file)) {
    return tl::unexpected(Failure{base::kExitEnvironment,
                                  "slipbench: error: " + base::printable(one.curve.shown_name) +
                                      " is no golden curve any more; it is not overwritten\n"});
  }
  auto file = base::OutputFile::create(one.curve.file, {},
                                       {.inputs = inputs, .force = true, .renewed = true});
  if (!file) {
    return tl::unexpected(
        Failure{base::kExitEnvironment, "slipbench: error: " + file.error() + "\n"});
  }
  return std::move(*file);
}

/// Writes the curves under their temporary names and points the checks there. To be called with
/// the folders locked: the reasons of other blessings are read from what is there now.
tl::expected<void, Failure> write(const cases::Case& problem, const std::string& reason,
                                  std::vector<Writing>& writings, std::vector<Held>& checks) {
  const std::vector<std::string> inputs = cases::history_files(problem);
  for (Writing& one : writings) {
    std::error_code ignored;
    one.was_there = fs::exists(one.curve.file, ignored);
    auto file = create_file(one, inputs);
    if (!file) return tl::unexpected(std::move(file.error()));
    if (one.was_there) one.before = check::read_golden_header(one.curve.file);
    one.header = check::golden_header(problem, one.curve, reason, one.before);
    one.unchanged = one.was_there && one.before.origin == one.header.origin &&
                    check::has_golden_rows(one.curve.file, one.text);
    if (one.unchanged) continue;
    file->append(check::to_text(one.header));
    file->append(one.text);
    if (auto closed = file->close(); !closed) {
      return tl::unexpected(
          Failure{base::kExitEnvironment, "slipbench: error: " + closed.error() + "\n"});
    }
    for (Held& check : checks) {
      auto& reference = std::get<cases::CurveReference>(check.fresh.against);
      if (reference.file == one.curve.file) reference.file = file->temporary();
    }
    one.file.emplace(std::move(*file));
  }
  return {};
}

/// "check 'pull': was 6.2 of its tolerance (CSF2 off by 3.1 N ...), now 0".
std::string told(const cases::Check& check, const std::optional<check::CheckProgress>& old,
                 const check::Verdict& now) {
  std::string before = "no curve before";
  if (old) {
    const check::Verdict verdict = old->verdict();
    if (verdict.compared == 0 || (!verdict.passed && verdict.failing == 0)) {
      before = "was not to be compared (" + verdict.message + ")";
    } else {
      before = fmt::format("was {:.2g} of its tolerance{}", verdict.worst_fraction(),
                           verdict.passed ? "" : " (" + verdict.message + ")");
    }
  }
  return fmt::format("  check '{}': {}, now {:.2g}\n", base::printable(check.name), before,
                     now.worst_fraction());
}

std::string parameters_of(const check::GoldenHeader& header) {
  constexpr std::string_view kParameters = "# parameters: ";
  for (const std::string& line : header.origin) {
    if (line.starts_with(kParameters)) return line.substr(kParameters.size());
  }
  return "none";
}

std::string told(const Writing& one) {
  const std::string name = base::printable(one.curve.shown_name);
  if (one.unchanged) return fmt::format("  {}: as it was, left alone\n", name);
  const auto rows = std::count(one.text.begin(), one.text.end(), '\n') - 1;
  std::string text =
      fmt::format("  {}: {}, {} rows, {} columns\n", name, one.was_there ? "replaced" : "new", rows,
                  one.curve.columns.size());
  if (one.was_there && parameters_of(one.before) != parameters_of(one.header)) {
    text += fmt::format("    parameters were {}\n    parameters are  {}\n",
                        parameters_of(one.before), parameters_of(one.header));
  }
  return text;
}

}  // namespace

int bless_command(const BlessOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.reason.find_first_not_of(" \t\r\n") == std::string::npos) {
    return terminal::refuse(base::kExitBadInput,
                            "--reason: wanted a sentence why today's curve is right");
  }
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  read::ReadCase read = read::read_case(options.file, {.overrides = *settings,
                                                       .allow_outside = options.allow_outside,
                                                       .curves_may_be_missing = true});
  if (!read.value || read.diagnostics.has_errors()) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  const cases::Case& problem = *read.value;
  auto curves = check::golden_curves(problem);
  if (!curves) return terminal::refuse(base::kExitBadInput, options.file + ": " + curves.error());
  std::vector<Writing> writings = prepare(std::move(*curves));

  std::vector<Held> checks;
  for (const Writing& one : writings) {
    for (const std::size_t index : one.curve.checks) {
      Held& held = checks.emplace_back(Held{problem.checks[index], {}, {}});
      if (one.was_there) held.old.emplace(problem, problem.checks[index]);
      std::get<cases::CurveReference>(held.fresh.against).data.reset();
    }
  }
  // From here on the checks stay where they are.
  for (Held& held : checks) held.now.emplace(problem, held.fresh);

  const auto increments = follow(problem, writings, checks);
  if (!increments) {
    terminal::print_error(increments.error().message);
    return increments.error().code;
  }
  std::vector<fs::path> places;
  for (const Writing& one : writings) {
    base::make_folders(one.curve.file.parent_path());  // what cannot be made is told below
    places.push_back(one.curve.file);
  }
  const base::FolderLocks locks(places);
  if (const auto written = write(problem, options.reason, writings, checks); !written) {
    terminal::print_error(written.error().message);
    return written.error().code;
  }
  std::string text =
      fmt::format("{}: {} increments, {}\n", results::case_stem(problem), *increments,
                  terminal::elapsed_text(std::chrono::steady_clock::now() - start));
  std::string verdicts;
  for (const Held& held : checks) {
    const check::Verdict now = held.now->verdict();
    if (!now.passed) {
      return terminal::refuse(
          base::kExitCheckFailed,
          fmt::format("{}: check '{}' would not pass against today's own curve, so "
                      "nothing was changed: {}",
                      options.file, base::printable(held.fresh.name), now.message));
    }
    verdicts += told(held.fresh, held.old, now);
  }
  std::vector<base::OutputFile*> together;
  for (Writing& one : writings) {
    text += told(one);
    if (one.file) together.push_back(&*one.file);
  }
  if (auto committed = base::commit(together, locks); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  terminal::print(text + verdicts);
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
