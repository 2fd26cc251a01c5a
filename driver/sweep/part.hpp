// SPDX-License-Identifier: Apache-2.0
// Parts of a sweep, and the names of the files that each leaves.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Samples from `first` on, before `end`.
struct SampleRange {
  std::size_t first = 0;
  std::size_t end = 0;
  friend bool operator==(const SampleRange&, const SampleRange&) = default;
};

/// A part of the samples, `number` of `count`, both from 1 on.
struct Part {
  std::size_t number = 1;
  std::size_t count = 1;

  /// The samples of the part, whole rows of them where they are laid out in rows.
  SampleRange range(const Sweep& sweep) const {
    const std::size_t length = row_length(sweep);
    const std::size_t rows = sweep.samples / length;
    return {(number - 1) * rows / count * length, number * rows / count * length};
  }
};

/// Reads "2/8"; nothing if it is none.
std::optional<Part> part_of(std::string_view text);

/// Tells in a sentence which samples are missing, and in which parts they would be if the parts
/// that are there are all of one division; or nothing.
std::string missing_text(const Sweep& sweep, std::span<const SampleRange> missing,
                         std::span<const Part> parts);

/// The sweep's file without its folders, for messages and heads.
std::string file_name(const Sweep& sweep);
/// The name of the files of a sweep, or of a part of it, before their ending: "name.2of8".
std::string result_name(const Sweep& sweep, const std::optional<Part>& part);
/// The files in a folder whose names are that of the whole sweep and an ending, sorted by names.
/// \param ending a regular expression
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const Sweep& sweep,
                                            const std::string& ending);

}  // namespace slipbench::driver::sweep
