// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "driver/calibrate/experiment_model.hpp"
#include "driver/calibrate/fit.hpp"
#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::calibrate {

/// Called at every evaluation: how many there were, and the sum of squares of the latest over 2.
using EvaluationWatch = std::function<void(long evaluations, double cost)>;

/// Values of the models where they were evaluated first and last with derivatives: before and after
/// the fit, as a rule. All rows of the data.
struct ModelValues {
  std::vector<double> first_x;
  std::vector<double> first;
  std::vector<double> last_x;
  std::vector<double> last;
};

/// The experiments of a fit as one least-squares problem (docs/theory, section 17): rows are
///   sqrt(w_experiment w_response) (model - measured)/sigma
/// of all compared points with a weight above 0, experiment by experiment and response by response,
/// then the rows of smoothness, sqrt(smoothness S) d2, with S the weighted sum of squares of the
/// measurements about their means. The functions of the problem own what they need.
///
/// \param models of the experiments that are fitted
/// \param values is filled by the evaluations
fit::ResidualProblem residual_problem(const Fit& fit,
                                      std::vector<std::shared_ptr<const ExperimentModel>> models,
                                      const ModelOptions& options, EvaluationWatch watch,
                                      std::shared_ptr<ModelValues> values);

/// Returns what a residual of a response is, in the quantity's unit, times this.
double residual_factor(const ExperimentFit& experiment, const ResponseFit& response);

/// Tells whether a response has rows in the problem: with a weight of 0 it has none, and is only
/// scored.
bool is_fitted(const ExperimentFit& experiment, const ResponseFit& response);

/// Rows that an experiment has in the problem: the points of its fitted responses.
std::size_t fitted_points(const ExperimentModel& model);

}  // namespace slipbench::driver::calibrate
