// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace slipbench::law {

struct Ambient;

/// The slips ahead of one, along which slip rate and contact force change in proportion: what a
/// coefficient law is asked along when the return mapping looks for its root (theory 11.4).
struct SlipLine {
  double slip = 0.0;                 ///< where the search stands [L], >= 0
  double end = 0.0;                  ///< as far as it wants to know [L]
  double rate_at_zero = 0.0;         ///< slip rate at slip 0 [L/T]
  double rate_per_slip = 0.0;        ///< >= 0 [1/T]
  double force = 0.0;                ///< F_N at `slip` [F]
  double force_per_slip = 0.0;       ///< [F/L]
  const Ambient* ambient = nullptr;  ///< of a law that sees the temperature; none: all 0

  double rate_at(double x) const { return rate_at_zero + x * rate_per_slip; }
  double force_at(double x) const { return force + (x - slip) * force_per_slip; }
};

inline constexpr double kNoBend = std::numeric_limits<double>::infinity();

/// Tells whether a place lies ahead: one that rounding puts just ahead is the one the search stands
/// on.
inline bool is_ahead(const SlipLine& line, double x) { return x > line.slip + 1e-14 * x; }

}  // namespace slipbench::law
