// SPDX-License-Identifier: Apache-2.0
// The closest point of {P <= T} to a force outside it, for a given multiplier: what a return to a
// potential and its tangent have in common.
#pragma once

#include <array>

#include "law/definition/potential.hpp"

namespace slipbench::law {

/// A contribution on the way back. Each of its leaves comes back by its factor times `pull`, at
/// most to 0: r_g = <t_g - c_g pull>.
struct PartReturn {
  double magnitude = 0.0;  ///< X_i [F]
  double share = 0.0;      ///< mu_i = dP/dX_i [1], at a corner the one of the subdifferential
  double pull = 0.0;       ///< q_i = x mu_i [F]
  double stiffness = 0.0;  ///< C_i = sum c_g^2 over the leaves not yet at 0 [1]
};

/// The trial force seen by the leaves of a potential, and the ways back from it:
///   y = y_tr - x m,  m in the subdifferential of P at y,  P(y) = T,
/// leaf by leaf and part by part (theory 11.7). Since every entry of the slip space belongs to one
/// leaf, X_i at given x and T is the root of one monotone scalar function; nothing iterates on
/// vectors, and corners need no special care.
class Projection {
 public:
  Projection(const Potential& potential, const SlipVector& trial) noexcept;

  /// The parts of a kSum potential after the multiplier x >= 0 [F], with the shares
  /// mu_i = (X_i/T)^(b-1) of the limit T > 0 [F]. They lie on the limit if combine() of their
  /// magnitudes is T.
  std::array<PartReturn, kComponents> sum_parts(double x, double limit) const noexcept;
  /// The parts of a kMax potential, each returned to T on its own; x is the sum of their pulls.
  std::array<PartReturn, kComponents> max_parts(double limit) const noexcept;
  /// Those of either after the x that brings them to T.
  std::array<PartReturn, kComponents> parts_on_limit(double x, double limit) const noexcept;

  /// r_g of the leaves in y [F].
  std::array<double, kComponents> lengths_left(
      const std::array<PartReturn, kComponents>& parts) const noexcept;
  /// y [F].
  SlipVector returned(const std::array<PartReturn, kComponents>& parts) const noexcept;
  /// m = (y_tr - y) / x [1], from the shares and not from the difference.
  SlipVector normal(const std::array<PartReturn, kComponents>& parts, double x) const noexcept;

  /// No multiplier is needed beyond this one [F] when there are no shifts.
  double longest() const noexcept;

  const std::array<double, kComponents>& lengths() const { return lengths_; }

 private:
  struct Level {
    double value = 0.0;
    double stiffness = 0.0;
  };
  Level level(int part, double pull) const noexcept;
  double pull_to(int part, double target) const noexcept;
  PartReturn sum_part(int part, double x, double limit) const noexcept;

  const Potential& potential_;
  const SlipVector& trial_;
  std::array<double, kComponents> lengths_{};  ///< t_g
};

}  // namespace slipbench::law
