// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// UNIVERSAL: a building block for user-defined friction; it has no predefined one.
struct Universal {
  static constexpr ConnectionInfo kInfo{"UNIVERSAL",
                                        "Node b turns about the 1-axis of a and its own 3-axis.",
                                        "basic", ComponentSet::of(5), ComponentSet::of(4, 6)};
};

}  // namespace slipbench::law
