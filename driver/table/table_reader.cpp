// SPDX-License-Identifier: Apache-2.0
#include "driver/table/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <utility>

#include "driver/base/csv/csv_fields.hpp"
#include "driver/base/csv/line_reader.hpp"
#include "driver/base/files/regular_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/table/hdf5_plugin.hpp"
#include "driver/table/npy.hpp"

namespace slipbench::driver::table {
namespace {

namespace fs = std::filesystem;
using Opened = tl::expected<std::unique_ptr<TableReader>, std::string>;

class CsvTable : public TableReader {
 public:
  /// Returns what is wrong, or nothing.
  std::string open(const fs::path& file) {
    if (const auto opened = lines_.open(file); !opened) return opened.error().message;
    while (true) {
      if (const auto filled = lines_.fill(); !filled) return filled.error().message;
      if (lines_.begin == lines_.lines_end) return "has no header";
      const bool first = lines_.next_line == 1;
      std::string_view line = lines_.take_line();
      if (first && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
      if (!line.starts_with('#')) {
        head_.columns = base::header_names(line, ',');
        return {};
      }
      head_.lines += base::printable(base::out_of_cells(line)) + "\n";
    }
  }

  const TableHead& head() const override { return head_; }

  tl::expected<std::size_t, std::string> read(std::span<double> numbers) override {
    const std::size_t width = head_.columns.size();
    std::size_t rows = 0;
    for (; (rows + 1) * width <= numbers.size(); ++rows) {
      if (const auto filled = lines_.fill(); !filled) return tl::unexpected(filled.error().message);
      if (lines_.begin == lines_.lines_end) break;
      const long number = lines_.next_line;
      if (!read_line(lines_.take_line(), numbers.subspan(rows * width, width))) {
        return tl::unexpected(fmt::format("{}: wanted {} numbers between commas", number, width));
      }
    }
    return rows;
  }

 private:
  static bool read_line(std::string_view line, std::span<double> numbers) {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i > 0 && (at == end || *at++ != ',')) return false;
      const auto [stop, error] = std::from_chars(at, end, numbers[i]);
      if (error != std::errc()) return false;
      at = stop;
    }
    return at == end;
  }

  base::LineReader lines_;
  TableHead head_;
};

class NpyTable : public TableReader {
 public:
  std::string open(const fs::path& file) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    stream_.open(file, std::ios::binary);
    if (error || !stream_) return "cannot be read";
    constexpr std::size_t kLongestHead = std::size_t{1} << 20U;
    std::string begin(std::min<std::uintmax_t>(kLongestHead, size), '\0');
    stream_.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    auto head = read_npy_head(begin);
    if (!head) return head.error();
    head_.columns = std::move(head->columns);
    left_ = head->rows;
    const std::uintmax_t row = head_.columns.size() * sizeof(double);
    if (left_ > size / row) {
      return fmt::format("has {} bytes where its head says {} rows", size, left_);
    }
    const std::uintmax_t wanted = head->size + left_ * row;
    if (size != wanted) {
      return fmt::format("has {} bytes where its head says {}", size, wanted);
    }
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(head->size));
    return {};
  }

  const TableHead& head() const override { return head_; }

  tl::expected<std::size_t, std::string> read(std::span<double> numbers) override {
    const std::size_t width = head_.columns.size();
    const auto rows =
        static_cast<std::size_t>(std::min<std::uint64_t>(left_, numbers.size() / width));
    if (rows > 0 && !stream_.read(reinterpret_cast<char*>(numbers.data()),
                                  static_cast<std::streamsize>(rows * width * sizeof(double)))) {
      return tl::unexpected<std::string>("cannot be read");
    }
    left_ -= rows;
    return rows;
  }

 private:
  std::ifstream stream_;
  TableHead head_;
  std::uint64_t left_ = 0;
};

/// Errors of another reader, with the name of the file before them: "a.csv:3: .." where a line has
/// one.
class NamedTable : public TableReader {
 public:
  NamedTable(std::unique_ptr<TableReader> table, std::string name)
      : table_(std::move(table)), name_(std::move(name)) {}
  const TableHead& head() const override { return table_->head(); }
  tl::expected<std::size_t, std::string> read(std::span<double> numbers) override {
    return table_->read(numbers).map_error([&](const std::string& fault) {
      const bool has_line = fault.front() >= '0' && fault.front() <= '9';
      return name_ + (has_line ? ":" : ": ") + fault;
    });
  }

 private:
  std::unique_ptr<TableReader> table_;
  std::string name_;
};

template <class Table>
Opened open_as(const fs::path& file) {
  auto table = std::make_unique<Table>();
  if (std::string fault = table->open(file); !fault.empty())
    return tl::unexpected(std::move(fault));
  return table;
}

Opened open_hdf5(const fs::path& file) {
  const auto plugin = hdf5_plugin();
  if (!plugin) return tl::unexpected(plugin.error());
  return (*plugin)->open(file);
}

}  // namespace

Opened open_table(const fs::path& file) {
  const std::string name = base::printable(file.string()) + ": ";
  const auto format = format_of(file);
  if (!format) return tl::unexpected(name + "is no .csv, .npy or .h5 file by its name");
  // Readers of CSV say so by themselves.
  if (*format != TableFormat::kCsv) {
    if (const auto regular = base::open_regular(file); !regular) {
      return tl::unexpected(regular.error());
    }
  }
  Opened table = *format == TableFormat::kCsv   ? open_as<CsvTable>(file)
                 : *format == TableFormat::kNpy ? open_as<NpyTable>(file)
                                                : open_hdf5(file);
  if (!table) return tl::unexpected(name + table.error());
  if ((*table)->head().columns.empty()) return tl::unexpected(name + "has no columns");
  return std::make_unique<NamedTable>(std::move(*table), base::printable(file.string()));
}

}  // namespace slipbench::driver::table
