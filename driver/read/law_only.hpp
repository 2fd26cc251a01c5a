// SPDX-License-Identifier: Apache-2.0
// Friction of a case for programs that have motions and forces of their own.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "law/definition/friction_definition.hpp"

namespace slipbench::driver::read {

/// All definitions of a connector, ready for the law.
struct LawOnly {
  std::vector<law::FrictionDefinition> definitions;
  std::vector<std::string> names;  ///< of each; empty where there is only one
};

/// Reads the friction of a case whose steps, output and checks need not be there. Data files are
/// looked for in `folder`. Errors: those of the text, and friction that wants more than a law: dead
/// zones, a coefficient for each direction, belts.
tl::expected<LawOnly, base::Diagnostics> read_law_only(const base::SourceText& source,
                                                       const std::string& folder);

}  // namespace slipbench::driver::read
