// SPDX-License-Identifier: Apache-2.0
// Kinds of files of slipbench: a case, or a fit of cases to measurements.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "driver/yaml/node.hpp"

namespace slipbench::driver::read {

/// Endings of the names of cases and fits; the first wins where both files exist.
inline constexpr std::array<std::string_view, 2> kCaseEndings{".yaml", ".yml"};

/// Tells whether a name has one of these endings.
bool has_case_ending(const std::filesystem::path& file);

/// The key `calibrate` of a file that is a fit and no case; nothing of any other file.
std::optional<yaml::Node> key_of_fit(const yaml::Node& root);

/// A key of a file that is a case and no fit, such as `connector`; nothing of any other file.
std::optional<yaml::Node> key_of_case(const yaml::Node& root);

/// Tells whether a file says at the beginning of a line that it is a fit (`calibrate:`), which is
/// known without parsing it. False for a file that cannot be read: reading it says why.
bool looks_like_fit(const std::filesystem::path& file);

}  // namespace slipbench::driver::read
