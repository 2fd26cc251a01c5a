// SPDX-License-Identifier: Apache-2.0
#include "driver/table/table_head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::table {

std::string csv_head(const TableHead& head) {
  std::string text = base::in_cells(head.lines);
  for (const std::string& name : head.columns) {
    // What would be taken for two names, for another one, or for a comment.
    const bool plain = !name.empty() && name.find(',') == std::string::npos &&
                       name.front() != '#' && name.front() != ' ' && name.back() != ' ';
    const std::string shown = base::in_cell(name);
    text += plain ? shown : '"' + shown + '"';
    text += ',';
  }
  text.back() = '\n';
  return text;
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
  const std::string mark = "\n" + std::string(base::kColumnsMark);
  const std::string lines = "\n" + head.lines;
  const std::size_t line = lines.find(mark);
  if (line == std::string::npos) return {};
  const std::size_t begin_units = line + mark.size();
  const std::string units =
      ", " + lines.substr(begin_units, lines.find('\n', begin_units) - begin_units) + ", ";
  const std::string wanted = ", " + std::string(column) + " [";
  const std::size_t place = units.find(wanted);
  if (place == std::string::npos) return {};
  const std::size_t begin = place + wanted.size();
  return units.substr(begin, units.find("], ", begin) - begin);
}

}  // namespace slipbench::driver::table
