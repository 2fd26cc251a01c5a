// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::commands {

/// Returns what `slipbench describe` tells of a coefficient law: its formula, every symbol with its
/// dimension, the rules between them, the source, and a drawing of mu over the slip rate for a
/// typical set of parameters. Empty for a name that is no law.
std::string describe_law(std::string_view name);

/// Returns what it tells of a key of the case format that is a map ("filter", "formulation"): where
/// it stands, and the keys below it. An option of a Radioss block leads to the key that says it,
/// Ifric to the laws with their numbers. Empty for a name that is neither.
std::string describe_key(std::string_view name);

/// A key that describe_key tells of, in one line.
struct DescribedKey {
  std::string_view name;
  std::string_view title;
};
std::vector<DescribedKey> described_keys();

}  // namespace slipbench::driver::commands
