// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/amplitudes.hpp"

#include <gsl/gsl_fft_real.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace slipbench::driver::plot {
namespace {

constexpr std::size_t kLeast = 8;
constexpr std::size_t kMost = std::size_t{1} << 20U;
constexpr std::size_t kPadding = 4;

/// The signal at `count` equal steps over its whole time.
std::vector<double> resampled(std::span<const double> times, std::span<const double> signal,
                              std::size_t count) {
  std::vector<double> values(count);
  const double step = (times.back() - times.front()) / static_cast<double>(count);
  std::size_t after = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = times.front() + static_cast<double>(i) * step;
    while (after + 1 < times.size() && times[after] < t) ++after;
    const double width = times[after] - times[after - 1];
    const double part = width > 0.0 ? (t - times[after - 1]) / width : 1.0;
    values[i] = signal[after - 1] + part * (signal[after] - signal[after - 1]);
  }
  return values;
}

/// The top of a parabola through a value and its neighbours: how far from the middle one, and its
/// height.
std::pair<double, double> top_of(double left, double middle, double right) {
  const double bend = left - 2.0 * middle + right;
  if (!(bend < 0.0)) return {0.0, middle};
  const double at = 0.5 * (left - right) / bend;
  return {at, middle - 0.25 * (left - right) * at};
}

}  // namespace

Amplitudes amplitudes_of(std::span<const double> times, std::span<const double> signal) {
  Amplitudes found;
  if (times.size() < kLeast || !(times.back() > times.front())) return found;
  const std::size_t count = std::min(kMost, std::bit_ceil(times.size()));
  std::vector<double> values = resampled(times, signal, count);
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    values[i] = (values[i] - mean) * (0.5 - 0.5 * std::cos(turn));
  }
  values.resize(kPadding * count);
  gsl_fft_real_radix2_transform(values.data(), 1, values.size());
  const std::size_t half = values.size() / 2;
  // The window's mean is 1/2, and a sine of amplitude 1 has half of it at +f and half at -f.
  const double scale = 4.0 / static_cast<double>(count);
  found.step = 1.0 / ((times.back() - times.front()) * static_cast<double>(kPadding));
  found.values.resize(half);
  found.values[0] = 0.0;
  for (std::size_t k = 1; k < half; ++k) {
    found.values[k] = scale * std::hypot(values[k], values[values.size() - k]);
  }
  constexpr std::size_t kFirst = kPadding + kPadding / 2;
  for (std::size_t k = kFirst; k + 1 < half; ++k) {
    if (found.values[k] < found.values[k - 1] || found.values[k] < found.values[k + 1]) continue;
    if (found.values[k] <= found.peak) continue;
    const auto [at, height] = top_of(found.values[k - 1], found.values[k], found.values[k + 1]);
    found.peak = height;
    found.peak_frequency = (static_cast<double>(k) + at) * found.step;
  }
  return found;
}

}  // namespace slipbench::driver::plot
