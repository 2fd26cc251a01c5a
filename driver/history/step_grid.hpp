// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstdint>

namespace slipbench::driver::history {

/// Two times of a step are one when they differ by no more than this part of its duration. Rounding
/// (k periods of 1/3 against k thirds) stays far below it, and no increment is that short on
/// purpose.
inline constexpr double kSameTime = 1e-12;

/// The ends of a step's increments: the uniform grid duration*i/n, merged with the breakpoints of
/// the step's profiles, one after another. Nothing is stored, so a step may be of any length.
///
/// Where a breakpoint and a point of the uniform grid are the same time (`kSameTime`), the
/// breakpoint stays; the last point is the duration itself.
class StepGrid {
 public:
  /// A step from 0 to `duration` > 0 in `increments` >= 1 uniform parts.
  StepGrid(double duration, std::int64_t increments)
      : duration_(duration),
        increments_(increments),
        merge_(kSameTime * duration),
        uniform_(uniform(1)) {
    assert(duration > 0.0 && increments >= 1);
  }

  /// The end of the last increment; 0 before the first.
  double time() const { return time_; }

  /// Tells whether the step's end has been reached.
  bool at_end() const { return at_end_; }

  /// Moves to the end of the next increment and returns it. `breakpoint` is the first breakpoint
  /// after `time()`, or infinity.
  double advance(double breakpoint) {
    assert(!at_end_);
    double next = uniform_;
    if (breakpoint > time_ + merge_ && breakpoint <= next + merge_) next = breakpoint;
    while (index_ < increments_ && uniform_ <= next + merge_) uniform_ = uniform(++index_);
    at_end_ = next >= duration_ - merge_;
    time_ = at_end_ ? duration_ : next;
    return time_;
  }

 private:
  double uniform(std::int64_t i) const {
    if (i >= increments_) return duration_;
    return duration_ * static_cast<double>(i) / static_cast<double>(increments_);
  }

  double duration_;
  std::int64_t increments_;
  double merge_;
  double time_ = 0.0;
  std::int64_t index_ = 1;  ///< The next point of the uniform grid,
  double uniform_;          ///< and its time.
  bool at_end_ = false;
};

}  // namespace slipbench::driver::history
