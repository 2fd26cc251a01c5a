// SPDX-License-Identifier: Apache-2.0
// Part of the law's library in the copy that rewrite.py makes.
#include "law/base/mutant.hpp"

#include <cstdio>
#include <cstdlib>

namespace slipbench::mutation {

const int active =
    std::getenv("SLIPBENCH_MUTANT") ? std::atoi(std::getenv("SLIPBENCH_MUTANT")) : kNone;
unsigned char reached[kMost] = {};

namespace {

/// Writes what a whole run reached, if the environment asks for it in a file.
struct AtExit {
  ~AtExit() {
    const char* const path = std::getenv("SLIPBENCH_REACHED_AT_EXIT");
    std::FILE* const file = path ? std::fopen(path, "w") : nullptr;
    if (!file) return;
    for (int i = 0; i < kMost; ++i) {
      if (reached[i]) std::fprintf(file, "%d ", i);
    }
    std::fclose(file);
  }
} at_exit;

}  // namespace
}  // namespace slipbench::mutation
