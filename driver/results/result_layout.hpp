// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::results {

/// Force columns of a friction definition.
struct FrictionColumns {
  std::string name;
  bool coupled = false;             ///< CSFC is its total force
  std::vector<std::string> forces;  ///< of its components
};

/// Words of a result about itself, in the lines that begin with '#' and its header.
struct ResultLayout {
  std::string title;
  std::vector<std::pair<std::string, std::string>> units;       ///< length, force, ..., as stated
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name and number
  std::vector<std::string> columns;
  std::map<std::string, std::string, std::less<>> column_units;
  std::vector<FrictionColumns> friction;
  /// Direction 1 of an orthotropic definition in its two components.
  std::map<std::string, std::array<double, 2>, std::less<>> directions;
};

std::vector<FrictionColumns> friction_columns(const cases::Case& problem);

/// The layout of a result of `problem` with these columns.
ResultLayout layout_of(const cases::Case& problem, std::span<const Column> columns);

/// The layout of a result file; `header` are its columns. A line that is missing leaves its part
/// empty: any CSV has a layout.
ResultLayout read_layout(const std::filesystem::path& file, std::span<const std::string> header);

/// Returns why a file with this layout is no whole result, in a sentence, or nothing: names of
/// definitions stand once, and are not more than a result may have columns; the last line of one
/// that was written to its end has a line feed.
std::string result_fault(const ResultLayout& layout, const std::filesystem::path& file);

}  // namespace slipbench::driver::results
