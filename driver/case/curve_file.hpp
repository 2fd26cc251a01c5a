// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/base/text/history_error.hpp"
#include "driver/case/shared_numbers.hpp"

namespace slipbench::driver::cases {

/// The first line of a golden curve.
inline constexpr std::string_view kGoldenMark = "# slipbench golden curve";
/// The comment of a golden curve before the number of its rows. Older ones have none.
inline constexpr std::string_view kGoldenRows = "# rows: ";
/// The column of a golden curve that holds the total time; every one has it.
inline constexpr std::string_view kGoldenTime = "time";
std::span<const std::string> golden_time_names();

/// The columns of a reference curve that the checks of a case want, read at the first need and
/// once for all callers. Several threads may ask at a time.
class CurveFile {
 public:
  struct Column {
    SharedNumbers values;  ///< as they stand in the file, but 0 for -0
    std::optional<double>
        resolution;  ///< half a unit of the last printed digit, see base::PrintedDigits
  };

  explicit CurveFile(base::DataSource source) : source_(std::move(source)) {}

  /// Says that a column will be asked for: the first of `names` that the file has. Only before the
  /// first `column`.
  void want(std::span<const std::string> names);

  /// A column of those wanted. Errors, in a sentence: a file that cannot be read or is faulty; no
  /// such column, naming those there are.
  tl::expected<const Column*, std::string> column(std::span<const std::string> names) const;

  /// Tells whether `slipbench bless` made it.
  bool golden() const { return contents().golden; }

  /// Reads the file now, so that whoever asks first need not wait for it.
  void read_ahead() const { contents(); }

  const std::filesystem::path& path() const { return source_.file; }

 private:
  struct Contents {
    bool golden = false;
    std::string fault;
    std::vector<std::string> header;
    std::string remedy;  ///< if nothing of what is wanted was found
    std::vector<std::string> names;
    std::vector<Column> columns;  ///< in the order of `names`
  };
  const Contents& contents() const;
  Contents read() const;

  base::DataSource source_;
  std::vector<std::string> wanted_;
  mutable std::once_flag once_;
  mutable Contents contents_;
};

/// Opens the file and reads of it, to tell whether it can be; what stands in it is not judged.
/// Errors are of the kind kEnvironment: missing, unreadable, no regular file.
tl::expected<void, base::HistoryError> openable_curve(const std::filesystem::path& file,
                                                      const std::string& shown_name);

/// Tells whether the file's first line is that of a golden curve.
bool is_golden_curve(const std::filesystem::path& file);

}  // namespace slipbench::driver::cases
