// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// CARTESIAN: a building block for user-defined friction; it has no predefined one.
struct Cartesian {
  static constexpr ConnectionInfo kInfo{
      "CARTESIAN", "Node b moves freely; translations are measured along the axes of a.", "basic",
      ComponentSet(), ComponentSet::of(1, 2, 3)};
};

}  // namespace slipbench::law
