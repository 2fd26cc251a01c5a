// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit/shape_projection.hpp"
#include "driver/calibrate/fit/statistics.hpp"
#include "tests/driver/calibrate/fit/synthetic_models.hpp"

namespace slipbench::driver::fit {
namespace {

using Model = std::function<double(std::span<const double> x, std::size_t row)>;

ResidualProblem rows_of(std::size_t rows, std::vector<UnknownRange> unknowns, Model model) {
  ResidualProblem problem;
  problem.rows = rows;
  problem.data_rows = rows;
  problem.unknowns = std::move(unknowns);
  problem.residuals = [model = std::move(model)](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = model(x, i);
    return true;
  };
  return problem;
}

/// Each ordinate is measured once, `measured`.
ResidualProblem curve_of(std::vector<double> measured, Shape shape, double start, double lower,
                         double upper) {
  ShapedBlock block{0, measured.size(), {}, shape};
  std::vector<UnknownRange> unknowns;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    block.abscissa.push_back(static_cast<double>(k * k + k));
    unknowns.push_back({.start = start, .lower = lower, .upper = upper});
  }
  const std::size_t rows = measured.size();
  ResidualProblem problem = rows_of(
      rows, unknowns, [measured = std::move(measured)](std::span<const double> x, std::size_t i) {
        return x[i] - measured[i];
      });
  problem.shapes = {block};
  return problem;
}

/// A line a + b t through points with a known scatter.
double line_noise(std::size_t i) { return 0.1 * std::sin(17.0 * static_cast<double>(i * i)); }
ResidualProblem line(UnknownRange a, UnknownRange b) {
  return rows_of(40, {a, b}, [](std::span<const double> x, std::size_t i) {
    const double t = 0.1 * static_cast<double>(i);
    return x[0] + x[1] * t - (1.0 + 0.5 * t + line_noise(i));
  });
}

TEST_CASE("An optimum outside of the bounds is found on the bound, exactly, and said so") {
  const auto bound = GENERATE(0, 1, 2, 3);
  UnknownRange slope{.start = 0.1};
  if (bound == 0) slope = {.start = 0.1, .lower = 0.0, .upper = 0.3};
  if (bound == 1) slope = {.start = 0.1, .upper = 0.3};
  if (bound == 2) slope = {.start = 0.9, .lower = 0.7};
  if (bound == 3) slope = {.start = 0.1, .lower = 0.01, .upper = 0.3, .scale = Scale::kLog};
  const double wanted = bound == 2 ? 0.7 : 0.3;
  const LeastSquaresFit fit = solve_least_squares(line({.start = 3.0}, slope), {});
  INFO(bound << ": " << fit.stop_sentence);
  CHECK(fit.converged);
  CHECK(fit.x[1] == Approx(wanted).epsilon(1e-12));
  CHECK((bound == 2 ? fit.at_lower[1] : fit.at_upper[1]) != 0);
  CHECK(fit.at_lower[0] == 0);
  CHECK(fit.at_upper[0] == 0);
  // With the slope there the intercept is the mean of what is left.
  double mean = 0.0;
  for (std::size_t i = 0; i < 40; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    mean += (1.0 + (0.5 - wanted) * t + line_noise(i)) / 40.0;
  }
  CHECK(fit.x[0] == Approx(mean).epsilon(1e-9));
}

TEST_CASE("A start on a bound is moved inside, said so, and does not stay there") {
  const LeastSquaresFit fit = solve_least_squares(
      line({.start = 0.0, .lower = 0.0, .upper = 10.0}, {.start = 2.0, .lower = 0.0, .upper = 2.0}),
      {});
  const LeastSquaresFit free = solve_least_squares(line({.start = 3.0}, {.start = 3.0}), {});
  CHECK(fit.converged);
  CHECK(fit.moved_inside[0] != 0);
  CHECK(fit.moved_inside[1] != 0);
  CHECK(fit.x[0] == Approx(free.x[0]).epsilon(1e-8));
  CHECK(fit.x[1] == Approx(free.x[1]).epsilon(1e-8));
  CHECK(free.moved_inside[0] == 0);
}

TEST_CASE("An unknown that nothing depends on is frozen at its start") {
  ResidualProblem problem = line({.start = 3.0}, {.start = 3.0});
  problem.unknowns.push_back({.start = 7.0, .lower = 0.0});
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  CHECK(fit.converged);
  CHECK(fit.frozen == std::vector<char>{0, 0, 1});
  CHECK(fit.x[2] == 7.0);
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  CHECK(statistics.identifiable == std::vector<char>{1, 1, 0});
  CHECK(std::isnan(statistics.standard_error[2]));
  CHECK(statistics.unknowns == 2);
}

TEST_CASE("Nothing gained is not called converged") {
  SECTION("zero gradient: no residual depends on anything") {
    const LeastSquaresFit fit = solve_least_squares(
        rows_of(5, {{.start = 1.0}}, [](std::span<const double>, std::size_t) { return 1.0; }), {});
    CHECK(fit.stop == StopReason::kZeroGradient);
    CHECK_FALSE(fit.converged);
    CHECK(fit.x[0] == 1.0);
  }
  SECTION("zero iterations: the start is the optimum") {
    const LeastSquaresFit found = solve_least_squares(line({.start = 3.0}, {.start = 3.0}), {});
    const LeastSquaresFit again =
        solve_least_squares(line({.start = found.x[0]}, {.start = found.x[1]}), {});
    CHECK(again.iterations == 0);
    CHECK(again.stop == StopReason::kNoIteration);
    CHECK_FALSE(again.converged);
  }
  SECTION("no value at the start") {
    ResidualProblem problem = line({.start = 3.0}, {.start = 3.0});
    problem.residuals = [](std::span<const double>, std::span<double>) { return false; };
    const LeastSquaresFit fit = solve_least_squares(problem, {});
    CHECK(fit.stop == StopReason::kModelFailure);
    CHECK_FALSE(fit.converged);
  }
  SECTION("fewer rows than unknowns") {
    const LeastSquaresFit fit = solve_least_squares(
        rows_of(1, {{.start = 1.0}, {.start = 2.0}},
                [](std::span<const double> x, std::size_t) { return x[0] + x[1]; }),
        {});
    CHECK(fit.stop == StopReason::kTooFewData);
    CHECK_FALSE(fit.converged);
  }
  SECTION("too few iterations allowed") {
    SolverOptions options;
    options.most_iterations = 2;
    const test::Synthetic wear = test::wear();
    const LeastSquaresFit fit = solve_least_squares(
        test::problem_of(wear, std::vector{120.0, 300.0, 6.0, 1500.0}, {}), options);
    CHECK(fit.stop == StopReason::kIterations);
    CHECK_FALSE(fit.converged);
  }
}

TEST_CASE("Every stop reason has a sentence, which leaves the verdict to who prints it") {
  for (int reason = 0; reason <= static_cast<int>(StopReason::kSilent); ++reason) {
    const std::string text = stop_text(static_cast<StopReason>(reason));
    CHECK_FALSE(text.empty());
    CHECK(text.find("converged") == std::string::npos);
  }
}

TEST_CASE("A monotone curve measured once an ordinate is the isotonic regression") {
  const std::vector<double> measured{0.3, 0.25, 0.4, 0.42, 0.39, 0.38, 0.5};
  const bool falls = GENERATE(false, true);
  std::vector<double> data = measured;
  if (falls) std::reverse(data.begin(), data.end());
  const Shape shape{falls ? Shape::Monotone::kDecreasing : Shape::Monotone::kIncreasing,
                    Shape::Curvature::kFree};
  std::vector<double> wanted = nearest_ascending(measured);
  if (falls) std::reverse(wanted.begin(), wanted.end());
  for (const double upper : {1.0, std::numeric_limits<double>::infinity()}) {
    const LeastSquaresFit fit = solve_least_squares(curve_of(data, shape, 0.2, 0.0, upper), {});
    INFO(fit.stop_sentence);
    CHECK(fit.converged);
    for (std::size_t k = 0; k < data.size(); ++k) {
      CHECK(fit.x[k] == Approx(wanted[k]).epsilon(1e-7));
    }
  }
}

TEST_CASE("A curve that has its shape already is met exactly, one that has not keeps it") {
  const auto convex = GENERATE(true, false);
  const double sign = convex ? 1.0 : -1.0;
  const Shape shape{Shape::Monotone::kFree,
                    convex ? Shape::Curvature::kConvex : Shape::Curvature::kConcave};
  std::vector<double> data;
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = static_cast<double>(k * k + k);
    data.push_back(0.5 + sign * 1e-3 * std::pow(a - 8.0, 2));
  }
  for (const double lower : {-1.0, -std::numeric_limits<double>::infinity()}) {
    const LeastSquaresFit exact = solve_least_squares(curve_of(data, shape, 0.4, lower, 3.0), {});
    INFO(exact.stop_sentence);
    CHECK(exact.converged);
    for (std::size_t k = 0; k < data.size(); ++k)
      CHECK(exact.x[k] == Approx(data[k]).epsilon(1e-7));

    std::vector<double> bent = data;
    bent[2] += sign * 0.2;
    const ResidualProblem problem = curve_of(bent, shape, 0.4, lower, 3.0);
    const LeastSquaresFit kept = solve_least_squares(problem, {});
    INFO(kept.stop_sentence);
    CHECK(kept.converged);
    const std::vector<double>& a = problem.shapes[0].abscissa;
    for (std::size_t k = 1; k + 1 < data.size(); ++k) {
      const double before = (kept.x[k] - kept.x[k - 1]) / (a[k] - a[k - 1]);
      const double after = (kept.x[k + 1] - kept.x[k]) / (a[k + 1] - a[k]);
      CHECK(sign * (after - before) >= -1e-12);
    }
    CHECK(kept.cost < 0.5 * 0.2 * 0.2);
  }
}

TEST_CASE("A frozen ordinate of a monotone curve gives way only as far as it must") {
  ResidualProblem problem = curve_of(
      {0.2, 0.4, 0.3, 0.5}, {Shape::Monotone::kIncreasing, Shape::Curvature::kFree}, 0.1, 0.0, 1.0);
  problem.residuals = [](std::span<const double> x, std::span<double> r) {
    r[0] = x[0] - 0.2;
    r[1] = x[1] - 0.4;
    r[2] = 0.0;
    r[3] = x[3] - 0.5;
    return true;
  };
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  CHECK(fit.frozen[2] != 0);
  CHECK(fit.x[2] == Approx(0.4).epsilon(1e-7));
  CHECK(fit.x[3] == Approx(0.5).epsilon(1e-7));
}

TEST_CASE("Robust losses find the value at which the bounded influences balance") {
  const std::vector<double> measured{0.1, -0.2, 0.05, 0.3, -0.1, 0.15, 8.0, 0.0, -0.05, 12.0, -7.0};
  const auto kind = GENERATE(Loss::Kind::kHuber, Loss::Kind::kSoftL1);
  ResidualProblem problem =
      rows_of(measured.size(), {{.start = 2.0}},
              [&](std::span<const double> x, std::size_t i) { return x[0] - measured[i]; });
  problem.loss = {kind, 0.25};
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  INFO(fit.stop_sentence);
  CHECK(fit.converged);
  double balance = 0.0;
  for (const double r : fit.residuals) balance += loss_weight(problem.loss, r) * r;
  CHECK(balance == Approx(0.0).margin(1e-8));
  CHECK(std::abs(fit.x[0]) < 0.2);
  CHECK(fit.cost == Approx(total_cost(problem, fit.residuals)));
  CHECK(fit.cost < fit.start_cost);
}

TEST_CASE("Several starts find the lower of two minima, the same one for the same seed") {
  const ResidualProblem problem = rows_of(2, {{.start = 2.5, .lower = -4.0, .upper = 4.0}},
                                          [](std::span<const double> x, std::size_t i) {
                                            return i == 0 ? x[0] * x[0] - 4.0 : 0.5 * (x[0] + 2.0);
                                          });
  SolverOptions options;
  const LeastSquaresFit one = solve_least_squares(problem, options);
  CHECK(one.x[0] > 0.0);
  options.starts = 8;
  const LeastSquaresFit many = solve_least_squares(problem, options);
  CHECK(many.x[0] == Approx(-2.0).epsilon(1e-8));
  CHECK(many.searches.size() == 8);
  CHECK(many.searches[0].end[0] == one.x[0]);
  const LeastSquaresFit again = solve_least_squares(problem, options);
  CHECK(again.searches[5].start == many.searches[5].start);
  options.seed = 2;
  CHECK(solve_least_squares(problem, options).searches[5].start != many.searches[5].start);
}

TEST_CASE("The profile of a linear model crosses its threshold at Student's interval") {
  const ResidualProblem problem = line({.start = 3.0}, {.start = 3.0, .lower = -5.0, .upper = 5.0});
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const FitStatistics statistics = fit_statistics(problem, fit, 0.9);
  for (std::size_t j = 0; j < 2; ++j) {
    const LikelihoodProfile profile = profile_likelihood(problem, fit, j, 0.9);
    CHECK_FALSE(profile.open_below);
    CHECK_FALSE(profile.open_above);
    CHECK(profile.lower == Approx(statistics.lower[j]).epsilon(1e-5));
    CHECK(profile.upper == Approx(statistics.upper[j]).epsilon(1e-5));
    CHECK(std::is_sorted(profile.value.begin(), profile.value.end()));
  }
}

TEST_CASE("A profile that the bounds cut off is open") {
  const ResidualProblem problem =
      line({.start = 3.0}, {.start = 0.5, .lower = 0.49, .upper = 0.51});
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const LikelihoodProfile profile = profile_likelihood(problem, fit, 1, 0.999);
  CHECK((profile.open_below || profile.open_above));
}

TEST_CASE("The bootstrap scatters as the linearised errors say where the noise is white") {
  const test::Synthetic decay = test::decay();
  const ResidualProblem problem =
      test::problem_of(decay, std::vector{0.5, 0.1, 1.0}, test::noise_of(decay, 5));
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  const Bootstrap result = bootstrap(problem, fit, 300, 0.95, 1);
  CHECK(result.done == 300);
  for (std::size_t j = 0; j < 3; ++j) {
    // 300 resamplings know their scatter to 4 %, the residuals at hand are one sample
    CHECK(result.standard_error[j] == Approx(statistics.standard_error[j]).epsilon(0.25));
    CHECK(result.lower[j] < fit.x[j]);
    CHECK(result.upper[j] > fit.x[j]);
  }
  CHECK(bootstrap(problem, fit, 5, 0.95, 1).standard_error ==
        bootstrap(problem, fit, 5, 0.95, 1).standard_error);
}

TEST_CASE("Only the product of two unknowns is seen: neither is identifiable") {
  const ResidualProblem problem =
      rows_of(20, {{.start = 2.0}, {.start = 3.0}, {.start = 1.0}},
              [](std::span<const double> x, std::size_t i) {
                const double t = static_cast<double>(i);
                return x[0] * x[1] + x[2] * t - (4.0 + 0.5 * t + line_noise(i));
              });
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  INFO(fit.stop_sentence);
  CHECK(fit.x[0] * fit.x[1] == Approx(4.0).margin(0.1));
  CHECK(statistics.identifiable == std::vector<char>{0, 0, 1});
  CHECK(std::isnan(statistics.standard_error[0]));
  CHECK(statistics.standard_error[2] > 0.0);
}

TEST_CASE("A problem with many rows ends where one with few does") {
  // The normal equations take over at 4000 entries; steps by QR end both.
  const auto problem_of = [](std::size_t copies) {
    return rows_of(40 * copies, {{.start = 5.0}, {.start = 0.01, .lower = 0.0}},
                   [](std::span<const double> x, std::size_t i) {
                     const double t = 0.1 * static_cast<double>(i % 40);
                     return x[0] * std::exp(-x[1] * t) -
                            (2.0 * std::exp(-0.7 * t) + line_noise(i % 40));
                   });
  };
  const LeastSquaresFit few = solve_least_squares(problem_of(1), {});
  const LeastSquaresFit many = solve_least_squares(problem_of(100), {});
  CHECK(few.converged);
  CHECK(many.converged);
  CHECK(many.x[0] == Approx(few.x[0]).epsilon(1e-9));
  CHECK(many.x[1] == Approx(few.x[1]).epsilon(1e-9));
  CHECK(many.cost == Approx(100.0 * few.cost).epsilon(1e-10));
}

/// A slider of a stick stiffness on a sine of 6, against data of `truth`; nothing is differenced.
ResidualProblem slider_of(std::array<double, 2> truth, double limit_start, double stiffness_start) {
  constexpr std::size_t kRows = 601;
  constexpr double kForce = 2680.0;
  const auto slide = [](double mu, double k, std::span<double> force, std::span<double> jacobian) {
    double f = 0.0;
    double by_mu = 0.0;
    double by_k = 0.0;
    double before = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double motion = 6.0 * std::sin(3.14159265358979 * 0.01 * static_cast<double>(i));
      f += k * (motion - before);
      by_k += motion - before;
      before = motion;
      if (std::abs(f) > mu * kForce) {
        by_mu = f > 0.0 ? kForce : -kForce;
        by_k = 0.0;
        f = mu * by_mu;
      }
      force[i] = f;
      if (jacobian.empty()) continue;
      jacobian[2 * i] = by_mu;
      jacobian[2 * i + 1] = by_k;
    }
  };
  std::vector<double> measured(kRows);
  slide(truth[0], truth[1], measured, {});
  ResidualProblem problem;
  problem.rows = problem.data_rows = kRows;
  problem.unknowns = {{.start = limit_start}, {.start = stiffness_start}};
  problem.derivatives = [=](std::span<const double> x, std::span<double> r,
                            std::span<double> jacobian) {
    slide(x[0], x[1], r, jacobian);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= measured[i];
    return true;
  };
  problem.residuals = [derivatives = problem.derivatives](std::span<const double> x,
                                                          std::span<double> r) {
    return derivatives(x, r, {});
  };
  return problem;
}

TEST_CASE("A slider's limit and stiffness are found from starts 3 off, seen there or not") {
  const std::array<double, 2> truth{0.23, 4200.0};
  const double mu = GENERATE(1.0 / 3.0, 3.0);
  const double k = GENERATE(1.0 / 3.0, 3.0);
  const LeastSquaresFit fit =
      solve_least_squares(slider_of(truth, mu * truth[0], k * truth[1]), {});
  INFO(mu << ", " << k << ": " << fit.stop_sentence);
  CHECK(fit.converged);
  CHECK(fit.x[0] == Approx(truth[0]).epsilon(1e-8));
  CHECK(fit.x[1] == Approx(truth[1]).epsilon(1e-8));
  CHECK(fit.frozen == std::vector<char>{0, 0});
}

TEST_CASE("A start from which nothing slips, or hardly anything sticks, is left") {
  const std::array<double, 2> truth{0.3, 800.0};
  const bool stiff = GENERATE(false, true);
  const LeastSquaresFit fit =
      solve_least_squares(stiff ? slider_of(truth, 0.15, 8e5) : slider_of(truth, 3.0, 700.0), {});
  INFO(stiff << ": " << fit.stop_sentence);
  CHECK(fit.converged);
  CHECK(fit.x[0] == Approx(truth[0]).epsilon(1e-8));
  CHECK(fit.x[1] == Approx(truth[1]).epsilon(1e-8));
  CHECK(fit.searches.size() > 1);
}

TEST_CASE("What has no effect at the end, though it has elsewhere, is no convergence") {
  // The data only stick: every higher limit is as good.
  const LeastSquaresFit fit = solve_least_squares(slider_of({9.0, 800.0}, 3.0, 500.0), {});
  INFO(fit.stop_sentence);
  CHECK(fit.stop == StopReason::kSilent);
  CHECK_FALSE(fit.converged);
  CHECK(fit.silent == std::vector<char>{1, 0});
  CHECK(fit.frozen == std::vector<char>{0, 0});
  CHECK(fit.x[1] == Approx(800.0).epsilon(1e-8));
}

TEST_CASE("Near a bound is measured by the scale, and near is not on it") {
  const auto decades = [](UnknownRange range, double wanted) {
    return rows_of(3, {range}, [wanted](std::span<const double> x, std::size_t i) {
      return std::log(x[0] / wanted) + 0.1 * static_cast<double>(i) - 0.1;
    });
  };
  const LeastSquaresFit inside = solve_least_squares(
      decades({.start = 2e3, .lower = 1.0, .upper = 1e12, .scale = Scale::kLog}, 4206.0), {});
  CHECK(inside.x[0] == Approx(4206.0).epsilon(1e-8));
  CHECK(inside.at_lower[0] == 0);
  const LeastSquaresFit open = solve_least_squares(
      rows_of(3, {{.start = 1e6, .lower = 0.0}},
              [](std::span<const double> x, std::size_t) { return x[0] - 1.05e-3; }),
      {});
  CHECK(open.at_lower[0] == 0);
  // 0.05 % of the way inside: where the user wants it, and so is 0 between -1000 and 1000
  for (const double start : {1500.0, 0.0}) {
    const double lower = start > 0.0 ? 1000.0 : -1000.0;
    const double upper = start > 0.0 ? 1e6 : 1000.0;
    const LeastSquaresFit kept = solve_least_squares(
        rows_of(3, {{.start = start, .lower = lower, .upper = upper}},
                [](std::span<const double> x, std::size_t) { return 1e-3 * (x[0] - 900.0); }),
        {});
    CHECK(kept.moved_inside[0] == 0);
    CHECK(kept.searches[0].start[0] == Approx(start).margin(1e-9));
  }
}

/// The least of |table x - measured|^2/2 with shape x >= 0: all sets of rows that hold are tried.
double least_cost(const Eigen::MatrixXd& table, const Eigen::VectorXd& measured,
                  const Eigen::MatrixXd& shape) {
  const Eigen::Index n = table.cols();
  double least = std::numeric_limits<double>::infinity();
  for (unsigned set = 0; set < 1U << static_cast<unsigned>(shape.rows()); ++set) {
    const auto held = static_cast<Eigen::Index>(std::popcount(set));
    Eigen::MatrixXd rows(held, n);
    for (Eigen::Index i = 0, at = 0; i < shape.rows(); ++i) {
      if ((set >> static_cast<unsigned>(i) & 1U) != 0) rows.row(at++) = shape.row(i);
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + held, n + held);
    system.topLeftCorner(n, n) = table.transpose() * table;
    system.bottomLeftCorner(held, n) = rows;
    system.topRightCorner(n, held) = rows.transpose();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + held);
    right.head(n) = table.transpose() * measured;
    const Eigen::VectorXd x = system.completeOrthogonalDecomposition().solve(right).head(n);
    if ((shape * x).minCoeff() < -1e-10) continue;
    least = std::min(least, 0.5 * (table * x - measured).squaredNorm());
  }
  return least;
}

TEST_CASE("Tables of any shape through noisy points are the least of their convex problem") {
  std::mt19937_64 engine(6);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index n = 3 + trial % 3;
    const int which = 1 + trial / 3 % 8;  // monotone + 3 curvature
    const Shape shape{static_cast<Shape::Monotone>(which % 3),
                      static_cast<Shape::Curvature>(which / 3)};
    constexpr Eigen::Index kPoints = 40;
    Eigen::MatrixXd table = Eigen::MatrixXd::Zero(kPoints, n);
    Eigen::VectorXd truth(n);
    for (Eigen::Index k = 0; k < n; ++k) truth(k) = 0.2 + 0.6 * uniform();
    for (Eigen::Index i = 0; i < kPoints; ++i) {
      const double at = uniform() * static_cast<double>(n - 1);
      const auto cell = static_cast<Eigen::Index>(at);
      table(i, cell + 1) = at - static_cast<double>(cell);
      table(i, cell) = 1.0 - table(i, cell + 1);
    }
    Eigen::VectorXd measured = table * truth;
    for (double& value : measured) value += 0.05 * (uniform() - 0.5);
    Eigen::MatrixXd demands(0, n);
    const auto demand = [&](std::initializer_list<double> factors, double sign) {
      for (Eigen::Index k = 0; k + static_cast<Eigen::Index>(factors.size()) <= n; ++k) {
        demands.conservativeResize(demands.rows() + 1, n);
        demands.bottomRows<1>().setZero();
        Eigen::Index at = k;
        for (const double factor : factors) demands(demands.rows() - 1, at++) = sign * factor;
      }
    };
    if (shape.monotone != Shape::Monotone::kFree) demand({-1.0, 1.0}, which % 3 == 1 ? 1.0 : -1.0);
    if (shape.curvature != Shape::Curvature::kFree) {
      demand({1.0, -2.0, 1.0}, which / 3 == 1 ? 1.0 : -1.0);
    }
    ResidualProblem problem =
        rows_of(kPoints, std::vector<UnknownRange>(n, {.start = 0.5, .lower = -9.0, .upper = 9.0}),
                [&](std::span<const double> x, std::size_t i) {
                  const Eigen::Map<const Eigen::VectorXd> ordinates(x.data(), n);
                  const auto row = static_cast<Eigen::Index>(i);
                  return table.row(row).dot(ordinates) - measured(row);
                });
    problem.derivatives = [&, residuals = problem.residuals](std::span<const double> x,
                                                             std::span<double> r,
                                                             std::span<double> jacobian) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobian.data(), kPoints, n) = table;
      return residuals(x, r);
    };
    ShapedBlock block{0, static_cast<std::size_t>(n), {}, shape};
    for (Eigen::Index k = 0; k < n; ++k) block.abscissa.push_back(static_cast<double>(k));
    problem.shapes = {block};
    const LeastSquaresFit fit = solve_least_squares(problem, {});
    const double least = least_cost(table, measured, demands);
    INFO("trial " << trial << ", shape " << which << ": " << fit.stop_sentence);
    CHECK(fit.converged);
    CHECK(fit.cost == Approx(least).epsilon(1e-6));
    const Eigen::Map<const Eigen::VectorXd> found(fit.x.data(), n);
    CHECK((demands * found).minCoeff() >= -1e-12);
  }
}

}  // namespace
}  // namespace slipbench::driver::fit
