// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace slipbench::law {

/// One step of an embedded Runge-Kutta pair.
template <std::size_t N>
struct RungeKuttaStep {
  std::array<double, N> end;    ///< of fifth order
  std::array<double, N> error;  ///< its difference from the embedded fourth order
};

/// A step h of x' = f(t, x) from x(t) by the pair 5(4) of Dormand and Prince (1980), seven stages.
/// \param f  f(t, x) -> x', both std::array<double, N>
template <std::size_t N, class Function>
RungeKuttaStep<N> runge_kutta_step(Function&& f, double t, const std::array<double, N>& x,
                                   double h) {
  constexpr std::size_t kStages = 7;
  constexpr std::array<double, kStages> kTime{0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};
  constexpr std::array<std::array<double, kStages - 1>, kStages> kA{{
      {},
      {1.0 / 5.0},
      {3.0 / 40.0, 9.0 / 40.0},
      {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
      {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
      {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
      {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
  }};
  constexpr std::array<double, kStages> kError{35.0 / 384.0 - 5179.0 / 57600.0,
                                               0.0,
                                               500.0 / 1113.0 - 7571.0 / 16695.0,
                                               125.0 / 192.0 - 393.0 / 640.0,
                                               -2187.0 / 6784.0 + 92097.0 / 339200.0,
                                               11.0 / 84.0 - 187.0 / 2100.0,
                                               -1.0 / 40.0};
  std::array<std::array<double, N>, kStages> slope;
  RungeKuttaStep<N> step{x, {}};
  for (std::size_t s = 0; s < kStages; ++s) {
    std::array<double, N> at = x;
    for (std::size_t n = 0; n < N; ++n) {
      double sum = 0.0;
      for (std::size_t j = 0; j < s; ++j) sum += kA[s][j] * slope[j][n];
      at[n] += h * sum;
    }
    slope[s] = f(t + kTime[s] * h, at);
    // The last stage stands at the end of the step.
    if (s == kStages - 1) step.end = at;
    for (std::size_t n = 0; n < N; ++n) step.error[n] += h * kError[s] * slope[s][n];
  }
  return step;
}

}  // namespace slipbench::law
