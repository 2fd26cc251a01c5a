// SPDX-License-Identifier: Apache-2.0
// New values for a YAML text that was written by hand: only they change, not a blank else.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/yaml/node.hpp"

namespace slipbench::driver::calibrate {

/// Changes in a node and below it.
struct NodeChange {
  std::optional<std::string> text;  ///< YAML in flow style, in place of the scalar that was there
  std::optional<std::string> key;   ///< another name of the entry that has the node as its value
  std::map<std::size_t, NodeChange> children;  ///< by item of a list or entry of a map

  bool empty() const { return !text && !key && children.empty(); }
};

/// The text of the tree with its changes. Comments, layout and anchors stay; an alias that would no
/// longer mean the same is written out. The result parses to the same tree but for the changes.
/// Errors, a sentence with the line: a scalar over several lines, for which there is no place.
tl::expected<std::string, std::string> with_changes(const yaml::Tree& tree,
                                                    const NodeChange& changes);

/// A text as YAML reads it back wherever it stands, in quotes if need be.
std::string yaml_scalar(std::string_view text, bool quoted = false);

}  // namespace slipbench::driver::calibrate
