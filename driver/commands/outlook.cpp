// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/outlook.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "driver/results/provenance.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGigabyte = 1e9;
constexpr double kPatience = 30.0;        ///< without a word [s]
constexpr double kLargeFile = kGigabyte;  ///< likewise [bytes]

std::string size_words(double bytes) {
  return bytes < kGigabyte ? fmt::format("{:.2g} MB", 1e-6 * bytes)
                           : fmt::format("{:.3g} GB", bytes / kGigabyte);
}

}  // namespace

std::string duration_words(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  if (seconds < kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string run_progress_text(std::int64_t increments, double done, double seconds) {
  std::string text = fmt::format("{:.0f} %, {} increments", 100.0 * done, increments);
  if (done > 0.0) text += fmt::format(", {} left", duration_words(seconds / done * (1.0 - done)));
  return text;
}

Outlook::Outlook(const cases::Case& problem, std::filesystem::path folder)
    : case_(&problem), length_(problem), folder_(std::move(folder)), start_(Clock::now()) {}

void Outlook::judge(const bench::Row& row, std::optional<std::uintmax_t> written) {
  const double done = length_.done(row);
  if (done <= 0.0) return;
  std::error_code error;
  const auto so_far = static_cast<double>(written.value_or(0));
  const double bytes = so_far / done;
  const double whole = seconds() / done;
  const double increments = static_cast<double>(row.index) / done;
  const std::string name = results::case_stem(*case_);
  const std::filesystem::path here = folder_.empty() ? "." : folder_;
  const auto space = std::filesystem::space(here, error);
  if (!error && bytes - so_far > static_cast<double>(space.available)) {
    throw NoRoom{fmt::format(
        "the rows of {} would take some {}, and {} are free in {}; write fewer rows ('output: "
        "{{every: "
        "N}}' or '--every N'), fewer columns ('output: {{columns: [..]}}') or '--no-output'",
        name, size_words(bytes), size_words(static_cast<double>(space.available)), here.string())};
  }
  if (whole < kPatience && bytes < kLargeFile) return;
  std::string text =
      fmt::format("{}: {:.3g} increments take some {}", name, increments, duration_words(whole));
  if (written) text += fmt::format(" and {} of rows", size_words(bytes));
  terminal::print_error(
      text + " ('output: {every: N}' writes fewer rows, Ctrl-C leaves nothing behind)\n");
}

double Outlook::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Outlook::show(const bench::Row& row, terminal::Progress& progress) const {
  if (length_.increments() > 0.0) {
    progress.say(run_progress_text(row.index, length_.done(row), seconds()));
  } else {
    progress.say(fmt::format("{} increments, t = {:.4g}", row.index, row.time));
  }
}

}  // namespace slipbench::driver::commands
