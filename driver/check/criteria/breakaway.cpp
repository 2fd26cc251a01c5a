// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/breakaway.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {
namespace {

/// Distance below its initial slope where a curve has left it, as a part of its largest change.
constexpr double kOffset = 0.02;
/// The initial slope is sought in so many tenths of the largest change.
constexpr int kInitialTenths = 5;
/// Changes below this part of the values are rounding.
constexpr double kNoChange = 1e-9;

/// The first branch of a curve as it goes: changes since its start, counted in its direction.
struct Course {
  std::vector<double> u;  ///< of the abscissa, never decreasing
  std::vector<double> g;  ///< of the value
  double direction = 1.0;
  double sign = 1.0;  ///< of the values' change
  double rise = 0.0;  ///< the largest g
};

Course course_of(const Series& curve, const Branch& branch) {
  Course course;
  course.direction = branch.direction;
  const double x0 = curve.abscissa[branch.first];
  const double q0 = curve.value[branch.first];
  double most = 0.0;
  double furthest = 0.0;
  for (std::size_t i = branch.first; i <= branch.last; ++i) {
    furthest = std::max(furthest, course.direction * (curve.abscissa[i] - x0));
    course.u.push_back(furthest);
    course.g.push_back(curve.value[i] - q0);
    if (std::abs(course.g.back()) > std::abs(most)) most = course.g.back();
  }
  course.sign = most < 0.0 ? -1.0 : 1.0;
  course.rise = std::abs(most);
  for (double& g : course.g) g *= course.sign;
  return course;
}

/// Place where a polyline y(u) first reaches a level, and the row at its end of that piece.
struct Crossing {
  double u = 0.0;
  std::size_t row = 0;
};

std::optional<Crossing> first_crossing(const std::vector<double>& u, const std::vector<double>& y,
                                       double level) {
  if (y.front() >= level) return Crossing{u.front(), 0};
  for (std::size_t i = 1; i < y.size(); ++i) {
    if (y[i] < level) continue;
    const double fraction = (level - y[i - 1]) / (y[i] - y[i - 1]);
    return Crossing{u[i - 1] + fraction * (u[i] - u[i - 1]), i};
  }
  return std::nullopt;
}

/// The initial slope: a straight line g = level + slope (u - from), infinitely steep if rigid.
struct InitialSlope {
  double from = 0.0;
  double level = 0.0;
  double slope = 0.0;
  Crossing end;  ///< of the tenth it was found in
};

InitialSlope initial_slope(const Course& course) {
  InitialSlope steepest;
  for (int tenth = 0; tenth < kInitialTenths; ++tenth) {
    const double level = 0.1 * tenth * course.rise;
    const auto begin = first_crossing(course.u, course.g, level);
    const auto end = first_crossing(course.u, course.g, level + 0.1 * course.rise);
    const double width = end->u - begin->u;
    const double slope = width > history::kSameTime * course.u.back()
                             ? 0.1 * course.rise / width
                             : std::numeric_limits<double>::infinity();
    if (slope > steepest.slope) steepest = {begin->u, level, slope, *end};
  }
  return steepest;
}

/// Returns where the course of a rigid curve ends its vertical part.
std::pair<double, double> end_of_rigid_part(const Course& course, const InitialSlope& initial) {
  double reached = course.g[initial.end.row];
  for (std::size_t i = initial.end.row;
       i < course.u.size() && course.u[i] <= initial.end.u + history::kSameTime * course.u.back();
       ++i) {
    reached = std::max(reached, course.g[i]);
  }
  return {initial.end.u, reached};
}

/// Returns where the course leaves the initial slope, as changes (u, g); nothing if it never does.
std::optional<std::pair<double, double>> departure(const Course& course,
                                                   const InitialSlope& initial) {
  // How far the course is below the line, from the end of the tenth on.
  std::vector<double> u{initial.end.u};
  std::vector<double> below{0.0};
  const auto line = [&](double at) { return initial.level + initial.slope * (at - initial.from); };
  for (std::size_t i = initial.end.row; i < course.u.size(); ++i) {
    u.push_back(course.u[i]);
    below.push_back(line(course.u[i]) - course.g[i]);
  }
  const auto left = first_crossing(u, below, kOffset * course.rise);
  if (!left) return std::nullopt;
  const auto halfway = first_crossing(u, below, 0.5 * kOffset * course.rise);
  // Traced back, but not to before a row that still is on the line.
  double last_on_line = initial.end.u;
  for (std::size_t k = 1; k < halfway->row; ++k) {
    if (below[k] <= kNoChange * course.rise) last_on_line = u[k];
  }
  double at = std::max(2.0 * halfway->u - left->u, last_on_line);
  // A sharp knee between two rows: the piece after them, traced back, meets the line between them.
  const std::size_t i = halfway->row;
  if (i + 1 < u.size() && below[i + 1] > below[i]) {
    const double knee = u[i] - below[i] * (u[i + 1] - u[i]) / (below[i + 1] - below[i]);
    if (knee >= u[i - 1] - history::kSameTime * course.u.back()) at = knee;
  }
  return std::pair{at, line(at)};
}

/// The time at a way of the first branch; NaN where it is not known.
double time_at(const Series& curve, const Branch& branch, const Course& course, double u) {
  if (curve.time.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto after = std::lower_bound(course.u.begin(), course.u.end(), u);
  const auto i = static_cast<std::size_t>(after - course.u.begin());
  if (i == course.u.size()) return curve.time[branch.last];
  const double end = curve.time[branch.first + i];
  if (i == 0) return end;
  const double begin = curve.time[branch.first + i - 1];
  return begin + (end - begin) * (u - course.u[i - 1]) / (course.u[i] - course.u[i - 1]);
}

Breakaway without_breakaway(std::string fault) {
  Breakaway none;
  none.fault = std::move(fault);
  return none;
}

}  // namespace

Breakaway breakaway(const Series& curve) {
  if (curve.size() < 2) return without_breakaway("is but a point");
  const Branch branch = branches(curve.abscissa, curve.noise).front();
  const Course course = course_of(curve, branch);
  if (course.u.back() == 0.0) return without_breakaway("does not move");
  double magnitude = 0.0;
  for (std::size_t i = branch.first; i <= branch.last; ++i) {
    magnitude = std::max(magnitude, std::abs(curve.value[i]));
  }
  if (course.rise <= kNoChange * magnitude) {
    return without_breakaway("has the same value all along, so there is no slope to leave");
  }
  const InitialSlope initial = initial_slope(course);
  std::optional<std::pair<double, double>> found;
  if (std::isinf(initial.slope)) {
    found = end_of_rigid_part(course, initial);
  } else {
    found = departure(course, initial);
  }
  if (!found) return without_breakaway("never leaves its initial slope");
  return {{},
          curve.abscissa[branch.first] + course.direction * found->first,
          curve.value[branch.first] + course.sign * found->second,
          time_at(curve, branch, course, found->first)};
}

CurveComparison compare_breakaway(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance) {
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return incomparable(common.fault);
  const Breakaway ours = breakaway(result);
  const Breakaway theirs = breakaway(reference);
  if (!ours.fault.empty()) return incomparable("no breakaway: the result " + ours.fault);
  if (!theirs.fault.empty()) return incomparable("no breakaway: the reference " + theirs.fault);
  const CurvePoint where{ours.abscissa, ours.value, theirs.value, ours.time};
  Measure value = judged("value at breakaway", MeasureUnit::kQuantity, ours.value, theirs.value);
  value.scale = scale_of(reference.value);
  value.tolerance = value_bound(tolerance, value.scale);
  value.where = where;
  Measure position =
      judged("position of breakaway", MeasureUnit::kAbscissa, ours.abscissa, theirs.abscissa);
  position.scale = scale_of(reference.abscissa);
  position.tolerance = position_bound(tolerance, position.scale);
  position.where = where;
  return compared(reference.size(), {std::move(value), std::move(position)});
}

}  // namespace slipbench::driver::check
