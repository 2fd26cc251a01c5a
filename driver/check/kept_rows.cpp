// SPDX-License-Identifier: Apache-2.0
#include "driver/check/kept_rows.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <variant>

#include "driver/bench/run_length.hpp"

namespace slipbench::driver::check {
namespace {

constexpr double kGigabyte = 1e9;

/// Memory that this process may still take [bytes]; infinite where the system does not say.
double free_memory() {
  double free = std::numeric_limits<double>::infinity();
  std::ifstream in("/proc/meminfo");
  std::string word;
  while (in >> word) {
    if (word != "MemAvailable:") continue;
    double kibibytes = 0.0;
    if (in >> kibibytes) free = 1024.0 * kibibytes;
    break;
  }
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    free = std::min(free, static_cast<double>(limit.rlim_cur));
  }
  return free;
}

}  // namespace

bool keeps_rows(const cases::Check& check, Trace trace) {
  return trace == Trace::kKeep || check.criterion != cases::Criterion::kPointwise ||
         std::holds_alternative<cases::CurveReference>(check.against);
}

std::string memory_fault(const cases::Case& problem, Trace trace) {
  // Abscissa, value, time and reference, and the regime.
  constexpr double kBytes = 4.0 * sizeof(double) + 1.0;
  const bench::RunLength length(problem);
  double rows = 0.0;
  const cases::Check* first = nullptr;
  for (const cases::Check& check : problem.checks) {
    if (!keeps_rows(check, trace)) continue;
    if (first == nullptr) first = &check;
    constexpr double kEver = std::numeric_limits<double>::infinity();
    rows += length.increments_between(check.step, check.from.value_or(-kEver),
                                      check.to.value_or(kEver));
  }
  const double need = kBytes * rows;
  const double free = free_memory();
  if (first == nullptr || need <= free) return {};
  return fmt::format(
      "check '{}' keeps the rows it compares: {:.3g} rows need at least {:.2g} GB of memory, and "
      "{:.2g} GB are free; compare fewer ('step: ..' or 'over: {{from: .., to: ..}}') or take "
      "fewer "
      "increments",
      first->name, rows, need / kGigabyte, free / kGigabyte);
}

}  // namespace slipbench::driver::check
