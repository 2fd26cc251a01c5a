// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

namespace slipbench::test {

/// A difference quotient and what is to be thought of it.
struct Derivative {
  double value = 0.0;
  double error = 0.0;  ///< estimate: the last change of the extrapolation
};

/// One-sided derivative of `f` at 0 by Richardson extrapolation of (f(h) - f(0))/h over three
/// halvings, so that the error is of third order in `h`; sign of `h` is the side.
///
/// \param f maps a step to a value, or to nothing if the evaluation left the branch of f(0)
/// \return nothing if any of the evaluations left the branch
template <class Function>
std::optional<Derivative> one_sided_derivative(const Function& f, double h) {
  const std::optional<double> f0 = f(0.0);
  if (!f0) return std::nullopt;
  double quotient[3];
  for (int i = 0; i < 3; ++i) {
    const double step = h / static_cast<double>(1 << i);
    const std::optional<double> fi = f(step);
    if (!fi) return std::nullopt;
    quotient[i] = (*fi - *f0) / step;
  }
  const double first = 2.0 * quotient[1] - quotient[0];
  const double second = 2.0 * quotient[2] - quotient[1];
  const double value = (4.0 * second - first) / 3.0;
  return Derivative{value, std::abs(value - second)};
}

}  // namespace slipbench::test
