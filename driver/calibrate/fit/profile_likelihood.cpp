// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "driver/calibrate/fit/error_scale.hpp"
#include "driver/calibrate/fit/statistics.hpp"

namespace slipbench::driver::fit {
namespace {

/// The problem with one unknown fixed: fitted again from the last answer.
class FixedFit {
 public:
  /// \param scale of the fit with all unknowns
  FixedFit(const ResidualProblem& problem, const LeastSquaresFit& fit, std::size_t unknown,
           const ErrorScale& scale);
  /// The least cost with the unknown at `value`; none where the model has no value.
  std::optional<double> cost(double value);
  /// The next fit starts from the optimum again.
  void restart() { last_ = optimum_; }
  int refits() const { return refits_; }
  int unconverged() const { return unconverged_; }

 private:
  std::vector<double> optimum_;  ///< the other unknowns
  std::vector<double> last_;
  std::shared_ptr<double> value_ = std::make_shared<double>(0.0);
  double others_;   ///< unknowns besides the fixed one that the data determine
  double freedom_;  ///< without them
  ResidualProblem reduced_;
  int refits_ = 0;
  int unconverged_ = 0;
};

FixedFit::FixedFit(const ResidualProblem& problem, const LeastSquaresFit& fit, std::size_t unknown,
                   const ErrorScale& scale)
    : others_(static_cast<double>(problem.data_rows) - scale.freedom - 1.0),
      freedom_(scale.freedom + 1.0),
      reduced_(problem) {
  const std::size_t n = problem.unknowns.size();
  const auto without = [](auto& list, std::size_t at) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
  };
  optimum_ = fit.x;
  without(optimum_, unknown);
  last_ = optimum_;
  without(reduced_.unknowns, unknown);
  for (ShapedBlock& block : reduced_.shapes) {
    if (unknown >= block.first && unknown < block.first + block.count) {
      without(block.abscissa, unknown - block.first);
      --block.count;
    } else if (block.first > unknown) {
      --block.first;
    }
  }
  std::erase_if(reduced_.shapes, [](const ShapedBlock& block) { return block.count == 0; });
  const auto full = [unknown, n, value = value_](std::span<const double> others) {
    std::vector<double> x(n);
    for (std::size_t j = 0; j < n; ++j) {
      x[j] = j == unknown ? *value : others[j - (j > unknown ? 1 : 0)];
    }
    return x;
  };
  reduced_.residuals = [model = problem.residuals, full](std::span<const double> others,
                                                         std::span<double> r) {
    return model(full(others), r);
  };
  if (!problem.derivatives) return;
  const auto whole = std::make_shared<std::vector<double>>(problem.rows * n);
  reduced_.derivatives = [model = problem.derivatives, full, whole, n, unknown](
                             std::span<const double> others, std::span<double> r,
                             std::span<double> jacobian) {
    if (!model(full(others), r, *whole)) return false;
    std::size_t to = 0;
    for (std::size_t entry = 0; entry < whole->size(); ++entry) {
      if (entry % n != unknown) jacobian[to++] = (*whole)[entry];
    }
    return true;
  };
}

std::optional<double> FixedFit::cost(double value) {
  *value_ = value;
  for (std::size_t j = 0; j < last_.size(); ++j) reduced_.unknowns[j].start = last_[j];
  if (last_.empty()) {
    std::vector<double> r(reduced_.rows);
    if (!reduced_.residuals(last_, r)) return std::nullopt;
  }
  SolverOptions options;
  options.gradient_tolerance = 1e-6;
  options.step_tolerance = 1e-9;
  options.polish = false;
  const LeastSquaresFit fit = solve_least_squares(reduced_, options);
  if (fit.stop == StopReason::kModelFailure || !std::isfinite(fit.cost)) return std::nullopt;
  ++refits_;
  if (!is_minimum(fit, others_, freedom_)) ++unconverged_;
  last_ = fit.x;
  return std::max(fit.cost, 0.0);
}

}  // namespace

LikelihoodProfile profile_likelihood(const ResidualProblem& problem, const LeastSquaresFit& fit,
                                     std::size_t unknown, double confidence) {
  LikelihoodProfile profile;
  profile.unknown = unknown;
  const UnknownRange& range = problem.unknowns[unknown];
  const double optimum = fit.x[unknown];
  profile.value = {optimum};
  profile.cost = {fit.cost};
  profile.threshold = std::numeric_limits<double>::quiet_NaN();
  profile.lower = profile.threshold;
  profile.upper = profile.threshold;
  const FitStatistics statistics = fit_statistics(problem, fit, confidence);
  const ErrorScale scale = error_scale(problem, fit, effective_unknowns(problem, fit));
  if (!(scale.freedom > 0.0) || fit.frozen[unknown] != 0) return profile;
  profile.lower = range.lower;
  profile.upper = range.upper;
  profile.open_below = true;
  profile.open_above = true;
  const double quantile = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, scale.freedom);
  // Student's t squared is Fisher's F of 1 and that many degrees of freedom.
  profile.threshold = fit.cost + 0.5 * scale.variance * scale.curvature * quantile * quantile;

  const bool log = range.scale == Scale::kLog && optimum > 0.0;
  double first = 0.5 * quantile * statistics.standard_error[unknown] / (log ? optimum : 1.0);
  const bool bounded = std::isfinite(range.upper - range.lower);
  const double width = bounded ? range.upper - range.lower : std::abs(optimum);
  if (!(first > 0.0)) first = log ? 0.1 : 0.02 * (width > 0.0 ? width : 1.0);
  FixedFit fixed(problem, fit, unknown, scale);
  std::vector<std::pair<double, double>> points{{optimum, fit.cost}};
  for (const double sense : {-1.0, 1.0}) {
    constexpr int kMostSteps = 12;
    constexpr double kGrowth = 1.4;
    constexpr int kMostCuts = 30;
    const double bound = sense < 0.0 ? range.lower : range.upper;
    const auto at = [&](double way) {
      const double value = log ? optimum * std::exp(sense * way) : optimum + sense * way;
      return std::clamp(value, range.lower, range.upper);
    };
    // The root of the gain in cost is nearly linear in the way.
    const double wanted = std::sqrt(profile.threshold - fit.cost);
    const auto height = [&](double cost) { return std::sqrt(std::max(cost - fit.cost, 0.0)); };
    fixed.restart();
    double inside = 0.0;
    double inside_height = 0.0;
    double way = first;
    for (int step = 0; step < kMostSteps; ++step) {
      const double value = at(way);
      if (value == optimum) break;
      const std::optional<double> cost = fixed.cost(value);
      if (!cost) break;
      points.emplace_back(value, *cost);
      if (*cost < profile.threshold) {
        inside = way;
        inside_height = height(*cost);
        if (value == bound) break;
        way = step == 0 ? 2.0 * first : kGrowth * way;
        continue;
      }
      double outside = way;
      double outside_height = height(*cost);
      double crossing = way;
      for (int cut = 0; cut < kMostCuts; ++cut) {
        double part = (wanted - inside_height) / (outside_height - inside_height);
        if (cut % 3 == 2) part = 0.5;
        crossing = inside + std::clamp(part, 1e-3, 1.0 - 1e-3) * (outside - inside);
        const std::optional<double> between = fixed.cost(at(crossing));
        if (!between) break;
        const double reached = height(*between);
        if (std::abs(reached - wanted) <= 1e-6 * wanted) break;
        (reached < wanted ? inside : outside) = crossing;
        (reached < wanted ? inside_height : outside_height) = reached;
      }
      points.emplace_back(at(crossing), profile.threshold);
      (sense < 0.0 ? profile.lower : profile.upper) = at(crossing);
      (sense < 0.0 ? profile.open_below : profile.open_above) = false;
      break;
    }
  }
  profile.refits = fixed.refits();
  profile.unconverged = fixed.unconverged();
  std::sort(points.begin(), points.end());
  profile.value.clear();
  profile.cost.clear();
  for (const auto& [value, cost] : points) {
    if (!profile.value.empty() && value == profile.value.back()) continue;
    profile.value.push_back(value);
    profile.cost.push_back(cost);
  }
  return profile;
}

std::vector<double> numbers_of(const LikelihoodProfile& profile) {
  std::vector<double> numbers{static_cast<double>(profile.unknown),
                              profile.threshold,
                              profile.lower,
                              profile.upper,
                              profile.open_below ? 1.0 : 0.0,
                              profile.open_above ? 1.0 : 0.0,
                              static_cast<double>(profile.refits),
                              static_cast<double>(profile.unconverged)};
  numbers.insert(numbers.end(), profile.value.begin(), profile.value.end());
  numbers.insert(numbers.end(), profile.cost.begin(), profile.cost.end());
  return numbers;
}

LikelihoodProfile profile_of(std::span<const double> numbers) {
  constexpr std::size_t kScalars = 8;
  LikelihoodProfile profile;
  profile.unknown = static_cast<std::size_t>(numbers[0]);
  profile.threshold = numbers[1];
  profile.lower = numbers[2];
  profile.upper = numbers[3];
  profile.open_below = numbers[4] != 0.0;
  profile.open_above = numbers[5] != 0.0;
  profile.refits = static_cast<int>(numbers[6]);
  profile.unconverged = static_cast<int>(numbers[7]);
  const std::span<const double> curve = numbers.subspan(kScalars);
  const std::size_t count = curve.size() / 2;
  profile.value.assign(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(count));
  profile.cost.assign(curve.begin() + static_cast<std::ptrdiff_t>(count), curve.end());
  return profile;
}

}  // namespace slipbench::driver::fit
