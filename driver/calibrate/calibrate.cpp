// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/calibrate/error_notes.hpp"
#include "driver/calibrate/experiment_model.hpp"
#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fitted_values.hpp"
#include "driver/calibrate/identifiability.hpp"
#include "driver/calibrate/outlier_notes.hpp"
#include "driver/calibrate/residuals.hpp"
#include "driver/calibrate/varied_case.hpp"
#include "driver/results/coverage.hpp"

namespace slipbench::driver::calibrate {
namespace {

using Models = std::vector<std::shared_ptr<const ExperimentModel>>;

/// The case and definition that a table is fitted in first.
struct TableHome {
  const cases::Case* problem = nullptr;
  const law::FrictionDefinition* definition = nullptr;
};

TableHome home_of(const Fit& fit, const VariedTable& table) {
  for (const ExperimentFit& experiment : fit.experiments) {
    const auto with = definitions_with(experiment.base, table);
    if (!with.empty()) {
      return {&experiment.base, &experiment.base.definitions[with.front()].law};
    }
  }
  return {};
}

/// Parameters in the fit's order, then the ordinates of every table.
void describe_unknowns(const Fit& fit, std::span<const VariedOrdinates> ordinates,
                       Calibration& calibration) {
  for (const VariedParameter& parameter : fit.vary) {
    FittedUnknown unknown;
    unknown.name = parameter.name;
    unknown.range = parameter.range;
    calibration.unknowns.push_back(std::move(unknown));
  }
  for (const VariedOrdinates& here : ordinates) {
    const VariedTable& varied = fit.tables[here.table];
    const TableHome home = home_of(fit, varied);
    if (home.definition == nullptr) continue;
    const law::TableFunction& function = *varied_table(*home.definition, varied.use);
    const law::Table& table = function.table();
    FittedTable fitted;
    fitted.index = here.table;
    fitted.first_unknown = here.first_unknown;
    fitted.count = here.count;
    fitted.shape = varied.shape;
    for (const law::Independent& independent : function.independents()) {
      fitted.columns.push_back(results::independent_name(independent));
    }
    const bool moment = law::is_rotational(home.definition->slip);
    for (std::size_t row = 0; row < here.count; ++row) {
      fitted.points.push_back(table.point(row));
      FittedUnknown unknown;
      unknown.name = fmt::format("{}[{}].{}", varied.name, row, varied.free);
      if (varied.use == VariedTable::Use::kInternalContactForce) {
        unknown.unit = base::unit_text(moment ? base::kMoment : base::kForce, home.problem->units);
      }
      unknown.range = {table.ordinate(row, here.column), varied.lower, varied.upper, varied.scale};
      calibration.unknowns.push_back(std::move(unknown));
    }
    calibration.tables.push_back(std::move(fitted));
  }
}

/// Returns how many rows all experiments may compare: as many as there can be in their files, each
/// read once, and 400,000.
std::uintmax_t most_rows(const Fit& fit) {
  std::uintmax_t most = 400'000;
  std::set<std::filesystem::path> files;
  for (const ExperimentFit& one : fit.experiments) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(one.data_path, unknown);
    if (!unknown && files.insert(one.data_path).second) most += size;
  }
  return most;
}

tl::expected<Models, CalibrationFailure> build_models(const Fit& fit, const ModelOptions& options) {
  const std::size_t count = fit.experiments.size();
  Models models(count);
  std::vector<ExperimentModel::Failure> failures(count);
  const std::uintmax_t most = most_rows(fit);
  std::atomic<std::uintmax_t> rows = 0;
  base::for_each_index(count, options.threads, [&](std::size_t i) {
    if (rows > most) return;
    auto model = ExperimentModel::make(fit, fit.experiments[i], options);
    if (model && (rows += model->points()) > most) {
      failures[i].message = fmt::format(
          "{}: the experiments compare more than {} rows together: the same files again and again",
          fit.file, most);
    } else if (model) {
      models[i] = std::make_shared<const ExperimentModel>(std::move(*model));
    } else {
      failures[i] = std::move(model.error());
    }
  });
  CalibrationFailure failure;
  for (std::size_t i = 0; i < count; ++i) {
    if (models[i] != nullptr || failures[i].message.empty()) continue;
    const int code = failures[i].environment ? base::kExitEnvironment
                     : failures[i].numerical ? base::kExitNumerical
                                             : base::kExitBadInput;
    failure.code = failure.message.empty() ? code : base::worse(failure.code, code);
    failure.message += (failure.message.empty() ? "" : "\n") + failures[i].message;
  }
  if (!failure.message.empty()) return tl::unexpected(failure);
  return models;
}

std::string all_of(std::size_t unknowns) {
  return unknowns == 1 ? "the unknown" : fmt::format("all {} unknowns", unknowns);
}

/// Returns how the derivatives of the fitted experiments are found, in a sentence.
std::string derivatives_text(const Fit& fit, const Models& models, std::size_t unknowns) {
  std::vector<std::string> parts;
  bool all_alike = true;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (fit.experiments[i].held_out) continue;
    const ExperimentModel& model = *models[i];
    const std::size_t exact = model.exact().size();
    const std::size_t differences = model.by_differences().size();
    std::string text;
    if (differences == 0) {
      text = "exact derivatives of " + all_of(exact);
    } else if (exact == 0) {
      text = "central differences for " + all_of(differences);
    } else {
      text = fmt::format("exact derivatives of {} unknowns, central differences for {}", exact,
                         differences);
    }
    if (!model.whole_runs_because().empty()) {
      text += fmt::format(" (whole runs: {})", model.whole_runs_because());
    }
    all_alike =
        all_alike && (parts.empty() || parts.front() == text) && exact + differences <= unknowns;
    parts.push_back(std::move(text));
  }
  if (parts.empty()) return {};
  if (all_alike) return parts.front();
  std::string text;
  for (std::size_t i = 0, part = 0; i < models.size(); ++i) {
    if (fit.experiments[i].held_out) continue;
    text += (text.empty() ? "" : "; ") + fit.experiments[i].name + ": " + parts[part++];
  }
  return text;
}

/// Counts the cells of the fitted tables that the experiments visit at the optimum.
void count_visits(const Fit& fit, const Models& models, unsigned threads,
                  Calibration& calibration) {
  if (calibration.tables.empty()) return;
  struct Visit {
    std::unique_ptr<cases::Case> problem;
    std::unique_ptr<results::Coverage> coverage;
  };
  std::vector<Visit> visits(models.size());
  base::for_each_index(models.size(), threads, [&](std::size_t i) {
    if (fit.experiments[i].held_out) return;
    auto problem = models[i]->case_at(calibration.fit.x);
    if (!problem) return;
    visits[i].problem = std::make_unique<cases::Case>(std::move(*problem));
    visits[i].coverage = std::make_unique<results::Coverage>(*visits[i].problem);
    models[i]->count_cells(calibration.fit.x, *visits[i].problem, *visits[i].coverage);
  });
  for (FittedTable& table : calibration.tables) {
    for (const Visit& visit : visits) {
      if (visit.coverage == nullptr) continue;
      add_visits(fit.tables[table.index], *visit.problem, *visit.coverage, &table);
    }
  }
}

double distance(double from, double to, double width) {
  if (!std::isfinite(from) || !std::isfinite(to)) return std::numeric_limits<double>::infinity();
  return std::isfinite(width) && width > 0.0 ? (to - from) / width
                                             : std::numeric_limits<double>::infinity();
}

void take_values(Calibration& calibration) {
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    FittedUnknown& unknown = calibration.unknowns[u];
    const fit::UnknownRange& range = unknown.range;
    unknown.value = u < calibration.fit.x.size() ? calibration.fit.x[u] : range.start;
    // On the axis that it was searched on.
    const auto at = [&](double x) { return range.scale == fit::Scale::kLog ? std::log(x) : x; };
    const double width = at(range.upper) - at(range.lower);
    unknown.distance_to_lower = distance(at(range.lower), at(unknown.value), width);
    unknown.distance_to_upper = distance(at(unknown.value), at(range.upper), width);
  }
}

/// Before, after, and which part of the cost is whose.
/// \param seen values that need not be found again
void take_experiments(const Models& models, const ModelOptions& options, const ModelValues& seen,
                      Calibration& calibration) {
  std::vector<double> start;
  for (const fit::UnknownRange& range : options.unknowns) start.push_back(range.start);
  std::vector<std::size_t> first(models.size(), 0);
  for (std::size_t i = 1; i < models.size(); ++i) {
    first[i] = first[i - 1] + models[i - 1]->points();
  }
  std::vector<FittedExperiment> fitted(models.size());
  base::for_each_index(models.size(), options.threads, [&](std::size_t i) {
    const std::size_t points = models[i]->points();
    const auto values_at = [&](std::span<const double> x) {
      // Those held out come last, and have no rows.
      const bool is_fitted = !models[i]->experiment().held_out;
      for (const auto& [at, values] :
           {std::tie(seen.first_x, seen.first), std::tie(seen.last_x, seen.last)}) {
        if (!is_fitted || !std::equal(x.begin(), x.end(), at.begin(), at.end())) continue;
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first[i]);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(points));
      }
      std::vector<double> values(points);
      if (x.empty() || !models[i]->values(x, values)) values.clear();
      return values;
    };
    fitted[i] = fitted_experiment(*models[i], i, values_at(start), values_at(calibration.fit.x));
  });
  const std::vector<double>& residuals = calibration.fit.residuals;
  std::size_t row = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i]->experiment().held_out || residuals.empty()) continue;
    double cost = 0.0;
    const std::size_t end = row + fitted_points(*models[i]);
    for (; row < end; ++row) {
      cost += 0.5 * fit::loss_value(calibration.problem.loss, residuals[row]);
    }
    if (calibration.fit.cost > 0.0) fitted[i].share_of_cost = cost / calibration.fit.cost;
  }
  calibration.experiments = std::move(fitted);
}

/// Tells whether the histories that were recorded at the start are still those of the optimum.
bool still_replays(const Models& models, std::span<const double> x) {
  return std::all_of(models.begin(), models.end(), [&](const auto& model) {
    if (model->exact().empty() && model->by_differences().empty()) return true;
    const auto problem = model->case_at(x);
    return !problem || model->replays(*problem);
  });
}

/// Tells whether what was taken as linear at the start is so at the optimum.
bool keep_slopes(const Models& models, std::span<const double> x) {
  return std::all_of(models.begin(), models.end(),
                     [&](const auto& model) { return model->keeps_slopes(x); });
}

struct Search {
  Models models;
  std::shared_ptr<ModelValues> seen = std::make_shared<ModelValues>();
  fit::ResidualProblem problem;
  fit::LeastSquaresFit fit;
};

tl::expected<Search, CalibrationFailure> search(const Fit& fit, const ModelOptions& options,
                                                const EvaluationWatch& watch,
                                                const fit::RunItems& items) {
  auto models = build_models(fit, options);
  if (!models) return tl::unexpected(models.error());
  Search found;
  found.models = std::move(*models);
  Models fitted;
  for (std::size_t i = 0; i < found.models.size(); ++i) {
    if (!fit.experiments[i].held_out) fitted.push_back(found.models[i]);
  }
  found.problem = residual_problem(fit, std::move(fitted), options, watch, found.seen);
  found.problem.items = items;
  found.fit = fit::solve_least_squares(found.problem, fit.solver);
  return found;
}

}  // namespace

tl::expected<Calibration, CalibrationFailure> calibrate(const Fit& fit,
                                                        const CalibrateProgress& progress,
                                                        const CalibrateSettings& settings) {
  const auto begun = std::chrono::steady_clock::now();
  Calibration calibration;
  ModelOptions options;
  options.threads = settings.threads == 0 ? base::core_count() : settings.threads;
  options.ordinates = varied_ordinates(fit);
  options.with_hash = settings.with_hashes;
  describe_unknowns(fit, options.ordinates, calibration);
  for (const FittedUnknown& unknown : calibration.unknowns) {
    options.unknowns.push_back(unknown.range);
  }
  const auto stage = std::make_shared<const char*>("search");
  const EvaluationWatch watch = [stage, step = progress.step](long evaluations, double cost) {
    if (step) step({*stage, evaluations, cost});
  };
  auto found = search(fit, options, progress.step ? watch : EvaluationWatch(), settings.items);
  if (found && !found->fit.x.empty() && !still_replays(found->models, found->fit.x)) {
    options.whole_runs = true;
    found = search(fit, options, progress.step ? watch : EvaluationWatch(), settings.items);
  }
  if (found && !found->fit.x.empty() && !keep_slopes(found->models, found->fit.x)) {
    options.slopes_anew = true;
    found = search(fit, options, progress.step ? watch : EvaluationWatch(), settings.items);
  }
  if (!found) return tl::unexpected(found.error());
  calibration.problem = std::move(found->problem);
  calibration.fit = std::move(found->fit);
  const Models& models = found->models;
  calibration.derivatives = derivatives_text(fit, models, calibration.unknowns.size());
  take_values(calibration);
  take_experiments(models, options, *found->seen, calibration);
  const bool has_optimum = !calibration.fit.jacobian.empty();
  if (has_optimum) {
    calibration.statistics =
        fit::fit_statistics(calibration.problem, calibration.fit, fit.confidence);
    count_visits(fit, models, options.threads, calibration);
    if (fit.bootstrap > 0 && calibration.fit.converged) {
      *stage = "resamplings";
      calibration.bootstrap = fit::bootstrap(calibration.problem, calibration.fit, fit.bootstrap,
                                             fit.confidence, fit.solver.seed);
    }
    *stage = "profiles";
    std::vector<std::size_t> profiled;
    for (std::size_t u = 0; u < fit.vary.size(); ++u) {
      const bool frozen = u < calibration.fit.frozen.size() && calibration.fit.frozen[u] != 0;
      if (fit.profile && !frozen && calibration.fit.converged) profiled.push_back(u);
    }
    const auto profile = [&](std::size_t i) {
      return fit::numbers_of(fit::profile_likelihood(calibration.problem, calibration.fit,
                                                     profiled[i], fit.confidence));
    };
    for (const std::vector<double>& numbers : settings.items
                                                  ? settings.items(profiled.size(), profile)
                                                  : fit::run_here(profiled.size(), profile)) {
      fit::LikelihoodProfile found_profile = fit::profile_of(numbers);
      if (std::isfinite(found_profile.threshold)) {
        calibration.profiles.push_back(std::move(found_profile));
      }
    }
    judge_identifiability(&calibration);
  }
  calibration.notes = calibration_notes(fit, calibration);
  if (has_optimum) {
    *stage = "outliers";
    for (const auto& notes : {outlier_notes(fit, calibration), error_notes(fit, calibration),
                              identifiability_notes(fit, calibration)}) {
      calibration.notes.insert(calibration.notes.end(), notes.begin(), notes.end());
    }
  }
  calibration.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return calibration;
}

}  // namespace slipbench::driver::calibrate
