// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct ReportOptions {
  std::vector<std::string> inputs;  ///< cases, folders of cases, results (.csv)
  std::string output;               ///< the page
  bool force = false;               ///< --force: replace a file that is no page of reports
  std::string title;                ///< empty: the name of the only input
  std::vector<std::string> settings;
  bool allow_outside = false;
  bool live = false;  ///< --live: the cases can be changed and run in the page
};

/// `slipbench report`: one self-contained HTML page about cases and results. The output does not
/// depend on the number of threads. Returns the exit code: 0 if the page was written and shows at
/// least one run, whatever its checks say; that of the worst case if none could be read and run.
int report_command(const ReportOptions& options);

}  // namespace slipbench::driver::commands
