// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "law/base/compensated_sum.hpp"
#include "law/base/notation.hpp"

namespace slipbench::law {

/// The regime of an increment; the numbers are those of the STATUS column.
enum class Regime : std::uint8_t {
  kOpen = 0,   ///< F_lim = 0: nothing to hold on to, no friction force
  kStick = 1,  ///< P < F_lim, or P = F_lim without slip
  kSlip = 2    ///< P = F_lim and the equivalent slip grew
};

/// The only memory of a friction definition. Entries follow SlipSpace; the unused ones stay 0. What
/// rounding leaves out of the accumulated slip is part of it; integration by extrapolation
/// (law/exact/extrapolated_update.hpp) leaves it 0.
struct FrictionState {
  std::array<double, kComponents> elastic_slip{};  ///< s_el [L]
  std::array<double, kComponents> force{};         ///< y [F]
  CompensatedSum accumulated_slip;                 ///< [L], never decreases
  Regime regime = Regime::kStick;

  friend bool operator==(const FrictionState& a, const FrictionState& b) {
    return a.elastic_slip == b.elastic_slip && a.force == b.force && a.regime == b.regime &&
           double{a.accumulated_slip} == double{b.accumulated_slip} &&
           a.accumulated_slip.left_out() == b.accumulated_slip.left_out();
  }
};

}  // namespace slipbench::law
