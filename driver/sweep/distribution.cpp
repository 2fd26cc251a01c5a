// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/distribution.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace slipbench::driver::sweep {

double Distribution::at(double part) const {
  switch (kind) {
    case Kind::kUniform:
      return numbers[0] + part * (numbers[1] - numbers[0]);
    case Kind::kLogUniform:
      return numbers[0] * std::pow(numbers[1] / numbers[0], part);
    case Kind::kNormal:
      return numbers[0] + gsl_cdf_gaussian_Pinv(part, numbers[1]);
    case Kind::kList:
      break;
  }
  const auto count = static_cast<double>(numbers.size());
  const double place = std::min(std::floor(part * count), count - 1.0);
  return numbers[static_cast<std::size_t>(place)];
}

}  // namespace slipbench::driver::sweep
