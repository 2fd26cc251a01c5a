// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/bless.hpp"

#include "driver/commands/shared.hpp"

namespace slipbench::driver {

int bless_command(const BlessOptions&) {
  print_error("slipbench: error: bless is not built yet\n");
  return kExitInternal;
}

}  // namespace slipbench::driver
