// SPDX-License-Identifier: Apache-2.0
// A Radioss starter deck.
#include "driver/commands/import_radioss.hpp"
#include "tests/fuzz/fuzz_deck.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void radioss(std::string_view input) { try_deck(input, driver::commands::import_radioss); }

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(radioss)
