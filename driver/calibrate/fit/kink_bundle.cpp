// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/kink_bundle.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace slipbench::driver::fit {
namespace {

constexpr std::size_t kMostCuts = 24;

/// The shares l >= 0 with the sum 1 that make |A l|^2/2 + e l least: two at a time give and take
/// (Platt 1998), from the first one.
Eigen::VectorXd best_shares(const Eigen::MatrixXd& planes, const Eigen::VectorXd& error) {
  constexpr int kMostTurns = 5000;
  constexpr double kEnough = 1e-10;  // of the first plane's square
  const Eigen::Index count = planes.cols();
  const Eigen::MatrixXd square = planes.transpose() * planes;
  Eigen::VectorXd share = Eigen::VectorXd::Zero(count);
  share(0) = 1.0;
  Eigen::VectorXd slope = square.col(0) + error;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    Eigen::Index taker = 0;
    Eigen::Index giver = -1;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (slope(i) < slope(taker)) taker = i;
      if (share(i) > 0.0 && (giver < 0 || slope(i) > slope(giver))) giver = i;
    }
    const double difference = slope(giver) - slope(taker);
    if (!(difference > kEnough * square(0, 0))) break;
    const double curvature =
        square(giver, giver) + square(taker, taker) - 2.0 * square(giver, taker);
    const double most = share(giver);
    const double moved = curvature * most > difference ? difference / curvature : most;
    share(taker) += moved;
    share(giver) = moved < most ? most - moved : 0.0;
    slope += moved * (square.col(taker) - square.col(giver));
  }
  return share;
}

}  // namespace

void KinkBundle::add(KinkCut cut) {
  if (cuts_.size() == kMostCuts) cuts_.erase(cuts_.begin());
  cuts_.push_back(std::move(cut));
}

KinkStep KinkBundle::step(const KinkCut& here, const Eigen::MatrixXd& map,
                          const Eigen::MatrixXd& triangle, double reach) {
  const auto upper = triangle.triangularView<Eigen::Upper>();
  const auto lower = triangle.transpose().triangularView<Eigen::Lower>();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> inverse(map);
  const auto way_to = [&](const KinkCut& cut) -> Eigen::VectorXd {
    return inverse.solve(cut.x - here.x);
  };
  cuts_.erase(
      std::remove_if(cuts_.begin(), cuts_.end(),
                     [&](const KinkCut& cut) { return !((upper * way_to(cut)).norm() <= reach); }),
      cuts_.end());
  const auto count = static_cast<Eigen::Index>(cuts_.size()) + 1;
  Eigen::MatrixXd planes(triangle.cols(), count);
  Eigen::VectorXd error = Eigen::VectorXd::Zero(count);
  planes.col(0) = lower.solve(map.transpose() * here.slope);
  for (Eigen::Index i = 1; i < count; ++i) {
    const KinkCut& cut = cuts_[static_cast<std::size_t>(i - 1)];
    const Eigen::VectorXd away = way_to(cut);
    const Eigen::VectorXd scaled = upper * away;
    const Eigen::VectorXd gradient = map.transpose() * cut.slope;
    planes.col(i) = lower.solve(gradient) - scaled;
    // How far the plane is below the cost here. A cost that is not convex lets it be above; and
    // what is far says little about here.
    constexpr double kMistrust = 0.25;
    const double below = here.cost - (cut.cost - gradient.dot(away) + 0.5 * scaled.squaredNorm());
    error(i) = std::max(std::abs(below), kMistrust * scaled.squaredNorm());
  }
  const Eigen::VectorXd share = best_shares(planes, error);
  const Eigen::VectorXd sum = planes * share;
  KinkStep result;
  result.step = -upper.solve(sum);
  result.gain = 0.5 * sum.squaredNorm() + error.dot(share);
  for (Eigen::Index i = 1; i < count; ++i) {
    if (share(i) > 0.0) result.holders.push_back(cuts_[static_cast<std::size_t>(i - 1)]);
  }
  return result;
}

}  // namespace slipbench::driver::fit
