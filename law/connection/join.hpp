// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// JOIN: a building block for user-defined friction; it has no predefined one.
struct Join {
  static constexpr ConnectionInfo kInfo{"JOIN", "Node b sits on a.", "basic",
                                        ComponentSet::of(1, 2, 3), ComponentSet()};
};

}  // namespace slipbench::law
