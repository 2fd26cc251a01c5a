// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::abaqus {

/// Keyword that is read, with the parameters that it may have.
struct KeywordRule {
  std::string_view name;                          ///< in capitals, one blank between words
  std::vector<std::string_view> parameters = {};  ///< likewise
  bool has_others = false;                        ///< parameters that are not in the list
};

/// The keywords that are read.
std::span<const KeywordRule> read_keywords();

/// Result of a search for a name that may be shortened.
struct FoundName {
  std::string_view name;                          ///< empty: none, or several
  std::vector<std::string_view> candidates = {};  ///< where several begin so
};

/// Returns a text in capitals and without blanks, as names are compared.
std::string folded(std::string_view text);

/// Finds a name of a list: the same one, or else the only one that begins so; case and blanks do
/// not matter.
FoundName find_name(std::string_view text, std::span<const std::string_view> names);

/// Finds a keyword, by its name or the beginning of it, among those that are read and those that
/// are known to be others. An unknown one has neither name nor candidates.
FoundName find_keyword(std::string_view text);

}  // namespace slipbench::driver::abaqus
