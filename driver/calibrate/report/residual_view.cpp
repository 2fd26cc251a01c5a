// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/residual_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slipbench::driver::calibrate {
namespace {

constexpr std::size_t kFewestForView = 8;
constexpr std::size_t kMostLags = 40;
/// A lag of noise lies within the band 95 of 100 times; one that counts lies clearly beyond it.
constexpr double kBeyondBand = 1.5;
/// Correlation of neighbours from which the errors of a fit are told to be too small.
constexpr double kStrong = 0.3;
/// Part of the measured range below which residuals are rounding.
constexpr double kRounding = 1e-9;

/// Bins by Freedman and Diaconis' rule, between 8 and 40 of them.
void count_bins(ResidualView& view, std::vector<double> sorted) {
  if (sorted.empty()) return;
  std::sort(sorted.begin(), sorted.end());
  view.lowest = sorted.front();
  view.highest = sorted.back();
  if (!(view.highest > view.lowest)) {
    const double half = view.lowest == 0.0 ? 0.5 : 0.5 * std::abs(view.lowest);
    view.lowest -= half;
    view.highest += half;
  }
  const auto n = static_cast<double>(sorted.size());
  const double quartiles = sorted[sorted.size() * 3 / 4] - sorted[sorted.size() / 4];
  const double width = 2.0 * quartiles / std::cbrt(n);
  const double wanted = width > 0.0 ? (view.highest - view.lowest) / width : 8.0;
  const auto bins = static_cast<std::size_t>(std::clamp(std::ceil(wanted), 8.0, 40.0));
  view.counts.assign(bins, 0);
  for (const double value : sorted) {
    const double part = (value - view.lowest) / (view.highest - view.lowest);
    const auto bin = static_cast<std::size_t>(part * static_cast<double>(bins));
    ++view.counts[std::min(bin, bins - 1)];
  }
}

/// Autocorrelation as usual: of products over all neighbours, by the sum of squares of all.
void correlate(ResidualView& view, std::span<const double> values) {
  if (values.size() < kFewestForView) return;
  double squares = 0.0;
  for (const double value : values) squares += (value - view.mean) * (value - view.mean);
  if (!(squares > 0.0)) return;
  const std::size_t lags = std::min(kMostLags, values.size() / 4);
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    double products = 0.0;
    for (std::size_t i = 0; i + lag < values.size(); ++i) {
      products += (values[i] - view.mean) * (values[i + lag] - view.mean);
    }
    view.autocorrelation.push_back(products / squares);
  }
  view.noise_band = 1.96 / std::sqrt(static_cast<double>(values.size()));
}

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// Tells of a mean that noise alone would hardly have.
std::string bias_words(const ResidualView& view, const std::string& unit, std::size_t points) {
  const double by_chance = 3.0 * view.deviation / std::sqrt(static_cast<double>(points));
  if (std::abs(view.mean) <= std::max(by_chance, 0.2 * view.deviation)) return {};
  return fmt::format(" On average the model is {} {} the measurement.",
                     with_unit(std::abs(view.mean), unit), view.mean > 0.0 ? "above" : "below");
}

void judge(ResidualView& view, const FittedResponse& response, std::size_t points) {
  if (points < kFewestForView) {
    view.words = fmt::format("{} point{}: too few to tell noise from a trend.", points,
                             points == 1 ? "" : "s");
    return;
  }
  if (std::hypot(view.mean, view.deviation) <= kRounding * response.range ||
      view.autocorrelation.empty()) {
    view.words = "Nothing is left but rounding.";
    return;
  }
  // Adding 0 takes the sign from a rounded -0.
  const std::size_t strays = view.outliers.points.size();
  if (strays > 0) {
    view.words = fmt::format("{} of {} points {}, farther than {:.2g} robust sigma from the rest. ",
                             strays, points + strays,
                             strays == 1 ? "is an outlier" : "are outliers", view.outliers.limit);
  }
  const double next = std::round(100.0 * view.autocorrelation.front()) / 100.0 + 0.0;
  const std::string figures = fmt::format(
      "correlation from one point to the next {:.2f}, of noise "
      "within \u00b1{:.2f}",
      next, view.noise_band);
  if (std::abs(next) <= kBeyondBand * view.noise_band) {
    view.words +=
        (strays > 0 ? "The rest looks like noise: " : "Looks like noise: ") + figures + ".";
  } else if (next < 0.0) {
    view.trend = true;
    view.words += "Neighbouring residuals differ in sign (" + figures +
                  "): look for a filter, a delay or a resampling of the data.";
  } else if (next < kStrong) {
    view.trend = true;
    view.words += "Neighbouring residuals are a little alike (" + figures +
                  "): mostly noise; a small part is something that the model does not have.";
  } else {
    view.trend = true;
    view.words += "A trend, no noise: neighbouring residuals are alike (" + figures +
                  "). The data have something that the model does not, and the standard errors "
                  "are too small.";
  }
  const std::string bias = bias_words(view, response.unit, points);
  // A fit by squares goes out of the way of outliers.
  if (strays > 0 && view.trend) view.words += " That may be the outliers' doing: mend them first.";
  view.trend = view.trend || strays > 0 || !bias.empty();
  view.words += bias;
}

}  // namespace

ResidualView residual_view(const FittedResponse& response, std::span<const double> model) {
  ResidualView view;
  std::vector<double> finite;
  const std::size_t points = std::min(model.size(), response.measured.size());
  for (std::size_t i = 0; i < points; ++i) {
    view.residuals.push_back(model[i] - response.measured[i]);
    if (std::isfinite(view.residuals.back())) finite.push_back(view.residuals.back());
  }
  view.outliers = find_outliers(view.residuals, kRounding * response.range);
  const std::vector<double> others = other_residuals(view.residuals, view.outliers);
  if (!others.empty()) {
    const auto n = static_cast<double>(others.size());
    for (const double value : others) view.mean += value / n;
    double squares = 0.0;
    for (const double value : others) squares += (value - view.mean) * (value - view.mean);
    view.deviation = others.size() > 1 ? std::sqrt(squares / (n - 1.0)) : 0.0;
  }
  count_bins(view, finite);
  correlate(view, others);
  judge(view, response, others.size());
  return view;
}

}  // namespace slipbench::driver::calibrate
