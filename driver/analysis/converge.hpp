// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/analysis/side_by_side.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// Convergence of a number over increments of dt, dt/2, dt/4.
struct Convergence {
  double first = 0.0;   ///< |a - b|: between dt and dt/2
  double second = 0.0;  ///< |b - c|: between dt/2 and dt/4
  double scale = 0.0;   ///< size of the number

  /// Below this part of the scale nothing changes.
  static constexpr double kNothing = 1e-9;

  bool settled() const { return first <= kNothing * scale && second <= kNothing * scale; }
  /// log2(|a - b| / |b - c|); infinity where the second is 0 and the first is not.
  double order() const;
  /// |a - exact| by extrapolation at the observed order; NaN where that says nothing.
  double error() const;
};

/// kSettles: half the increment changes something, a quarter nothing more.
enum class ConvergenceVerdict { kSettled, kSettles, kSecondOrder, kFirstOrder, kSlow, kNone };
ConvergenceVerdict judge(const Convergence& convergence);

/// `slipbench run --converge`: the case with one, two and four increments where it has one (between
/// the rows of a measured history straight lines), compared at the rows of the first. Tells for
/// each definition how far the forces are apart, the dissipated energy, the observed order, and a
/// verdict in words; where a coefficient falls with the slip rate, the increment that decides.
/// Writes nothing. Errors: a run that fails.
tl::expected<std::string, CommandFailure> converge(const cases::Case& problem);

}  // namespace slipbench::driver::analysis
