// SPDX-License-Identifier: Apache-2.0
// Names to show in place of one that is not known: few, and the nearest first.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::base {

/// So many names are shown at once, at most.
inline constexpr std::size_t kMostSuggestions = 5;

/// Returns the names that are looked at for one near a word: the first thousand, and fewer of long
/// ones, as comparing two takes a time that grows with the product of their lengths.
[[nodiscard]] std::span<const std::string_view> candidates_among(
    std::string_view word, std::span<const std::string_view> names);

/// Optimal string alignment distance: how many letters must be inserted, deleted, replaced or
/// swapped with their neighbour; blind to case and to '-' and ' ' against '_'.
[[nodiscard]] std::size_t name_distance(std::string_view a, std::string_view b);

/// The names that a mistyped word may have meant, at most kMostSuggestions and each once: those
/// that differ in at most a third of their letters, the nearest first, then those that contain the
/// word, the shortest first.
[[nodiscard]] std::vector<std::string_view> suggestions(std::string_view word,
                                                        std::span<const std::string_view> names);

/// "did you mean 'a' or 'b'?"; without a suggestion all names if they are few, "known: a and b",
/// else `otherwise`.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       std::span<const std::string_view> names,
                                       std::string_view otherwise);

/// "a, b and c"; of many the first ones only: "a, b, c, d, e and 12 more".
[[nodiscard]] std::string few_in_words(std::span<const std::string_view> names);

}  // namespace slipbench::driver::base
