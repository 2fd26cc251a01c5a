// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <type_traits>

#include "law/base/notation.hpp"

namespace slipbench::law {

/// A vector of the scaled slip space with as many entries as the space has; the states keep theirs
/// in arrays of six.
template <int D>
using Slip = Eigen::Matrix<double, D, 1>;

template <int D>
Slip<D> load(const std::array<double, kComponents>& a) {
  return Eigen::Map<const Slip<D>>(a.data());
}
template <int D>
void store(const Slip<D>& v, std::array<double, kComponents>* a) {
  Eigen::Map<Slip<D>>(a->data()) = v;
}

/// Calls visit(D), a constant, for a slip space of that many entries.
template <int D = 1, class Visit>
decltype(auto) in_dimension(int dimension, Visit visit) {
  if constexpr (D < kComponents) {
    if (dimension > D) return in_dimension<D + 1>(dimension, visit);
  }
  return visit(std::integral_constant<int, D>{});
}

/// |v|; exact in one dimension.
template <int D>
double norm(const Slip<D>& v) {
  if constexpr (D == 1) {
    return std::abs(v[0]);
  } else {
    return std::sqrt(v.squaredNorm());
  }
}

}  // namespace slipbench::law
