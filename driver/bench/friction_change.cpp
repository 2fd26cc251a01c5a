// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/friction_change.hpp"

#include <cmath>
#include <utility>

namespace slipbench::driver::bench {

tl::expected<void, base::HistoryError> FrictionChanges::begin_step(
    const cases::Step& step, bool first, double total_time, std::span<const double> mu,
    std::vector<law::FrictionDefinition>& definitions) {
  running_.clear();
  amplitudes_.clear();
  for (const cases::FrictionChange& change : step.friction_changes) {
    auto amplitude = history::ProfileCursor::open(change.amplitude);
    if (!amplitude) return tl::unexpected(std::move(amplitude.error()));
    if (auto begun = amplitude->begin({step.duration, 0.0, total_time}); !begun) return begun;
    law::FrictionDefinition& definition = definitions[change.definition];
    running_.push_back({change.definition, definition.stick.value, change.stick.value,
                        change.blends_elastic_slip});
    amplitudes_.push_back(std::move(*amplitude));
    definition.law = change.law;
    definition.blend = {first ? 0.0 : mu[change.definition], 0.0};
    definition.force_limit = change.force_limit;
    if (!change.blends_elastic_slip) definition.stick = change.stick;
  }
  return {};
}

void FrictionChanges::advance(double t, bool at_end,
                              std::vector<law::FrictionDefinition>& definitions) {
  for (std::size_t i = 0; i < running_.size(); ++i) {
    const Running& change = running_[i];
    law::FrictionDefinition& definition = definitions[change.definition];
    const double weight = at_end ? 1.0 : amplitudes_[i].value(t);
    definition.blend.weight = weight;
    if (change.blends_elastic_slip) {
      definition.stick.value =
          std::lerp(change.elastic_slip_start, change.elastic_slip_end, weight);
    }
  }
  if (!at_end) return;
  for (const Running& change : running_) definitions[change.definition].blend = {};
  running_.clear();
  amplitudes_.clear();
}

}  // namespace slipbench::driver::bench
