// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// CARDAN: a building block for user-defined friction; it has no predefined one.
struct Cardan {
  static constexpr ConnectionInfo kInfo{
      "CARDAN", "Rotations are free and measured as Cardan angles in the sequence 1-2-3.", "basic",
      ComponentSet(), ComponentSet::of(4, 5, 6)};
};

}  // namespace slipbench::law
