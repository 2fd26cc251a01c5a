// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct BlessOptions {
  std::string file;    ///< the case
  std::string reason;  ///< why today's curve is right; goes into the golden file
  std::vector<std::string> settings;
  bool allow_outside = false;
};

/// `slipbench bless`: runs a case and writes today's curves into the golden files that its checks
/// name. Returns the exit code.
int bless_command(const BlessOptions& options);

}  // namespace slipbench::driver::commands
