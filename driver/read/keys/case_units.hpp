// SPDX-License-Identifier: Apache-2.0
// The system of units of a case.
#pragma once

#include "driver/read/keys/case_text.hpp"

namespace slipbench::driver::read {

/// The units under `units:`; faulty ones are reported and stand for SI ones, so that conversions to
/// them do not look wrong as well.
base::UnitSystem read_units(yaml::Binder& binder, const UnitsText& text);

/// The same from the tree of a case, without a word on faults: those are reported with the rest.
base::UnitSystem units_of(const yaml::Node& root);

}  // namespace slipbench::driver::read
