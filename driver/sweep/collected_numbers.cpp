// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/collected_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/history/step_grid.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::sweep {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Brings one more value of a quantity to what is left of it. Extremes are those of the values that
/// are numbers; `so_far` is nan before the first.
double reduced(Reduction reduction, double so_far, double value) {
  if (reduction == Reduction::kMagnitude) value = std::abs(value);
  const bool better = reduction == Reduction::kLast || std::isnan(so_far) ||
                      (reduction == Reduction::kMinimum ? value < so_far : value > so_far);
  return better ? value : so_far;
}

/// Tells whether an event is of the kind that is counted.
bool is_counted(Counted counted, const results::Event& event) {
  using law::Regime;
  switch (counted) {
    case Counted::kStickToSlip:
      return event.from == Regime::kStick && event.to == Regime::kSlip;
    case Counted::kSlipToStick:
      return event.from == Regime::kSlip && event.to == Regime::kStick;
    case Counted::kReversal:
      break;
  }
  return event.reversal;
}

/// The least value that lasts, with all below it, for a part of the time.
double quantile(std::vector<std::pair<double, double>>& weighted, double part) {
  if (weighted.empty()) return kNone;
  std::sort(weighted.begin(), weighted.end());
  double all = 0.0;
  for (const auto& [value, time] : weighted) all += time;
  double below = 0.0;
  for (const auto& [value, time] : weighted) {
    below += time;
    // Sums of the same times differ by their rounding.
    if (below >= part * all * (1.0 - history::kSameTime)) return value;
  }
  return weighted.back().first;
}

}  // namespace

CollectedNumbers::CollectedNumbers(const Sweep& sweep, const cases::Case& problem)
    : sweep_(&sweep), running_(sweep.collected.size()) {
  const std::vector<results::Column> columns = results::result_columns(problem);
  own_.reserve(sweep.collected.size());
  for (std::size_t i = 0; i < running_.size(); ++i) {
    const Collected& one = sweep.collected[i];
    if (one.counted && !events_) events_.emplace(problem);
    if (one.loop && !cycles_) cycles_.emplace(problem);
    if (!one.quantity) continue;
    running_[i].number = kNone;
    running_[i].value = kNone;
    own_.push_back(*one.quantity);
    auto quantity = check::RowExpression::make(problem, columns, own_.back(), one.variables);
    if (quantity) {
      running_[i].quantity = std::move(*quantity);
    } else if (fault_.empty()) {
      fault_ = one.name + ": " + quantity.error();
    }
  }
}

void CollectedNumbers::add(std::span<const bench::Row> rows) {
  if (cycles_) cycles_->add(rows);
  for (const bench::Row& row : rows) {
    const std::span<const results::Event> now =
        events_ ? events_->take(row) : std::span<const results::Event>();
    for (std::size_t i = 0; i < running_.size() && fault_.empty(); ++i) {
      const Collected& one = sweep_->collected[i];
      Running& running = running_[i];
      if (one.counted) {
        running.number += static_cast<double>(std::count_if(
            now.begin(), now.end(),
            [&](const results::Event& event) { return is_counted(*one.counted, event); }));
      }
      if (!running.quantity) continue;
      const auto value = (*running.quantity)(row);
      if (value) {
        take(one, row, *value, running);
      } else {
        fault_ = one.name + ": " + value.error().message;
      }
    }
  }
}

void CollectedNumbers::take(const Collected& collected, const bench::Row& row, double value,
                            Running& running) {
  switch (collected.reduction) {
    case Reduction::kQuantile:
      if (row.duration > 0.0 && !std::isnan(value)) {
        running.weighted.emplace_back(value, row.duration);
      }
      return;
    case Reduction::kFirstAbove:
    case Reduction::kFirstBelow: {
      const double sign = collected.reduction == Reduction::kFirstAbove ? 1.0 : -1.0;
      const double before = sign * (running.value - collected.level);
      const double here = sign * (value - collected.level);
      if (std::isnan(running.number) && here > 0.0) {
        // Along the increment as a straight line; at once where there is none to go along.
        const bool crossed = before <= 0.0 && std::isfinite(before);
        const double part = std::isfinite(here) ? before / (before - here) : 1.0;
        running.number = crossed ? running.time + part * (row.time - running.time) : row.time;
      }
      running.value = value;
      running.time = row.time;
      return;
    }
    default:
      running.number = reduced(collected.reduction, running.number, value);
  }
}

void CollectedNumbers::finish(std::span<double> numbers) {
  for (std::size_t i = 0; i < running_.size(); ++i) {
    const Collected& one = sweep_->collected[i];
    numbers[i] = running_[i].number;
    if (one.reduction == Reduction::kQuantile) {
      numbers[i] = quantile(running_[i].weighted, one.level);
    }
    if (!one.loop) continue;
    double energy = 0.0;
    for (const results::CycleEnergy& cycle : cycles_->energies()) {
      const double own = *one.loop == Loop::kFirst ? cycle.first : cycle.last;
      energy += cycle.count > 0 ? own : kNone;
    }
    numbers[i] = energy;
  }
}

}  // namespace slipbench::driver::sweep
