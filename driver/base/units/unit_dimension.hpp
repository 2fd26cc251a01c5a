// SPDX-License-Identifier: Apache-2.0
// Dimensions of units: what one measures, as opposed to how many of another it is.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/units/units.hpp"

namespace slipbench::driver::base {

inline constexpr Dimension kFrequency{.time = -1};

/// The dimension of a rotation's quantity from that of the translation's it corresponds to: moments
/// stand for forces, angles for lengths.
constexpr Dimension rotated(const Dimension& translation) {
  return {translation.force, translation.force, translation.time, translation.temperature,
          translation.length + translation.angle};
}

/// The dimension a unit has by itself: a mass is one of force, length and time, and an angle counts
/// ("rad/s" is no "Hz"). Errors: an unknown unit; one of something that no case has (a current).
tl::expected<Dimension, HistoryError> dimension_of_unit(std::string_view unit);

/// The dimension in words: "a force", "a length", "an angle", "force*length^-2".
std::string in_words(const Dimension& dimension);

/// Returns whether a unit of dimension `unit` may stand where `wanted` is measured: a moment per
/// angle may leave out the radian.
bool measures(const Dimension& unit, const Dimension& wanted);

/// "a length is wanted, such as mm": the dimension and the case's unit for it, as far as stated.
std::string wanted_in_words(const Dimension& wanted, const UnitSystem& system);

}  // namespace slipbench::driver::base
