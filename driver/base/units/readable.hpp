// SPDX-License-Identifier: Apache-2.0
// Numbers for people.
#pragma once

#include <string>

#include "driver/base/units/units.hpp"

namespace slipbench::driver::base {

/// A number of at most `digits` significant digits: "105.0", "0.0143", "1.25e+06".
std::string rounded(double value, int digits = 4);

/// A number with a unit, a blank between them where there is a unit.
std::string with_unit(const std::string& number, const std::string& unit);

/// The unit of energies, mJ rather than N mm where the case's units make one.
std::string energy_unit(const UnitSystem& units);

/// An energy of the case's units [F L] with three digits, in the multiple of the joule that makes
/// it readable ("9.02 J" for 9020 N mm); in the case's own unit where that is none ("3.1 lbf in").
std::string energy_text(double value, const UnitSystem& units);

}  // namespace slipbench::driver::base
