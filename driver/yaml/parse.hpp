// SPDX-License-Identifier: Apache-2.0
// From text to tree: the strict subset of YAML that cases, fits and sweeps are written in.
#pragma once

#include <tl/expected.hpp>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/yaml/node.hpp"

namespace slipbench::driver::yaml {

inline constexpr int kDeepestNesting = 64;
/// Number of nodes that all aliases of a file together may stand for.
inline constexpr unsigned kAliasBudget = 1'000'000;
/// Characters of texts longer than any number, such as formulas, that they may stand for; twice the
/// length of the file more.
inline constexpr unsigned kAliasText = 500'000;

/// Parses one YAML document whose root is a map. Accepted: maps, lists, plain and quoted scalars,
/// block texts, comments, anchors and aliases. An error with its place, and as many of them as can
/// be told apart, for: anything check_text finds, tabs in the indentation, quotes and brackets that
/// are not closed, missing ':', duplicate keys, keys that are no words, tags, merge keys,
/// directives, a second document, nesting deeper than kDeepestNesting, aliases that are undefined,
/// contain themselves or expand beyond kAliasBudget or kAliasText, an empty file, a root that is no
/// map.
[[nodiscard]] tl::expected<Tree, base::Diagnostics> parse_yaml(const base::SourceText& source);

}  // namespace slipbench::driver::yaml
