// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace slipbench::law {

/// One record of a table of part pairs: every part of one side with every part of the other. A
/// group stands for its parts, a single part for itself; a group on both sides means every pair
/// inside it, each part with itself included.
struct PartPair {
  std::vector<int> side1;  ///< part ids, in any order
  std::vector<int> side2;
};

/// Tells whether a record joins the parts `a` and `b`, whichever of them stands on which side.
inline bool joins(const PartPair& pair, int a, int b) {
  const auto has = [](const std::vector<int>& side, int part) {
    return std::find(side.begin(), side.end(), part) != side.end();
  };
  return (has(pair.side1, a) && has(pair.side2, b)) || (has(pair.side1, b) && has(pair.side2, a));
}

/// The record in force between the parts `a` and `b`: the last one that joins them, so that a later
/// record refines an earlier one. Symmetric in `a` and `b`.
/// \return its index in `pairs`; nothing if none joins them and the default holds
/// Source: Altair Radioss reference, /FRICTION (key RADIOSS). Proven by
/// law/friction/part_pairs_test.
inline std::optional<std::size_t> last_joining(std::span<const PartPair> pairs, int a, int b) {
  for (std::size_t i = pairs.size(); i > 0; --i) {
    if (joins(pairs[i - 1], a, b)) return i - 1;
  }
  return std::nullopt;
}

}  // namespace slipbench::law
