// SPDX-License-Identifier: Apache-2.0
// Steps near kinks of the cost, where the gradient of one point is of little use.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace slipbench::driver::fit {

/// A point with cost and slope, over the unknowns.
struct KinkCut {
  Eigen::VectorXd x;
  double cost = 0.0;
  Eigen::VectorXd slope;  ///< d cost/dx
};

/// Gain that the cuts leave, and the step to it.
struct KinkStep {
  Eigen::VectorXd step;
  double gain = 0.0;             ///< predicted fall of the cost
  std::vector<KinkCut> holders;  ///< cuts of other points that hold the step back
};

/// A bundle method in the metric of Gauss and Newton. The cost is taken for |R s|^2/2 plus the
/// greatest of the planes that touch what remains at the points seen. With the plane of one point
/// the step is that of Gauss and Newton. (docs/theory, section 17; Lemarechal 1978, Kiwiel
/// 1985.)
class KinkBundle {
 public:
  bool empty() const { return cuts_.empty(); }
  void add(KinkCut cut);
  /// \param here the best point, whose cut need not be in the bundle
  /// \param map dx/dz of the coordinates that are searched, full rank
  /// \param triangle R of the linearised problem there, full rank
  /// \param reach cuts beyond this |R s| are dropped
  KinkStep step(const KinkCut& here, const Eigen::MatrixXd& map, const Eigen::MatrixXd& triangle,
                double reach);

 private:
  std::vector<KinkCut> cuts_;
};

}  // namespace slipbench::driver::fit
