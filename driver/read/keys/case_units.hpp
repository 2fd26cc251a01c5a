// SPDX-License-Identifier: Apache-2.0
// The system of units of a case.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "driver/read/keys/case_text.hpp"

namespace slipbench::driver::read {

/// The units under `units:`; faulty ones are reported and stand for SI ones, so that conversions to
/// them do not look wrong as well.
base::UnitSystem read_units(yaml::Binder& binder, const UnitsText& text);

/// The same from the tree of a case, without a word on faults: those are reported with the rest.
base::UnitSystem units_of(const yaml::Node& root);

/// The same of the case that a sweep or a fit in `folder` names by `text`; nothing where it cannot
/// be read, or must not (see base::resolve_data_path).
std::optional<base::UnitSystem> units_of_file(const std::filesystem::path& folder,
                                              std::string_view text, bool allow_outside);

}  // namespace slipbench::driver::read
