// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/iso18571.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "driver/check/criteria/ascending.hpp"
#include "driver/check/criteria/bounds.hpp"

namespace slipbench::driver::check {
namespace {

constexpr std::size_t kSamples = 1000;
constexpr double kInnerCorridor = 0.05;
constexpr double kOuterCorridor = 0.50;
constexpr std::size_t kLargestShift = kSamples / 5;
constexpr double kWarpingWindow = 0.1;
constexpr double kMagnitudeLimit = 0.50;
constexpr double kSlopeLimit = 2.0;
constexpr std::size_t kSmoothing = 9;
constexpr double kCorridorWeight = 0.4;
constexpr double kOtherWeight = 0.2;

/// Correlations and warping costs that differ by less are equal but for rounding.
constexpr double kTie = 1e-12;
/// A signal that varies by less than this part of the reference's magnitude is constant.
constexpr double kConstant = 1e-9;

using Samples = std::span<const double>;

double score(double error, double limit) { return error < limit ? 1.0 - error / limit : 0.0; }

/// A relative error, of a reference that may be zero in the part compared.
double ratio(double numerator, double denominator) {
  if (numerator == 0.0) return 0.0;
  return denominator > 0.0 ? numerator / denominator : std::numeric_limits<double>::infinity();
}

double corridor_score(Samples f, Samples r) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double apart = std::abs(f[i] - r[i]);
    if (apart <= kInnerCorridor) {
      sum += 1.0;
    } else if (apart < kOuterCorridor) {
      const double part = (kOuterCorridor - apart) / (kOuterCorridor - kInnerCorridor);
      sum += part * part;
    }
  }
  return sum / static_cast<double>(f.size());
}

double mean(Samples x) {
  double sum = 0.0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

/// Returns the means of the first samples, of one and more.
std::vector<double> means_up_to(Samples x) {
  std::vector<double> means;
  means.reserve(x.size());
  double sum = 0.0;
  for (const double value : x) {
    sum += value;
    means.push_back(sum / static_cast<double>(means.size() + 1));
  }
  return means;
}

/// Sums of products of two signals, each less its mean.
struct Products {
  double ff = 0.0;
  double rr = 0.0;
  double fr = 0.0;
};

/// Adds them up. Stands alone: beside the calls of roots the sums would leave the registers at -O1.
[[gnu::noinline]] Products products(Samples f, Samples r, double f_mean, double r_mean) {
  double ff = 0.0, rr = 0.0, fr = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double a = f[i] - f_mean, b = r[i] - r_mean;
    ff += a * a;
    rr += b * b;
    fr += a * b;
  }
  return {ff, rr, fr};
}

/// Pearson's coefficient; NaN, which no comparison prefers, if one of the signals is constant.
double correlation(Samples f, Samples r, double f_mean, double r_mean) {
  const auto [ff, rr, fr] = products(f, r, f_mean, r_mean);
  const double least = kConstant * kConstant * static_cast<double>(f.size());
  if (!(ff > least && rr > least)) return std::numeric_limits<double>::quiet_NaN();
  return fr / (std::sqrt(ff) * std::sqrt(rr));
}

/// Two signals, one of them shifted, as far as they overlap.
struct Shifted {
  std::size_t steps = 0;
  bool late = false;  ///< the result comes after the reference
  bool correlates = false;
  Samples f;
  Samples r;
};

Shifted best_shift(Samples f, Samples r) {
  Shifted best{0, false, false, f, r};
  const std::vector<double> f_means = means_up_to(f), r_means = means_up_to(r);
  double highest = correlation(f, r, f_means.back(), r_means.back());
  best.correlates = std::isfinite(highest);
  if (!best.correlates) highest = -std::numeric_limits<double>::infinity();
  const auto attempt = [&](const Shifted& candidate, double f_mean, double r_mean) {
    const double found = correlation(candidate.f, candidate.r, f_mean, r_mean);
    if (!(found > highest + kTie)) return;
    highest = found;
    best = candidate;
  };
  for (std::size_t n = 1; n <= kLargestShift; ++n) {
    const std::size_t rest = f.size() - n;
    // In one loop, as neither sum waits for the other.
    double f_sum = 0.0, r_sum = 0.0;
    for (std::size_t i = n; i < f.size(); ++i) {
      f_sum += f[i];
      r_sum += r[i];
    }
    const auto count = static_cast<double>(rest);
    attempt({n, true, true, f.subspan(n), r.first(rest)}, f_sum / count, r_means[rest - 1]);
    attempt({n, false, true, f.first(rest), r.subspan(n)}, f_means[rest - 1], r_sum / count);
  }
  return best;
}

/// The error of magnitude along the cheapest warping path, both sums carried along with its cost.
double magnitude_error(Samples f, Samples r) {
  struct Cell {
    double cost = std::numeric_limits<double>::infinity();
    double apart = 0.0;
    double size = 0.0;
  };
  const std::size_t n = f.size();
  const auto reach =
      static_cast<std::size_t>(std::ceil(kWarpingWindow * static_cast<double>(n))) - 1;
  // Along a diagonal, row plus column, no cell waits for another. Row i stands at i + 1; the cells
  // beside those within reach stay out of it, but for the one before the first of all.
  std::vector<Cell> now(n + 2), before(n + 2), earlier(n + 2);
  earlier[0].cost = 0.0;
  for (std::size_t d = 0; d < 2 * n - 1; ++d) {
    const std::size_t first =
        std::max(d < n ? 0 : d - (n - 1), d < reach ? 0 : (d - reach + 1) / 2);
    const std::size_t last = std::min({d, n - 1, (d + reach) / 2});
    now[first] = now[last + 2] = Cell{};
    for (std::size_t i = first; i <= last; ++i) {
      const double wanted = r[d - i];
      const double apart = std::abs(f[i] - wanted);
      const Cell& aside = before[i + 1].cost < before[i].cost ? before[i + 1] : before[i];
      const Cell& from = earlier[i].cost <= aside.cost + kTie ? earlier[i] : aside;
      now[i + 1] = {from.cost + apart * apart, from.apart + apart, from.size + std::abs(wanted)};
    }
    std::swap(earlier, before);
    std::swap(before, now);
  }
  const Cell& end = before[n];
  return ratio(end.apart, end.size);
}

/// Central differences over one step, one-sided at the ends.
std::vector<double> slopes(Samples x) {
  const std::size_t last = x.size() - 1;
  std::vector<double> out(x.size());
  out[0] = x[1] - x[0];
  out[last] = x[last] - x[last - 1];
  for (std::size_t i = 1; i < last; ++i) out[i] = 0.5 * (x[i + 1] - x[i - 1]);
  return out;
}

/// Moving mean over 9 points, near the ends over 7, 5, 3 and 1.
std::vector<double> smoothed(Samples x) {
  std::vector<double> out(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t half = std::min({kSmoothing / 2, i, x.size() - 1 - i});
    out[i] = mean(x.subspan(i - half, 2 * half + 1));
  }
  return out;
}

double slope_error(Samples f, Samples r) {
  const std::vector<double> f_slope = smoothed(slopes(f)), r_slope = smoothed(slopes(r));
  double apart = 0.0, size = 0.0;
  for (std::size_t i = 0; i < f_slope.size(); ++i) {
    apart += std::abs(f_slope[i] - r_slope[i]);
    size += std::abs(r_slope[i]);
  }
  return ratio(apart, size);
}

Measure reported(const char* name, double value) {
  return {.name = name,
          .unit = MeasureUnit::kNone,
          .value = value,
          .reference = 1.0,
          .deviation = 1.0 - value,
          .scale = 1.0,
          .tolerance = std::numeric_limits<double>::infinity(),
          .where = {}};
}

}  // namespace

CurveComparison compare_iso18571(const Series& result, const Series& reference,
                                 const cases::Tolerance& tolerance) {
  const AscendingCurves curves = ascending_curves(result, reference);
  CurveComparison out;
  out.fault = curves.fault;
  if (!out.fault.empty()) return out;
  out.compared = curves.compared;

  std::vector<double> f = cell_means(curves.result, curves.interval, kSamples);
  std::vector<double> r = cell_means(curves.reference, curves.interval, kSamples);
  const Interval values = extent(r);
  const double size = std::max(std::abs(values.from), std::abs(values.to));
  if (!(values.width() > kConstant * size)) {
    out.fault = "the reference is constant: ISO/TS 18571 rates neither its phase nor its slope";
    return out;
  }
  for (double& value : r) value /= size;
  // What is that far off has no score left; its square must stay a number.
  for (double& value : f) value = std::clamp(value / size, -1e100, 1e100);

  const Shifted shifted = best_shift(f, r);
  const auto steps = static_cast<double>(shifted.steps);
  const double corridor = corridor_score(f, r);
  const double phase = shifted.correlates ? score(steps, static_cast<double>(kLargestShift)) : 0.0;
  const double magnitude = score(magnitude_error(shifted.f, shifted.r), kMagnitudeLimit);
  const double slope = score(slope_error(shifted.f, shifted.r), kSlopeLimit);

  // The loss of each score rather than the score, so that equal curves lose exactly nothing.
  const double lost = kCorridorWeight * (1.0 - corridor) +
                      kOtherWeight * ((1.0 - phase) + (1.0 - magnitude) + (1.0 - slope));
  Measure rating = reported("rating", 1.0 - lost);
  rating.deviation = lost;
  rating.tolerance = value_bound(tolerance, 1.0);
  out.measures.push_back(rating);
  out.measures.push_back(reported("corridor score", corridor));
  out.measures.push_back(reported("phase score", phase));
  out.measures.push_back(reported("magnitude score", magnitude));
  out.measures.push_back(reported("slope score", slope));
  Measure delay = reported("delay", 0.0);
  delay.unit = MeasureUnit::kAbscissa;
  delay.reference = 0.0;
  delay.deviation = steps * curves.interval.width() / static_cast<double>(kSamples);
  delay.value = shifted.late ? delay.deviation : -delay.deviation;
  delay.scale = curves.interval.width();
  if (shifted.steps == 0) delay.value = 0.0;
  out.measures.push_back(delay);
  return out;
}

}  // namespace slipbench::driver::check
