// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slipbench::driver::commands {

struct ConvertOptions {
  std::string file;    ///< a result as .csv, .npy or .h5
  std::string target;  ///< the same
  bool force = false;  ///< --force: replace a file that is none of the same result
};

/// `slipbench convert`: writes a table of numbers in another format, in blocks, every number with
/// the same bits; says what the format has no place for. Returns the exit code.
int convert_command(const ConvertOptions& options);

}  // namespace slipbench::driver::commands
