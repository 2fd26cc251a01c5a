// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/report.hpp"

#include "driver/commands/shared.hpp"

namespace slipbench::driver {

int report_command(const ReportOptions&) {
  print_error("slipbench: error: report is not built yet\n");
  return kExitInternal;
}

}  // namespace slipbench::driver
