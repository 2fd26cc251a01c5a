// SPDX-License-Identifier: Apache-2.0
#include "driver/read/file_kind.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "driver/base/text/source_text.hpp"

namespace slipbench::driver::read {
namespace {

constexpr std::string_view kFitKey = "calibrate";
constexpr std::array<std::string_view, 3> kCaseKeys{"connector", "friction", "history"};

std::optional<yaml::Node> key_among(const yaml::Node& root,
                                    std::span<const std::string_view> names) {
  if (!root.is_map()) return std::nullopt;
  for (const yaml::Entry entry : root.entries()) {
    if (std::find(names.begin(), names.end(), entry.key.text()) != names.end()) return entry.key;
  }
  return std::nullopt;
}

}  // namespace

bool has_case_ending(const std::filesystem::path& file) {
  return std::find(kCaseEndings.begin(), kCaseEndings.end(), file.extension()) !=
         kCaseEndings.end();
}

std::optional<yaml::Node> key_of_fit(const yaml::Node& root) {
  if (key_among(root, kCaseKeys)) return std::nullopt;
  return key_among(root, std::span(&kFitKey, 1));
}

std::optional<yaml::Node> key_of_case(const yaml::Node& root) {
  if (key_among(root, std::span(&kFitKey, 1))) return std::nullopt;
  return key_among(root, kCaseKeys);
}

bool looks_like_fit(const std::filesystem::path& file) {
  const auto source = base::read_source(file.string());
  if (!source) return false;
  const std::string_view text = source->text();
  for (std::size_t at = text.find(kFitKey); at != std::string_view::npos;
       at = text.find(kFitKey, at + 1)) {
    if (at > 0 && text[at - 1] != '\n') continue;
    const std::size_t colon = text.find_first_not_of(" \t", at + kFitKey.size());
    if (colon != std::string_view::npos && text[colon] == ':') return true;
  }
  return false;
}

}  // namespace slipbench::driver::read
