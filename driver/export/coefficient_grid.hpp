// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/export/run_range.hpp"

namespace slipbench::driver::exports {

/// Coefficient on a grid of slip rates and contact forces, linear between its points and constant
/// outside of them.
struct CoefficientGrid {
  std::vector<double> rates;   ///< [L/T], ascending from 0 on; 0 alone where it does not matter
  std::vector<double> forces;  ///< F_N [F], ascending; one alone where it does not matter
  std::vector<std::vector<double>> mu;  ///< of each force, over the rates
  double error = 0.0;  ///< largest difference from the law [1], between the points, in its range
};

/// Samples a law at the temperature and fields of the start of a run, over the range in which the
/// law has its shape and the run goes. Points are added until straight lines between them are off
/// by no more than 1e-4 of the largest coefficient, as far as 200 points a side go. Knots of a
/// table are among the points.
CoefficientGrid tabulate(const law::FrictionLaw& law, const RunRange& run);

}  // namespace slipbench::driver::exports
