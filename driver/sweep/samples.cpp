// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/samples.hpp"

#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace slipbench::driver::sweep {
namespace {

/// One step of SplitMix64 (Steele, Lea and Flood 2014): mixes all bits of a number.
std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31U);
}

std::uint64_t hash(std::uint64_t seed, std::uint64_t sample, std::uint64_t parameter) {
  return mixed(mixed(mixed(seed) ^ sample) ^ parameter);
}

/// A number between 0 and 1, both excluded.
double fraction(std::uint64_t bits) { return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53; }

/// Counts as samples what is drawn once for all of them.
constexpr std::uint64_t kForAll = std::numeric_limits<std::uint64_t>::max();

/// The numbers 0 .. count-1 in random order (Fisher and Yates).
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t parameter) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    const double part = fraction(hash(~seed, i, parameter));
    std::swap(order[i - 1], order[static_cast<std::size_t>(part * static_cast<double>(i))]);
  }
  return order;
}

}  // namespace

std::size_t most_coordinates(Sampler sampler) {
  switch (sampler) {
    case Sampler::kSobol:
      return gsl_qrng_sobol->max_dimension;
    case Sampler::kHalton:
      return gsl_qrng_reversehalton->max_dimension;
    case Sampler::kGrid:
    case Sampler::kLatinHypercube:
    case Sampler::kRandom:
    case Sampler::kCsv:
      break;
  }
  return std::numeric_limits<std::size_t>::max();
}

Samples::Samples(const Sweep& sweep)
    : sweep_(&sweep),
      row_length_(row_length(sweep)),
      point_((sweep.sobol_indices ? 2 : 1) * sweep.varied.size()) {
  const std::size_t count = point_.size();
  if (sweep.sampler == Sampler::kSobol || sweep.sampler == Sampler::kHalton) {
    sequence_.reset(
        gsl_qrng_alloc(sweep.sampler == Sampler::kSobol ? gsl_qrng_sobol : gsl_qrng_reversehalton,
                       static_cast<unsigned>(count)),
        [](void* sequence) { gsl_qrng_free(static_cast<gsl_qrng*>(sequence)); });
  }
  if (sweep.sampler == Sampler::kLatinHypercube) {
    for (std::size_t p = 0; p < count; ++p)
      strata_.push_back(shuffled(sweep.samples / row_length_, sweep.seed, p));
  }
}

double Samples::part(std::size_t coordinate) const {
  const std::size_t row = next_ / row_length_;
  const double drawn = fraction(hash(sweep_->seed, row, coordinate));
  if (sequence_) {
    const double shifted = point_[coordinate] + fraction(hash(sweep_->seed, kForAll, coordinate));
    return shifted - std::floor(shifted);
  }
  if (!strata_.empty()) {
    return (static_cast<double>(strata_[coordinate][row]) + drawn) /
           static_cast<double>(strata_[coordinate].size());
  }
  return drawn;
}

void Samples::advance() {
  if (sequence_ && next_ % row_length_ == 0)
    gsl_qrng_get(static_cast<gsl_qrng*>(sequence_.get()), point_.data());
}

void Samples::skip(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i, ++next_) advance();
}

std::size_t Samples::take(std::span<double> values) {
  const std::size_t width = sweep_->varied.size();
  const std::size_t count = std::min(values.size() / width, sweep_->samples - next_);
  // A quantile of 0 or 1 may be infinite.
  constexpr double kLeast = 0x1p-53;
  for (std::size_t i = 0; i < count; ++i, ++next_) {
    advance();
    std::size_t rest = next_;
    for (std::size_t p = width; p-- > 0;) {
      const Distribution& distribution = sweep_->varied[p].distribution;
      double& value = values[i * width + p];
      if (sweep_->sampler == Sampler::kGrid) {
        value = distribution.numbers[rest % distribution.numbers.size()];
        rest /= distribution.numbers.size();
      } else if (sweep_->sampler == Sampler::kCsv) {
        value = distribution.numbers[next_];
      } else {
        // In a row of samples the first is A, the last B, and that between has one coordinate of B.
        const std::size_t in_row = next_ % row_length_;
        const bool of_b = in_row > 0 && (in_row == p + 1 || in_row + 1 == row_length_);
        value = distribution.at(std::clamp(part(of_b ? width + p : p), kLeast, 1.0 - kLeast));
      }
    }
  }
  return count;
}

}  // namespace slipbench::driver::sweep
