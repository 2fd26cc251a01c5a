# SPDX-License-Identifier: Apache-2.0
# cmake -D SOURCE=.. -D FILE=.. -D FACTS=.. -P SlipbenchBuildFacts.cmake: writes the source file with what `slipbench --version
# --verbose` tells. Run at each build, since a commit changes without CMake being asked; the file is only touched if it changes.
set(commit "unknown, not built in a clone")
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git describe --always --dirty --abbrev=12 WORKING_DIRECTORY ${SOURCE}
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit ${described})
  endif()
endif()
file(CONFIGURE OUTPUT ${FILE} @ONLY CONTENT [[
#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {
const char* build_facts() { return "commit: @commit@\n@FACTS@"; }
}  // namespace slipbench::driver::cli
]])
