// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/run_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/run_length.hpp"
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

std::size_t chunk_size(const Sweep& sweep) {
  // Enough for the lanes of a pack; of long runs so few that not much is lost with a chunk.
  constexpr std::size_t kMost = 128;
  constexpr double kIncrements = 0x1p18;
  // In packs a long run takes a fraction of its time.
  constexpr double kMoreInPacks = 64.0;
  const double increments = bench::RunLength(sweep.base).increments();
  const double budget = may_pack(sweep) ? kMoreInPacks * kIncrements : kIncrements;
  const double fitting = std::floor(budget / std::max(increments, 1.0));
  return static_cast<std::size_t>(std::clamp(fitting, 1.0, static_cast<double>(kMost)));
}

Chunk::Chunk(const Sweep& sweep, std::size_t first_sample, std::size_t samples)
    : first(first_sample),
      count(samples),
      values(samples * sweep.varied.size()),
      numbers(samples * sweep.collected.size()),
      failures(samples) {}

SampleOutcome Chunk::outcome(std::size_t sample) const {
  const std::size_t width = values.size() / count;
  const std::size_t depth = numbers.size() / count;
  return {first + sample, std::span(values).subspan(sample * width, width),
          std::span(numbers).subspan(sample * depth, depth), failures[sample]};
}

bool agrees(const Sweep& sweep, const PackedRun& packed) {
  constexpr std::array kParts{0.02, 0.98, 0.31};
  const std::size_t width = sweep.varied.size();
  const std::size_t depth = sweep.collected.size();
  const std::size_t count = 2 * kParts.size();
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t p = 0; p < width; ++p) {
      // All of them at one edge, then each at another one than the one before it.
      const std::size_t part = i < kParts.size() ? i : i + p;
      values.push_back(sweep.varied[p].distribution.at(kParts[part % kParts.size()]));
    }
  }
  std::vector<double> numbers(count * depth);
  std::vector<char> done(count);
  packed.run(values, numbers, done);
  std::vector<double> own(depth);
  for (std::size_t i = 0; i < count; ++i) {
    if (done[i] == 0) continue;
    const auto row = std::span(values).subspan(i * width, width);
    if (!run_sample(sweep, row, own).empty()) return false;
    if (std::memcmp(own.data(), &numbers[i * depth], depth * sizeof(double)) != 0) return false;
  }
  return true;
}

std::unique_ptr<PackedRun> packed_run(const Sweep& sweep) {
  auto packed = PackedRun::make(sweep);
  if (packed && !agrees(sweep, *packed)) packed.reset();
  return packed;
}

void run_chunk(const Sweep& sweep, Chunk& chunk, const PackedRun* packed) {
  const std::size_t width = sweep.varied.size();
  const std::size_t depth = sweep.collected.size();
  std::vector<char> done(chunk.count);
  for (std::size_t i = 0; packed != nullptr && i < chunk.count; i += PackedRun::kMost) {
    const std::size_t count = std::min(PackedRun::kMost, chunk.count - i);
    packed->run(std::span(chunk.values).subspan(i * width, count * width),
                std::span(chunk.numbers).subspan(i * depth, count * depth),
                std::span(done).subspan(i, count));
  }
  for (std::size_t i = 0; i < chunk.count; ++i) {
    if (done[i] != 0) continue;
    const std::span<double> own = std::span(chunk.numbers).subspan(i * depth, depth);
    chunk.failures[i] = run_sample(sweep, chunk.outcome(i).values, own);
    if (chunk.failures[i].empty()) continue;
    std::fill(own.begin(), own.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

void run_sweep(const Sweep& sweep, const SweepOptions& options,
               const std::function<void(const SampleOutcome&)>& take) {
  // So many samples, or more for many threads, are in memory at once and wait for the slowest.
  constexpr std::size_t kTogether = 1024;
  const std::size_t size = options.chunk > 0 ? options.chunk : chunk_size(sweep);
  const std::size_t together = std::max<std::size_t>(kTogether / size, 4 * options.threads);
  Samples samples(sweep);
  samples.skip(options.first);
  const std::size_t end = std::min(options.end, sweep.samples);
  // Fewer samples are run before a pack is set up and compared.
  constexpr std::size_t kWorthPacking = 64;
  const bool packs = options.packs && end >= options.first + kWorthPacking;
  const std::unique_ptr<PackedRun> packed = packs ? packed_run(sweep) : nullptr;
  std::size_t failed = 0;
  std::vector<Chunk> chunks;
  for (std::size_t begin = options.first; begin < end;) {
    chunks.clear();
    for (; begin < end && chunks.size() < together; begin = chunks.back().end()) {
      // Chunks begin at multiples of their size, wherever the samples that are wanted begin.
      chunks.emplace_back(sweep, begin, std::min(end, (begin / size + 1) * size) - begin);
      samples.take(chunks.back().values);
    }
    base::for_each_index(chunks.size(), options.threads, [&](std::size_t i) {
      if (options.recall && options.recall(chunks[i])) return;
      run_chunk(sweep, chunks[i], packed.get());
      if (options.finished) options.finished(chunks[i]);
    });
    for (const Chunk& chunk : chunks) {
      for (std::size_t i = 0; i < chunk.count; ++i) {
        failed += chunk.failures[i].empty() ? 0 : 1;
        take(chunk.outcome(i));
      }
    }
    if (options.progress) options.progress(begin - options.first, failed);
  }
}

}  // namespace slipbench::driver::sweep
