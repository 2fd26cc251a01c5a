// SPDX-License-Identifier: Apache-2.0
// A file of numbers as it comes from a rig: where it is, and how it is written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// A reader's answer to a sample that is not there.
enum class MissingSample : std::uint8_t {
  kError,  ///< refuses the file
  kSkip,   ///< leaves out the row
  kHold,   ///< keeps the column's value of the row before
};

/// The ways in which files of numbers differ.
struct CsvFormat {
  char decimal = '.';      ///< or ','
  char separator = '\0';   ///< `,` `;` tab or blanks; 0: as the header shows
  int skip = 0;            ///< lines before the header
  bool units_row = false;  ///< the line below the header holds the units of the columns
  MissingSample missing = MissingSample::kError;

  friend bool operator==(const CsvFormat&, const CsvFormat&) = default;
};

/// A file of numbers and how it is written.
struct DataSource {
  std::filesystem::path file;
  std::string shown_name = {};  ///< how messages name the file; its path when empty
  CsvFormat format = {};

  friend bool operator==(const DataSource&, const DataSource&) = default;
};

/// Samples that were not there.
struct MissingSamples {
  long count = 0;       ///< rows left out, or samples held
  long first_line = 0;  ///< of the first of them

  void add(long more, long line) {
    if (count == 0) first_line = line;
    count += more;
  }
};

/// "3 rows were left out, as they lack a sample (first in line 17)"; empty for none.
std::string in_words(const MissingSamples& missing, MissingSample answer);

/// The likely cause of a time that stays the same: it is missing, and was held. Empty otherwise.
std::string_view of_held_time(const CsvFormat& format, double time, double before);

/// The words of a case for a source: "{file: rig.csv, decimal: \",\", skip: 4}".
std::string in_words(std::string_view name, const CsvFormat& format);

}  // namespace slipbench::driver::base
