// SPDX-License-Identifier: Apache-2.0
#include "tests/support/project_paths.hpp"

namespace slipbench::test {

std::string source_dir() { return SLIPBENCH_SOURCE_DIR; }

std::string binary_dir() { return SLIPBENCH_BINARY_DIR; }

}  // namespace slipbench::test
