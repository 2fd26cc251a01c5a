// SPDX-License-Identifier: Apache-2.0
// An Abaqus input deck.
#include "driver/commands/import_abaqus.hpp"
#include "tests/fuzz/fuzz_deck.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void abaqus(std::string_view input) { try_deck(input, driver::commands::import_abaqus); }

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(abaqus)
