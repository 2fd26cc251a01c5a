// SPDX-License-Identifier: Apache-2.0
#include "driver/report/case_report.hpp"

namespace slipbench::driver {

void CaseReport::drop_details() {
  has_details = false;
  thinned = false;
  columns = {};
  rows = {};
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
