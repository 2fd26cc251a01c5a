// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA keyword deck.
#include "driver/commands/import_lsdyna.hpp"
#include "tests/fuzz/fuzz_deck.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void lsdyna(std::string_view input) { try_deck(input, driver::commands::import_lsdyna); }

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(lsdyna)
