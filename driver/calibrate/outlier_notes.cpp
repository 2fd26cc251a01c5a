// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/outlier_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "driver/base/text/format_number.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/outliers.hpp"
#include "driver/calibrate/residuals.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::string amount(double number, const std::string& unit) {
  return short_number(number) + (unit.empty() ? "" : " " + unit);
}

/// "t = 0.31 s (line 33): 45.2 N, 12 sigma above the model".
std::string outlier_text(const FittedResponse& response, const std::string& time_unit,
                         std::size_t i) {
  const std::size_t point = response.outliers.points[i];
  const double above = response.measured[point] - response.after[point];
  std::string text =
      fmt::format("t = {:.7g}{}{}", response.time[point], time_unit.empty() ? "" : " ", time_unit);
  if (i < response.lines.size()) text += fmt::format(" (line {})", response.lines[i]);
  const double sigmas = std::abs(above) / response.outliers.scale;
  return text + fmt::format(": {}, {:.{}f} sigma {} the model",
                            amount(response.measured[point], response.unit), sigmas,
                            sigmas < 10.0 ? 1 : 0, above > 0.0 ? "above" : "below");
}

/// Returns what residuals of normal noise may be before they count less, to two digits: as it is
/// told.
double usual_threshold(std::span<const double> residuals) {
  const double usual = kUsualThreshold * robust_scale(residuals);
  return usual > 0.0 ? base::rounded_number(usual, 2) : 0.0;
}

/// Returns whether residuals of the responses are so alike that one threshold serves them all.
bool alike(const Fit& fit, const Calibration& calibration) {
  constexpr double kAlike = 3.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const FittedExperiment& fitted : calibration.experiments) {
    const ExperimentFit& experiment = fit.experiments[fitted.index];
    for (std::size_t k = 0; k < fitted.responses.size(); ++k) {
      if (!is_fitted(experiment, experiment.responses[k])) continue;
      const double size =
          residual_factor(experiment, experiment.responses[k]) * fitted.responses[k].outliers.scale;
      least = std::min(least, size);
      most = std::max(most, size);
    }
  }
  return !(most > kAlike * least);
}

/// "; mu is then 0.3002 instead of 0.3561", of the unknown that moves by most of its error; empty
/// if that is less than one.
std::string move_text(const Calibration& calibration, const fit::LeastSquaresFit& mended) {
  double most = 1.0;
  std::string text;
  for (std::size_t u = 0; u < mended.x.size(); ++u) {
    const double from = calibration.fit.x[u];
    const double errors = std::abs(mended.x[u] - from) / calibration.statistics.standard_error[u];
    if (!(errors > most)) continue;
    most = errors;
    text = fmt::format("; {} is then {:.4g} instead of {:.4g}", told_name(calibration, u),
                       mended.x[u], from);
  }
  return text;
}

/// Returns how outliers are made to count little, in the words of a fit file, and what that
/// changes; empty if the loss that was asked for does it. The threshold is that of the noise which
/// is left when it is followed: squares go out of the way of outliers until all of the others are
/// off.
std::string remedy(const Fit& fit, const Calibration& calibration) {
  constexpr double kNear = 3.0;
  constexpr int kMostRounds = 5;
  constexpr double kSettled = 0.8;
  const std::string_view helps = " under `calibrate:` lets them count little";
  if (!alike(fit, calibration)) {
    return fmt::format("the sigma of each response and `loss: {{huber: {}}}`{}", kUsualThreshold,
                       helps);
  }
  const std::size_t data = calibration.problem.data_rows;
  double threshold = usual_threshold(std::span(calibration.fit.residuals).first(data));
  const bool asked = fit.loss.kind != fit::Loss::Kind::kSquares;
  if (asked && fit.loss.threshold <= kNear * threshold) return {};
  fit::ResidualProblem problem = calibration.problem;
  fit::SolverOptions options = fit.solver;
  options.starts = 1;
  fit::LeastSquaresFit mended = calibration.fit;
  for (int round = 0; round < kMostRounds && problem.residuals; ++round) {
    for (std::size_t u = 0; u < mended.x.size(); ++u) problem.unknowns[u].start = mended.x[u];
    problem.loss = {fit::Loss::Kind::kHuber, threshold};
    mended = fit::solve_least_squares(problem, options);
    if (!mended.converged) break;
    const double next = usual_threshold(std::span(mended.residuals).first(data));
    if (!(next < kSettled * threshold)) break;
    threshold = next;
  }
  return fmt::format("`loss: {{huber: {}}}`{}{}", threshold, helps,
                     mended.converged ? move_text(calibration, mended) : "");
}

}  // namespace

std::vector<std::string> outlier_notes(const Fit& fit, const Calibration& calibration) {
  constexpr std::size_t kMostTold = 5;
  std::vector<std::string> notes;
  if (calibration.fit.residuals.size() < calibration.problem.data_rows) return notes;
  std::optional<std::string> advice;
  for (const FittedExperiment& fitted : calibration.experiments) {
    const ExperimentFit& experiment = fit.experiments[fitted.index];
    for (std::size_t k = 0; k < fitted.responses.size(); ++k) {
      const FittedResponse& response = fitted.responses[k];
      const std::vector<std::size_t>& points = response.outliers.points;
      if (points.empty()) continue;
      const std::size_t count = response.measured.size();
      std::string text = fmt::format(
          "{}, {}: {} of {} points {}, more than {:.2g} robust sigma (of {}) from the rest and "
          "from "
          "their neighbours (noise has such a point in fewer than 1 of 100 series): ",
          experiment.name, response.quantity, points.size(), count,
          points.size() == 1 ? "is an outlier" : "are outliers", response.outliers.limit,
          amount(response.outliers.scale, response.unit));
      for (std::size_t i = 0; i < std::min(points.size(), kMostTold); ++i) {
        text += (i > 0 ? "; " : "") + outlier_text(response, experiment.base.units.time, i);
      }
      if (points.size() > kMostTold) {
        text += fmt::format("; {} more in the JSON file", points.size() - kMostTold);
      }
      if (!advice) advice = remedy(fit, calibration);
      if (!advice->empty() && is_fitted(experiment, experiment.responses[k])) {
        text += "; if they are faults of the measurement, " + *advice;
        if (points.front() == 0)
          text += "; where the run is still settling, `from` leaves them out";
      }
      notes.push_back(std::move(text));
    }
  }
  return notes;
}

}  // namespace slipbench::driver::calibrate
