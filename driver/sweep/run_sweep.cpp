// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/run_sweep.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/run_length.hpp"
#include "driver/sweep/collected_numbers.hpp"
#include "driver/sweep/samples.hpp"

namespace slipbench::driver::sweep {
namespace {

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
  CollectedNumbers collected(sweep, problem);
  if (!collected.fault().empty()) return collected.fault();
  const auto ended =
      bench::run_in_blocks(problem, [&](std::span<const bench::Row> rows) { collected.add(rows); });
  if (!ended) return ended.error().message;
  collected.finish(numbers);
  return collected.fault();
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

std::string setting_text(const base::ParameterText& one) {
  const double* number = std::get_if<double>(&one.value);
  return one.name + "=" +
         (number != nullptr ? base::format_number(*number) : std::get<std::string>(one.value));
}

std::string settings_text(const Sweep& sweep) {
  std::string text;
  for (const base::ParameterText& one : sweep.settings) {
    text += (text.empty() ? "" : ", ") + setting_text(one);
  }
  return text;
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
  const auto size = static_cast<std::size_t>(std::clamp(fitting, 1.0, static_cast<double>(kMost)));
  // Whole rows, which are taken together where they are reduced.
  const std::size_t length = row_length(sweep);
  return std::max(size / length, std::size_t{1}) * length;
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

/// Values at the edges of what is varied, sample by sample.
std::vector<double> edge_samples(const Sweep& sweep) {
  constexpr std::array kParts{0.02, 0.98, 0.31};
  std::vector<double> values;
  if (sweep.sampler == Sampler::kCsv) {
    // The rows in which a parameter is lowest, or highest: others may be none that can be run.
    constexpr std::size_t kMostRows = 16;
    std::set<std::size_t> rows;
    for (const VariedParameter& one : sweep.varied) {
      const auto begin = one.distribution.numbers.begin();
      const auto end = begin + static_cast<std::ptrdiff_t>(sweep.samples);
      const auto [low, high] = std::minmax_element(begin, end);
      rows.insert(static_cast<std::size_t>(low - begin));
      rows.insert(static_cast<std::size_t>(high - begin));
      if (rows.size() > kMostRows) break;
    }
    for (const std::size_t row : rows) {
      for (const VariedParameter& one : sweep.varied) {
        values.push_back(one.distribution.numbers[row]);
      }
    }
    return values;
  }
  for (std::size_t i = 0; i < 2 * kParts.size(); ++i) {
    for (std::size_t p = 0; p < sweep.varied.size(); ++p) {
      // All of them at one edge, then each at another one than the one before it.
      const std::size_t part = i < kParts.size() ? i : i + p;
      values.push_back(sweep.varied[p].distribution.at(kParts[part % kParts.size()]));
    }
  }
  return values;
}

bool agrees(const Sweep& sweep, const PackedRun& packed) {
  const std::size_t width = sweep.varied.size();
  const std::size_t depth = sweep.collected.size();
  const std::vector<double> values = edge_samples(sweep);
  const std::size_t count = values.size() / width;
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
  const std::size_t together = std::max(kTogether / size, std::size_t{4} * options.threads);
  Samples samples(sweep);
  samples.skip(options.first);
  const std::size_t end = std::min(options.end, sweep.samples);
  // Fewer samples are run before a pack is set up and compared.
  constexpr std::size_t kWorthPacking = 64;
  const bool packs = options.packs && end >= options.first + kWorthPacking;
  const std::unique_ptr<PackedRun> packed = packs ? packed_run(sweep) : nullptr;
  std::size_t failed = 0;
  std::atomic<bool> stopped{false};
  std::vector<Chunk> chunks;
  for (std::size_t begin = options.first; begin < end;) {
    chunks.clear();
    for (; begin < end && chunks.size() < together; begin = chunks.back().end()) {
      // Chunks begin at multiples of their size, wherever the samples that are wanted begin.
      chunks.emplace_back(sweep, begin, std::min(end, (begin / size + 1) * size) - begin);
      samples.take(chunks.back().values);
    }
    base::for_each_index(chunks.size(), options.threads, [&](std::size_t i) {
      if (options.go_on && !stopped && !options.go_on()) stopped = true;
      if (stopped || (options.recall && options.recall(chunks[i]))) return;
      run_chunk(sweep, chunks[i], packed.get());
      if (options.finished) options.finished(chunks[i]);
    });
    if (stopped) return;
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
