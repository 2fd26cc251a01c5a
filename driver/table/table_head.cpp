// SPDX-License-Identifier: Apache-2.0
#include "driver/table/table_head.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace slipbench::driver::table {

std::string csv_head(const TableHead& head) {
  return fmt::format("{}{}\n", head.lines, fmt::join(head.columns, ","));
}

std::optional<TableFormat> format_named(std::string_view word) {
  const auto* const found = std::find(kTableFormats.begin(), kTableFormats.end(), word);
  if (found == kTableFormats.end()) return std::nullopt;
  return static_cast<TableFormat>(found - kTableFormats.begin());
}

std::optional<TableFormat> format_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".hdf5") return TableFormat::kHdf5;
  return ending.empty() ? std::nullopt : format_named(std::string_view(ending).substr(1));
}

std::string unit_of(const TableHead& head, std::string_view column) {
  constexpr std::string_view kUnits = "# columns: ";
  const std::size_t line = head.lines.find(kUnits);
  if (line == std::string::npos) return {};
  const std::size_t end = head.lines.find('\n', line);
  const std::string units =
      ", " + head.lines.substr(line + kUnits.size(), end - line - kUnits.size()) + ", ";
  const std::string wanted = ", " + std::string(column) + " [";
  const std::size_t place = units.find(wanted);
  if (place == std::string::npos) return {};
  const std::size_t begin = place + wanted.size();
  return units.substr(begin, units.find("], ", begin) - begin);
}

}  // namespace slipbench::driver::table
