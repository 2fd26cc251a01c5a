// SPDX-License-Identifier: Apache-2.0
#include "driver/report/case_report.hpp"

#include <iterator>
#include <utility>

namespace slipbench::driver::report {

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

void CaseReport::drop_details() {
  has_details = false;
  columns = {};
  drawn = {};
  run = {};
  definitions = {};
  events = {};
  energies = {};
  coverage = {};
  summary = {};
  for (ReportCheck& check : checks) {
    check.value = {};
    check.reference = {};
    check.difference = {};
    check.verdict.measures = {};
  }
}

}  // namespace slipbench::driver::report
