// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "driver/calibrate/least_squares/loss.hpp"
#include "driver/calibrate/least_squares/problem.hpp"
#include "driver/calibrate/least_squares/search.hpp"
#include "driver/calibrate/least_squares/starting_points.hpp"

namespace slipbench::driver {
namespace {

/// How far inside of a fold a start is moved, in its coordinate: 0.25 % of the way between two
/// bounds.
constexpr double kInset = 0.1;

/// Whether an unknown changes any residual.
std::vector<char> silent_unknowns(std::span<const double> jacobian, std::size_t unknowns) {
  std::vector<char> silent(unknowns, 1);
  for (std::size_t j = 0; j < unknowns; ++j) {
    for (std::size_t i = j; i < jacobian.size() && silent[j] != 0; i += unknowns) {
      if (jacobian[i] != 0.0) silent[j] = 0;
    }
  }
  return silent;
}

/// The unknowns that no residual depends on at any of the starts.
std::vector<char> frozen_unknowns(Evaluator& evaluator, const UnknownMap& map,
                                  std::span<const std::vector<double>> starts) {
  std::vector<char> frozen(evaluator.unknowns(), 1);
  std::vector<double> x(evaluator.unknowns());
  std::vector<double> r(evaluator.rows());
  std::vector<double> jacobian(evaluator.rows() * evaluator.unknowns());
  bool found = false;
  for (const std::vector<double>& start : starts) {
    map.unknowns(map.coordinates(start, kInset), x);
    if (!evaluator.derivatives(x, r, jacobian, false)) continue;
    found = true;
    const std::vector<char> silent = silent_unknowns(jacobian, x.size());
    for (std::size_t j = 0; j < x.size(); ++j) frozen[j] = frozen[j] != 0 && silent[j] != 0;
    if (std::none_of(frozen.begin(), frozen.end(), [](char f) { return f != 0; })) break;
  }
  if (!found) std::fill(frozen.begin(), frozen.end(), 0);
  return frozen;
}

/// Whether `a` is the better end: a clearly lower cost, or the same and converged.
bool better(const SearchEnd& a, const SearchEnd& b) {
  constexpr double kSame = 1e-9;
  const bool a_failed = a.stop == StopReason::kModelFailure;
  const bool b_failed = b.stop == StopReason::kModelFailure;
  if (a_failed != b_failed) return b_failed;
  if (a.point.cost < b.point.cost * (1.0 - kSame)) return true;
  if (b.point.cost < a.point.cost * (1.0 - kSame)) return false;
  return is_convergence(a.stop) && !is_convergence(b.stop);
}

/// Whether a search found no minimum, or one at which some unknown has no effect: it may have
/// escaped along a valley.
bool lost(const SearchEnd& end) {
  return end.stop == StopReason::kIterations ||
         (end.degenerate && (is_convergence(end.stop) || end.stop == StopReason::kNoProgress));
}

/// One search from a start. If it is lost: by magnitudes, and from there as before; and if that is
/// lost as well, with another scaling of the trust region.
SearchEnd search_from(Evaluator& evaluator, const UnknownMap& map, std::span<const char> frozen,
                      std::span<const double> z, const SolverOptions& options) {
  SearchEnd best = search(evaluator, map, z, options);
  const ResidualProblem& problem = evaluator.problem();
  const double start_cost = best.start_cost;
  if (lost(best) && UnknownMap::has_magnitudes(problem)) {
    const UnknownMap magnitudes(problem, frozen, UnknownMap::Unbounded::kMagnitudes);
    std::vector<double> x(evaluator.unknowns());
    map.unknowns(z, x);
    const SearchEnd second =
        search(evaluator, magnitudes, magnitudes.coordinates(x, kInset), options);
    if (better(second, best)) {
      SearchEnd third = search(evaluator, map, map.coordinates(second.point.x, 0.0), options);
      if (third.stop == StopReason::kNoIteration) third.stop = second.stop;
      third.iterations += second.iterations;
      if (better(third, best)) best = std::move(third);
    }
  }
  if (lost(best)) {
    SearchEnd other = search(evaluator, map, z, options, TrustScaling::kLevenberg);
    if (better(other, best)) best = std::move(other);
  }
  best.start_cost = start_cost;
  return best;
}

void mark_bounds(const ResidualProblem& problem, LeastSquaresFit& fit) {
  constexpr double kAt = 1e-8;
  for (std::size_t j = 0; j < fit.x.size(); ++j) {
    const UnknownRange& range = problem.unknowns[j];
    double width = range.upper - range.lower;
    if (!std::isfinite(width)) width = std::max(std::abs(fit.x[j]), std::abs(range.start));
    fit.at_lower[j] = fit.frozen[j] == 0 && fit.x[j] - range.lower <= kAt * width;
    fit.at_upper[j] = fit.frozen[j] == 0 && range.upper - fit.x[j] <= kAt * width;
  }
}

}  // namespace

LeastSquaresFit solve_least_squares(const ResidualProblem& problem, const SolverOptions& options) {
  // What goes wrong is told by return values; GSL's own handler would end the program.
  gsl_set_error_handler_off();
  const std::size_t n = problem.unknowns.size();
  LeastSquaresFit fit;
  fit.frozen.assign(n, 0);
  fit.at_lower.assign(n, 0);
  fit.at_upper.assign(n, 0);
  fit.moved_inside.assign(n, 0);

  std::vector<std::vector<double>> starts(1);
  for (const UnknownRange& range : problem.unknowns) starts[0].push_back(range.start);
  for (std::vector<double>& start : starting_points(problem, options.starts - 1, options.seed)) {
    starts.push_back(std::move(start));
  }

  Evaluator evaluator(problem);
  std::vector<char> frozen = fit.frozen;
  if (n > 0 && problem.rows > 0) {
    frozen = frozen_unknowns(evaluator, UnknownMap(problem, frozen), starts);
  }
  const bool all_frozen = std::all_of(frozen.begin(), frozen.end(), [](char f) { return f != 0; });
  const std::vector<char> map_frozen = all_frozen ? fit.frozen : frozen;
  const UnknownMap map(problem, map_frozen);
  std::vector<SearchEnd> ends;
  std::size_t best = 0;
  for (const std::vector<double>& start : starts) {
    const std::vector<double> z = map.coordinates(start, kInset);
    std::vector<double> from(n);
    map.unknowns(z, from);
    ends.push_back(search_from(evaluator, map, map_frozen, z, options));
    const SearchEnd& end = ends.back();
    fit.searches.push_back(
        {from, end.point.x, end.start_cost, end.point.cost, end.iterations, end.stop});
    if (better(end, ends[best])) best = ends.size() - 1;
  }

  SearchEnd& end = ends[best];
  fit.frozen = frozen;
  for (std::size_t j = 0; j < n; ++j) {
    const double moved = std::abs(fit.searches[0].start[j] - starts[0][j]);
    fit.moved_inside[j] = frozen[j] == 0 && moved > 1e-9 * std::abs(starts[0][j]);
  }
  fit.x = end.point.x;
  fit.start_cost = ends[0].start_cost;
  fit.cost = end.point.cost;
  fit.stop = end.stop;
  fit.converged = is_convergence(fit.stop);
  fit.stop_sentence = stop_text(fit.stop);
  if (fit.converged && end.at_kink) {
    fit.stop_sentence = fmt::format(
        "at a kink of the model, where the gradient jumps: the steps left are below {} standard "
        "errors",
        end.step_left);
  }
  fit.iterations = end.iterations;
  fit.gradient_norm = end.offset;
  fit.polished = end.polished;
  fit.residuals = std::move(end.point.residuals);
  fit.jacobian = std::move(end.point.jacobian);
  fit.jacobian.resize(problem.rows * n);
  fit.weights = row_weights(problem, fit.residuals);
  fit.residual_evaluations = evaluator.residual_evaluations();
  fit.derivative_evaluations = evaluator.derivative_evaluations();
  mark_bounds(problem, fit);
  return fit;
}

}  // namespace slipbench::driver
