// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "driver/calibrate/table_lines.hpp"
#include "driver/suite/work_crew.hpp"

namespace slipbench::driver {
namespace {

/// All that the functions of a problem work with.
struct Assembly {
  std::vector<std::shared_ptr<const ExperimentModel>> models;
  std::vector<std::size_t> first;  ///< row of each of them
  std::vector<SmoothnessRow> smooth;
  std::vector<double> smooth_factor;
  std::size_t data_rows = 0;
  unsigned threads = 1;
  EvaluationWatch watch;
  std::shared_ptr<ModelValues> seen;
  long evaluations = 0;

  /// The first point with derivatives: a search looks at its start, and then begins there.
  struct Start {
    std::vector<double> x;
    std::vector<double> r;
    std::vector<double> jacobian;
  };
  std::optional<Start> start;

  /// Values of the models become residuals, and derivatives theirs.
  void weigh(std::size_t m, std::size_t unknowns, std::span<double> r,
             std::span<double> jacobian) const {
    const ExperimentModel& model = *models[m];
    const std::span<const ComparedResponse> responses = model.responses();
    for (std::size_t k = 0; k < responses.size(); ++k) {
      const std::vector<double>& measured = responses[k].measured.value;
      const std::size_t at = first[m] + responses[k].first;
      const double factor = residual_factor(model.experiment(), model.experiment().responses[k]);
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

  bool derivatives(std::span<const double> x, std::span<double> r, std::span<double> jacobian) {
    if (start && std::equal(x.begin(), x.end(), start->x.begin(), start->x.end())) {
      std::copy(start->r.begin(), start->r.end(), r.begin());
      std::copy(start->jacobian.begin(), start->jacobian.end(), jacobian.begin());
      return true;
    }
    const bool is_first = evaluations == 0;
    if (!evaluate(x, r, jacobian)) return false;
    if (is_first) {
      start = Start{{x.begin(), x.end()}, {r.begin(), r.end()}, {jacobian.begin(), jacobian.end()}};
    }
    return true;
  }

  void keep(std::span<const double> x, std::span<const double> values) const {
    if (seen->first_x.empty()) {
      seen->first_x.assign(x.begin(), x.end());
      seen->first.assign(values.begin(), values.end());
    }
    seen->last_x.assign(x.begin(), x.end());
    seen->last.assign(values.begin(), values.end());
  }

  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> jacobian) {
    const std::size_t n = x.size();
    std::vector<char> good(models.size(), 0);
    const auto run = [&](std::size_t m) {
      const auto values = r.subspan(first[m], models[m]->points());
      good[m] = jacobian.empty()
                    ? models[m]->values(x, values)
                    : models[m]->derivatives(
                          x, values, jacobian.subspan(first[m] * n, models[m]->points() * n));
    };
    for_each_index(models.size(), threads, run);
    ++evaluations;
    if (std::find(good.begin(), good.end(), 0) != good.end()) return false;
    if (!jacobian.empty()) keep(x, r.first(data_rows));
    for (std::size_t m = 0; m < models.size(); ++m) weigh(m, n, r, jacobian);
    smoothen(x, r, jacobian);
    if (watch) {
      double sum = 0.0;
      for (const double residual : r) sum += residual * residual;
      watch(evaluations, 0.5 * sum);
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
    const Case& problem = model->experiment().base;
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

ResidualProblem residual_problem(const Fit& fit,
                                 std::vector<std::shared_ptr<const ExperimentModel>> models,
                                 const ModelOptions& options, EvaluationWatch watch,
                                 std::shared_ptr<ModelValues> values) {
  const auto assembly = std::make_shared<Assembly>();
  ResidualProblem problem;
  problem.unknowns = options.unknowns;
  problem.loss = fit.loss;
  std::size_t work = 0;
  for (const auto& model : models) {
    assembly->first.push_back(assembly->data_rows);
    assembly->data_rows += model->points();
    work += model->run_rows();
  }
  const double squares = measured_squares(models);
  for (const VariedOrdinates& ordinates : options.ordinates) {
    const VariedTable& varied = fit.tables[ordinates.table];
    const law::Table* table = start_table(models, varied);
    if (table == nullptr) continue;
    for (ShapedBlock& block : shaped_blocks(*table, varied.shape, ordinates.first_unknown)) {
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
  problem.residuals = [assembly](std::span<const double> x, std::span<double> r) {
    return assembly->evaluate(x, r, {});
  };
  problem.derivatives = [assembly](std::span<const double> x, std::span<double> r,
                                   std::span<double> jacobian) {
    return assembly->derivatives(x, r, jacobian);
  };
  return problem;
}

}  // namespace slipbench::driver
