// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slipbench::driver::commands {

struct NewOptions {
  std::string type;
  std::string output;  ///< a file that is not there yet; empty for the terminal
};

/// `slipbench new`: prints or writes the minimal case of a connection type. Returns the exit code.
int new_command(const NewOptions& options);

}  // namespace slipbench::driver::commands
