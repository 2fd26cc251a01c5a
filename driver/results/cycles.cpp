// SPDX-License-Identifier: Apache-2.0
#include "driver/results/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver::results {
namespace {

bool has_wave(const cases::Step& step) {
  return std::any_of(step.drives.begin(), step.drives.end(), [](const cases::Drive& drive) {
    return std::holds_alternative<history::Wave>(drive.profile);
  });
}

}  // namespace

double cycle_length(const cases::Step& step) {
  // Periods in text have few digits: a third may be 0.33333333.
  constexpr double kWhole = 1e-6;
  double longest = 0.0;
  for (const cases::Drive& drive : step.drives) {
    if (const auto* wave = std::get_if<history::Wave>(&drive.profile)) {
      longest = std::max(longest, wave->period);
    }
  }
  if (longest == 0.0) return step.repeat > 1 ? step.duration : 0.0;
  for (const cases::Drive& drive : step.drives) {
    const auto* wave = std::get_if<history::Wave>(&drive.profile);
    if (wave == nullptr) continue;
    const double times = longest / wave->period;
    if (std::abs(times - std::rint(times)) > kWhole * times) return 0.0;
  }
  return longest <= step.duration * (1.0 + history::kSameTime) ? longest : 0.0;
}

CycleCounter::CycleCounter(const cases::Case& problem)
    : energies_(problem.definitions.size()),
      start_(problem.definitions.size()),
      before_(problem.definitions.size()) {
  for (const cases::Step& step : problem.steps)
    steps_.push_back({cycle_length(step), has_wave(step)});
}

void CycleCounter::add(std::span<const bench::Row> rows) {
  const bench::Row& last = rows.back();
  if (rows.front().index > 1 && last.step == step_ && last.pass == pass_ &&
      rows.front().step == step_ && rows.front().pass == pass_ && !is_over(last)) {
    step_time_ = last.step_time;
    remember(last);
    return;
  }
  for (std::size_t k = 0; !steps_.empty() && k < rows.size(); ++k) {
    const bench::Row& row = rows[k];
    if (row.index == 0) continue;
    if (row.step != step_ || row.pass != pass_ || row.index == 1) {
      if (k > 0) remember(rows[k - 1]);
      step_ = row.step;
      pass_ = row.pass;
      start_ = before_;
      step_time_ = 0.0;
      ends_ = 0;
      end_ = end_of_next();
    }
    if (is_over(row)) {
      if (k > 0) remember(rows[k - 1]);
      end_cycles(row);
    }
    step_time_ = row.step_time;
  }
  remember(last);
}

bool CycleCounter::is_over(const bench::Row& row) const {
  return row.step_time >= end_ * (1.0 - history::kSameTime);
}

double CycleCounter::end_of_next() const {
  const double length = steps_[static_cast<std::size_t>(step_)].length;
  return length > 0.0 ? static_cast<double>(ends_ + 1) * length
                      : std::numeric_limits<double>::infinity();
}

void CycleCounter::remember(const bench::Row& row) {
  for (std::size_t d = 0; d < before_.size(); ++d) before_[d] = row.definitions[d].dissipation;
}

void CycleCounter::end_cycles(const bench::Row& row) {
  // Cycles that lie within one increment are all alike, and there may be very many: of more than
  // these, those between the first and the last few are counted at once.
  constexpr double kSingly = 16.0;
  const double width = row.step_time - step_time_;
  const double length = steps_[static_cast<std::size_t>(step_)].length;
  const auto fraction = [&] {
    return width > 0.0 ? std::clamp((end_ - step_time_) / width, 0.0, 1.0) : 1.0;
  };
  while (is_over(row)) {
    const double more = (row.step_time - end_) / length;
    end_cycle(fraction(), row);
    ++ends_;
    if (more > kSingly) {
      const std::int64_t alike = static_cast<std::int64_t>(more) - 2;
      ends_ += alike;
      end_ = static_cast<double>(ends_) * length;
      for (std::size_t d = 0; d < energies_.size(); ++d) {
        energies_[d].count += alike;
        start_[d] = dissipation(d, fraction(), row);
      }
    }
    end_ = end_of_next();
  }
}

double CycleCounter::dissipation(std::size_t index, double fraction, const bench::Row& row) const {
  const double now = row.definitions[index].dissipation;
  return fraction == 1.0 ? now : before_[index] + fraction * (now - before_[index]);
}

void CycleCounter::end_cycle(double fraction, const bench::Row& row) {
  (steps_[static_cast<std::size_t>(row.step)].wave ? waves_ : repeats_) = true;
  for (std::size_t d = 0; d < energies_.size(); ++d) {
    const double end = dissipation(d, fraction, row);
    const double energy = end - start_[d];
    start_[d] = end;
    CycleEnergy& all = energies_[d];
    if (all.count == 0) all.first = all.lowest = all.highest = energy;
    if (all.count > 0) all.before_last = all.last;
    all.last = energy;
    all.lowest = std::min(all.lowest, energy);
    all.highest = std::max(all.highest, energy);
    ++all.count;
  }
}

std::string CycleCounter::found_by() const {
  if (waves_ && repeats_) return "period of the waves, or repeated step";
  if (waves_) return "period of the waves";
  return repeats_ ? "repeated step" : "";
}

}  // namespace slipbench::driver::results
