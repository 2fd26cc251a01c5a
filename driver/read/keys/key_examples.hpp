// SPDX-License-Identifier: Apache-2.0
// Examples of values that the keys of cases and fits take.
#pragma once

#include <span>
#include <string>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// A value that the key of a row takes, as YAML in one line: one that its name asks for, the last
/// word of a choice, a number within its bounds, or a map of the keys that it cannot do without.
/// \param rows all rows of that kind of file
std::string example_of(const yaml::KeyRow& row, std::span<const yaml::KeyRow> rows);

}  // namespace slipbench::driver::read
