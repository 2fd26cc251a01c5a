// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/point_judge.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::driver {
namespace {

/// Below this part of its magnitude, the range of a reference is its rounding.
constexpr double kNearlyConstant = 1e-9;

double deviation_of(const CurvePoint& point) { return std::abs(point.value - point.reference); }

}  // namespace

void PointSample::keep(const Point& point) {
  if (points_.size() == kMost) {
    // Every second one goes: the rest is as evenly spread as before.
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize((points_.size() + 1) / 2);
    stride_ *= 2;
  }
  points_.push_back(point);
  until_next_ = stride_;
}

void PointJudge::add(const CurvePoint& point, int status) {
  const double reference = point.reference;
  lowest_ = count_ == 0 ? reference : std::min(lowest_, reference);
  highest_ = count_ == 0 ? reference : std::max(highest_, reference);
  const double deviation = deviation_of(point);
  if (count_ == 0 || deviation > worst_deviation_) {
    worst_ = point;
    worst_deviation_ = deviation;
  }
  all_.offer(count_, point, status);
  if (deviation > certain_tolerance()) suspect(point, deviation, status);
  ++count_;
}

/// Only points that may yet fail are kept, so a check that passes needs next to no memory.
void PointJudge::suspect(const CurvePoint& point, double deviation, int status) {
  suspicious_.offer(count_, point, status);
  suspects_.push_back({point.time, point.abscissa, deviation});
  if (suspects_.size() < prune_at_) return;
  const double certain = certain_tolerance();
  std::erase_if(suspects_, [&](const Suspect& s) { return s.deviation <= certain; });
  prune_at_ = std::max(prune_at_, 2 * suspects_.size());
}

/// What a relative tolerance is relative to.
double PointJudge::scale() const {
  const double range = highest_ - lowest_;
  const double magnitude = std::max(std::abs(highest_), std::abs(lowest_));
  return range < kNearlyConstant * magnitude ? magnitude : range;
}

double PointJudge::tolerance() const { return std::max(absolute_, relative_ * scale()); }

/// The tolerance cannot turn out smaller than this: the range only grows, and the magnitude, too.
double PointJudge::certain_tolerance() const {
  const double range = highest_ - lowest_;
  const double magnitude = std::max(std::abs(highest_), std::abs(lowest_));
  return std::max(absolute_, relative_ * std::max(range, kNearlyConstant * magnitude));
}

PointJudge::Result PointJudge::result() const {
  Result result;
  result.scale = scale();
  result.tolerance = tolerance();
  result.worst = worst_;
  for (const Suspect& suspect : suspects_) {
    if (suspect.deviation <= result.tolerance) continue;
    ++result.failing;
    const CurvePoint point{.abscissa = suspect.abscissa, .time = suspect.time};
    if (!result.first) result.first = point;
    result.last = point;
  }
  return result;
}

std::vector<CausePoint> PointJudge::sample() const {
  std::vector<PointSample::Point> points(all_.points().begin(), all_.points().end());
  points.insert(points.end(), suspicious_.points().begin(), suspicious_.points().end());
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.index < b.index; });
  const double limit = tolerance();
  std::vector<CausePoint> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].index == points[i - 1].index) continue;
    result.push_back({points[i].point, points[i].status, deviation_of(points[i].point) > limit});
  }
  return result;
}

}  // namespace slipbench::driver
