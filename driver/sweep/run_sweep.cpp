// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/run_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/check/row_values.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/events.hpp"
#include "driver/sweep/samples.hpp"

namespace slipbench::driver::sweep {
namespace {

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

/// The first error, in one line.
std::string first_error(const base::Diagnostics& diagnostics) {
  for (const base::Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity != base::Severity::kError) continue;
    return diagnostic.path + (diagnostic.path.empty() ? "" : ": ") + diagnostic.message;
  }
  return "the case cannot be read";
}

/// Runs one sample. Returns why it failed, or nothing.
std::string run_sample(const Sweep& sweep, std::span<const double> values,
                       std::span<double> numbers) {
  read::ReadOptions options{.overrides = overrides_of(sweep, values),
                            .allow_outside = sweep.allow_outside,
                            .curves_may_be_missing = true};
  const read::ReadCase read = sweep.parsed.resolve(options);
  if (!read.value) return first_error(read.diagnostics);
  const cases::Case& problem = *read.value;
  const std::vector<results::Column> columns = results::result_columns(problem);
  // An expression serves one thread at a time: each sample has copies.
  std::vector<base::Expression> own;
  own.reserve(sweep.collected.size());
  std::vector<std::optional<check::RowExpression>> quantities(sweep.collected.size());
  std::optional<results::EventDetector> events;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Collected& one = sweep.collected[i];
    if (one.counted) {
      numbers[i] = 0.0;
      if (!events) events.emplace(problem);
      continue;
    }
    numbers[i] = std::numeric_limits<double>::quiet_NaN();
    own.push_back(*one.quantity);
    auto quantity = check::RowExpression::make(problem, columns, own.back(), one.variables);
    if (!quantity) return one.name + ": " + quantity.error();
    quantities[i] = std::move(*quantity);
  }
  std::string failure;
  const auto ended = bench::run_case(problem, [&](const bench::Row& row) {
    const std::span<const results::Event> now =
        events ? events->take(row) : std::span<const results::Event>();
    for (std::size_t i = 0; i < quantities.size() && failure.empty(); ++i) {
      const Collected& one = sweep.collected[i];
      if (one.counted) {
        numbers[i] += static_cast<double>(std::count_if(
            now.begin(), now.end(),
            [&](const results::Event& event) { return is_counted(*one.counted, event); }));
        continue;
      }
      const auto value = (*quantities[i])(row);
      if (!value) {
        failure = one.name + ": " + value.error().message;
        return;
      }
      numbers[i] = reduced(one.reduction, numbers[i], *value);
    }
  });
  return ended ? failure : ended.error().message;
}

}  // namespace

std::vector<base::ParameterText> overrides_of(const Sweep& sweep, std::span<const double> values) {
  std::vector<base::ParameterText> overrides = sweep.settings;
  overrides.reserve(overrides.size() + values.size());
  for (std::size_t p = 0; p < values.size(); ++p) {
    overrides.push_back({sweep.varied[p].name, values[p]});
  }
  return overrides;
}

void run_sweep(const Sweep& sweep, const SweepOptions& options,
               const std::function<void(const SampleOutcome&)>& take) {
  // So many samples are in memory at once, and wait for the slowest of them.
  constexpr std::size_t kTogether = 1024;
  const std::size_t width = sweep.varied.size();
  const std::size_t depth = sweep.collected.size();
  std::vector<double> values(kTogether * width);
  std::vector<double> numbers(kTogether * depth);
  std::vector<std::string> failures(kTogether);
  Samples samples(sweep);
  samples.skip(options.first);
  const std::size_t end = std::min(options.end, sweep.samples);
  std::size_t failed = 0;
  for (std::size_t begin = options.first; begin < end;) {
    const std::size_t most = std::min(kTogether, end - begin);
    const std::size_t count = samples.take(std::span(values).first(most * width));
    base::for_each_index(count, options.threads, [&](std::size_t i) {
      const std::span<double> own = std::span(numbers).subspan(i * depth, depth);
      failures[i] = run_sample(sweep, std::span(values).subspan(i * width, width), own);
      if (!failures[i].empty()) {
        std::fill(own.begin(), own.end(), std::numeric_limits<double>::quiet_NaN());
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      failed += failures[i].empty() ? 0 : 1;
      const SampleOutcome outcome{begin + i, std::span(values).subspan(i * width, width),
                                  std::span(numbers).subspan(i * depth, depth), failures[i]};
      take(outcome);
    }
    begin += count;
    if (options.progress) options.progress(begin - options.first, failed);
  }
}

}  // namespace slipbench::driver::sweep
