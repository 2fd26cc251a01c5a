// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/definition/known_limit.hpp"
#include "law/update/euclidean_return.hpp"

namespace slipbench::law {

/// One increment of a definition with the Euclidean norm of D components and a known limit, in the
/// bits of update(), for histories in blocks.
/// \param increment its motion, and what `limit_of` needs
/// \param old not of `result`
/// \param limit_of gives the KnownLimit of the increment for its motion |ds| [L]
/// \param[in,out] result of an increment of the same definition, or as it is by default; the
/// tangent, the direction of the motion and the slope of the wear stay
template <int D, class LimitOf>
[[gnu::always_inline]] inline void update_known(const FrictionDefinition& definition,
                                                const ConnectorIncrement& increment,
                                                const FrictionState& old, LimitOf limit_of,
                                                FrictionUpdate* result) noexcept {
  const IncrementBegin<Slip<D>> begin(definition, increment, old);
  const KnownLimit limit = limit_of(begin.motion);
  EuclideanReturn<D, KnownLimit, Wanted::kRow> steps(begin, limit);
  if (steps.rest.force > 0.0) {
    result->onset = 0.0;
  } else {
    *result = FrictionUpdate{};
  }
  take_steps(steps, result);
}

}  // namespace slipbench::law
