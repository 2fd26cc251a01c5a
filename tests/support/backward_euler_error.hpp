// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace slipbench::test {

/// Error of backward Euler, followed to ever more increments where a few do not do.
struct BackwardEulerError {
  double coarse = 0.0;  ///< of `count` increments
  double fine = 0.0;    ///< of twice as many
  double last = 0.0;    ///< of the most that were asked for
};

/// Returns the error of `count` and 2 `count` increments, and of 10, 100, 1000 times 2 `count`
/// until it is within 1e-3, or of 10,000 times as many until it is within 5 %: before increments
/// are small against the elastic slip, and the events of a history, the error has no order yet.
/// \param error_at number of increments -> error [1]
template <class ErrorAt>
BackwardEulerError backward_euler_error(int count, ErrorAt&& error_at) {
  BackwardEulerError error{error_at(count), error_at(2 * count), 0.0};
  error.last = error.fine;
  for (int times = 10; error.last > (times > 1000 ? 0.05 : 1e-3) && times <= 10000; times *= 10) {
    error.last = error_at(2 * count * times);
  }
  return error;
}

/// Returns the middle one of an odd number of values, or the one behind the middle [1].
inline double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace slipbench::test
