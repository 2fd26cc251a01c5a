// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driver/sweep/journal.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/run_sweep.hpp"

namespace slipbench::driver::sweep {

/// Parts of one sweep, files of rows and journals, which are read as the whole. They may overlap:
/// the same sample has the same numbers in all of them. Memory grows with chunks, not with rows.
/// All files stay open.
class Parts {
 public:
  /// Raises the limit of open files of this program as far as it may be raised. The sweep and its
  /// identity must outlive the parts.
  Parts(const Sweep& sweep, const std::string& identity);

  /// Adds a journal or the rows of a part. Returns why it does not belong to the sweep, or is not
  /// whole: a sentence that begins with its path, or nothing.
  std::string add(const std::filesystem::path& file);

  /// Finds the samples that no part has.
  std::vector<SampleRange> missing() const;
  /// Tells in a sentence which are missing, and in which parts they would be; or nothing.
  std::string missing_text() const { return sweep::missing_text(*sweep_, missing(), parts_); }

  /// Hands out all samples, of which none may be missing, in the order of their ids. Of failed
  /// samples that come from files of rows, the first is run again for its reason. Returns a
  /// sentence if a file cannot be read.
  std::string for_each(const std::function<void(const SampleOutcome&)>& take);

 private:
  struct Rows {
    std::filesystem::path path;
    std::ifstream file;
  };
  /// Successive samples of a source.
  struct Piece {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t source = 0;  ///< of journals_ or of rows_
    bool of_journal = false;
    JournalRecord record = {};  ///< of rows only the offset
  };

  std::string add_journal(const std::filesystem::path& file);
  std::string add_rows(const std::filesystem::path& file);
  /// \param known samples at its begin that were read from another piece
  std::string read(const Piece& piece, std::size_t known, Chunk& chunk);
  void give_reasons(Chunk& chunk, std::size_t from);

  const Sweep* sweep_;
  const std::string* identity_;
  std::vector<std::unique_ptr<Journal>> journals_;
  std::vector<Rows> rows_;
  std::vector<Part> parts_;
  std::vector<Piece> pieces_;
};

/// The journals of a sweep, of its parts and of the ranks of a farm in a folder, and the files of
/// rows of its parts, sorted by their names.
std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder,
                                               const Sweep& sweep);
std::vector<std::filesystem::path> parts_in(const std::filesystem::path& folder,
                                            const Sweep& sweep);

}  // namespace slipbench::driver::sweep
