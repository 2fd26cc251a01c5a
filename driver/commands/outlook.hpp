// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "driver/bench/run_length.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {

/// Thrown from within a run that is going to fill the disk.
struct NoRoom {
  std::string message;
};

/// "12 s", "3 min", "1.5 h".
std::string duration_words(double seconds);

/// "45 %, 900000 increments, 12 s left", the last only once some of it is done.
std::string run_progress_text(std::int64_t increments, double done, double seconds);

/// Foresees from its first rows what a long run will take, once, and tells it on standard error if
/// that is too long to wait for without a word; then shows how far it is.
class Outlook {
 public:
  /// \param folder where the result goes
  Outlook(const cases::Case& problem, std::filesystem::path folder);

  /// Cheap enough to be called whenever some rows are done. Throws NoRoom if the disk has less room
  /// than the rows need.
  /// \param row the last of them
  /// \param rows gives the bytes that all of them so far take of the disk; nothing for no file
  /// \param progress shows how far the run is
  template <class Rows>
  void look(const bench::Row& row, Rows rows, terminal::Progress& progress) {
    if (row.index < next_) return;
    if (next_ == kFirst) judge(row, rows());
    next_ = row.index + kFirst;
    show(row, progress);
  }

 private:
  static constexpr std::int64_t kFirst = std::int64_t{1} << 16U;
  void judge(const bench::Row& row, std::optional<std::uintmax_t> written);
  void show(const bench::Row& row, terminal::Progress& progress) const;
  double seconds() const;

  std::int64_t next_ = kFirst;
  const cases::Case* case_;
  bench::RunLength length_;
  std::filesystem::path folder_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace slipbench::driver::commands
