// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver {

/// What `slipbench describe` tells of a coefficient law: its formula, every symbol with its
/// dimension, the rules between them, the source, and a drawing of mu over the slip rate for a
/// typical set of parameters. Empty for a name that is no law.
std::string describe_law(std::string_view name);

/// What it tells of a key of the case format that is a map ("filter", "formulation"): where it
/// stands, and the keys below it. Empty for a name that is no such key.
std::string describe_key(std::string_view name);

}  // namespace slipbench::driver
