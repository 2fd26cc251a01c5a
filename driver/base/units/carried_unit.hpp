// SPDX-License-Identifier: Apache-2.0
// Numbers that carry their unit, "12 mm", in the system of the case.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/units/unit_dimension.hpp"

namespace slipbench::driver::base {

/// A number that was written with a unit.
struct CarriedUnit {
  double value = 0.0;    ///< in the case's system
  Dimension dimension;   ///< of the unit
  bool shifted = false;  ///< from a unit of temperature with another zero
};

/// Returns whether a text is a number with something behind it that may be a unit.
[[nodiscard]] bool carries_unit(std::string_view text);

/// Reads a number with its unit. Errors, as a sentence that quotes the text: an unknown unit, one
/// of another dimension than `wanted`, a case that does not state the unit to convert to.
/// \param text one for which carries_unit() holds
/// \param wanted nothing: any dimension will do
/// \param difference of temperatures: no offset is added
[[nodiscard]] tl::expected<CarriedUnit, std::string> read_with_unit(
    std::string_view text, const std::optional<Dimension>& wanted, const UnitSystem& system,
    bool difference = false);

/// The sentence for a parameter that was shifted: whether it is a temperature or a difference of
/// two is known where it is used.
[[nodiscard]] std::string shifted_in_words(std::string_view text, const CarriedUnit& read,
                                           const UnitSystem& system);

/// The sentence for a text whose unit has another dimension than is wanted.
[[nodiscard]] std::string misfit(std::string_view text, const Dimension& unit,
                                 const Dimension& wanted, const UnitSystem& system);

}  // namespace slipbench::driver::base
