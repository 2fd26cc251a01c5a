// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Rest of a measurement when a fit is taken from it: model - measured, of all points.
struct ResidualView {
  std::vector<double> residuals;  ///< in the quantity's unit; not finite where either value is not
  Outliers outliers;              ///< of them
  double mean = 0.0;              ///< of the others
  double deviation = 0.0;         ///< standard deviation of the others about their mean
  double lowest = 0.0;            ///< edges of the histogram
  double highest = 0.0;
  std::vector<std::int64_t> counts;  ///< of bins of equal width, from `lowest` to `highest`
  /// Correlation of residuals 1, 2, ... points apart, outliers left out; at most 40, empty of fewer
  /// than 8 points.
  std::vector<double> autocorrelation;
  /// Of noise 95 of 100 of them lie within +- this: 1.96/sqrt(points) (Box, Jenkins and Reinsel,
  /// Time Series Analysis, section 2.1.6).
  double noise_band = 0.0;
  bool trend = false;  ///< whether `words` tell of something other than noise
  std::string words;   ///< whether it is noise, outliers or a trend, a sentence or two
};

/// The residuals of a response, before (`model` = response.before) or after the fit.
ResidualView residual_view(const FittedResponse& response, std::span<const double> model);

}  // namespace slipbench::driver::calibrate
