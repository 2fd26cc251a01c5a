// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/suggestions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::base {
namespace {

char folded(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return c == '-' || c == ' ' ? '_' : c;
}

std::string folded(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) { return folded(c); });
  return result;
}

}  // namespace

std::size_t name_distance(std::string_view a, std::string_view b) {
  // Three rows of the table at a time.
  std::vector<std::size_t> two_back(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = folded(a[i - 1]) == folded(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) &&
                           folded(a[i - 2]) == folded(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], two_back[j - 2] + 1);
    }
    std::swap(two_back, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::span<const std::string_view> candidates_among(std::string_view word,
                                                   std::span<const std::string_view> names) {
  constexpr std::size_t kMost = 1000;
  constexpr std::size_t kMostPairs = 200 * kMost;  // of letters
  std::size_t count = 0;
  for (std::size_t pairs = 0; count < std::min(names.size(), kMost); ++count) {
    pairs += word.size() * names[count].size();
    if (pairs > kMostPairs) break;
  }
  return names.first(count);
}

std::vector<std::string_view> suggestions(std::string_view word,
                                          std::span<const std::string_view> names) {
  // A word longer than any name has no near one, and the distance is quadratic in its length.
  constexpr std::size_t kLongestWord = 100;
  constexpr std::size_t kShortestPart = 3;
  if (word.empty() || word.size() > kLongestWord) return {};
  std::vector<std::pair<std::size_t, std::string_view>> ranked;
  for (const std::string_view name : candidates_among(word, names)) {
    const std::size_t distance = name_distance(word, name);
    if (distance <= std::max(word.size(), name.size()) / 3) {
      ranked.emplace_back(distance, name);
    } else if (word.size() >= kShortestPart &&
               folded(name).find(folded(word)) != std::string::npos) {
      ranked.emplace_back(kLongestWord + name.size(), name);
    }
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string_view> best;
  for (const auto& [rank, name] : ranked) {
    if (best.size() == kMostSuggestions) break;
    if (std::find(best.begin(), best.end(), name) == best.end()) best.push_back(name);
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> names,
                         std::string_view otherwise) {
  std::vector<std::string> quoted;
  for (const std::string_view name : suggestions(word, names)) {
    quoted.push_back("'" + std::string(name) + "'");
  }
  if (!quoted.empty()) {
    const std::vector<std::string_view> views(quoted.begin(), quoted.end());
    return "did you mean " + in_words(views) + "?";
  }
  if (names.empty() || names.size() > kMostSuggestions) return std::string(otherwise);
  return "known: " + in_words(names, "and");
}

std::string few_in_words(std::span<const std::string_view> names) {
  // One name more takes no more room than saying that there is one more.
  if (names.size() <= kMostSuggestions + 1) return in_words(names, "and");
  std::string text;
  for (const std::string_view name : names.first(kMostSuggestions)) {
    text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return fmt::format("{} and {} more", text, names.size() - kMostSuggestions);
}

}  // namespace slipbench::driver::base
