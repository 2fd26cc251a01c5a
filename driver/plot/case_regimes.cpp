// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/case_regimes.hpp"

namespace slipbench::driver::plot {

CaseRegimes::CaseRegimes(const cases::Case& problem)
    : case_(&problem),
      detector_(problem),
      summary_(problem),
      regimes_(problem.definitions.size()) {}

void CaseRegimes::add(const bench::Row& row) {
  summary_.add(row);
  const auto events = detector_.take(row);
  if (row.index == 0) {
    for (std::size_t d = 0; d < regimes_.size(); ++d) {
      regimes_[d].begin(static_cast<int>(row.definitions[d].update.state.regime), row.time);
    }
  }
  for (const results::Event& event : events) {
    if (event.jump) continue;
    results::RegimeRecorder& regimes = regimes_[event.definition];
    const bool turns = event.from == law::Regime::kSlip && event.to == law::Regime::kSlip;
    // Slip that turns to the opposite sense has stuck on the way, but where the turn was located.
    const bool located = row.definitions[event.definition].changes.count > 0;
    if (turns && !located) regimes.pause(end_, event.time);
    regimes.change(static_cast<int>(event.to), event.time);
  }
  end_ = row.time;
}

void CaseRegimes::finish(results::PlotData& data) {
  for (std::size_t d = 0; d < regimes_.size(); ++d) {
    results::RegimeHistory history = regimes_[d].end(end_);
    const results::DefinitionSummary& sum = summary_.definitions()[d];
    history.slip_time = sum.slip_time;
    history.open_time = sum.open_time;
    history.slip_begins = sum.events;
    history.reversals = sum.reversals;
    for (results::PlotDefinition& definition : data.definitions) {
      if (definition.name == case_->definitions[d].name) definition.regimes = history;
    }
  }
}

}  // namespace slipbench::driver::plot
