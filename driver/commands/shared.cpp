// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/shared.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/read/file_kind.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

/// The first reason why standard output did not take something.
int output_error = 0;

void note_output_error() {
  if (output_error == 0) output_error = errno == 0 ? EIO : errno;
}

}  // namespace

tl::expected<std::vector<ParameterText>, std::string> parse_settings(
    std::span<const std::string> settings) {
  std::vector<ParameterText> all;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size()) {
      return tl::unexpected(
          fmt::format("--set {}: wanted name=value, for example --set mu=0.2", setting));
    }
    ParameterText text{setting.substr(0, equals), setting.substr(equals + 1)};
    if (const auto number = parse_number(std::get<std::string>(text.value))) text.value = *number;
    all.push_back(std::move(text));
  }
  return all;
}

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_output_error();
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) note_output_error();
}

void print_error(std::string_view text) {
  flush_output();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

int refuse(int code, std::string_view message) {
  print_error(fmt::format("slipbench: error: {}\n", printable(message)));
  return code;
}

std::string folder_fault(const std::string& folder, std::string_view whose) {
  constexpr std::array<std::string_view, 9> kEndings{".csv",  ".json", ".yaml", ".yml", ".txt",
                                                     ".html", ".svg",  ".png",  ".pdf"};
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return {};
  const std::string ending = fs::path(folder).extension().string();
  if (folder != "-" && std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) {
    return {};
  }
  return fmt::format("-o {}: wanted a folder, not a file: results are called after their {}",
                     folder, whose);
}

std::string named_case(const std::string& path) {
  std::error_code error;
  if (path == kStandardInput) return path;
  if (fs::exists(fs::symlink_status(path, error))) return path;
  std::string found;
  for (const std::string_view ending : kCaseEndings) {
    const std::string file = path + std::string(ending);
    if (!fs::is_regular_file(file, error)) continue;
    if (found.empty()) {
      found = file;
    } else {
      print_error(fmt::format("slipbench: warning: there are {0} and {1}; {0} is taken\n",
                              printable(found), printable(file)));
    }
  }
  return found.empty() ? path : found;
}

int finish_output(int code) {
  flush_output();
  if (output_error == 0) return code;
  if (output_error == EPIPE) return code == kExitOk ? kExitNoReader : code;
  static bool told = false;
  if (!std::exchange(told, true))
    print_error(fmt::format("slipbench: error: standard output cannot be written: {}\n",
                            std::generic_category().message(output_error)));
  return worse(code, kExitEnvironment);
}

bool colour_wanted(int descriptor) {
  const auto value = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string_view(text == nullptr ? "" : text);
  };
  const auto forced = [&](const char* name) { return !value(name).empty() && value(name) != "0"; };
  if (!value("NO_COLOR").empty()) return false;
  if (forced("FORCE_COLOR") || forced("CLICOLOR_FORCE")) return true;
  if (value("CLICOLOR") == "0") return false;
  return isatty(descriptor) == 1 && !value("TERM").empty() && value("TERM") != "dumb";
}

std::string elapsed_text(std::chrono::steady_clock::duration elapsed) {
  const double seconds = std::chrono::duration<double>(elapsed).count();
  constexpr double kShort = 0.1;
  if (seconds < kShort) return fmt::format("{:.2g} ms", 1e3 * seconds);
  return fmt::format("{:.2f} s", seconds);
}

tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const Case& problem, const std::function<void(const Row&)>& take) {
  return follow_case(problem, [&](const Simulation& simulation) { take(simulation.row()); });
}

tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const Case& problem, const std::function<void(const Simulation&)>& take) {
  auto simulation = Simulation::start(problem);
  if (!simulation) return tl::unexpected(std::move(simulation.error()));
  while (true) {
    take(*simulation);
    auto more = simulation->advance();
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) break;
  }
  return std::vector<MotionJump>(simulation->jumps().begin(), simulation->jumps().end());
}

int exit_code(const SimulationFailure& failure) {
  switch (failure.kind) {
    case SimulationFailure::Kind::kInput:
      return kExitBadInput;
    case SimulationFailure::Kind::kEnvironment:
      return kExitEnvironment;
    case SimulationFailure::Kind::kNumerical:
      break;
  }
  return kExitNumerical;
}

std::string failure_text(const Case& problem, const SimulationFailure& failure) {
  return fmt::format(
      "{}: {}: {}\n", problem.file,
      failure.kind == SimulationFailure::Kind::kNumerical ? "numerical failure" : "error",
      failure.message);
}

std::vector<std::string> history_files(const Case& problem) {
  std::vector<std::string> files = {problem.file};
  if (problem.measured) files.push_back(problem.measured->data.file.string());
  for (const Step& step : problem.steps) {
    for (const Drive& drive : step.drives) {
      if (const auto* csv = std::get_if<CsvColumn>(&drive.profile)) {
        files.push_back(csv->data.file.string());
      }
    }
  }
  return files;
}

std::vector<std::string> input_files(const Case& problem) {
  std::vector<std::string> files = history_files(problem);
  files.insert(files.end(), problem.data_files.begin(), problem.data_files.end());
  for (const Check& check : problem.checks) {
    if (const auto* curve = std::get_if<CurveReference>(&check.against)) {
      files.push_back(curve->file.string());
    }
  }
  return files;
}

std::string worst_text(const Check& check, const Verdict& verdict) {
  const Tolerance& tolerance = check.tolerance;
  if (tolerance.relative && !tolerance.absolute && verdict.scale > 0.0) {
    return fmt::format("worst {:.2g} of {:.2g}", verdict.worst_deviation() / verdict.scale,
                       *tolerance.relative);
  }
  return fmt::format("worst {:.2g} of its tolerance", verdict.worst_fraction());
}

std::string verdict_text(const Check& check, const Verdict& verdict) {
  return fmt::format("check '{}': {}", check.name,
                     verdict.passed ? worst_text(check, verdict) : verdict.message);
}

}  // namespace slipbench::driver
