// SPDX-License-Identifier: Apache-2.0
#include "law/base/exponential_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "law/base/first_negative.hpp"

namespace slipbench::law {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The sum over the largest of its exponentials: of the same sign, and without overflow. 0 where
/// it is not above its rounding.
double scaled(const ExponentialSum& sum, double t) noexcept {
  double largest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < sum.count; ++i) largest = std::max(largest, sum.term[index(i)].rate * t);
  double value = 0.0;
  double size = 0.0;
  for (int i = 0; i < sum.count; ++i) {
    const ExponentialTerm& term = sum.term[index(i)];
    double p = 0.0;
    double magnitude = 0.0;
    for (int k = term.degree; k >= 0; --k) {
      p = p * t + term.c[index(k)];
      magnitude = magnitude * std::abs(t) + std::abs(term.c[index(k)]);
    }
    const double factor = term.rate * t == largest ? 1.0 : std::exp(term.rate * t - largest);
    value += p * factor;
    size += magnitude * factor;
  }
  return std::abs(value) > 8.0 * kEpsilon * size ? value : 0.0;
}

/// exp(-rate t) (sum exp(-shift t))' of the last term: that term has one coefficient less.
ExponentialSum reduced(const ExponentialSum& sum) noexcept {
  ExponentialSum shifted = sum;
  const double shift = sum.term[index(sum.count - 1)].rate;
  for (int i = 0; i < shifted.count; ++i) {
    ExponentialTerm& term = shifted.term[index(i)];
    term.rate = i == shifted.count - 1 ? 0.0 : term.rate - shift;
  }
  return derivative(shifted);
}

/// Numbers beyond those of a double make terms that no derivative ends.
bool is_finite(const ExponentialSum& sum) noexcept {
  for (int i = 0; i < sum.count; ++i) {
    const ExponentialTerm& term = sum.term[index(i)];
    double check = term.rate;
    for (int k = 0; k <= term.degree; ++k) check += 0.0 * term.c[index(k)];
    if (!std::isfinite(check)) return false;
  }
  return true;
}

SignChanges collect(const ExponentialSum& sum, double from, double to, double width) noexcept {
  SignChanges found;
  if (sum.count == 0 || !is_finite(sum) || (sum.count == 1 && sum.term[0].degree == 0))
    return found;
  // Between places where the derivative changes its sign; those need only be near.
  const SignChanges turns = collect(reduced(sum), from, to, 1e-11);
  double low = from;
  double at_low = scaled(sum, from);
  for (int i = 0; i <= turns.count; ++i) {
    const double high = i == turns.count ? to : turns.at[index(i)];
    const double at_high = scaled(sum, high);
    if (at_high == 0.0) continue;
    if ((at_low < 0.0 && at_high > 0.0) || (at_low > 0.0 && at_high < 0.0)) {
      if (found.count == static_cast<int>(found.at.size())) return found;
      const double sign = at_low > 0.0 ? 1.0 : -1.0;
      found.at[index(found.count++)] =
          first_negative([&](double t) { return sign * scaled(sum, t); }, low, high, width, 1e-3);
    }
    low = high;
    at_low = at_high;
  }
  return found;
}

}  // namespace

void ExponentialSum::add(const ExponentialTerm& added, double factor) noexcept {
  int i = 0;
  while (i < count && term[index(i)].rate != added.rate) ++i;
  if (i == kMostTerms) return;
  if (i == count) {
    term[index(i)] = {added.rate, 0, {}};
    ++count;
  }
  ExponentialTerm& into = term[index(i)];
  into.degree = std::max(into.degree, added.degree);
  for (int k = 0; k <= added.degree; ++k) into.c[index(k)] += factor * added.c[index(k)];
  while (into.degree > 0 && into.c[index(into.degree)] == 0.0) --into.degree;
  if (into.degree == 0 && into.c[0] == 0.0) {
    term[index(i)] = term[index(count - 1)];
    --count;
  }
}

void ExponentialSum::add(const ExponentialSum& sum, double factor) noexcept {
  for (int i = 0; i < sum.count; ++i) add(sum.term[index(i)], factor);
}

double ExponentialSum::operator()(double t) const noexcept {
  double value = 0.0;
  for (int i = 0; i < count; ++i) {
    const ExponentialTerm& one = term[index(i)];
    double p = 0.0;
    for (int k = one.degree; k >= 0; --k) p = p * t + one.c[index(k)];
    value += one.rate == 0.0 ? p : p * std::exp(one.rate * t);
  }
  return value;
}

ExponentialSum exponential_term(double rate, std::initializer_list<double> coefficients) noexcept {
  ExponentialTerm term;
  term.rate = rate;
  int k = 0;
  for (const double c : coefficients) {
    term.degree = k;
    term.c[index(k++)] = c;
  }
  ExponentialSum sum;
  sum.add(term);
  return sum;
}

ExponentialSum product(const ExponentialSum& a, const ExponentialSum& b) noexcept {
  ExponentialSum result;
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const ExponentialTerm& x = a.term[index(i)];
      const ExponentialTerm& y = b.term[index(j)];
      ExponentialTerm term;
      term.rate = x.rate + y.rate;
      term.degree = std::min(x.degree + y.degree, ExponentialTerm::kMostDegree);
      for (int k = 0; k <= x.degree; ++k) {
        for (int l = 0; l <= y.degree && k + l <= ExponentialTerm::kMostDegree; ++l) {
          term.c[index(k + l)] += x.c[index(k)] * y.c[index(l)];
        }
      }
      result.add(term);
    }
  }
  return result;
}

ExponentialSum derivative(const ExponentialSum& sum) noexcept {
  ExponentialSum result;
  for (int i = 0; i < sum.count; ++i) {
    ExponentialTerm term = sum.term[index(i)];
    for (int k = 0; k <= term.degree; ++k) {
      term.c[index(k)] *= term.rate;
      if (k < term.degree) term.c[index(k)] += (k + 1) * sum.term[index(i)].c[index(k + 1)];
    }
    result.add(term);
  }
  return result;
}

SignChanges sign_changes(const ExponentialSum& sum, double from, double to) noexcept {
  if (!(from < to)) return {};
  return collect(sum, from, to, 2.0 * kEpsilon);
}

double first_sign_change(const ExponentialSum& sum, double from, double to) noexcept {
  const SignChanges changes = sign_changes(sum, from, to);
  return changes.count > 0 ? changes.at[0] : std::numeric_limits<double>::infinity();
}

}  // namespace slipbench::law
