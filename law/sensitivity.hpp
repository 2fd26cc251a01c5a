// SPDX-License-Identifier: Apache-2.0
// Exact derivatives of a friction history to the numbers of its definition.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "law/friction_definition.hpp"
#include "law/friction_state.hpp"
#include "law/increment.hpp"
#include "law/return_mapping.hpp"

namespace slipbench::law {

/// How the numbers of a definition depend on unknowns: d(number)/d(unknown), by definition_slopes.
struct DefinitionSlopes {
  std::size_t unknowns = 0;
};

/// Differences between two definitions that differ in one unknown by `width`, added as column
/// `unknown` of `slopes`.
/// \return false where the two differ in something the derivatives do not cover
bool add_slopes(const FrictionDefinition& below, const FrictionDefinition& above, double width,
                std::size_t unknown, DefinitionSlopes* slopes);

}  // namespace slipbench::law
