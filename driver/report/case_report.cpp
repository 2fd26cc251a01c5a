// SPDX-License-Identifier: Apache-2.0
#include "driver/report/case_report.hpp"

#include <iterator>
#include <utility>

namespace slipbench::driver {

void ReportEvents::add(ReportEvent event) {
  ++total_;
  if (first_.size() < kMostAtEachEnd) {
    first_.push_back(std::move(event));
    return;
  }
  last_.push_back(std::move(event));
  if (last_.size() > kMostAtEachEnd) last_.pop_front();
}

std::vector<ReportEvent> ReportEvents::take() {
  std::vector<ReportEvent> all = std::exchange(first_, {});
  all.insert(all.end(), std::make_move_iterator(last_.begin()),
             std::make_move_iterator(last_.end()));
  last_.clear();
  return all;
}

void CaseReport::put_rows(DrawnRows drawn) {
  rows = std::move(drawn.rows.numbers);
  row_index = std::move(drawn.rows.index);
  thinned = drawn.thinned;
  beginning = drawn.beginning;
  last_cycle = drawn.cycle;
}

void CaseReport::drop_details() {
  has_details = false;
  thinned = false;
  columns = {};
  rows = {};
  row_index = {};
  beginning.reset();
  last_cycle.reset();
  definitions = {};
  events = {};
  energies = {};
  coverage = {};
  summary = {};
  for (ReportCheck& check : checks) {
    check.value = {};
    check.reference = {};
    check.verdict.measures = {};
  }
}

}  // namespace slipbench::driver
