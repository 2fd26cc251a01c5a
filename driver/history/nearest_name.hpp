// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace slipbench::driver {

/// The candidate that differs from `name` by the fewest insertions, deletions and replacements,
/// upper and lower case counting as equal; empty when none is near (more than a third of the
/// name's letters, at least two, would have to change). The first of equals wins.
std::string_view nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace slipbench::driver
