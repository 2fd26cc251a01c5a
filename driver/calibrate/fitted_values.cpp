// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fitted_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/residuals.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Part of the measured range below which residuals are rounding, as of data without noise.
constexpr double kRounding = 1e-9;

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
        told_name(calibration, u), lower ? "lower" : "upper",
        lower ? unknown.range.lower : unknown.range.upper, lower ? "less" : "more"));
  }
}

void note_starts(const Calibration& calibration, std::vector<std::string>& notes) {
  const fit::LeastSquaresFit& fit = calibration.fit;
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    if (u >= fit.moved_inside.size() || fit.moved_inside[u] == 0 || fit.searches.empty()) continue;
    const FittedUnknown& unknown = calibration.unknowns[u];
    notes.push_back(
        fmt::format("the start {:.6g} of {} is on a bound, or not of the shape that is wanted: the "
                    "search began at {:.6g}",
                    unknown.range.start, told_name(calibration, u), fit.searches.front().start[u]));
  }
}

void note_trends(const Fit& fit, const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kTrend = 0.5;
  constexpr std::size_t kFewest = 20;
  bool confined = false;
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    const auto ended = [&](const std::vector<char>& at) { return u < at.size() && at[u] != 0; };
    confined = confined || !calibration.unknowns[u].held_by.empty() ||
               ended(calibration.fit.at_lower) || ended(calibration.fit.at_upper);
  }
  for (const FittedExperiment& experiment : calibration.experiments) {
    if (fit.experiments[experiment.index].held_out) continue;
    for (const FittedResponse& response : experiment.responses) {
      // What is left of data without noise is rounding, and that may look like anything.
      const bool rounding = !(response.rmse_after > kRounding * response.range);
      if (response.measured.size() < kFewest || rounding) continue;
      // Outliers bend a fit by squares until what is left of the others looks like a trend.
      const bool bent =
          fit.loss.kind == fit::Loss::Kind::kSquares && !response.outliers.points.empty();
      if (bent || !(response.autocorrelation > kTrend)) continue;
      notes.push_back(fmt::format(
          "{}, {}: what is left ({} rms) is a trend, not noise (autocorrelation {:.2f} from one "
          "point to the next): the model{} lacks something, and standard errors are too small",
          fit.experiments[experiment.index].name, response.quantity,
          with_unit(response.rmse_after, response.unit), response.autocorrelation,
          confined ? ", as far as bounds and shapes allow it," : ""));
    }
  }
}

/// An error for its size: in standard deviations of the measurement, or as a part of the range that
/// the measured values have together with 0, so that a steady force is as large as a loop of it.
double for_its_size(const FittedResponse& response, std::optional<double> sigma) {
  if (sigma) return response.rmse_after / *sigma;
  const auto [least, most] =
      std::minmax_element(response.measured.begin(), response.measured.end());
  const double range = std::max(*most, 0.0) - std::min(*least, 0.0);
  return range > 0.0 ? response.rmse_after / range : response.rmse_after;
}

struct FittedError {
  double rmse = 0.0;
  double for_its_size = 0.0;
};

/// The largest error, for its size, of the fitted responses of a quantity whose noise is like that
/// of a hold-out: means of cycles have less than rows. Nothing if none is fitted so.
/// \param by_sigma whether they have a standard deviation
std::optional<FittedError> fitted_error(const Fit& fit, const Calibration& calibration,
                                        const ExperimentFit& hold_out, const std::string& quantity,
                                        bool by_sigma) {
  std::optional<FittedError> largest;
  for (const FittedExperiment& experiment : calibration.experiments) {
    const ExperimentFit& asked = fit.experiments[experiment.index];
    if (asked.average_cycles.has_value() != hold_out.average_cycles.has_value()) continue;
    for (std::size_t r = 0; r < experiment.responses.size(); ++r) {
      const FittedResponse& response = experiment.responses[r];
      if (response.quantity != quantity || !is_fitted(asked, asked.responses[r])) continue;
      const std::optional<double> sigma =
          by_sigma ? asked.responses[r].sigma : std::optional<double>();
      if (by_sigma && !sigma) continue;
      const double error = for_its_size(response, sigma);
      if (!largest || error > largest->for_its_size) largest = {response.rmse_after, error};
    }
  }
  return largest;
}

void note_hold_outs(const Fit& fit, const Calibration& calibration,
                    std::vector<std::string>& notes) {
  constexpr double kMuchWorse = 1.5;
  for (const FittedExperiment& experiment : calibration.experiments) {
    const ExperimentFit& asked = fit.experiments[experiment.index];
    if (!asked.held_out) continue;
    for (std::size_t r = 0; r < experiment.responses.size(); ++r) {
      const FittedResponse& response = experiment.responses[r];
      std::optional<double> sigma = asked.responses[r].sigma;
      auto fitted = fitted_error(fit, calibration, asked, response.quantity, sigma.has_value());
      if (!fitted && sigma) {
        sigma.reset();
        fitted = fitted_error(fit, calibration, asked, response.quantity, false);
      }
      const double error = for_its_size(response, sigma);
      if (!fitted || !(error > kMuchWorse * std::max(fitted->for_its_size, kRounding))) continue;
      const auto size = [&](double number) {
        return sigma ? fmt::format("{:.2g} sigma", number)
                     : fmt::format("{:.2g} % of its range", 100.0 * number);
      };
      notes.push_back(fmt::format(
          "hold-out {}, {}: RMSE {} ({}) against {} ({}) of the fitted data: what was found does "
          "not carry over; fewer unknowns, more smoothness or more experiments may help",
          asked.name, response.quantity, with_unit(response.rmse_after, response.unit), size(error),
          with_unit(fitted->rmse, response.unit), size(fitted->for_its_size)));
    }
  }
}

void note_weights(const Fit& fit, std::vector<std::string>& notes) {
  for (const ExperimentFit& experiment : fit.experiments) {
    if (experiment.weight == 0.0) {
      notes.push_back(fmt::format("{} has the weight 0: it is scored like a hold-out, not fitted",
                                  experiment.name));
      continue;
    }
    for (const ResponseFit& response : experiment.responses) {
      if (response.weight > 0.0) continue;
      notes.push_back(fmt::format("{}, {} has the weight 0: it is scored, not fitted",
                                  experiment.name, response.quantity_text));
    }
  }
}

/// Notes how many starts ended where, for the verdict; other minima that fit nearly as well are
/// something to look at.
void note_minima(const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kNearlyAsGood = 2.0;
  const fit::LeastSquaresFit& fit = calibration.fit;
  std::size_t others = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const fit::SearchTrace& search : fit.searches) {
    if (!fit::is_convergence(search.stop) || found_the_minimum(fit, search)) continue;
    if (!(search.cost <= kNearlyAsGood * fit.cost)) continue;
    ++others;
    nearest = std::min(nearest, search.cost);
  }
  if (others == 0) return;
  notes.push_back(fmt::format(
      "{} of {} starts converged elsewhere and fit{} nearly as well, the best at {:.4g} times the "
      "cost of this one: the data hardly decide between them",
      others, fit.searches.size(), others == 1 ? "s" : "", nearest / fit.cost));
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
    const base::UnitSystem& units = experiment.base.units;
    FittedResponse response;
    response.quantity = asked.quantity_text;
    if (asked.dimension) response.unit = base::unit_text(*asked.dimension, units);
    if (asked.over) {
      response.over = *asked.over;
      response.over_unit = base::unit_text(asked.over_dimension, units);
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
    response.outliers = find_outliers(left, kRounding * response.range);
    response.autocorrelation = lag_one_autocorrelation(other_residuals(left, response.outliers));
    for (const std::size_t point : response.outliers.points) {
      if (compared.measured.line.empty()) break;
      response.lines.push_back(static_cast<std::size_t>(compared.measured.line[point]));
    }
    if (!compared.position.empty()) {
      response.position = compared.position;
      const bool angle = compared.position.starts_with("CPR");
      response.position_unit = base::unit_text(angle ? base::kAngle : base::kLength, units);
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
  note_weights(fit, notes);
  note_outliers(calibration, notes);
  return notes;
}

}  // namespace slipbench::driver::calibrate
