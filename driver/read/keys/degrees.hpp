// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/yaml/binding.hpp"
#include "driver/yaml/node.hpp"

namespace slipbench::driver::read {

/// Use of an angle, which decides the numbers of radians that are doubted.
enum class AngleUse {
  kPhase,  ///< any beyond a full turn
  kSwing,  ///< of an oscillation, or a place: multiples of 2.5 beyond a full turn
  kWay     ///< where a motion goes to, perhaps turn after turn: multiples of 15, up to two circles
};

/// Warns of a bare number of radians that looks like one of degrees. What carries its unit, or is
/// an expression, is meant; anything but a scalar is passed over. \return whether it warned
bool doubt_angle(yaml::Binder& binder, const yaml::Node& node, const yaml::Path& path,
                 AngleUse use);

/// The same for the numbers in a profile: its phase, and all of them if it drives a rotation.
void doubt_angles_of_profile(yaml::Binder& binder, const yaml::Node& profile,
                             const yaml::Path& path, bool rotation);

}  // namespace slipbench::driver::read
