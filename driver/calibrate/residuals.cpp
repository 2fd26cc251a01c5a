// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/residuals.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/calibrate/table_lines.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// All that the functions of a problem work with.
struct Assembly {
  std::vector<std::shared_ptr<const ExperimentModel>> models;
  std::vector<std::size_t> first;   ///< row of each of them
  std::vector<std::size_t> counts;  ///< and how many it has
  std::vector<std::size_t> places;  ///< of their points, those without a weight among them
  std::size_t points = 0;
  std::vector<SmoothnessRow> smooth;
  std::vector<double> smooth_factor;
  std::size_t data_rows = 0;
  unsigned threads = 1;
  EvaluationWatch watch;
  std::shared_ptr<ModelValues> seen;
  std::atomic<long> evaluations = 0;
  std::mutex watching;

  /// Values of the models become residuals, and derivatives theirs.
  void weigh(std::size_t m, std::size_t unknowns, std::span<double> r,
             std::span<double> jacobian) const {
    const ExperimentModel& model = *models[m];
    const std::span<const ComparedResponse> responses = model.responses();
    std::size_t next = first[m];
    for (std::size_t k = 0; k < responses.size(); ++k) {
      const ResponseFit& response = model.experiment().responses[k];
      if (!is_fitted(model.experiment(), response)) continue;
      const std::vector<double>& measured = responses[k].measured.value;
      const std::size_t at = next;
      next += measured.size();
      const double factor = residual_factor(model.experiment(), response);
      for (std::size_t i = 0; i < measured.size(); ++i) {
        r[at + i] = factor * (r[at + i] - measured[i]);
      }
      if (factor == 1.0 || jacobian.empty()) continue;
      for (double& slope : jacobian.subspan(at * unknowns, measured.size() * unknowns)) {
        slope *= factor;
      }
    }
  }

  void smoothen(std::span<const double> x, std::span<double> r, std::span<double> jacobian) const {
    const std::size_t n = x.size();
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      double sum = 0.0;
      const std::size_t row = data_rows + i;
      if (!jacobian.empty()) {
        const auto slopes = jacobian.subspan(row * n, n);
        std::fill(slopes.begin(), slopes.end(), 0.0);
      }
      for (std::size_t j = 0; j < 3; ++j) {
        const double weight = smooth_factor[i] * smooth[i].weight[j];
        sum += weight * x[smooth[i].unknown[j]];
        if (!jacobian.empty()) jacobian[row * n + smooth[i].unknown[j]] = weight;
      }
      r[row] = sum;
    }
  }

  void keep(std::span<const double> x, std::span<const double> values) const {
    if (seen->first_x.empty()) {
      seen->first_x.assign(x.begin(), x.end());
      seen->first.assign(values.begin(), values.end());
    }
    seen->last_x.assign(x.begin(), x.end());
    seen->last.assign(values.begin(), values.end());
  }

  /// Values and derivatives of a model with responses that have no weight: only the others have
  /// rows in `r` and `jacobian`.
  /// \param all values of all of its points
  bool run_partly(std::size_t m, std::span<const double> x, std::span<double> all,
                  std::span<double> r, std::span<double> jacobian) const {
    const ExperimentModel& model = *models[m];
    const std::size_t n = x.size();
    std::vector<double> slopes(jacobian.empty() ? 0 : all.size() * n);
    if (!(jacobian.empty() ? model.values(x, all) : model.derivatives(x, all, slopes))) {
      return false;
    }
    std::size_t row = 0;
    for (std::size_t k = 0; k < model.responses().size(); ++k) {
      if (!is_fitted(model.experiment(), model.experiment().responses[k])) continue;
      const ComparedResponse& response = model.responses()[k];
      const std::size_t count = response.measured.value.size();
      const auto values = all.subspan(response.first, count);
      std::copy(values.begin(), values.end(), r.subspan(row).begin());
      if (!jacobian.empty()) {
        const auto some = std::span(slopes).subspan(response.first * n, count * n);
        std::copy(some.begin(), some.end(), jacobian.subspan(row * n).begin());
      }
      row += count;
    }
    return true;
  }

  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> jacobian) {
    const std::size_t n = x.size();
    std::vector<char> good(models.size(), 0);
    // Beside the rows, only where some points have none.
    std::vector<double> all(points > data_rows ? points : 0);
    const auto run = [&](std::size_t m) {
      const auto values = r.subspan(first[m], counts[m]);
      const auto slopes =
          jacobian.empty() ? jacobian : jacobian.subspan(first[m] * n, counts[m] * n);
      if (all.empty()) {
        good[m] = jacobian.empty() ? models[m]->values(x, values)
                                   : models[m]->derivatives(x, values, slopes);
      } else {
        const auto here = std::span(all).subspan(places[m], models[m]->points());
        good[m] = run_partly(m, x, here, values, slopes);
      }
    };
    base::for_each_index(models.size(), threads, run);
    const long count = ++evaluations;
    if (std::find(good.begin(), good.end(), 0) != good.end()) return false;
    if (!jacobian.empty()) keep(x, all.empty() ? r.first(data_rows) : std::span<double>(all));
    for (std::size_t m = 0; m < models.size(); ++m) weigh(m, n, r, jacobian);
    smoothen(x, r, jacobian);
    if (watch) {
      double sum = 0.0;
      for (const double residual : r) sum += residual * residual;
      const std::lock_guard<std::mutex> alone(watching);
      watch(count, 0.5 * sum);
    }
    return true;
  }
};

/// The weighted sum of squares of all measurements about the means of their responses.
double measured_squares(std::span<const std::shared_ptr<const ExperimentModel>> models) {
  double sum = 0.0;
  for (const auto& model : models) {
    const std::span<const ComparedResponse> responses = model->responses();
    for (std::size_t k = 0; k < responses.size(); ++k) {
      const std::vector<double>& measured = responses[k].measured.value;
      double mean = 0.0;
      for (const double value : measured) mean += value;
      mean /= static_cast<double>(std::max<std::size_t>(measured.size(), 1));
      const double factor = residual_factor(model->experiment(), model->experiment().responses[k]);
      for (const double value : measured) sum += std::pow(factor * (value - mean), 2);
    }
  }
  return sum;
}

/// A table of the fitted cases, at its start.
const law::Table* start_table(std::span<const std::shared_ptr<const ExperimentModel>> models,
                              const VariedTable& varied) {
  for (const auto& model : models) {
    const cases::Case& problem = model->experiment().base;
    const auto with = definitions_with(problem, varied);
    if (with.empty()) continue;
    return &varied_table(problem.definitions[with.front()].law, varied.use)->table();
  }
  return nullptr;
}

}  // namespace

double residual_factor(const ExperimentFit& experiment, const ResponseFit& response) {
  return std::sqrt(experiment.weight * response.weight) / response.sigma.value_or(1.0);
}

bool is_fitted(const ExperimentFit& experiment, const ResponseFit& response) {
  return !experiment.held_out && experiment.weight * response.weight > 0.0;
}

std::size_t fitted_points(const ExperimentModel& model) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < model.responses().size(); ++k) {
    if (!is_fitted(model.experiment(), model.experiment().responses[k])) continue;
    count += model.responses()[k].measured.value.size();
  }
  return count;
}

fit::ResidualProblem residual_problem(const Fit& fit,
                                      std::vector<std::shared_ptr<const ExperimentModel>> models,
                                      const ModelOptions& options, EvaluationWatch watch,
                                      std::shared_ptr<ModelValues> values) {
  const auto assembly = std::make_shared<Assembly>();
  fit::ResidualProblem problem;
  problem.unknowns = options.unknowns;
  problem.loss = fit.loss;
  std::size_t work = 0;
  for (const auto& model : models) {
    assembly->first.push_back(assembly->data_rows);
    assembly->places.push_back(assembly->points);
    assembly->points += model->points();
    for (std::size_t k = 0; k < model->responses().size(); ++k) {
      if (!is_fitted(model->experiment(), model->experiment().responses[k])) continue;
      problem.groups.push_back(assembly->data_rows);
      assembly->data_rows += model->responses()[k].measured.value.size();
    }
    assembly->counts.push_back(assembly->data_rows - assembly->first.back());
    work += model->run_rows();
  }
  const double squares = measured_squares(models);
  for (const VariedOrdinates& ordinates : options.ordinates) {
    const VariedTable& varied = fit.tables[ordinates.table];
    const law::Table* table = start_table(models, varied);
    if (table == nullptr) continue;
    for (fit::ShapedBlock& block : shaped_blocks(*table, varied.shape, ordinates.first_unknown)) {
      problem.shapes.push_back(std::move(block));
    }
    if (varied.smoothness == 0.0) continue;
    for (const SmoothnessRow& row :
         smoothness_rows(*table, ordinates.column, ordinates.first_unknown)) {
      assembly->smooth.push_back(row);
      assembly->smooth_factor.push_back(std::sqrt(varied.smoothness * squares));
    }
  }
  // Below so many increments, threads cost more than they bring.
  constexpr std::size_t kWorthThreads = 5000;
  assembly->threads = work >= kWorthThreads ? options.threads : 1;
  assembly->models = std::move(models);
  assembly->watch = std::move(watch);
  assembly->seen = std::move(values);
  problem.data_rows = assembly->data_rows;
  problem.rows = assembly->data_rows + assembly->smooth.size();
  // Of several experiments each has its own thread already.
  problem.threads = assembly->models.size() > 1 ? 1 : assembly->threads;
  // Also where the law is replayed, slopes of what expressions make of the unknowns are
  // differences.
  problem.derivative_accuracy = 1e-9;
  problem.residuals = [assembly](std::span<const double> x, std::span<double> r) {
    return assembly->evaluate(x, r, {});
  };
  problem.derivatives = [assembly](std::span<const double> x, std::span<double> r,
                                   std::span<double> jacobian) {
    return assembly->evaluate(x, r, jacobian);
  };
  return problem;
}

}  // namespace slipbench::driver::calibrate
