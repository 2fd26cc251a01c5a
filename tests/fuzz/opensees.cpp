// SPDX-License-Identifier: Apache-2.0
// An OpenSees script.
#include "driver/commands/import_opensees.hpp"
#include "tests/fuzz/fuzz_deck.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void opensees(std::string_view input) { try_deck(input, driver::commands::import_opensees); }

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(opensees)
