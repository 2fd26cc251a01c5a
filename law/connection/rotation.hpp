// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// ROTATION: a building block for user-defined friction; it has no predefined one.
struct Rotation {
  static constexpr ConnectionInfo kInfo{
      "ROTATION", "Rotations are free and measured as the components of the rotation vector.",
      "basic", ComponentSet(), ComponentSet::of(4, 5, 6)};
};

}  // namespace slipbench::law
