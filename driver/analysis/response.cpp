// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "driver/base/units/readable.hpp"
#include "driver/bench/run_case.hpp"

namespace slipbench::driver::analysis {
namespace {

double dissipation_of(const bench::Row& row) {
  double sum = 0.0;
  for (const bench::DefinitionRow& one : row.definitions) sum += one.dissipation;
  return sum;
}

/// Slip that takes up energy although the force is below its limit, as a viscous penalty has it.
double creep_of(const bench::Row& row) {
  constexpr double kBelow = 1.0 - 1e-9;
  double sum = 0.0;
  for (const bench::DefinitionRow& one : row.definitions) {
    double force = 0.0;
    for (const double part : one.update.state.force) force += part * part;
    force = std::sqrt(force);
    if (force > 0.0 && force < kBelow * one.update.limit) sum += one.update.dissipation / force;
  }
  return sum;
}

std::string percent(double part) {
  constexpr double kWhole = 1.0;  // from here on digits behind the point say nothing
  if (part < kWhole) return base::rounded(100.0 * part, 2) + " %";
  return fmt::format("{:.0f} %", 100.0 * part);
}

}  // namespace

tl::expected<ResponseDifference, std::string> compare_responses(const cases::Case& one,
                                                                const cases::Case& other) {
  if (one.definitions.size() != other.definitions.size()) {
    return tl::unexpected<std::string>("they have not as many friction definitions");
  }
  ResponseDifference difference;
  auto beside = bench::Simulation::start(other);
  if (!beside) return tl::unexpected(std::move(beside.error().message));
  std::optional<std::string> failure;
  const auto take_other = [&] {
    difference.other_dissipation = dissipation_of(beside->row());
    difference.other_creep += creep_of(beside->row());
  };
  // Goes to the next row; tells whether there is one, and none is behind a failure.
  const auto goes_on = [&] {
    const auto more = beside->advance();
    if (!more) failure = more.error().message;
    if (!more || !*more) return false;
    take_other();
    return true;
  };
  take_other();
  bool ended = false;
  const auto run = bench::run_case(one, [&](const bench::Row& row) {
    difference.dissipation = dissipation_of(row);
    difference.creep += creep_of(row);
    constexpr double kSameTime = 1e-9;
    const double slack = kSameTime * std::abs(row.time);
    while (!ended && beside->row().time < row.time - slack) ended = !goes_on();
    if (ended || beside->row().time > row.time + slack) {
      ++difference.unmatched;
      return;
    }
    for (std::size_t d = 0; d < row.definitions.size(); ++d) {
      difference.force.add(row, d, beside->row().definitions[d].update.state);
    }
  });
  if (!run) return tl::unexpected(run.error().message);
  while (!ended) ended = !goes_on();
  if (failure) return tl::unexpected(std::move(*failure));
  return difference;
}

std::string difference_text(const ResponseDifference& difference) {
  if (difference.is_none()) return "the same friction force and energy, in all digits";
  const ForceDistance& force = difference.force;
  std::string text = fmt::format("friction force off by at most {} of {} ({}) at T = {}",
                                 base::rounded(force.most, 3), base::rounded(force.largest, 3),
                                 percent(force.relative(force.most)), base::rounded(force.time));
  const double lost = difference.dissipation;
  const double change = difference.other_dissipation - lost;
  if (lost > 0.0) {
    text += fmt::format(", dissipated energy {} {}", percent(std::abs(change) / lost),
                        change < 0.0 ? "less" : "more");
  }
  // Of an increment in which slip ends, rounding is left.
  const double least = 1e-6 * std::max(difference.creep, difference.other_creep);
  if (std::abs(difference.creep - difference.other_creep) > least) {
    text +=
        fmt::format(", creep while sticking {} in place of {}",
                    base::rounded(difference.other_creep, 3), base::rounded(difference.creep, 3));
  }
  if (difference.unmatched > 0) {
    text += fmt::format("; {} rows have no counterpart", difference.unmatched);
  }
  return text;
}

}  // namespace slipbench::driver::analysis
