// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fitted_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::driver {
namespace {

double root_mean_square(std::span<const double> numbers) {
  double sum = 0.0;
  for (const double number : numbers) sum += number * number;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(numbers.size(), 1)));
}

std::vector<double> difference(std::span<const double> model, std::span<const double> measured) {
  std::vector<double> residuals(measured.size());
  std::transform(model.begin(), model.end(), measured.begin(), residuals.begin(), std::minus<>());
  return residuals;
}

/// `values` of one response, or as many NaN.
std::vector<double> part(std::span<const double> values, std::size_t first, std::size_t count) {
  if (values.empty()) return std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
  const auto some = values.subspan(first, count);
  return {some.begin(), some.end()};
}

std::string with_unit(double number, const std::string& unit) {
  return fmt::format("{:.3g}{}{}", number, unit.empty() ? "" : " ", unit);
}

void note_bounds(const Calibration& calibration, std::vector<std::string>& notes) {
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    const auto ended = [&](const std::vector<char>& at) { return u < at.size() && at[u] != 0; };
    const bool lower = ended(calibration.fit.at_lower);
    if (!lower && !ended(calibration.fit.at_upper)) continue;
    const FittedUnknown& unknown = calibration.unknowns[u];
    notes.push_back(fmt::format(
        "{} ended at its {} bound {:.6g}: the data ask for {} than it allows; its standard error "
        "says nothing there",
        unknown.name, lower ? "lower" : "upper", lower ? unknown.range.lower : unknown.range.upper,
        lower ? "less" : "more"));
  }
}

void note_starts(const Calibration& calibration, std::vector<std::string>& notes) {
  const LeastSquaresFit& fit = calibration.fit;
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    if (u >= fit.moved_inside.size() || fit.moved_inside[u] == 0 || fit.searches.empty()) continue;
    const FittedUnknown& unknown = calibration.unknowns[u];
    notes.push_back(
        fmt::format("the start {:.6g} of {} is on a bound, or not of the shape that is wanted: the "
                    "search began "
                    "at {:.6g}",
                    unknown.range.start, unknown.name, fit.searches.front().start[u]));
  }
}

void note_trends(const Fit& fit, const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kTrend = 0.5;
  constexpr std::size_t kFewest = 20;
  for (const FittedExperiment& experiment : calibration.experiments) {
    if (fit.experiments[experiment.index].held_out) continue;
    for (const FittedResponse& response : experiment.responses) {
      // What is left of data without noise is rounding, and that may look like anything.
      const bool rounding = !(response.rmse_after > 1e-9 * response.range);
      if (response.measured.size() < kFewest || rounding) continue;
      if (!(response.autocorrelation > kTrend)) continue;
      notes.push_back(fmt::format(
          "{}, {}: what is left ({} rms) is a trend, not noise (autocorrelation {:.2f} from one "
          "point to the next): the model lacks something, and standard errors are too small",
          fit.experiments[experiment.index].name, response.quantity,
          with_unit(response.rmse_after, response.unit), response.autocorrelation));
    }
  }
}

/// The largest error of the fitted responses of a quantity; nothing if none is fitted.
std::optional<double> fitted_error(const Fit& fit, const Calibration& calibration,
                                   const std::string& quantity) {
  std::optional<double> largest;
  for (const FittedExperiment& experiment : calibration.experiments) {
    if (fit.experiments[experiment.index].held_out) continue;
    for (const FittedResponse& response : experiment.responses) {
      if (response.quantity != quantity) continue;
      largest = std::max(largest.value_or(0.0), response.rmse_after);
    }
  }
  return largest;
}

void note_hold_outs(const Fit& fit, const Calibration& calibration,
                    std::vector<std::string>& notes) {
  constexpr double kMuchWorse = 1.5;
  for (const FittedExperiment& experiment : calibration.experiments) {
    if (!fit.experiments[experiment.index].held_out) continue;
    for (const FittedResponse& response : experiment.responses) {
      const auto fitted = fitted_error(fit, calibration, response.quantity);
      const double least = 1e-9 * response.range;
      if (!fitted || !(response.rmse_after > kMuchWorse * std::max(*fitted, least))) continue;
      notes.push_back(fmt::format(
          "hold-out {}, {}: RMSE {} against {} of the fitted data: what was found does not carry "
          "over; fewer unknowns, more smoothness or more experiments may help",
          fit.experiments[experiment.index].name, response.quantity,
          with_unit(response.rmse_after, response.unit), with_unit(*fitted, response.unit)));
    }
  }
}

void note_minima(const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kSameCost = 1e-6;
  const LeastSquaresFit& fit = calibration.fit;
  if (fit.searches.size() < 2) return;
  std::size_t same = 0;
  std::size_t others = 0;
  double nearest = std::numeric_limits<double>::infinity();
  const double slack = kSameCost * std::abs(fit.cost) + 1e-15 * std::abs(fit.start_cost);
  for (const SearchTrace& search : fit.searches) {
    if (!is_convergence(search.stop)) continue;
    if (search.cost <= fit.cost + slack) {
      ++same;
    } else {
      ++others;
      nearest = std::min(nearest, search.cost);
    }
  }
  if (others == 0) return;
  notes.push_back(fmt::format(
      "of {} starts {} found this minimum and {} ended in other ones, the best of them at {:.3g} "
      "times its cost",
      fit.searches.size(), same, others, nearest / fit.cost));
}

void note_outliers(const Calibration& calibration, std::vector<std::string>& notes) {
  const std::vector<double>& weights = calibration.fit.weights;
  const auto data = std::min(weights.size(), calibration.problem.data_rows);
  const auto end = weights.begin() + static_cast<std::ptrdiff_t>(data);
  const auto light = std::count_if(weights.begin(), end, [](double w) { return w < 0.5; });
  if (light == 0) return;
  notes.push_back(fmt::format("the robust loss gives {} of {} points less than half their weight",
                              light, data));
}

}  // namespace

double lag_one_autocorrelation(std::span<const double> residuals) {
  if (residuals.size() < 3) return 0.0;
  double mean = 0.0;
  for (const double r : residuals) mean += r;
  mean /= static_cast<double>(residuals.size());
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += (residuals[i] - mean) * (residuals[i] - mean);
    if (i > 0) products += (residuals[i] - mean) * (residuals[i - 1] - mean);
  }
  return squares > 0.0 ? products / squares : 0.0;
}

FittedExperiment fitted_experiment(const ExperimentModel& model, std::size_t index,
                                   std::span<const double> before, std::span<const double> after) {
  const ExperimentFit& experiment = model.experiment();
  FittedExperiment fitted;
  fitted.index = index;
  fitted.rows_read = model.measurements().rows_read;
  fitted.rows_used = model.measurements().rows_used;
  fitted.cleaning = model.measurements().cleaning;
  fitted.cleaning.insert(fitted.cleaning.end(), model.notes().begin(), model.notes().end());
  fitted.data_hash = model.measurements().hash;
  for (std::size_t r = 0; r < experiment.responses.size(); ++r) {
    const ResponseFit& asked = experiment.responses[r];
    const ComparedResponse& compared = model.responses()[r];
    const std::size_t count = compared.measured.time.size();
    const UnitSystem& units = experiment.base.units;
    FittedResponse response;
    response.quantity = asked.quantity_text;
    if (asked.dimension) response.unit = unit_text(*asked.dimension, units);
    if (asked.over) {
      response.over = *asked.over;
      response.over_unit = unit_text(asked.over_dimension, units);
    }
    response.time = compared.measured.time;
    response.abscissa = compared.measured.over;
    response.measured = compared.measured.value;
    response.before = part(before, compared.first, count);
    response.after = part(after, compared.first, count);
    response.rmse_before = root_mean_square(difference(response.before, response.measured));
    const std::vector<double> left = difference(response.after, response.measured);
    response.rmse_after = root_mean_square(left);
    const auto [least, most] =
        std::minmax_element(response.measured.begin(), response.measured.end());
    response.range = *most - *least;
    for (const double residual : left) response.mean_error += residual / static_cast<double>(count);
    response.autocorrelation = lag_one_autocorrelation(left);
    if (!compared.position.empty()) {
      response.position = compared.position;
      const bool angle = compared.position.starts_with("CPR");
      response.position_unit = unit_text(angle ? kAngle : kLength, units);
      response.positions = compared.positions;
    }
    fitted.responses.push_back(std::move(response));
  }
  return fitted;
}

std::vector<std::string> calibration_notes(const Fit& fit, const Calibration& calibration) {
  std::vector<std::string> notes;
  note_starts(calibration, notes);
  note_bounds(calibration, notes);
  note_minima(calibration, notes);
  note_trends(fit, calibration, notes);
  note_hold_outs(fit, calibration, notes);
  note_outliers(calibration, notes);
  return notes;
}

}  // namespace slipbench::driver
