// SPDX-License-Identifier: Apache-2.0
// Sums of polynomials times exponentials, whose sign changes can all be found.
#pragma once

#include <array>
#include <initializer_list>

namespace slipbench::law {

/// P(t) exp(rate t), P(t) = c[0] + c[1] t + ... + c[degree] t^degree.
struct ExponentialTerm {
  static constexpr int kMostDegree = 7;
  double rate = 0.0;
  int degree = 0;
  std::array<double, kMostDegree + 1> c{};
};

/// A sum of such terms, no two of one rate. Of fixed size, since the return mapping builds it; what
/// is put in must fit.
struct ExponentialSum {
  static constexpr int kMostTerms = 10;
  std::array<ExponentialTerm, kMostTerms> term{};
  int count = 0;

  void add(const ExponentialTerm& term, double factor = 1.0) noexcept;
  void add(const ExponentialSum& sum, double factor = 1.0) noexcept;
  double operator()(double t) const noexcept;
};

/// exp(rate t) times the polynomial with these coefficients, lowest first.
ExponentialSum exponential_term(double rate, std::initializer_list<double> coefficients) noexcept;
inline ExponentialSum polynomial(std::initializer_list<double> coefficients) noexcept {
  return exponential_term(0.0, coefficients);
}

ExponentialSum product(const ExponentialSum& a, const ExponentialSum& b) noexcept;
ExponentialSum derivative(const ExponentialSum& sum) noexcept;

/// Places where a sum changes its sign, ascending.
struct SignChanges {
  std::array<double, 24> at{};
  int count = 0;
};

/// All sign changes of the sum inside (from, to). By Rolle's theorem: times exp(-rate t) of one
/// term, which changes no sign, the derivative has that term with one degree less, so that after
/// as many steps as the sum has coefficients nothing is left; between two sign changes of the
/// derivative there is one of the function at most, found by bisection and secants.
/// A value below its own rounding has no sign, and a sum with numbers that are not finite no
/// change.
SignChanges sign_changes(const ExponentialSum& sum, double from, double to) noexcept;

/// The first of them; infinity if there is none.
double first_sign_change(const ExponentialSum& sum, double from, double to) noexcept;

}  // namespace slipbench::law
