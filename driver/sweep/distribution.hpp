// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace slipbench::driver::sweep {

/// Spread of one varied parameter, as its quantile function.
struct Distribution {
  enum class Kind : std::uint8_t { kUniform, kLogUniform, kNormal, kList } kind = Kind::kUniform;
  /// Lowest and highest value; of a normal distribution mean and standard deviation; the values of
  /// a list, which are equally likely.
  std::vector<double> numbers;

  /// Returns the value below which `part` of all values lie.
  /// \param part between 0 and 1, both excluded; of a list also 0
  double at(double part) const;
};

}  // namespace slipbench::driver::sweep
