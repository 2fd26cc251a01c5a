// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/calibrate/fit/convex_step.hpp"
#include "driver/calibrate/fit/kink_bundle.hpp"
#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit/simplex_polish.hpp"
#include "driver/calibrate/fit/trust_region.hpp"

namespace slipbench::driver::fit {
namespace {

/// Beyond this gain nothing but rounding is left in a sum of squares.
constexpr double kRounding = 1e-14;
/// Standard errors, all unknowns together, from where a minimum counts as near.
constexpr double kNearErrors = 5.0;
/// Standard errors, root mean square over the unknowns, that are left at a point which counts as a
/// minimum though the gradient says that there is something to gain.
constexpr double kNearMinimum = 1e-3;
/// Standard errors, in the mean of all unknowns, that are too small to matter.
constexpr double kInvisible = 0.01;

/// Tells whether the slope jumps between the point and all that holds it: rises by much more than
/// the curvature has it. Asked of the unknowns, since coordinates are curved near their folds.
bool at_kink(const KinkCut& here, std::span<const KinkCut> holders,
             const Eigen::MatrixXd& products) {
  constexpr double kJump = 10.0;
  const Eigen::Index n = here.x.size();
  return !holders.empty() && std::all_of(holders.begin(), holders.end(), [&](const KinkCut& cut) {
    const Eigen::VectorXd way = cut.x - here.x;
    return way.dot(cut.slope - here.slope) > kJump * way.dot(products.topLeftCorner(n, n) * way);
  });
}

class Search {
 public:
  Search(Evaluator& evaluator, const UnknownMap& map, const SolverOptions& options)
      : objective_(evaluator, map), options_(options), shaped_(false), released_(map.size(), 0) {
    const std::vector<char> shaped = map.shaped();
    shaped_ = std::find(shaped.begin(), shaped.end(), 1) != shaped.end();
  }

  SearchEnd run(std::span<const double> start, TrustScaling scaling, SearchPoint* at_start);

 private:
  bool stopped() const { return end_.iterations >= options_.most_iterations; }
  int left() const { return options_.most_iterations - end_.iterations; }
  std::optional<StopReason> judge(const Linearisation& linear) const;
  std::optional<StopReason> finish();
  double residual_error() const;
  double total_offset() const;
  bool bends_sharply(double errors);
  bool jumps(const KinkCut& here, std::span<const KinkCut> holders);
  bool poll(double errors);
  KinkCut cut_of(const SearchPoint& point, const Linearisation& linear) const;
  bool has_idle_unknown(const Linearisation& linear) const;
  bool hold_at_folds();
  bool release();
  enum class Settled : std::uint8_t { kMinimum, kLower, kNothing };
  Settled settle_shapes();

  Objective objective_;
  const SolverOptions& options_;
  bool shaped_;                ///< some unknowns have a shape to keep
  std::vector<int> released_;  ///< how often a coordinate was given back
  SearchPoint trial_;
  SearchEnd end_;
};

/// Tells whether the point is a minimum.
std::optional<StopReason> Search::judge(const Linearisation& linear) const {
  const SearchPoint& point = end_.point;
  // A cost of zero, but for rounding, has no angle.
  if (point.cost <= kRounding * kRounding * end_.start_cost) return StopReason::kCost;
  if (linear.offset <= options_.gradient_tolerance) return StopReason::kGradient;
  const std::vector<double> change = objective_.unknown_step(point, linear.step);
  bool small = true;
  for (std::size_t j = 0; j < change.size(); ++j) {
    small = small && std::abs(change[j]) <= options_.step_tolerance * std::abs(point.x[j]);
  }
  if (small) return StopReason::kStep;
  return std::nullopt;
}

/// Steps of Gauss and Newton, held back by what was seen beyond kinks; for as long as they bring
/// the cost or the gradient down.
std::optional<StopReason> Search::finish() {
  constexpr int kMostSteps = 40;
  // Of the offset before: a step without a gain must do that, else the trust region is better.
  constexpr double kEnough = 0.8;
  SearchPoint& point = end_.point;
  SearchPoint& trial = trial_;
  // The differences of the trust region are not fine enough to end on.
  const bool differences = !objective_.evaluator().problem().derivatives;
  if (differences) {
    const std::vector<double> z = point.z;
    if (objective_.derivatives(z, trial, true)) std::swap(point, trial);
  }
  Linearisation linear = objective_.linearise(point);
  std::optional<StopReason> verdict = judge(linear);
  KinkBundle bundle;
  int poor = 0;
  const int most_poor = 10 + 2 * static_cast<int>(objective_.free().size());
  for (int step = 0; step < kMostSteps && !verdict && !stopped(); ++step) {
    // Where less is left than can be told from the noise of the data, kinks are worth a model.
    const double error = residual_error();
    const double invisible =
        kInvisible * error * std::sqrt(static_cast<double>(objective_.free().size()));
    const bool near =
        linear.rank == objective_.free().size() && linear.projection.norm() <= kNearErrors * error;
    KinkStep next{linear.step, 0.0, {}};
    if (near) {
      const KinkCut here = cut_of(point, linear);
      next =
          bundle.step(here, objective_.coordinate_map(point), linear.triangle, kNearErrors * error);
      if (next.gain <= 0.5 * invisible * invisible &&
          at_kink(here, next.holders, linear.products) && jumps(here, next.holders)) {
        end_.at_kink = true;
        end_.step_left = kInvisible;
        verdict = StopReason::kStep;
        break;
      }
    }
    const std::vector<double> z = objective_.moved(point, next.step);
    if (!objective_.derivatives(z, trial, differences)) break;
    const double gain = 1.0 - trial.cost / point.cost;
    if (gain < -kCostNoise && !near) break;
    const Linearisation there = objective_.linearise(trial);
    const bool nearer = there.offset < kEnough * linear.offset;
    const bool lower = gain > kRounding || (gain >= -kCostNoise && nearer);
    // With a kink on the way little of what was promised is kept.
    const bool kept = lower && (gain * point.cost > 0.5 * next.gain || gain >= 1e-3 || nearer);
    if (!kept && !(near && next.gain > kCostNoise * point.cost && ++poor <= most_poor)) {
      if (lower) {
        std::swap(point, trial);
        linear = there;
        ++end_.iterations;
        verdict = judge(linear);
      }
      break;
    }
    if (!lower) {
      bundle.add(cut_of(trial, there));
      continue;
    }
    if (near && (!kept || !bundle.empty())) bundle.add(cut_of(point, linear));
    std::swap(point, trial);
    linear = there;
    ++end_.iterations;
    if (shaped_ && hold_at_folds()) linear = objective_.linearise(point);
    verdict = judge(linear);
  }
  end_.offset = linear.offset;
  end_.degenerate = linear.rank < objective_.free().size() || has_idle_unknown(linear);
  return verdict;
}

/// The standard error of one residual, as far as the point tells.
double Search::residual_error() const {
  const auto data = static_cast<double>(end_.point.residuals.size());
  const auto unknowns = static_cast<double>(objective_.free().size());
  return std::sqrt(2.0 * end_.point.cost / std::max(data - unknowns, 1.0));
}

/// The step that is left, all unknowns together, in standard errors.
double Search::total_offset() const {
  const auto data = static_cast<double>(end_.point.residuals.size());
  const auto unknowns = static_cast<double>(objective_.free().size());
  return end_.offset * std::sqrt(std::max(data - unknowns, 1.0));
}

/// Tells whether a cost has a kink between t = first and t = last: its second difference on ever
/// shorter parts of the way, where it is the greatest, falls with their length instead of its
/// square.
/// \param threads that may ask for costs at once
template <typename Cost>
bool kinks_between(double first, double last, int halvings, unsigned threads, const Cost& cost) {
  constexpr double kKink = 0.2;  // 0.5 at least where there is one, else 2^-halvings
  const auto bend = [](double a, double b, double c) { return std::abs(a - 2.0 * b + c); };
  const auto costs_at = [&]<std::size_t kCount>(const std::array<double, kCount>& t) {
    std::array<double, kCount> costs{};
    base::for_each_index(kCount, threads, [&](std::size_t i) { costs[i] = cost(t[i]); });
    return costs;
  };
  double width = last - first;
  double left = first;
  std::array<double, 3> at = costs_at(std::array{left, left + 0.5 * width, last});
  const double whole = bend(at[0], at[1], at[2]);
  double greatest = whole;
  for (int k = 0; k < halvings; ++k, width *= 0.5) {
    const auto [before, after] = costs_at(std::array{left + 0.25 * width, left + 0.75 * width});
    const std::array<std::array<double, 3>, 3> parts{
        {{at[0], before, at[1]}, {before, at[1], after}, {at[1], after, at[2]}}};
    std::size_t most = 0;
    greatest = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double here = bend(parts[i][0], parts[i][1], parts[i][2]);
      if (here > greatest) {
        greatest = here;
        most = i;
      }
    }
    at = parts[most];
    left += 0.25 * static_cast<double>(most) * width;
  }
  return greatest * std::pow(2.0, halvings) > kKink * whole;
}

/// Tells whether the cost has a kink along Gauss and Newton's step, within so many standard errors.
bool Search::bends_sharply(double errors) {
  const SearchPoint& point = end_.point;
  const Linearisation linear = objective_.linearise(end_.point);
  const double length = linear.projection.norm();
  if (!(length > 0.0) || linear.rank < objective_.free().size()) return false;
  const double way = std::min(1.0, errors * residual_error() / length);
  // The kink may be where the point is, in the middle.
  const unsigned threads = objective_.evaluator().problem().threads;
  return kinks_between(-way, way, 5, threads, [&](double t) {
    if (t == 0.0) return point.cost;
    SearchPoint there;
    return objective_.cost(objective_.moved(point, t * linear.step), there)
               ? there.cost
               : std::numeric_limits<double>::quiet_NaN();
  });
}

/// Tells whether the slope jumps on the way to the holder where it rises least. A strongly curved
/// cost may look like a kink from its two ends.
bool Search::jumps(const KinkCut& here, std::span<const KinkCut> holders) {
  const KinkCut* mildest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const SearchPoint& point = end_.point;
  const Linearisation linear = objective_.linearise(end_.point);
  const Eigen::Index n = here.x.size();
  for (const KinkCut& cut : holders) {
    const Eigen::VectorXd way = cut.x - here.x;
    const double rise =
        way.dot(cut.slope - here.slope) / way.dot(linear.products.topLeftCorner(n, n) * way);
    if (rise < least) {
      least = rise;
      mildest = &cut;
    }
  }
  if (mildest == nullptr) return true;
  Evaluator& evaluator = objective_.evaluator();
  return kinks_between(0.0, 1.0, 3, evaluator.problem().threads, [&](double t) {
    if (t == 0.0) return point.cost;
    std::vector<double> x(point.x.size());
    std::vector<double> r(point.residuals.size());
    for (Eigen::Index j = 0; j < n; ++j) {
      x[static_cast<std::size_t>(j)] = here.x(j) + t * (mildest->x(j) - here.x(j));
    }
    return evaluator.residuals(x, r) ? total_cost(evaluator.problem(), r)
                                     : std::numeric_limits<double>::quiet_NaN();
  });
}

/// Tries steps of so many standard errors, both ways along as many directions as there are
/// unknowns, independent of one another by the linearised problem.
/// \return whether one of them lowers the cost; the point is then the lowest
bool Search::poll(double errors) {
  SearchPoint& point = end_.point;
  const Linearisation linear = objective_.linearise(point);
  const Eigen::Index m = linear.triangle.cols();
  if (linear.rank < objective_.free().size()) return false;
  const double error = residual_error();
  double lowest = point.cost;
  std::vector<double> best;
  for (Eigen::Index i = 0; i < 2 * m; ++i) {
    const double length = (i % 2 == 0 ? errors : -errors) * error;
    const Eigen::VectorXd step = linear.triangle.triangularView<Eigen::Upper>().solve(
        Eigen::VectorXd(length * Eigen::VectorXd::Unit(m, i / 2)));
    const std::vector<double> z = objective_.moved(point, step);
    if (!objective_.cost(z, trial_) || !(trial_.cost < lowest)) continue;
    lowest = trial_.cost;
    best = z;
  }
  if (best.empty() || !objective_.derivatives(best, trial_, false)) return false;
  std::swap(point, trial_);
  ++end_.iterations;
  return true;
}

KinkCut Search::cut_of(const SearchPoint& point, const Linearisation& linear) const {
  KinkCut cut;
  cut.cost = point.cost;
  const auto n = static_cast<Eigen::Index>(point.x.size());
  cut.x = Eigen::Map<const Eigen::VectorXd>(point.x.data(), n);
  cut.slope = linear.products.col(n).head(n);
  return cut;
}

/// Tells whether some unknown could change by its own size without any effect.
bool Search::has_idle_unknown(const Linearisation& linear) const {
  constexpr double kEffect = 1e-6;  // as a part of the residuals
  const Eigen::Index n = linear.products.cols() - 1;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double x = end_.point.x[static_cast<std::size_t>(j)];
    const double effect = x * x * linear.products(j, j);
    if (effect > 0.0 && effect < kEffect * kEffect * linear.products(n, n)) return true;
  }
  return false;
}

/// Puts coordinates that are close to a fold, with the cost falling towards it, onto it: the
/// unknown is at its bound.
/// \return whether any was
bool Search::hold_at_folds() {
  constexpr double kClose = 0.1;
  SearchPoint& point = end_.point;
  std::vector<double> z = point.z;
  const std::vector<FoldPoint> folds = objective_.map().folds(z);
  std::vector<std::size_t> close;
  const std::size_t m = objective_.free().size();
  const std::vector<double> root = objective_.root_weights(point);
  std::vector<double> f;
  std::vector<double> jacobian;
  for (std::size_t c = 0; c < m; ++c) {
    const std::size_t k = objective_.free()[c];
    if (!(folds[k].distance < kClose) || released_[k] > 2) continue;
    if (f.empty()) {
      point.z = z;  // principal coordinates: the same unknowns
      f.resize(point.residuals.size());
      jacobian.resize(f.size() * m);
      objective_.weigh(point, root, f, jacobian);
    }
    double gradient = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) gradient += f[i] * jacobian[i * m + c];
    // Towards the inside z rises on the lower side of two bounds and of a single one.
    if (gradient * folds[k].inward > 0.0) close.push_back(k);
  }
  if (close.empty()) return false;
  const auto try_to_hold = [&](std::span<const std::size_t> which) {
    std::vector<double> moved = point.z;
    for (const std::size_t k : which) moved[k] = folds[k].coordinate;
    SearchPoint trial;
    if (!objective_.derivatives(moved, trial, false) || trial.cost > point.cost) return false;
    point = std::move(trial);
    for (const std::size_t k : which) objective_.set_held(k, true);
    return true;
  };
  if (try_to_hold(close)) return true;
  if (close.size() == 1) return false;
  bool any = false;
  for (const std::size_t k : close) any = try_to_hold({&k, 1}) || any;
  return any;
}

/// Gives back what is held although the cost falls inside.
bool Search::release() {
  constexpr double kInside = 0.05;
  SearchPoint& point = end_.point;
  const std::vector<double> slopes = objective_.inward_slopes(point);
  std::vector<double> z = point.z;
  const std::vector<FoldPoint> folds = objective_.map().folds(z);
  bool any = false;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    if (slopes[k] >= 0.0 || released_[k] > 2) continue;
    // The way inside that lowers the cost may be short.
    for (double inside = kInside; inside > 1e-5; inside *= 0.1) {
      std::vector<double> moved = z;
      moved[k] = folds[k].coordinate + folds[k].inward * inside;
      SearchPoint trial;
      if (!objective_.derivatives(moved, trial, false) || trial.cost > point.cost) continue;
      z = moved;
      point = std::move(trial);
      objective_.set_held(k, false);
      ++released_[k];
      any = true;
      break;
    }
  }
  return any;
}

/// Steps of Gauss and Newton under bounds and shapes, over the unknowns: where intervals of a shape
/// have no length, coordinates do not show all ways that are open.
/// \return kNothing: the verdict stands, or has become kNoProgress
Search::Settled Search::settle_shapes() {
  constexpr Eigen::Index kMost = 200;
  constexpr int kMostSteps = 50;
  constexpr int kHalvings = 12;
  SearchPoint& point = end_.point;
  const std::vector<Inequality> inequalities = objective_.map().inequalities();
  bool lower = false;
  double promise = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const Linearisation linear = objective_.linearise(point);
    const Eigen::Index n = linear.products.cols() - 1;
    if (n > kMost) return Settled::kNothing;
    const ConvexStep next = convex_step(linear.products, point.x, inequalities);
    promise = next.gain / std::max(point.cost, std::numeric_limits<double>::min());
    end_.offset = std::sqrt(2.0 * next.gain /
                            std::max(linear.products(n, n), std::numeric_limits<double>::min()));
    bool small = true;
    for (Eigen::Index j = 0; j < n; ++j) {
      small = small && std::abs(next.change(j)) <=
                           options_.step_tolerance * std::abs(point.x[static_cast<std::size_t>(j)]);
    }
    std::optional<StopReason> verdict;
    if (end_.offset <= options_.gradient_tolerance) {
      verdict = StopReason::kGradient;
    } else if (small) {
      verdict = StopReason::kStep;
    } else if (promise <= kRounding || point.cost <= kRounding * kRounding * end_.start_cost) {
      verdict = StopReason::kCost;
    }
    if (verdict) {
      if (lower || !is_convergence(end_.stop)) {
        end_.stop = *verdict;
        end_.at_kink = false;
        end_.step_left = 0.0;
      }
      end_.degenerate = has_idle_unknown(linear);
      return Settled::kMinimum;
    }
    if (stopped()) break;
    bool accepted = false;
    double part = 1.0;
    for (int k = 0; k < kHalvings && !accepted; ++k, part *= 0.5) {
      std::vector<double> x = point.x;
      for (Eigen::Index j = 0; j < n; ++j) x[static_cast<std::size_t>(j)] += part * next.change(j);
      const std::vector<double> z = objective_.map().coordinates(x, 0.0);
      accepted = k == 0 ? objective_.derivatives(z, trial_, false)
                        : objective_.cost(z, trial_) && trial_.cost < point.cost &&
                              objective_.derivatives(z, trial_, false);
      accepted = accepted && trial_.cost < point.cost;
    }
    if (!accepted) break;
    std::swap(point, trial_);
    ++end_.iterations;
    lower = true;
    std::vector<double> z = point.z;
    const std::vector<FoldPoint> folds = objective_.map().folds(z);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      objective_.set_held(k, folds[k].distance < kOnFold);
    }
  }
  if (stopped()) return Settled::kNothing;
  const double left = total_offset() / std::sqrt(static_cast<double>(objective_.map().size()));
  if (left <= kNearMinimum) {
    if (lower || !is_convergence(end_.stop)) {
      end_.stop = StopReason::kStep;
      end_.step_left = kNearMinimum;
    }
    return Settled::kMinimum;
  }
  if (lower) return Settled::kLower;
  // More is promised than was kept: no minimum, unless the model has a kink there.
  if (is_convergence(end_.stop) && !end_.at_kink) {
    end_.stop = StopReason::kNoProgress;
  }
  return Settled::kNothing;
}

SearchEnd Search::run(std::span<const double> start, TrustScaling scaling, SearchPoint* at_start) {
  constexpr std::array kScalings{TrustScaling::kMore, TrustScaling::kAccelerated,
                                 TrustScaling::kLevenberg, TrustScaling::kMarquardt};
  constexpr int kIdleRounds = static_cast<int>(kScalings.size());
  SearchPoint& point = end_.point;
  if (at_start != nullptr) {
    point = std::move(*at_start);
  } else if (!objective_.derivatives(start, point, false)) {
    objective_.cost(start, point);
    end_.start_cost = point.cost;
    end_.stop = StopReason::kModelFailure;
    return std::move(end_);
  }
  end_.start_cost = point.cost;
  if (point.residuals.size() < objective_.map().size()) {
    end_.stop = StopReason::kTooFewData;
    return std::move(end_);
  }
  if (std::all_of(point.jacobian.begin(), point.jacobian.end(),
                  [](double j) { return j == 0.0; })) {
    end_.stop = StopReason::kZeroGradient;
    return std::move(end_);
  }
  const bool robust = objective_.evaluator().problem().loss.kind != Loss::Kind::kSquares;
  constexpr double kFirstGain = 1e-3;
  double least_gain = kFirstGain;
  int idle = 0;
  constexpr int kNearRounds = 2;  // where little is left
  constexpr double kNearKink = 0.1;
  constexpr int kMostPolls = 3;
  int polls = 0;
  bool first = true;
  auto strategy = static_cast<std::size_t>(std::find(kScalings.begin(), kScalings.end(), scaling) -
                                           kScalings.begin());
  end_.stop = StopReason::kNoProgress;
  while (true) {
    const double before = point.cost;
    TrustRegionOptions options;
    options.scaling = kScalings[strategy % kScalings.size()];
    // Weights are those of the round's start: a robust loss wants short rounds.
    options.most_iterations = robust ? std::min(left(), 5) : left();
    options.least_gain = least_gain;
    options.most_idle = least_gain >= kFirstGain ? 1 : 2;
    // Coordinates of shapes are curved: the plain steps over the unknowns come first.
    if (!(shaped_ && first)) {
      end_.iterations += trust_region(objective_, point, trial_, options);
      hold_at_folds();
    }
    first = false;
    std::optional<StopReason> verdict;
    if (!stopped()) verdict = finish();
    if (verdict) {
      end_.stop = *verdict;
      if (release()) continue;
      if (shaped_ && settle_shapes() == Settled::kLower) {
        end_.at_kink = false;
        idle = 0;
        continue;
      }
      break;
    }
    if (stopped()) {
      end_.stop = StopReason::kIterations;
      break;
    }
    const double gain = 1.0 - point.cost / before;
    const bool near = total_offset() <= kNearErrors;
    least_gain = std::max(1e-2 * least_gain, kRounding);
    if (gain > 1e-6) {
      idle = 0;
      continue;
    }
    ++strategy;
    ++idle;
    const bool kinked = near && idle > kNearRounds && bends_sharply(kNearKink);
    if (idle <= kIdleRounds && !kinked) continue;
    if (release()) {
      idle = 0;
      continue;
    }
    if (shaped_) {
      const Settled how = settle_shapes();
      if (how == Settled::kMinimum) break;
      if (how == Settled::kLower) {
        idle = 0;
        continue;
      }
    }
    // Bates and Watts' relative offset: the step that is left, in standard errors.
    const auto data = static_cast<double>(point.residuals.size());
    const auto unknowns = static_cast<double>(objective_.free().size());
    const double relative = end_.offset * std::sqrt(std::max(data - unknowns, 1.0) / unknowns);
    if (relative <= kNearMinimum) {
      end_.stop = StopReason::kStep;
      end_.step_left = kNearMinimum;
      break;
    }
    // A kink has no gradient to follow.
    if (kinked && ++polls <= kMostPolls) {
      if (poll(kNearKink)) {
        idle = 0;
        continue;
      }
      end_.stop = StopReason::kStep;
      end_.at_kink = true;
      end_.step_left = kNearKink;
      break;
    }
    if (options_.polish && !end_.polished && simplex_polish(objective_, point)) {
      end_.polished = true;
      idle = 0;
      continue;
    }
    if (relative <= kNearKink) {
      end_.stop = StopReason::kStep;
      end_.at_kink = bends_sharply(kNearKink);
      end_.step_left = kNearKink;
    }
    break;
  }
  end_.reached = end_.stop;
  // Less is rounding: the start was the minimum, or a kink.
  if (end_.iterations == 0 || !(point.cost < end_.start_cost * (1.0 - kRounding))) {
    end_.iterations = 0;
    end_.stop = StopReason::kNoIteration;
  }
  return std::move(end_);
}

}  // namespace

SearchEnd search(Evaluator& evaluator, const UnknownMap& map, std::span<const double> start,
                 const SolverOptions& options, TrustScaling scaling, SearchPoint* at_start) {
  return Search(evaluator, map, options).run(start, scaling, at_start);
}

}  // namespace slipbench::driver::fit
