// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/unseen_combinations.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Sine of the angle between two columns below which they are parallel; derivatives by differences
/// have about this error.
constexpr double kParallel = 1e-4;
/// Eigenvalues of the matrix of cosines below this belong to its null space, likewise.
constexpr double kNull = 1e-8;
/// Components of a null vector of unit length that count.
constexpr double kPart = 0.05;

std::vector<std::size_t> not_identifiable(const Calibration& calibration) {
  std::vector<std::size_t> result;
  const std::vector<char>& identifiable = calibration.statistics.identifiable;
  for (std::size_t u = 0; u < calibration.unknowns.size() && u < identifiable.size(); ++u) {
    const bool seen = calibration.unknowns[u].visits > 0;
    if (identifiable[u] == 0 && seen) result.push_back(u);
  }
  return result;
}

/// J^T W J of some unknowns over the compared rows.
Eigen::MatrixXd products(const Calibration& calibration, const std::vector<std::size_t>& some) {
  const std::size_t n = calibration.unknowns.size();
  const std::vector<double>& jacobian = calibration.fit.jacobian;
  const std::vector<double>& weights = calibration.fit.weights;
  const std::size_t rows = std::min(jacobian.size() / n, calibration.problem.data_rows);
  const auto m = static_cast<Eigen::Index>(some.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(m, m);
  Eigen::VectorXd row(m);
  for (std::size_t r = 0; r < rows; ++r) {
    for (Eigen::Index i = 0; i < m; ++i) {
      row[i] = jacobian[r * n + some[static_cast<std::size_t>(i)]];
    }
    sum.selfadjointView<Eigen::Lower>().rankUpdate(row, r < weights.size() ? weights[r] : 1.0);
  }
  return sum.selfadjointView<Eigen::Lower>();
}

std::string names(const Calibration& calibration, const std::vector<std::size_t>& unknowns) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string_view> list;
  for (std::size_t i = 0; i < std::min(unknowns.size(), kMost); ++i) {
    list.push_back(calibration.unknowns[unknowns[i]].name);
  }
  const std::string more =
      unknowns.size() > kMost ? fmt::format("{} more", unknowns.size() - kMost) : std::string();
  if (!more.empty()) list.push_back(more);
  return base::in_words(list, "and");
}

/// Returns what of two unknowns is seen whose columns are parallel, dr/db = a dr/da.
std::string_view seen_function(double a, double value_a, double value_b) {
  const auto is = [&](double wanted) { return std::abs(a - wanted) <= 1e-3 * std::abs(wanted); };
  const bool nonzero = value_a != 0.0 && value_b != 0.0;
  const double quotient = nonzero ? value_a / value_b : 0.0;
  const bool product = nonzero && is(quotient);
  const bool ratio = nonzero && is(-quotient);
  const bool sum = is(1.0);
  const bool difference = is(-1.0);
  if (product && sum) return "the product or the sum";
  if (ratio && difference) return "the quotient or the difference";
  if (product) return "the product";
  if (ratio) return "the quotient";
  if (sum) return "the sum";
  if (difference) return "the difference";
  return "one combination";
}

}  // namespace

std::vector<UnseenCombination> unseen_combinations(const Calibration& calibration) {
  const std::vector<std::size_t> some = not_identifiable(calibration);
  std::vector<UnseenCombination> result;
  if (some.size() < 2) return result;
  const Eigen::MatrixXd gram = products(calibration, some);
  const auto m = gram.rows();
  const Eigen::VectorXd length = gram.diagonal().cwiseMax(0.0).cwiseSqrt();
  if (!(length.minCoeff() > 0.0) || !length.allFinite()) return result;
  const Eigen::MatrixXd cosines =
      length.cwiseInverse().asDiagonal() * gram * length.cwiseInverse().asDiagonal();

  // Parallel columns first: they can be put into words.
  std::vector<char> told(some.size(), 0);
  for (Eigen::Index i = 0; i < m; ++i) {
    if (told[static_cast<std::size_t>(i)] != 0) continue;
    std::vector<Eigen::Index> group{i};
    for (Eigen::Index j = i + 1; j < m; ++j) {
      if (1.0 - std::abs(cosines(i, j)) < 0.5 * kParallel * kParallel) group.push_back(j);
    }
    if (group.size() < 2) continue;
    UnseenCombination combination;
    for (const Eigen::Index j : group) {
      told[static_cast<std::size_t>(j)] = 1;
      combination.unknowns.push_back(some[static_cast<std::size_t>(j)]);
    }
    std::string_view what = "one combination";
    if (group.size() == 2) {
      const auto [a, b] = std::pair{combination.unknowns[0], combination.unknowns[1]};
      what = seen_function(gram(group[0], group[1]) / gram(group[0], group[0]),
                           calibration.unknowns[a].value, calibration.unknowns[b].value);
    }
    combination.sentence =
        fmt::format("only {} of {} is seen", what, names(calibration, combination.unknowns));
    result.push_back(std::move(combination));
  }

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(cosines);
  for (Eigen::Index k = 0; k < m && solver.eigenvalues()[k] < kNull; ++k) {
    UnseenCombination combination;
    bool new_one = false;
    for (Eigen::Index i = 0; i < m; ++i) {
      if (std::abs(solver.eigenvectors()(i, k)) < kPart) continue;
      combination.unknowns.push_back(some[static_cast<std::size_t>(i)]);
      new_one = new_one || told[static_cast<std::size_t>(i)] == 0;
      told[static_cast<std::size_t>(i)] = 1;
    }
    if (!new_one || combination.unknowns.size() < 2) continue;
    combination.sentence = fmt::format("{} are seen in fewer combinations than they are",
                                       names(calibration, combination.unknowns));
    result.push_back(std::move(combination));
  }
  return result;
}

}  // namespace slipbench::driver::calibrate
