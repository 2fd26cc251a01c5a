// SPDX-License-Identifier: Apache-2.0
#include "law/definition/potential.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::law {
namespace {

/// Returns |y| over the entries that a leaf has, without their squares.
/// Apart from `coordinate`, whose callers would take it in else: 3 % of an exact increment.
[[gnu::noinline, gnu::cold]] double small_norm(const PotentialLeaf& leaf,
                                               const SlipVector& y) noexcept {
  double norm = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (leaf.direction[k] != 0.0) norm = std::hypot(norm, y[k]);
  }
  return norm;
}

}  // namespace

double coordinate(const PotentialLeaf& leaf, const SlipVector& y) noexcept {
  if (leaf.kind != PotentialLeaf::Kind::kNorm) return dot(leaf.direction, y) - leaf.center;
  // Smaller squares have lost digits, or underflow to 0: a limit of nearly nothing with an
  // allowable elastic slip leaves such forces.
  constexpr double kNoDigits = 1e-290;
  double square = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (leaf.direction[k] != 0.0) square += y[k] * y[k];
  }
  return square > kNoDigits ? std::sqrt(square) : small_norm(leaf, y);
}

double length(const PotentialLeaf& leaf, const SlipVector& y) noexcept {
  const double v = coordinate(leaf, y);
  return leaf.kind == PotentialLeaf::Kind::kHalfLine ? std::max(v, 0.0) : std::abs(v);
}

double combine(const Potential& potential, const std::array<double, kComponents>& parts) noexcept {
  double largest = 0.0;
  for (const double x : parts) largest = std::max(largest, x);
  if (potential.combine == PotentialOperator::kMax || !(largest > 0.0)) return largest;
  const double b = potential.exponent;
  double sum = 0.0;
  if (b == 1.0) {
    for (const double x : parts) sum += x;
    return sum;
  }
  if (b == 2.0) {
    for (const double x : parts) sum += (x / largest) * (x / largest);
    return largest * std::sqrt(sum);
  }
  // Ratios keep large exponents from overflowing.
  for (const double x : parts) {
    if (x > 0.0) sum += std::pow(x / largest, b);
  }
  return largest * std::pow(sum, 1.0 / b);
}

std::array<double, kComponents> contributions(const Potential& potential,
                                              const SlipVector& y) noexcept {
  std::array<double, kComponents> parts{};
  for (int g = 0; g < potential.leaves; ++g) {
    const PotentialLeaf& leaf = potential.leaf[static_cast<std::size_t>(g)];
    parts[static_cast<std::size_t>(leaf.part)] += leaf.factor * length(leaf, y);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = std::max(parts[i] - potential.offset[i], 0.0);
  }
  return parts;
}

double value(const Potential& potential, const SlipVector& y) noexcept {
  return combine(potential, contributions(potential, y));
}

SlipVector gradient(const Potential& potential, const SlipVector& y) noexcept {
  const auto parts = contributions(potential, y);
  const double p = combine(potential, parts);
  SlipVector result{};
  if (!(p > 0.0)) return result;
  std::array<double, kComponents> share{};  // dP/dX_i
  if (potential.combine == PotentialOperator::kMax) {
    double count = 0.0;
    for (const double x : parts) count += x == p ? 1.0 : 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) share[i] = parts[i] == p ? 1.0 / count : 0.0;
  } else {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] > 0.0) share[i] = std::pow(parts[i] / p, potential.exponent - 1.0);
    }
  }
  for (int g = 0; g < potential.leaves; ++g) {
    const PotentialLeaf& leaf = potential.leaf[static_cast<std::size_t>(g)];
    const double r = length(leaf, y);
    if (!(r > 0.0)) continue;
    const double slope = leaf.factor * share[static_cast<std::size_t>(leaf.part)];
    const bool norm = leaf.kind == PotentialLeaf::Kind::kNorm;
    const double sign = norm || coordinate(leaf, y) > 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      if (leaf.direction[k] == 0.0) continue;
      result[k] += slope * (norm ? y[k] / r : sign * leaf.direction[k]);
    }
  }
  return result;
}

}  // namespace slipbench::law
