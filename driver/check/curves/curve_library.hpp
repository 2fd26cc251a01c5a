// SPDX-License-Identifier: Apache-2.0
// The reference curves that come with the program: reference/curves/NAME.csv and what NAME.md says
// of each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::check {

struct ShippedCurve {
  std::string name;
  std::string text;  ///< one line: the first of NAME.md, without its mark of a heading
  std::filesystem::path file;
};

/// All of them, by name; none where the program was installed without them.
std::vector<ShippedCurve> shipped_curves();

/// Tells whether a case means a shipped curve by this: a name has neither a '/' nor a '.', a file
/// has.
bool is_curve_name(std::string_view text);

/// The file of a shipped curve.
std::optional<std::filesystem::path> find_shipped_curve(std::string_view name);

/// NAME.md: origin, meaning of the columns, accuracy and licence of a shipped curve. Empty if there
/// is no such curve or nothing is said of it.
std::string curve_description(std::string_view name);

}  // namespace slipbench::driver::check
