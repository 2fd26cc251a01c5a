// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "law/base/notation.hpp"

namespace slipbench::law {

/// Way of putting the contributions of a potential together (docs/theory, section 7).
enum class PotentialOperator : std::uint8_t {
  kSum,  ///< P = (sum X_i^b)^(1/b)
  kMax   ///< P = max X_i
};

/// One term of a contribution, over entries of the slip space that no other leaf uses. With the
/// vector y of the scaled forces and the unit vector e = `direction`:
///   kNorm      r = |y over the entries with e_k != 0|
///   kLine      r = |v|, v = e.y - center
///   kHalfLine  r = max(v, 0), else as kLine
struct PotentialLeaf {
  enum class Kind : std::uint8_t { kNorm, kLine, kHalfLine };
  Kind kind = Kind::kLine;
  int part = 0;                                 ///< the contribution it belongs to
  std::array<double, kComponents> direction{};  ///< e, in slip space; of kNorm 1 marks a member
  double factor = 1.0;                          ///< c > 0
  double center = 0.0;                          ///< [F]; of kNorm 0
};

/// P(y) [F], the magnitude of the tangential force, other than the Euclidean norm; convex. A
/// contribution is X_i = <sum c_g r_g - offset_i> over its leaves g. `build_potential` makes one
/// out of the terms of a case; its slip space is scaled so that a unit along each entry has P = 1.
struct Potential {
  PotentialOperator combine = PotentialOperator::kSum;
  double exponent = 2.0;                     ///< b >= 1, of kSum
  int parts = 0;                             ///< contributions, 1..6
  std::array<double, kComponents> offset{};  ///< [F]
  int leaves = 0;                            ///< 1..6
  std::array<PotentialLeaf, kComponents> leaf{};
  /// No shifts: P(c y) = c P(y) for c > 0, so that the dissipation is F_lim dL.
  bool homogeneous = true;
};

/// A vector of the slip space; entries beyond its dimension are 0.
using SlipVector = std::array<double, kComponents>;

inline double dot(const SlipVector& a, const SlipVector& b) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// v of a line or half line, |y| of a norm [F].
double coordinate(const PotentialLeaf& leaf, const SlipVector& y) noexcept;
/// r of a leaf [F], not negative.
double length(const PotentialLeaf& leaf, const SlipVector& y) noexcept;

/// The contributions X_i [F] put together: (sum X_i^b)^(1/b), or the largest.
double combine(const Potential& potential, const std::array<double, kComponents>& parts) noexcept;

/// X_i(y) [F]; the entries beyond `parts` are 0.
std::array<double, kComponents> contributions(const Potential& potential,
                                              const SlipVector& y) noexcept;
/// P(y) [F]; docs/theory, section 7.
double value(const Potential& potential, const SlipVector& y) noexcept;

/// dP/dy [1], the direction of slip. At a corner the one-sided slope taken of each r is 0, and of
/// contributions that share the maximum it is the mean.
SlipVector gradient(const Potential& potential, const SlipVector& y) noexcept;

}  // namespace slipbench::law
