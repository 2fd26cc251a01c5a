// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// REVOLUTE: a building block for user-defined friction; it has no predefined one.
struct Revolute {
  static constexpr ConnectionInfo kInfo{"REVOLUTE", "Node b turns about the 1-axis of a only.",
                                        "basic", ComponentSet::of(5, 6), ComponentSet::of(4)};
};

}  // namespace slipbench::law
