// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "driver/case/case.hpp"
#include "driver/export/loss.hpp"

namespace slipbench::driver::read {
struct CaseText;
}

namespace slipbench::driver::exports {

/// Writes a case as an Abaqus input deck: two nodes, a connector element with its section and
/// behaviour, and its history as motions, loads and amplitudes. Node a is fixed, and constraint
/// forces are loads of node b, so that the deck runs as it stands. Numbers have at most 20
/// characters, lines eight items.
/// \param problem,written the case, and what is written under its keys
/// \return a sentence where Abaqus has no such joint
tl::expected<ExportedDeck, std::string> to_abaqus(const cases::Case& problem,
                                                  const read::CaseText& written,
                                                  const ExportOptions& options);

}  // namespace slipbench::driver::exports
