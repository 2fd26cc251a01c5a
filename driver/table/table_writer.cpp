// SPDX-License-Identifier: Apache-2.0
#include "driver/table/table_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/table/hdf5_plugin.hpp"
#include "driver/table/npy.hpp"

namespace slipbench::driver::table {
namespace {

// Records are little endian, and so are the machines this is built for.
static_assert(std::endian::native == std::endian::little);

void append_text(std::span<const double> numbers, const TableHead& head, base::OutputFile& file) {
  const std::size_t width = head.columns.size();
  const bool counted = head.columns.front() == "id";
  std::string& text = file.buffer();
  for (std::size_t i = 0; i < numbers.size(); i += width) {
    std::span<const double> row = numbers.subspan(i, width);
    // The shortest text of 100000 is 1e+05. A file of others may have any number there.
    if (counted && row.front() == std::trunc(row.front())) {
      text += fmt::format("{:.0f},", row.front());
      row = row.subspan(1);
    }
    base::append_numbers(text, row);
    text.back() = '\n';
    file.flush_if_full();
  }
}

void append_bytes(std::span<const double> numbers, base::OutputFile& file) {
  // Some at a time: the buffer is to stay small.
  constexpr std::size_t kTogether = 8192;
  for (std::size_t i = 0; i < numbers.size(); i += kTogether) {
    const auto some = numbers.subspan(i, std::min(kTogether, numbers.size() - i));
    file.append({reinterpret_cast<const char*>(some.data()), some.size_bytes()});
  }
}

/// Returns why the columns cannot be told apart in a file, in a sentence, or nothing.
std::string names_fault(const TableHead& head) {
  std::set<std::string_view> names;
  for (const std::string& name : head.columns) {
    if (name.find_first_of("\"\r\n") != std::string::npos) {
      return fmt::format("a quote or the end of a line cannot stand in the name of a column: {}",
                         base::printable(name));
    }
    if (base::printable(name) != name) {
      return "a control character, or a mark that turns the direction of writing, cannot stand in "
             "the name of a column: " +
             base::printable(name);
    }
    if (!names.insert(name).second) {
      return fmt::format("two columns are called {}; give one another name", base::printable(name));
    }
  }
  return {};
}

}  // namespace

tl::expected<TableWriter, std::string> TableWriter::create(TableFormat format, TableHead head,
                                                           base::OutputFile& file) {
  if (const std::string fault = names_fault(head); !fault.empty()) {
    return tl::unexpected(fmt::format("{}: {}", base::printable(file.target().string()), fault));
  }
  TableWriter writer(format, std::move(head), file);
  if (format == TableFormat::kCsv) {
    file.append(csv_head(writer.head_));
    return writer;
  }
  if (format == TableFormat::kHdf5) {
    if (const auto plugin = hdf5_plugin(); !plugin) return tl::unexpected(plugin.error());
    if (auto named = file.need_name(); !named) return tl::unexpected(std::move(named.error()));
    auto staged =
        base::OutputFile::create(file.temporary().string() + ".rows", {}, base::kNeverNamed);
    if (!staged) return tl::unexpected(std::move(staged.error()));
    writer.staged_.emplace(std::move(*staged));
    return writer;
  }
  auto begin = npy_head(writer.head_.columns, 0);
  if (!begin) return tl::unexpected(std::move(begin.error()));
  file.append(*begin);
  return writer;
}

void TableWriter::write(std::span<const double> numbers) {
  rows_ += numbers.size() / head_.columns.size();
  if (format_ == TableFormat::kCsv) {
    append_text(numbers, head_, *file_);
  } else {
    append_bytes(numbers, rows_file());
  }
}

tl::expected<void, std::string> TableWriter::finish() {
  if (format_ == TableFormat::kNpy) file_->replace_start(*npy_head(head_.columns, rows_));
  if (format_ != TableFormat::kHdf5) return {};
  if (auto closed = staged_->close(); !closed) return closed;
  std::ifstream rows(staged_->temporary(), std::ios::binary);
  std::vector<std::string> units;
  units.reserve(head_.columns.size());
  for (const std::string& column : head_.columns) units.push_back(unit_of(head_, column));
  const auto read = [&](std::span<double> numbers) {
    rows.read(reinterpret_cast<char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size_bytes()));
    return static_cast<std::size_t>(rows.gcount()) / sizeof(double) / head_.columns.size();
  };
  std::string fault = (*hdf5_plugin())->write(file_->temporary(), head_, units, rows_, read);
  if (fault.empty()) return {};
  return tl::unexpected(file_->target().string() + ": " + fault);
}

base::FileMark mark_of(TableFormat format, const TableHead& head, const base::FileMark& of_csv) {
  switch (format) {
    case TableFormat::kCsv:
      break;
    case TableFormat::kNpy: {
      // Nothing else in it says whose it is; as much of its columns as stands at the start.
      const std::string columns = npy_columns(head.columns);
      return {of_csv.owner, "\x93NUMPY", columns.substr(0, base::kMarkedBytes / 2)};
    }
    case TableFormat::kHdf5:
      if (of_csv.text.empty()) return {of_csv.owner};
      return {of_csv.owner, "\x89HDF\r\n\x1a\n", of_csv.text.substr(1)};
  }
  return of_csv;
}

}  // namespace slipbench::driver::table
