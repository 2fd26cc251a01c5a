// SPDX-License-Identifier: Apache-2.0
// Lanes of a batch, and what each has to be: the bits of update().
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "law/batch/pack.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::test {

inline std::vector<law::InstructionSet> available_instructions() {
  std::vector<law::InstructionSet> all;
  for (const law::InstructionSet set :
       {law::InstructionSet::kPortable, law::InstructionSet::kAvx2, law::InstructionSet::kAvx512}) {
    if (is_available(set)) all.push_back(set);
  }
  return all;
}

/// All numbers of a lane at its end, by their bits.
using Bits = std::vector<std::uint64_t>;

inline Bits bits(const law::FrictionState& state, const law::LaneSummary& summary) {
  Bits all;
  for (std::size_t k = 0; k < law::kComponents; ++k) {
    all.push_back(std::bit_cast<std::uint64_t>(state.force[k]));
    all.push_back(std::bit_cast<std::uint64_t>(state.elastic_slip[k]));
  }
  for (const double x : {double{state.accumulated_slip}, state.accumulated_slip.left_out(),
                         summary.peak_force, double{summary.dissipation}, summary.limit}) {
    all.push_back(std::bit_cast<std::uint64_t>(x));
  }
  all.push_back(static_cast<std::uint64_t>(state.regime));
  for (const std::int64_t count : {summary.slipping, summary.open, summary.doubtful}) {
    all.push_back(static_cast<std::uint64_t>(count));
  }
  return all;
}

/// A definition that is updated by itself: what a lane has to be.
struct AloneLane {
  law::FrictionState state;
  law::LaneSummary summary;

  void advance(const law::FrictionDefinition& definition,
               const law::ConnectorIncrement& increment) {
    const law::FrictionUpdate u = law::update(definition, increment, state);
    state = u.state;
    summary.peak_force = std::max(summary.peak_force, law::equivalent_force(definition, state));
    summary.dissipation += u.dissipation;
    summary.limit = u.limit;
    if (state.regime == law::Regime::kSlip) ++summary.slipping;
    if (state.regime == law::Regime::kOpen) ++summary.open;
    if (u.multiple_roots || u.jumps > 0 || !u.converged) ++summary.doubtful;
  }
};

}  // namespace slipbench::test
