// SPDX-License-Identifier: Apache-2.0
// A sweep file, beside the cases of cases/sweeps.
#include <string>

#include "driver/sweep/read_sweep.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void sweep(std::string_view input) {
  copy_of_sources("cases/sweeps");
  const auto read = driver::sweep::read_sweep(own_file("fuzz_sweep.yaml", input).string());
  const std::string messages = driver::base::render(read.diagnostics, read.sources);
  want(read.value.has_value() || !messages.empty(), "a sweep that is refused has an error");
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(sweep)
