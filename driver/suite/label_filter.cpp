// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/label_filter.hpp"

#include <algorithm>

#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::suite {
namespace {

/// Tells whether a pattern with `*` and `?` describes the whole text. Only the last `*` ever has to
/// be tried again, one character later, so the time is at most that of length times length.
bool describes(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t after_star = std::string_view::npos;  // in the pattern
  std::size_t resume = 0;                           // in the text
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      after_star = ++p;
      resume = t;
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      t += base::decode_utf8(text.substr(t)).length;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (after_star != std::string_view::npos) {
      p = after_star;
      resume += base::decode_utf8(text.substr(resume)).length;
      t = resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace

bool label_matches(std::string_view label, std::string_view pattern) {
  if (pattern.find_first_of("*?") != std::string_view::npos) return describes(pattern, label);
  return label.find(pattern) != std::string_view::npos;
}

bool label_matches_any(std::string_view label, std::span<const std::string> patterns) {
  return patterns.empty() ||
         std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return label_matches(label, pattern); });
}

}  // namespace slipbench::driver::suite
