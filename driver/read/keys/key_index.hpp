// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// Returns where in a case file a key is known: "connector", "history[] or friction[]"; empty if
/// nowhere.
std::string places_of_key(std::string_view key);

/// The same among the keys of another kind of file.
std::string places_of_key(std::string_view key, std::span<const yaml::KeyRow> rows);

/// Returns where CP1, f1, field1 and the like are prescribed; empty for other keys.
std::string place_of_quantity(std::string_view key);

/// Returns what there is to say of a key or connection type that this version does not have, or
/// nothing.
std::optional<yaml::LaterKey> later_key(std::string_view key);

/// Returns what brings a result column that not every case has, such as CSF2_RAW: a sentence; empty
/// for other names.
std::string origin_of_column(std::string_view name);

/// Words of messages about the keys of a case.
extern const yaml::FileWords kCaseWords;

}  // namespace slipbench::driver::read
