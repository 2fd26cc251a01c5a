// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/criteria/likely_cause.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/series.hpp"
#include "driver/check/curves/spacing.hpp"

namespace slipbench::driver::check {

/// A few of many points, evenly spread over all that were offered: the memory is bounded.
class PointSample {
 public:
  struct Point {
    std::int64_t index = 0;  ///< of all points of the check
    CurvePoint point;
    int status = -1;
  };

  void offer(std::int64_t index, const CurvePoint& point, int status) {
    if (--until_next_ > 0) return;
    keep({index, point, status});
  }
  std::span<const Point> points() const { return points_; }

 private:
  static constexpr std::size_t kMost = 1024;
  void keep(const Point& point);

  std::vector<Point> points_;
  std::int64_t stride_ = 1;
  std::int64_t until_next_ = 1;
};

/// Judges a check point by point; points come one after another and only those are kept that may
/// turn out to fail.
///
/// The tolerance is the larger of the absolute one and the relative one times the scale of the
/// reference over the compared points (scale_of in criteria/bounds.hpp).
class PointJudge {
 public:
  explicit PointJudge(const cases::Tolerance& tolerance)
      : absolute_(tolerance.absolute.value_or(0.0)), relative_(tolerance.relative.value_or(0.0)) {}

  /// \param status of the quantity's definition: see CausePoint
  void add(const CurvePoint& point, int status) {
    all_.offer(count_, point, status);
    const double deviation = deviation_of(point);
    const bool says_something = !(point.reference >= references_.from) ||
                                !(point.reference <= references_.to) ||
                                deviation > worst_deviation_ || deviation > certain_;
    // Most points say nothing new, nor does the one before them.
    if (says_something || worst_is_last_ || suspect_is_last_ || count_ == 0)
      consider(point, status);
    last_ = point;
    ++count_;
  }

  /// The total time of a failing point, and how far that is from the nearest of its neighbours.
  struct FailingTime {
    double time = 0.0;
    double step = 0.0;
  };
  struct Result {
    double scale = 0.0;
    double largest = 0.0;  ///< absolute value of the reference
    double tolerance = 0.0;
    ToldPoint worst;
    std::int64_t failing = 0;
    std::optional<FailingTime> first;  ///< of the failing points
    std::optional<FailingTime> last;
  };
  Result result() const;

  /// Some of the points, in their order, for judging why the check fails.
  std::vector<CausePoint> sample() const;

  std::int64_t count() const { return count_; }

 private:
  /// A failing point as far as it is told.
  struct Suspect {
    double time;
    double time_step;
    double deviation;
  };

  static double deviation_of(const CurvePoint& point) {
    return std::abs(point.value - point.reference);
  }
  double certain_tolerance() const;
  double tolerance() const;
  void consider(const CurvePoint& point, int status);
  void suspect(const CurvePoint& point, double deviation, double time_step, int status);

  double absolute_;
  double relative_;
  std::int64_t count_ = 0;
  Interval references_;   ///< from the smallest to the largest
  double certain_ = 0.0;  ///< the tolerance cannot turn out smaller than this
  CurvePoint last_;
  CurvePoint worst_;
  double worst_deviation_ = 0.0;
  Spacing worst_spacing_;
  bool worst_is_last_ = false;     ///< so its next neighbour is still to come
  bool suspect_is_last_ = false;   ///< the same of the last suspect
  std::vector<Suspect> suspects_;  ///< points that may turn out to fail
  std::size_t prune_at_ = 4096;
  PointSample all_;
  PointSample suspicious_;
};

}  // namespace slipbench::driver::check
