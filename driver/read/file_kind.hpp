// SPDX-License-Identifier: Apache-2.0
// Kinds of files of slipbench: a case, a fit of cases to measurements, a sweep of a case.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "driver/yaml/node.hpp"

namespace slipbench::driver::read {

/// Endings of the names of all of them; the first wins where both files exist.
inline constexpr std::array<std::string_view, 2> kCaseEndings{".yaml", ".yml"};

/// Tells whether a name has one of these endings.
bool has_case_ending(const std::filesystem::path& file);

/// The kinds, in the order of their commands' words.
enum class FileKind : std::uint8_t { kCase, kFit, kSweep };

/// A key of a file that is of one kind and of no other, such as `connector` of a case or
/// `calibrate` of a fit; nothing of any other file.
std::optional<yaml::Node> key_of(const yaml::Node& root, FileKind kind);

/// The kind of a file that is of one kind only, but not of the wanted one, in a sentence that names
/// the command for it: "this is a case, not a fit file: 'slipbench run x.yaml' runs it".
struct OtherKind {
  yaml::Node key;
  std::string sentence;
};
std::optional<OtherKind> other_kind(const yaml::Node& root, FileKind wanted);

/// Tells whether a file is a fit or a sweep and nothing else: it has their key, at the beginning of
/// a line, with a map below, and else at most a version and a title. False for a file that cannot
/// be read or parsed: reading it says what is wrong.
bool is_no_case(const std::filesystem::path& file);

}  // namespace slipbench::driver::read
