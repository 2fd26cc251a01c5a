// SPDX-License-Identifier: Apache-2.0
// A friction definition as plain numbers: to hand it to a program that reads no case, and to see
// which of its numbers a parameter moves.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "law/definition/friction_definition.hpp"

namespace slipbench::law {

/// Returns all numbers that a definition's updates depend on, in an order of its own: those of the
/// slip space, the criterion, the contact forces, the law, its blend, the limit, the stick, the
/// formulation. The name of the unit that a law's constants were fitted in is not among them, the
/// factor it stands for is.
std::vector<double> pack(const FrictionDefinition& definition);

/// Returns the definition that begins at the front of `numbers`, and takes its numbers away from
/// there. What is returned gives the updates of the definition that was packed, in all bits.
/// Nothing, if the numbers are no definition: too few, a kind that there is none of, a table that
/// is none or has other columns than are asked for, a number that is not finite or out of its
/// bounds.
std::optional<FrictionDefinition> unpack(std::span<const double>& numbers);

/// Returns the definitions of a connector as one list: the version of this order, how many they
/// are, then each.
std::vector<double> pack_all(std::span<const FrictionDefinition> definitions);

/// Returns the definitions of such a list; nothing, if it is none, of another version, or has
/// numbers left over.
std::optional<std::vector<FrictionDefinition>> unpack_all(std::span<const double> numbers);

}  // namespace slipbench::law
