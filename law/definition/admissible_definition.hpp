// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/definition/friction_definition.hpp"

namespace slipbench::law {

/// Tells whether updates of a definition are defined: its indices lie within, its tables have the
/// columns that are asked for, its numbers are finite and within the bounds that the reader of
/// cases holds them to. The bounds of a law's own parameters are the law's (`Field::bounds`).
bool is_admissible(const FrictionDefinition& definition);

}  // namespace slipbench::law
