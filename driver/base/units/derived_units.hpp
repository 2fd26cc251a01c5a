// SPDX-License-Identifier: Apache-2.0
// Units that follow from those of force, length and time, under the names they go by.
#pragma once

#include <optional>
#include <string>

#include "driver/base/units/units.hpp"

namespace slipbench::driver::base {

/// The power of ten that makes joules of the case's energies; nothing outside of SI.
std::optional<int> joule_exponent(const UnitSystem& units);

/// The power of ten that makes kilograms of the case's masses; nothing outside of SI.
std::optional<int> kilogram_exponent(const UnitSystem& units);

/// The name of the unit of mass that follows from force, length and time: "t" of N, mm and s,
/// "slug" of lbf, ft and s; empty where it has none.
std::string mass_name(const UnitSystem& units);

/// "Hz" where times are in s, "kHz" in ms, "1/h" in h; empty where the case states no time.
std::string frequency_name(const UnitSystem& units);

}  // namespace slipbench::driver::base
