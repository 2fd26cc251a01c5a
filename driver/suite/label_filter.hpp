// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace slipbench::driver::suite {

/// Tells whether a case's label is meant by a pattern: it is a part of the label or, with `*` (any
/// text) or `?` (any one character) in it, describes the whole label.
bool label_matches(std::string_view label, std::string_view pattern);

/// Tells whether one of the patterns means the label; no patterns mean all labels.
bool label_matches_any(std::string_view label, std::span<const std::string> patterns);

}  // namespace slipbench::driver::suite
