// SPDX-License-Identifier: Apache-2.0
// A case in the words of a solver, and what that costs on the case's own history.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/analysis/response.hpp"
#include "driver/case/case.hpp"
#include "driver/export/loss.hpp"

namespace slipbench::driver::read {
struct CaseText;
}

namespace slipbench::driver::commands {

/// Programs that a case is exported to.
inline constexpr std::array<std::string_view, 5> kExportTargets{"abaqus", "radioss", "lsdyna",
                                                                "opensees", "table"};

/// Writes a case as a deck of a program.
/// \return a sentence where the program has no word for it
tl::expected<exports::ExportedDeck, std::string> exported_case(
    std::string_view program, const cases::Case& problem, const read::CaseText& written,
    const exports::ExportOptions& options);

/// Reads a deck back and runs the case beside what it became.
/// Programs that state friction of contacts only give their friction to the case's own connector.
/// \param deck not only the block to paste
/// \return a sentence where the deck is not read back, or a run does not end
tl::expected<analysis::ResponseDifference, std::string> measured_difference(
    std::string_view program, const cases::Case& problem, const read::CaseText& written,
    const std::string& deck);

}  // namespace slipbench::driver::commands
