// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slipbench::test {

/// Returns the folder of the sources. Absolute, as is the next; known to one file only, so that no
/// other test is compiled anew where the folder is another.
std::string source_dir();
/// Returns the folder of this build.
std::string binary_dir();

}  // namespace slipbench::test
