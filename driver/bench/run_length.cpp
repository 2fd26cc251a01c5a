// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/run_length.hpp"

#include <algorithm>

namespace slipbench::driver::bench {

RunLength::RunLength(const cases::Case& problem) {
  double time = 0.0;
  for (const cases::Step& step : problem.steps) {
    const double passes = step.repeat;
    const double end = time + passes * step.duration;
    const auto increments = static_cast<double>(step.increments);
    parts_.push_back({step.name, step.duration, time, end, increments_, increments, passes});
    increments_ += passes * increments;
    time = end;
  }
}

double RunLength::increments_between(const std::optional<std::string>& step, double from,
                                     double to) const {
  double sum = 0.0;
  for (const Part& part : parts_) {
    if (step && *step != part.name) continue;
    const double overlap = std::min(to, part.end) - std::max(from, part.begin);
    sum += part.passes * part.increments * std::clamp(overlap / (part.end - part.begin), 0.0, 1.0);
  }
  return sum;
}

double RunLength::done(const Row& row) const {
  if (parts_.empty() || row.index == 0) return 0.0;
  const Part& part = parts_[static_cast<std::size_t>(row.step)];
  const double behind = part.before + part.increments * (row.pass + row.step_time / part.duration);
  return std::clamp(behind / increments_, 0.0, 1.0);
}

}  // namespace slipbench::driver::bench
