// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "driver/base/files/file_mark.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/table/table_head.hpp"

namespace slipbench::driver::table {

/// Rows of numbers on their way to a file. Numbers read back to the same double from all formats.
/// In a CSV file a number is the shortest text that does; whole ones in a first column `id` have
/// all their digits.
class TableWriter {
 public:
  /// Writes what stands before the rows. \p file must outlive it. Error: there is no such format
  /// here (the plug-in is missing), no room for the columns, or two of one name; a sentence.
  static tl::expected<TableWriter, std::string> create(TableFormat format, TableHead head,
                                                       base::OutputFile& file);

  /// Writes whole rows. Errors of the file are told when it is completed.
  void write(std::span<const double> numbers);

  /// Bytes that the rows so far take of the disk when it is completed. Those of an HDF5 file are
  /// there twice then.
  std::uintmax_t bytes() const { return staged_ ? 2 * staged_->size() : file_->size(); }

  /// Completes the file but for its name, which base::commit gives it. Error: a sentence.
  tl::expected<void, std::string> finish();

 private:
  TableWriter(TableFormat format, TableHead head, base::OutputFile& file)
      : format_(format), head_(std::move(head)), file_(&file) {}
  base::OutputFile& rows_file() { return staged_ ? *staged_ : *file_; }

  TableFormat format_;
  TableHead head_;
  base::OutputFile* file_;
  std::optional<base::OutputFile> staged_;  ///< rows of an HDF5 file, whose number is not known yet
  std::uint64_t rows_ = 0;
};

/// Returns the mark of a table whose CSV form has the mark `of_csv`, of which the text begins with
/// the end of a line; where it has none, nothing marks an HDF5 file.
base::FileMark mark_of(TableFormat format, const TableHead& head, const base::FileMark& of_csv);

}  // namespace slipbench::driver::table
