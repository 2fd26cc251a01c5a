// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>
#include <system_error>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

/// "samples 3 to 7", "sample 3"
std::string range_text(const SampleRange& range) {
  return range.end - range.first == 1 ? fmt::format("sample {}", range.first)
                                      : fmt::format("samples {} to {}", range.first, range.end - 1);
}

}  // namespace

std::optional<Part> part_of(std::string_view text) {
  Part part;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, part.count);
  // Samples and parts are below 2^31: their product has room.
  constexpr std::size_t kMost = 1'000'000'000;
  const bool good = count.ec == std::errc() && count.ptr == end && part.number >= 1 &&
                    part.number <= part.count && part.count <= kMost;
  return good ? std::optional(part) : std::nullopt;
}

std::string file_name(const Sweep& sweep) {
  return base::printable(fs::path(sweep.file).filename().string());
}

std::string result_name(const Sweep& sweep, const std::optional<Part>& part) {
  const std::string stem = fs::path(sweep.file).stem().string();
  return part ? fmt::format("{}.{}of{}", stem, part->number, part->count) : stem;
}

std::string missing_text(const Sweep& sweep, std::span<const SampleRange> gaps,
                         std::span<const Part> parts) {
  if (gaps.empty()) return {};
  constexpr std::size_t kShown = 4;
  std::string text = "missing are ";
  for (std::size_t i = 0; i < std::min(kShown, gaps.size()); ++i) {
    text += (i > 0 ? ", " : "") + range_text(gaps[i]);
  }
  if (gaps.size() > kShown) text += fmt::format(" and {} more ranges", gaps.size() - kShown);
  const bool one_count =
      !parts.empty() && std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
        return part.count == parts.front().count;
      });
  if (!one_count) return text;
  std::string numbers;
  std::size_t shown = 0;
  for (Part part{1, parts.front().count}; part.number <= part.count; ++part.number) {
    const SampleRange own = part.range(sweep);
    const bool hit = std::any_of(gaps.begin(), gaps.end(), [&](const SampleRange& gap) {
      return gap.first < own.end && own.first < gap.end;
    });
    if (!hit) continue;
    if (++shown > kShown) return fmt::format("{}: parts {}, ..", text, numbers);
    numbers += fmt::format("{}{}/{}", shown > 1 ? ", " : "", part.number, part.count);
  }
  return fmt::format("{}: {} {}", text, shown > 1 ? "parts" : "part", numbers);
}

std::vector<fs::path> files_in(const fs::path& folder, const Sweep& sweep,
                               const std::string& ending) {
  const std::string stem = result_name(sweep, std::nullopt);
  const std::regex form(ending);
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(stem)) continue;
    if (std::regex_match(name.substr(stem.size()), form)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace slipbench::driver::sweep
