// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slipbench::driver {

/// Where in a case file a key is known: "connector", "history[] or friction[]"; empty if nowhere.
std::string places_of_key(std::string_view key);

/// For keys and words that the case format names but this version does not have: a sentence.
std::optional<std::string_view> later_key(std::string_view key);

}  // namespace slipbench::driver
