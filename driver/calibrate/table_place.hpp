// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/case/case.hpp"
#include "driver/yaml/node.hpp"

namespace slipbench::driver::calibrate {

/// A node and the way to it from the root: indices of items and entries.
struct Place {
  yaml::Node node;
  std::vector<std::size_t> way = {};
  yaml::Path path = {};

  [[nodiscard]] std::optional<Place> find(std::string_view key) const;
  [[nodiscard]] Place at(std::size_t i) const;
};

/// Returns the key of a definition under which a varied table stands.
std::string_view word_of(VariedTable::Use use);

/// Lists the names of the entries of `friction:` in a text: given, or friction1, friction2, ...
std::vector<std::string> entry_names(const yaml::Node& root);

/// Finds where a case's text gives a definition its coefficient (its own, or that of the parts that
/// meet) or its internal contact force; nothing where it is not written.
std::optional<Place> table_place(const yaml::Node& root, const cases::Case& problem,
                                 std::size_t definition, VariedTable::Use use);

}  // namespace slipbench::driver::calibrate
