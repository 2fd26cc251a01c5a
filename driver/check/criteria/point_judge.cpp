// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/point_judge.hpp"

#include <algorithm>
#include <cmath>

#include "driver/check/criteria/bounds.hpp"

namespace slipbench::driver::check {

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

void PointJudge::consider(const CurvePoint& point, int status) {
  const double reference = point.reference;
  references_.from = count_ == 0 ? reference : std::min(references_.from, reference);
  references_.to = count_ == 0 ? reference : std::max(references_.to, reference);
  certain_ = certain_tolerance();
  const double deviation = deviation_of(point);
  const bool is_worst = count_ == 0 || deviation > worst_deviation_;
  const bool is_suspect = deviation > certain_;
  const Spacing before = count_ == 0 ? Spacing{} : spacing(last_, point);
  if (worst_is_last_) worst_spacing_ = narrower(worst_spacing_, before);
  if (suspect_is_last_) {
    suspects_.back().time_step = std::min(suspects_.back().time_step, before.time);
  }
  if (is_worst) {
    worst_ = point;
    worst_deviation_ = deviation;
    worst_spacing_ = before;
  }
  worst_is_last_ = is_worst;
  suspect_is_last_ = is_suspect;
  if (is_suspect) suspect(point, deviation, before.time, status);
}

/// Only points that may yet fail are kept, so a check that passes needs next to no memory.
void PointJudge::suspect(const CurvePoint& point, double deviation, double time_step, int status) {
  suspicious_.offer(count_, point, status);
  suspects_.push_back({point.time, time_step, deviation});
  if (suspects_.size() < prune_at_) return;
  std::erase_if(suspects_, [&](const Suspect& s) { return s.deviation <= certain_; });
  suspect_is_last_ = deviation > certain_;
  prune_at_ = std::max(prune_at_, 2 * suspects_.size());
}

double PointJudge::tolerance() const {
  return std::max(absolute_, relative_ * scale_of(references_));
}

double PointJudge::certain_tolerance() const {
  return std::max(absolute_, relative_ * least_scale(references_));
}

PointJudge::Result PointJudge::result() const {
  Result result;
  result.scale = scale_of(references_);
  result.largest = magnitude(references_);
  result.tolerance = tolerance();
  result.worst = {worst_, worst_spacing_};
  for (const Suspect& suspect : suspects_) {
    if (suspect.deviation <= result.tolerance) continue;
    ++result.failing;
    const FailingTime failing{suspect.time, suspect.time_step};
    if (!result.first) result.first = failing;
    result.last = failing;
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

}  // namespace slipbench::driver::check
