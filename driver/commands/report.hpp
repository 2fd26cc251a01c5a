// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver {

struct ReportOptions {
  std::vector<std::string> inputs;  ///< cases, folders of cases, results (.csv)
  std::string output;               ///< the page
  std::string title;                ///< empty: made of the inputs
  std::vector<std::string> settings;
  bool allow_outside = false;
};

/// `slipbench report`: one self-contained HTML page about cases and results. Returns the exit code.
int report_command(const ReportOptions& options);

}  // namespace slipbench::driver
