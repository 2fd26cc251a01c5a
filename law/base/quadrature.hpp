// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace slipbench::law {

/// Integral of f over [a, b] by the five-point Gauss-Legendre rule (exact for polynomials of degree
/// nine).
template <class Function>
double gauss(Function&& f, double a, double b) {
  constexpr std::array kNode{0.0, 0.538469310105683091036314420700,
                             0.906179845938663992797626878299};
  constexpr std::array kWeight{0.568888888888888888888888888889, 0.478628670499366468041291514836,
                               0.236926885056189087514264040720};
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  double sum = kWeight[0] * f(middle);
  for (std::size_t i = 1; i < kNode.size(); ++i) {
    sum += kWeight[i] * (f(middle - half * kNode[i]) + f(middle + half * kNode[i]));
  }
  return half * sum;
}

/// Integral of f over [a, b], halved until a piece and its halves agree to `tolerance` (absolute,
/// for each piece); at most `depth` times, and not after `budget` pieces in all, so that rounding
/// above the tolerance ends too.
template <class Function>
double integral(Function&& f, double a, double b, double tolerance, int* budget, int depth = 32) {
  const double middle = 0.5 * (a + b);
  const double whole = gauss(f, a, b);
  const double halves = gauss(f, a, middle) + gauss(f, middle, b);
  if (depth == 0 || --*budget < 0 || !(std::abs(whole - halves) > tolerance)) return halves;
  return integral(f, a, middle, tolerance, budget, depth - 1) +
         integral(f, middle, b, tolerance, budget, depth - 1);
}

}  // namespace slipbench::law
