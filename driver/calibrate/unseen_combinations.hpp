// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Unknowns that the data see together only.
struct UnseenCombination {
  std::vector<std::size_t> unknowns;  ///< in Calibration::unknowns, ascending
  std::string sentence;               ///< "only the product of mu and N is seen"
};

/// The combinations that the residuals do not depend on, to first order at the optimum: the null
/// space of the Jacobian of the unknowns that the statistics call not identifiable. Columns that
/// are parallel say which function of two unknowns is seen: with dr/db = a dr/da it is the product
/// if a = x_a/x_b, the quotient if a = -x_a/x_b, the sum or the difference if a = 1 or -1.
std::vector<UnseenCombination> unseen_combinations(const Calibration& calibration);

}  // namespace slipbench::driver::calibrate
