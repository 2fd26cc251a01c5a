// SPDX-License-Identifier: Apache-2.0
#include "driver/read/file_kind.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::read {
namespace {

struct KindWords {
  FileKind kind;
  std::string_view name;
  std::string_view command;  ///< and what it does to the file
  std::string_view does;
};
constexpr std::array kKinds{KindWords{FileKind::kCase, "case", "run", "runs it"},
                            KindWords{FileKind::kFit, "fit file", "calibrate", "works on it"},
                            KindWords{FileKind::kSweep, "sweep file", "sweep", "works on it"}};
constexpr std::array<std::string_view, 3> kCaseKeys{"connector", "friction", "history"};

/// The keys that only a file of the kind has: fits and sweeps have that of their command's name.
std::span<const std::string_view> keys_of(const KindWords& kind) {
  if (kind.kind == FileKind::kCase) return kCaseKeys;
  return {&kind.command, 1};
}

std::optional<yaml::Node> key_among(const yaml::Node& root,
                                    std::span<const std::string_view> names) {
  if (!root.is_map()) return std::nullopt;
  for (const yaml::Entry entry : root.entries()) {
    if (std::find(names.begin(), names.end(), entry.key.text()) != names.end()) return entry.key;
  }
  return std::nullopt;
}

/// Tells whether a line begins with the word of a fit or a sweep and a colon, which costs less than
/// parsing every case of a folder twice.
bool may_name_other_kind(std::string_view text) {
  for (const KindWords& one : kKinds) {
    if (one.kind == FileKind::kCase) continue;
    const std::string_view word = one.command;
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
      if (at > 0 && text[at - 1] != '\n') continue;
      const std::size_t colon = text.find_first_not_of(" \t", at + word.size());
      if (colon != std::string_view::npos && text[colon] == ':') return true;
    }
  }
  return false;
}

}  // namespace

bool has_case_ending(const std::filesystem::path& file) {
  return std::find(kCaseEndings.begin(), kCaseEndings.end(), file.extension()) !=
         kCaseEndings.end();
}

std::optional<yaml::Node> key_of(const yaml::Node& root, FileKind kind) {
  std::optional<yaml::Node> found;
  for (const KindWords& one : kKinds) {
    const auto key = key_among(root, keys_of(one));
    if (key && one.kind != kind) return std::nullopt;
    if (key) found = key;
  }
  return found;
}

std::optional<OtherKind> other_kind(const yaml::Node& root, FileKind wanted) {
  const std::string_view wanted_name = kKinds[static_cast<std::size_t>(wanted)].name;
  for (const KindWords& one : kKinds) {
    if (one.kind == wanted) continue;
    if (const auto key = key_of(root, one.kind)) {
      return OtherKind{
          *key, "this is a " + std::string(one.name) + ", not a " + std::string(wanted_name) +
                    ": 'slipbench " + std::string(one.command) + " " +
                    base::printable(root.source().name()) + "' " + std::string(one.does)};
    }
  }
  return std::nullopt;
}

bool is_no_case(const std::filesystem::path& file) {
  const auto source = base::read_source(file.string());
  if (!source || !may_name_other_kind(source->text())) return false;
  const auto tree = yaml::parse_yaml(*source);
  if (!tree || !tree->root().is_map()) return false;
  bool has_work = false;
  for (const yaml::Entry entry : tree->root().entries()) {
    const std::string_view key = entry.key.text();
    if (key == "slipbench" || key == "title") continue;
    const auto* const kind = std::find_if(kKinds.begin() + 1, kKinds.end(),
                                          [&](const auto& one) { return one.command == key; });
    if (has_work || kind == kKinds.end() || !entry.value.is_map() || entry.value.size() == 0) {
      return false;
    }
    has_work = true;
  }
  return has_work;
}

}  // namespace slipbench::driver::read
