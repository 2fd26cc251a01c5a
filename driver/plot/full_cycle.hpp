// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "driver/history/history_error.hpp"
#include "driver/results/plot_data.hpp"

namespace slipbench::driver {

/// Finds the last full cycle of a motion while its rows come: from one turning point to the next
/// but one, which is the same place but for a thousandth of the motion's range. A cycle of less
/// than 2 % of the range is what is left of a vibration, and none. Turning points are those of
/// branches(), the last row included.
class FullCycleFinder {
 public:
  /// \param range of the whole motion, highest less lowest
  explicit FullCycleFinder(double range) : range_(range) {}
  void add(double position);
  /// The first and the last row of the cycle, counted from 0.
  std::optional<std::array<std::int64_t, 2>> last() const;

 private:
  struct Turn {
    std::int64_t row = 0;
    double position = 0.0;
  };
  bool full(const Turn& first, const Turn& middle, const Turn& end) const;

  double range_;
  std::int64_t count_ = 0;
  double direction_ = 0.0;  ///< 0 before it moves
  double start_ = 0.0;
  double position_ = 0.0;    ///< of the last row
  double furthest_ = 0.0;    ///< of this branch
  std::int64_t dwells_ = 0;  ///< the last row that is still there
  std::int64_t turns_ = 0;
  std::array<Turn, 2> before_;  ///< the last two turns
  std::optional<std::array<std::int64_t, 2>> last_;
};

/// Reads the rows of the last full cycle of each definition from the result that `data` is of: of
/// the first of its motions that has one. More than kMostCycleRows are thinned.
///
/// Errors: those of CsvReader.
tl::expected<void, HistoryError> add_full_cycles(PlotData& data, const std::filesystem::path& file,
                                                 const std::string& shown_name);

/// So many rows of one cycle leave nothing out that a picture could show.
inline constexpr std::size_t kMostCycleRows = 20000;

}  // namespace slipbench::driver
