// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/calibrate/fit/search.hpp"
#include "driver/calibrate/fit/starting_points.hpp"

namespace slipbench::driver::fit {
namespace {

/// Distance by which a start is moved inside of a fold, in its coordinate: 0.25 % of the way
/// between two bounds.
constexpr double kInset = 0.1;

/// Part of themselves, or of their range, by which two numbers may differ and count as the same.
constexpr double kSame = 1e-9;

/// Tells whether an unknown changes any residual.
std::vector<char> silent_unknowns(std::span<const double> jacobian, std::size_t unknowns) {
  std::vector<char> silent(unknowns, 1);
  for (std::size_t j = 0; j < unknowns; ++j) {
    for (std::size_t i = j; i < jacobian.size() && silent[j] != 0; i += unknowns) {
      if (jacobian[i] != 0.0) silent[j] = 0;
    }
  }
  return silent;
}

/// Tells whether `a` is the better end: a clearly lower cost, or the same and converged.
bool better(const SearchEnd& a, const SearchEnd& b) {
  const bool a_failed = a.stop == StopReason::kModelFailure;
  const bool b_failed = b.stop == StopReason::kModelFailure;
  if (a_failed != b_failed) return b_failed;
  if (a.point.cost < b.point.cost * (1.0 - kSame)) return true;
  if (b.point.cost < a.point.cost * (1.0 - kSame)) return false;
  return is_convergence(a.stop) && !is_convergence(b.stop);
}

/// Tells whether a search found no minimum, or one at which some unknown has no effect: it may have
/// escaped along a valley.
bool lost(const SearchEnd& end) {
  return end.stop == StopReason::kIterations ||
         (end.degenerate && (is_convergence(end.stop) || end.stop == StopReason::kNoProgress));
}

/// One search from a start. If it is lost: by magnitudes, and from there as before; and if that is
/// lost as well, with another scaling of the trust region.
/// \param point at z with its derivatives, if they are known; is used up
SearchEnd search_from(Evaluator& evaluator, const UnknownMap& map, std::span<const char> frozen,
                      std::span<const double> kept, std::span<const double> z, SearchPoint* point,
                      const SolverOptions& options) {
  SearchEnd best = search(evaluator, map, z, options, TrustScaling::kMore, point);
  const ResidualProblem& problem = evaluator.problem();
  const double start_cost = best.start_cost;
  if (lost(best) && UnknownMap::has_magnitudes(problem)) {
    const UnknownMap magnitudes(problem, frozen, UnknownMap::Unbounded::kMagnitudes, kept);
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

/// Tells whether x is on a bound or beyond, within kSame of what the scale measures.
bool on_bound(const UnknownRange& range, double x, bool upper) {
  const double bound = upper ? range.upper : range.lower;
  if (!std::isfinite(bound)) return false;
  if (upper ? x >= bound : x <= bound) return true;
  const bool between = std::isfinite(range.lower) && std::isfinite(range.upper);
  if (range.scale == Scale::kLog) {
    if (!(bound > 0.0)) return false;
    const double width = between && range.lower > 0.0 ? std::log(range.upper / range.lower) : 1.0;
    return std::abs(std::log(x / bound)) <= kSame * width;
  }
  const double width = between ? range.upper - range.lower : std::max(std::abs(bound), std::abs(x));
  return std::abs(x - bound) <= kSame * width;
}

void mark_bounds(const ResidualProblem& problem, LeastSquaresFit& fit) {
  for (std::size_t j = 0; j < fit.x.size(); ++j) {
    const UnknownRange& range = problem.unknowns[j];
    fit.at_lower[j] = fit.frozen[j] == 0 && on_bound(range, fit.x[j], false);
    fit.at_upper[j] = fit.frozen[j] == 0 && on_bound(range, fit.x[j], true);
  }
}

/// The unknowns whose start is on a bound or beyond, or is not of its shape.
void mark_moved(const ResidualProblem& problem, const UnknownMap& map, LeastSquaresFit& fit) {
  std::vector<double> start;
  for (const UnknownRange& range : problem.unknowns) start.push_back(range.start);
  std::vector<double> shaped(start.size());
  map.unknowns(map.coordinates(start, 0.0), shaped);
  for (std::size_t j = 0; j < start.size(); ++j) {
    if (fit.frozen[j] != 0) continue;
    const UnknownRange& range = problem.unknowns[j];
    double width = range.upper - range.lower;
    if (!std::isfinite(width)) width = std::abs(start[j]);
    fit.moved_inside[j] = on_bound(range, start[j], false) || on_bound(range, start[j], true) ||
                          std::abs(shaped[j] - start[j]) > kSame * width;
  }
}

/// All searches of one problem.
class Searches {
 public:
  Searches(const ResidualProblem& problem, const SolverOptions& options)
      : problem_(problem),
        options_(options),
        evaluator_(problem),
        acts_(problem.unknowns.size(), 0),
        in_block_(problem.unknowns.size(), 0),
        all_(problem, std::vector<char>(problem.unknowns.size(), 0)) {
    for (const ShapedBlock& block : problem.shapes) {
      for (std::size_t k = 0; k < block.count; ++k) in_block_[block.first + k] = 1;
    }
  }

  void run();

  struct Trace {
    std::vector<double> from;
    SearchEnd end;
    std::vector<char> silent_at_start;
    std::vector<char> frozen;  ///< to the end
    /// Of a trace that was followed elsewhere, which has no residuals and derivatives; else empty.
    std::vector<char> silent_at_end = {};
  };
  const std::vector<Trace>& traces() const { return traces_; }
  Trace& best() { return traces_[best_]; }
  const Evaluator& evaluator() const { return evaluator_; }
  const UnknownMap& map() const { return all_; }

  /// Parameters without effect where a search ended, although they have one elsewhere.
  std::vector<char> lost_unknowns(const Trace& trace) const;

 private:
  void follow(std::span<const double> start);
  void follow_all(std::span<const std::vector<double>> starts);
  std::vector<double> encoded() const;
  Trace decoded(std::span<const double> numbers);
  void bring_best();
  void probe(std::span<const double> base, std::span<const char> which);
  std::vector<double> probes_of(std::size_t unknown, double value) const;

  const ResidualProblem& problem_;
  const SolverOptions& options_;
  Evaluator evaluator_;
  std::vector<char> acts_;  ///< unknowns that were seen to change a residual
  std::vector<char> in_block_;
  UnknownMap all_;
  std::vector<Trace> traces_;
  std::vector<std::vector<double>> starts_;
  std::size_t best_ = 0;
};

bool any_of(std::span<const char> flags) {
  return std::any_of(flags.begin(), flags.end(), [](char f) { return f != 0; });
}

/// Searches from one start what has an effect there, and then what has become visible.
void Searches::follow(std::span<const double> start) {
  const std::size_t n = start.size();
  Trace trace;
  trace.from.resize(n);
  trace.silent_at_start.assign(n, 0);
  std::vector<double> z = all_.coordinates(start, kInset);
  all_.unknowns(z, trace.from);
  SearchPoint point;
  const bool found =
      n > 0 && problem_.rows > 0 && Objective(evaluator_, all_).derivatives(z, point, false);
  if (found) trace.silent_at_start = silent_unknowns(point.jacobian, n);
  for (std::size_t j = 0; j < n && found; ++j) {
    if (trace.silent_at_start[j] == 0) acts_[j] = 1;
  }
  trace.frozen = trace.silent_at_start;
  if (std::all_of(trace.frozen.begin(), trace.frozen.end(), [](char f) { return f != 0; })) {
    trace.frozen.assign(n, 0);  // nothing to search, which is told
  }
  if (!any_of(trace.frozen)) {
    trace.end =
        search_from(evaluator_, all_, trace.frozen, {}, z, found ? &point : nullptr, options_);
  } else {
    std::vector<double> kept(n);
    for (std::size_t j = 0; j < n; ++j) {
      kept[j] = acts_[j] != 0 && in_block_[j] == 0 ? start[j] : problem_.unknowns[j].start;
    }
    const UnknownMap map(problem_, trace.frozen, UnknownMap::Unbounded::kLinear, kept);
    z = map.coordinates(start, kInset);
    map.unknowns(z, trace.from);
    // As a rule the same point in other coordinates.
    const bool same = found && trace.from == point.x;
    point.z = z;
    trace.end =
        search_from(evaluator_, map, trace.frozen, kept, z, same ? &point : nullptr, options_);
  }
  constexpr double kBesideFold = 1e-3;
  while (any_of(trace.frozen)) {
    SearchEnd& end = trace.end;
    if (end.stop == StopReason::kModelFailure || end.stop == StopReason::kTooFewData) break;
    const std::vector<char> silent = silent_unknowns(end.point.jacobian, n);
    bool appeared = false;
    for (std::size_t j = 0; j < n; ++j) {
      if (trace.frozen[j] == 0 || silent[j] != 0) continue;
      trace.frozen[j] = 0;
      acts_[j] = 1;
      appeared = true;
    }
    if (!appeared) break;
    const std::vector<double> kept = end.point.x;
    const UnknownMap map(problem_, trace.frozen, UnknownMap::Unbounded::kLinear, kept);
    SearchEnd next = search_from(evaluator_, map, trace.frozen, kept,
                                 map.coordinates(kept, kBesideFold), nullptr, options_);
    if (next.stop == StopReason::kModelFailure) break;
    if (next.stop == StopReason::kNoIteration) next.stop = next.reached;
    next.iterations += end.iterations;
    next.start_cost = end.start_cost;
    end = std::move(next);
  }
  traces_.push_back(std::move(trace));
}

/// All that is told of the only trace, or needed to choose among traces, as numbers.
std::vector<double> Searches::encoded() const {
  const Trace& trace = traces_[0];
  const SearchEnd& end = trace.end;
  std::vector<double> numbers{static_cast<double>(evaluator_.residual_evaluations()),
                              static_cast<double>(evaluator_.derivative_evaluations()),
                              end.start_cost,
                              end.point.cost,
                              static_cast<double>(end.iterations),
                              static_cast<double>(end.stop),
                              end.point.jacobian.empty() ? 0.0 : 1.0};
  const std::size_t n = acts_.size();
  const std::vector<char> silent =
      end.point.jacobian.empty() ? std::vector<char>(n) : silent_unknowns(end.point.jacobian, n);
  numbers.insert(numbers.end(), silent.begin(), silent.end());
  numbers.insert(numbers.end(), trace.from.begin(), trace.from.end());
  // Of a search that failed there is no end.
  numbers.insert(numbers.end(), end.point.x.begin(), end.point.x.end());
  return numbers;
}

Searches::Trace Searches::decoded(std::span<const double> numbers) {
  const std::size_t n = acts_.size();
  evaluator_.count(static_cast<long>(numbers[0]), static_cast<long>(numbers[1]));
  Trace trace;
  trace.end.start_cost = numbers[2];
  trace.end.point.cost = numbers[3];
  trace.end.iterations = static_cast<int>(numbers[4]);
  trace.end.stop = static_cast<StopReason>(numbers[5]);
  constexpr std::size_t kFlags = 7;
  for (const double silent : numbers.subspan(kFlags, n)) {
    trace.silent_at_end.push_back(silent != 0.0 && numbers[6] != 0.0 ? 1 : 0);
  }
  const std::span<const double> places = numbers.subspan(kFlags + n);
  trace.from.assign(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n));
  trace.end.point.x.assign(places.begin() + static_cast<std::ptrdiff_t>(n), places.end());
  return trace;
}

/// Follows the given start, and the others as items if nothing of the first matters to them.
void Searches::follow_all(std::span<const std::vector<double>> starts) {
  follow(starts[0]);
  const auto others = starts.subspan(1);
  const bool all_act = std::all_of(acts_.begin(), acts_.end(), [](char acts) { return acts != 0; });
  if (others.empty() || !problem_.items || !all_act) {
    for (const std::vector<double>& start : others) follow(start);
    return;
  }
  const auto made = problem_.items(others.size(), [&](std::size_t i) {
    Searches own(problem_, options_);
    own.acts_ = acts_;
    own.follow(others[i]);
    return own.encoded();
  });
  for (const std::vector<double>& numbers : made) traces_.push_back(decoded(numbers));
}

/// Follows the best trace here, if it was followed elsewhere: to the same end.
void Searches::bring_best() {
  if (traces_[best_].silent_at_end.empty()) return;
  const StopReason stop = traces_[best_].end.stop;
  Searches own(problem_, options_);
  own.acts_ = acts_;
  own.follow(starts_[best_]);
  traces_[best_] = std::move(own.traces_[0]);
  traces_[best_].end.stop = stop;
}

std::vector<char> Searches::lost_unknowns(const Trace& trace) const {
  std::vector<char> silent(acts_.size(), 0);
  if (!trace.silent_at_end.empty()) {
    silent = trace.silent_at_end;
  } else if (trace.end.point.jacobian.empty()) {
    return silent;
  } else {
    silent = silent_unknowns(trace.end.point.jacobian, silent.size());
  }
  for (std::size_t j = 0; j < silent.size(); ++j) {
    silent[j] = silent[j] != 0 && acts_[j] != 0 && in_block_[j] == 0;
  }
  return silent;
}

/// Returns where an unknown without effect may have one: factors, or parts of what the bounds
/// leave.
std::vector<double> Searches::probes_of(std::size_t unknown, double value) const {
  const UnknownRange& range = problem_.unknowns[unknown];
  std::vector<double> probes;
  if (value != 0.0) {
    for (const double factor : {1.0 / 3.0, 3.0, 0.1, 10.0}) probes.push_back(value * factor);
  } else {
    const double up = std::isfinite(range.upper) ? range.upper : 1.0;
    const double down = std::isfinite(range.lower) ? range.lower : -1.0;
    for (const double part : {0.1, 0.3, 0.9}) {
      probes.push_back(part * up);
      probes.push_back(part * down);
    }
  }
  std::erase_if(probes, [&](double probe) {
    return !(probe > range.lower && probe < range.upper) || probe == value;
  });
  return probes;
}

/// Looks for values at which unknowns without effect have one, and searches from the best of them.
void Searches::probe(std::span<const double> base, std::span<const char> which) {
  std::vector<double> at_base(problem_.rows);
  if (!evaluator_.residuals(base, at_base)) return;
  std::vector<std::vector<double>> starts;
  std::vector<double> there(problem_.rows);
  for (std::size_t j = 0; j < which.size(); ++j) {
    if (which[j] == 0) continue;
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> best;
    for (const double value : probes_of(j, base[j])) {
      std::vector<double> x(base.begin(), base.end());
      x[j] = value;
      if (!evaluator_.residuals(x, there) || there == at_base) continue;
      acts_[j] = 1;
      const double cost = total_cost(problem_, there);
      if (!(cost < least)) continue;
      least = cost;
      best = std::move(x);
    }
    if (!best.empty()) starts.push_back(std::move(best));
  }
  for (const std::vector<double>& start : starts) follow(start);
}

void Searches::run() {
  const std::size_t n = problem_.unknowns.size();
  starts_.resize(1);
  for (const UnknownRange& range : problem_.unknowns) starts_[0].push_back(range.start);
  for (std::vector<double>& start : starting_points(problem_, options_.starts - 1, options_.seed)) {
    starts_.push_back(std::move(start));
  }
  follow_all(starts_);
  const auto choose = [&] {
    for (Trace& trace : traces_) {
      if (is_convergence(trace.end.stop) && any_of(lost_unknowns(trace))) {
        trace.end.stop = StopReason::kSilent;
      }
    }
    best_ = 0;
    for (std::size_t i = 1; i < traces_.size(); ++i) {
      if (better(traces_[i].end, traces_[best_].end)) best_ = i;
    }
    bring_best();
  };
  const auto parameters = [&](std::vector<char> silent) {
    for (std::size_t j = 0; j < n; ++j) silent[j] = silent[j] != 0 && in_block_[j] == 0;
    return silent;
  };
  if (problem_.rows < n) return choose();
  const std::vector<char> at_start = parameters(traces_[0].silent_at_start);
  if (any_of(at_start)) probe(std::vector<double>(traces_[0].from), at_start);
  choose();
  constexpr int kMostProbes = 2;
  for (int round = 0; round < kMostProbes; ++round) {
    if (best().end.stop == StopReason::kModelFailure || best().end.point.jacobian.empty()) break;
    const std::vector<char> at_end = parameters(silent_unknowns(best().end.point.jacobian, n));
    const bool same_place = best_ == 0 && best().end.point.x == traces_[0].from;
    if (!any_of(at_end) || same_place) break;
    const std::size_t before = best_;
    probe(std::vector<double>(best().end.point.x), at_end);
    choose();
    if (best_ == before) break;
  }
}

}  // namespace

LeastSquaresFit solve_least_squares(const ResidualProblem& problem, const SolverOptions& options) {
  // What goes wrong is told by return values; GSL's own handler would end the program.
  gsl_set_error_handler_off();
  const std::size_t n = problem.unknowns.size();
  LeastSquaresFit fit;
  fit.at_lower.assign(n, 0);
  fit.at_upper.assign(n, 0);
  fit.moved_inside.assign(n, 0);

  Searches searches(problem, options);
  searches.run();
  for (const Searches::Trace& trace : searches.traces()) {
    const SearchEnd& end = trace.end;
    fit.searches.push_back(
        {trace.from, end.point.x, end.start_cost, end.point.cost, end.iterations, end.stop});
  }
  fit.start_cost = fit.searches[0].start_cost;
  Searches::Trace& best = searches.best();
  SearchEnd& end = best.end;
  fit.silent = searches.lost_unknowns(best);
  fit.frozen = end.stop == StopReason::kZeroGradient ? best.silent_at_start : best.frozen;
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.silent[j] != 0) fit.frozen[j] = 0;
  }
  mark_moved(problem, searches.map(), fit);
  fit.x = end.point.x;
  fit.cost = end.point.cost;
  fit.stop = end.stop;
  fit.converged = is_convergence(fit.stop);
  fit.stop_sentence = stop_text(fit.stop);
  if (fit.converged && end.at_kink) {
    fit.stop_sentence = fmt::format(
        "at a kink of the model, where the gradient jumps: the steps left are below {} standard "
        "errors",
        end.step_left);
  } else if (fit.converged && end.step_left > 0.0) {
    fit.stop_sentence = fmt::format("the steps left are below {} standard errors", end.step_left);
  }
  fit.iterations = end.iterations;
  fit.gradient_norm = end.offset;
  fit.polished = end.polished;
  fit.residuals = std::move(end.point.residuals);
  fit.jacobian = std::move(end.point.jacobian);
  fit.jacobian.resize(problem.rows * n);
  fit.weights = row_weights(problem, fit.residuals);
  fit.residual_evaluations = searches.evaluator().residual_evaluations();
  fit.derivative_evaluations = searches.evaluator().derivative_evaluations();
  mark_bounds(problem, fit);
  return fit;
}

}  // namespace slipbench::driver::fit
