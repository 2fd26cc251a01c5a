// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/curves/common_range.hpp"

namespace slipbench::driver::check {
namespace {

constexpr std::size_t kParts = 1000;
/// Ends that are nearer than this part of the box meet.
constexpr double kClosed = 0.02;

struct Vec {
  double x = 0.0;
  double y = 0.0;
};
double distance(const Vec& a, const Vec& b) { return std::hypot(a.x - b.x, a.y - b.y); }
double squared(const Vec& a, const Vec& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// A polygon run through at constant speed from 0 to 1.
struct Path {
  std::vector<Vec> corners;
  std::vector<double> at;     ///< share of the length at each corner
  std::vector<double> place;  ///< row of each corner; between two rows on a closing segment
};

bool is_closed(const std::vector<Vec>& corners) {
  return distance(corners.front(), corners.back()) <= kClosed;
}

Path path(std::vector<Vec> corners, bool close) {
  Path out;
  out.corners = std::move(corners);
  for (std::size_t i = 0; i < out.corners.size(); ++i) out.place.push_back(static_cast<double>(i));
  if (close) {
    out.corners.push_back(out.corners.front());
    out.place.push_back(out.place.back());
  }
  out.at.reserve(out.corners.size());
  double length = 0.0;
  for (std::size_t i = 0; i < out.corners.size(); ++i) {
    if (i > 0) length += distance(out.corners[i - 1], out.corners[i]);
    out.at.push_back(length);
  }
  if (length > 0.0) {
    for (double& at : out.at) at /= length;
    out.at.back() = 1.0;
  }
  return out;
}

/// Reads a path at shares of its length that increase from one call to the next.
class Walker {
 public:
  explicit Walker(const Path& path) : path_(&path) {}

  Vec operator()(double s) {
    seek(s);
    const Vec &a = path_->corners[i_], &b = path_->corners[last()];
    const double part = part_of(s);
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  }
  /// Returns where in the rows of the curve that is: "3.25" is a quarter of the way from row 3 to
  /// row 4.
  double row(double s) {
    seek(s);
    const double a = path_->place[i_], b = path_->place[last()];
    return a + part_of(s) * (b - a);
  }

 private:
  std::size_t last() const { return std::min(i_ + 1, path_->corners.size() - 1); }
  void seek(double s) {
    if (s < path_->at[i_]) i_ = 0;  // once around a closed loop
    while (i_ + 2 < path_->at.size() && path_->at[i_ + 1] <= s) ++i_;
  }
  double part_of(double s) const {
    const double length = path_->at[last()] - path_->at[i_];
    return length > 0.0 ? std::clamp((s - path_->at[i_]) / length, 0.0, 1.0) : 0.0;
  }

  const Path* path_;
  std::size_t i_ = 0;
};

double turned(double s) { return s - std::floor(s); }

std::vector<Vec> at_equal_parts(const Path& path) {
  std::vector<Vec> out;
  Walker walk(path);
  for (std::size_t i = 0; i < kParts; ++i) {
    out.push_back(walk(static_cast<double>(i) / static_cast<double>(kParts)));
  }
  return out;
}

/// The start on a closed path `f` from where it is nearest to `r`, by the sum of squares: the best
/// of the equal parts, then a golden section between its neighbours.
double best_phase(const Path& f, const Path& r) {
  const std::vector<Vec> f_points = at_equal_parts(f), r_points = at_equal_parts(r);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t shift = 0; shift < kParts; ++shift) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kParts - shift; ++i)
      sum += squared(f_points[i + shift], r_points[i]);
    for (std::size_t i = kParts - shift; i < kParts; ++i) {
      sum += squared(f_points[i + shift - kParts], r_points[i]);
    }
    if (sum < least) {
      least = sum;
      best = shift;
    }
  }
  const auto sum_at = [&](double phase) {
    Walker walk(f);
    double sum = 0.0;
    for (std::size_t i = 0; i < kParts; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(kParts);
      sum += squared(walk(turned(s + phase)), r_points[i]);
    }
    return sum;
  };
  constexpr double kStep = 1.0 / static_cast<double>(kParts);
  constexpr double kShrink = 1.0 / std::numbers::phi;
  constexpr int kRounds = 60;  // 0.618^60 of two steps is below the rounding of a share
  const double start = static_cast<double>(best) * kStep;
  double a = start - kStep, b = start + kStep;
  double c = b - kShrink * (b - a), d = a + kShrink * (b - a);
  double at_c = sum_at(c), at_d = sum_at(d);
  for (int round = 0; round < kRounds; ++round) {
    if (at_c < at_d) {
      b = d;
      d = c;
      at_d = at_c;
      c = b - kShrink * (b - a);
      at_c = sum_at(c);
    } else {
      a = c;
      c = d;
      at_c = at_d;
      d = a + kShrink * (b - a);
      at_d = sum_at(d);
    }
  }
  // A loop that begins where the other one does is not turned by the search's rounding.
  const double middle = 0.5 * (a + b);
  return sum_at(start) <= sum_at(middle) ? start : middle;
}

/// A column of a curve at a place between its rows; NaN if it has none.
double between_rows(const std::vector<double>& column, double row) {
  if (column.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto i = std::min(static_cast<std::size_t>(row), column.size() - 1);
  const std::size_t next = std::min(i + 1, column.size() - 1);
  const double part = row - static_cast<double>(i);
  return (1.0 - part) * column[i] + part * column[next];
}

/// Tells whether lengths between these points are numbers.
bool measurable(const std::vector<Vec>& points) {
  constexpr double kFarthest = 1e150;
  return std::all_of(points.begin(), points.end(), [](const Vec& p) {
    return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest;
  });
}

}  // namespace

CurveComparison compare_arc_length(const Series& result, const Series& reference,
                                   const cases::Tolerance& tolerance) {
  CurveComparison out;
  out.fault = common_range(result, reference).fault;
  if (!out.fault.empty()) return out;
  const Interval box = extent(reference.abscissa);
  const double width = box.width(), height = scale_of(reference.value);
  if (!(width > 0.0)) {
    out.fault = "the reference's abscissa does not move: its curve has no width to compare with";
  } else if (!(height > 0.0)) {
    out.fault = "the reference is zero throughout: its curve has no height to compare with";
  }
  if (!out.fault.empty()) return out;
  out.compared = static_cast<std::int64_t>(reference.size());

  const double level = extent(reference.value).from;
  const auto corners = [&](const Series& curve) {
    std::vector<Vec> points;
    points.reserve(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      points.push_back({(curve.abscissa[i] - box.from) / width, (curve.value[i] - level) / height});
    }
    return points;
  };
  std::vector<Vec> f_corners = corners(result), r_corners = corners(reference);
  if (!measurable(f_corners) || !measurable(r_corners)) {
    out.fault = "the result is too far from the reference to measure a distance";
    return out;
  }
  const bool closed = is_closed(f_corners) && is_closed(r_corners);
  const Path f = path(std::move(f_corners), closed), r = path(std::move(r_corners), closed);
  const double phase = closed ? best_phase(f, r) : 0.0;
  const auto along_f = [&](double s) { return closed ? turned(s + phase) : s; };

  // The distance is convex between the corners of both.
  std::vector<double> places = r.at;
  for (const double at : f.at) places.push_back(closed ? turned(at - phase) : at);
  std::sort(places.begin(), places.end());
  double largest = -1.0, worst = 0.0;
  Walker walk_f(f), walk_r(r);
  for (const double s : places) {
    const double apart = distance(walk_f(along_f(s)), walk_r(s));
    if (apart > largest) {
      largest = apart;
      worst = s;
    }
  }
  const double r_row = Walker(r).row(worst), f_row = Walker(f).row(along_f(worst));
  double sum = 0.0;
  Walker again_f(f), again_r(r);
  for (std::size_t i = 0; i < kParts; ++i) {
    const double s = (static_cast<double>(i) + 0.5) / static_cast<double>(kParts);
    sum += distance(again_f(along_f(s)), again_r(s));
  }

  Measure measure{
      .name = closed ? "largest distance of closed loops" : "largest distance along the curves",
      .unit = MeasureUnit::kNone,
      .value = largest,
      .reference = 0.0,
      .deviation = largest,
      .scale = 1.0,
      .tolerance = value_bound(tolerance, 1.0),
      .where = CurvePoint{.abscissa = between_rows(reference.abscissa, r_row),
                          .value = between_rows(result.value, f_row),
                          .reference = between_rows(reference.value, r_row),
                          .time = between_rows(result.time, f_row)}};
  out.measures.push_back(measure);
  measure.name = "mean distance";
  measure.value = measure.deviation = sum / static_cast<double>(kParts);
  measure.tolerance = std::numeric_limits<double>::infinity();
  measure.where.reset();
  out.measures.push_back(measure);
  return out;
}

}  // namespace slipbench::driver::check
