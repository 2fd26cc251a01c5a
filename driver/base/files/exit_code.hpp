// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::driver::base {

/// Answer of the program to its caller. An interruption ends it with 130 or 143.
enum ExitCode : int {
  kExitOk = 0,
  kExitCheckFailed = 1,
  kExitBadInput = 2,
  kExitNumerical = 3,
  kExitEnvironment = 4,
  kExitInternal = 70,
  kExitNoReader = 141,  ///< standard output was closed by its reader before its end, as by head
};

/// Returns the one of two outcomes to report: the larger number is the worse trouble.
inline int worse(int a, int b) { return a > b ? a : b; }

}  // namespace slipbench::driver::base
