// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/commands/deck_output.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::commands {

/// Targets of an export that hold the law itself, whatever it is: no deck, and nothing is lost of
/// the friction.
inline constexpr std::array<std::string_view, 2> kLawTargets{"numbers", "fmu"};

/// Writes the friction of a case for a program of one's own: its numbers, or a functional mock-up
/// unit. Tells on standard error what of the case is not in it. Returns the exit code. \param read
/// the case, with the texts that it was read from \param settings that it was read with
int export_law(const read::ReadCase& read, const std::string& file,
               const std::vector<base::ParameterText>& settings, const DeckOutputOptions& options);

}  // namespace slipbench::driver::commands
