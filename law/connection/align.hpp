// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// ALIGN: a building block for user-defined friction; it has no predefined one.
struct Align {
  static constexpr ConnectionInfo kInfo{"ALIGN", "The axes of b stay parallel to those of a.",
                                        "basic", ComponentSet::of(4, 5, 6), ComponentSet()};
};

}  // namespace slipbench::law
