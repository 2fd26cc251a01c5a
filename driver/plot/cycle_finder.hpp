// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace slipbench::driver::plot {

/// The cycles of a motion. Each ends with every second turning point; the first begins with the
/// run, the last ends with it.
struct MotionCycles {
  /// The last row of each, counted from 0; it is the first row of the next one, too.
  std::vector<std::int64_t> ends;
  /// First and last row of the last full cycle: from a turning point to the next but one, which is
  /// the same place but for a thousandth of the range. Nothing if there is none: then the motion
  /// turns, but is no cyclic one.
  std::optional<std::array<std::int64_t, 2>> full;
};

/// Finds the cycles of a motion while its rows come. A turn by less than 2 % of the range is one of
/// a vibration, and none.
class CycleFinder {
 public:
  /// \param range of the whole motion, highest less lowest
  explicit CycleFinder(double range) : range_(range) {}
  void add(double position);
  MotionCycles cycles() const;

 private:
  struct Turn {
    std::int64_t row = 0;
    double position = 0.0;
  };
  bool full(const Turn& first, const Turn& end) const;

  double range_;
  std::int64_t count_ = 0;
  double direction_ = 0.0;  ///< 0 before it moves
  double start_ = 0.0;
  double position_ = 0.0;    ///< of the last row
  double furthest_ = 0.0;    ///< of this branch
  std::int64_t dwells_ = 0;  ///< the last row that is still there
  std::int64_t turns_ = 0;
  std::array<Turn, 2> before_;  ///< the last two turns
  MotionCycles found_;
};

/// The numbers of the cycles that are drawn of so many: all of up to five; else 1, 2, 5, 10, 20, 50
/// and so on, or powers of ten if those would be too many to be told apart; and the last one.
std::vector<std::int64_t> drawn_cycles(std::int64_t count);

}  // namespace slipbench::driver::plot
