// SPDX-License-Identifier: Apache-2.0
// The implicit part of the return mapping: where a force that slips comes to rest on its limit.
#pragma once

#include "law/definition/capstan_limit.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {

/// Smallest positive root x [L] of h(x) = trial - kappa x - F_lim(x) (theory 11.3), given
/// h(0) > 0 and kappa > 0 [F/L]. One exists in (0, trial/kappa] since F_lim >= 0. The search walks
/// from knot to knot (LimitFunction::next_knot); between two of them h is convex or concave, so
/// that one sign change means one root, and a dip shows in the slopes at the ends: no earlier root
/// is passed over. `LimitOf` is LimitFunction or one side of a CapstanLimit, here and below.
template <class LimitOf>
double first_root(const LimitOf& limit, double trial, double kappa) noexcept;

/// Tells whether h is positive at a knot after `root`, where it is not: there are more roots.
template <class LimitOf>
bool has_later_root(const LimitOf& limit, double trial, double kappa, double root) noexcept;

/// The first slip in [0, slip] from which on F_lim is 0, given that it is 0 at `slip`; 0 if it is 0
/// at rest already. The limit wears away once: bisection.
template <class LimitOf>
double first_zero(const LimitOf& limit, double slip) noexcept;

}  // namespace slipbench::law
