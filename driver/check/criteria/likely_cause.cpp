// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/likely_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "driver/results/summary.hpp"

namespace slipbench::driver::check {
namespace {

constexpr double kOfTolerance = 0.1;
constexpr double kOfDeviation = 0.01;
/// Part of the points that may be off for a reason of their own.
constexpr double kOutliers = 0.05;
constexpr std::size_t kFewest = 3;
constexpr std::size_t kFewestOfDelay = 5;

/// Ratios are taken where the reference is not small: above this part of its largest magnitude.
constexpr double kOfLargest = 0.1;

constexpr int kOpen = 0, kStick = 1, kSlip = 2;

/// A point with its stick: f - f0 and r - r0 belong to the one that began at f0, r0.
struct Point {
  double at = 0.0;
  double f = 0.0;
  double r = 0.0;
  double f0 = 0.0;
  double r0 = 0.0;
  int status = -1;
  bool failing = false;
  /// Of a stick point without a slip before it: the reference where the result slips first.
  std::optional<double> first_limit = std::nullopt;

  double deviation() const { return std::abs(f - r); }
};

/// Points that a cause covers, and the ones among them that it does not explain.
struct Count {
  std::size_t points = 0;
  std::size_t wrong = 0;

  void add(bool explained) {
    ++points;
    if (!explained) ++wrong;
  }
  double share() const {
    return points == 0 ? 0.0 : static_cast<double>(wrong) / static_cast<double>(points);
  }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Enough digits to tell the ratio from 1.
std::string ratio_text(double ratio) {
  const double apart = std::abs(ratio - 1.0);
  const int needed = apart > 0.0 ? 2 + static_cast<int>(std::ceil(-std::log10(apart))) : 3;
  return fmt::format("{:.{}g}", ratio, std::clamp(needed, 3, 15));
}

/// Tells whether a ratio is 100, 1000, 0.01 or the like, as units are.
bool is_unit_ratio(double ratio) {
  const double decades = std::log10(std::abs(ratio));
  return ratio > 0.0 && std::abs(std::round(decades)) >= 2.0 &&
         std::abs(decades - std::round(decades)) < 1e-4;
}

/// The points with numbers, each with the start of its stick.
std::vector<Point> prepared(std::span<const CausePoint> points) {
  std::vector<Point> out;
  out.reserve(points.size());
  double f0 = 0.0, r0 = 0.0;
  std::size_t fresh_from = 0;  // the points from here on have seen no slip yet
  bool fresh = true;
  std::optional<Point> slipped;  // the last slip point, if no stick has followed yet
  for (const CausePoint& given : points) {
    Point p{.at = given.point.abscissa,
            .f = given.point.value,
            .r = given.point.reference,
            .status = given.status,
            .failing = given.failing};
    if (!std::isfinite(p.at) || !std::isfinite(p.f) || !std::isfinite(p.r)) continue;
    if (p.status == kOpen) {
      f0 = r0 = 0.0;
      slipped.reset();
      fresh = true;
      fresh_from = out.size() + 1;
    } else if (p.status == kStick && slipped) {
      f0 = slipped->f;
      r0 = slipped->r;
      slipped.reset();
    }
    p.f0 = f0;
    p.r0 = r0;
    if (p.status == kSlip) {
      slipped = p;
      for (; fresh && fresh_from < out.size(); ++fresh_from) out[fresh_from].first_limit = p.r;
      fresh = false;
    }
    out.push_back(p);
  }
  return out;
}

class Inquiry {
 public:
  Inquiry(std::vector<Point> points, const CauseScales& scales)
      : points_(std::move(points)), scales_(scales) {
    for (const Point& p : points_) failing_ += p.failing ? 1 : 0;
  }

  std::string cause() const {
    if (failing_ < kFewest) return {};
    if (is_negative()) return "looks like the sign: the negative of the reference everywhere";
    const std::optional<double> factor = factor_everywhere();
    if (factor && *factor == 0.0) return "looks like no load at all: the result is zero everywhere";
    if (factor && is_unit_ratio(*factor)) {
      return fmt::format("looks like a unit: ratio {:.3g} everywhere", *factor);
    }
    const std::optional<double> offset = offset_everywhere();
    if (factor && !offset && holds_in_stick(*factor)) {
      return fmt::format("looks like {}: ratio {} everywhere", in_stick_and_slip(),
                         ratio_text(*factor));
    }
    if (const auto ratio = coefficient()) {
      return fmt::format(
          "looks like the coefficient (or the normal force): ratio {} everywhere in slip",
          ratio_text(*ratio));
    }
    if (const auto ratio = stick_stiffness(); ratio && !offset) {
      return fmt::format(
          "looks like the stick stiffness (or the motion): ratio {} everywhere in stick",
          ratio_text(*ratio));
    }
    if (factor && offset) return {};  // a reference of one level does not tell which
    if (factor) return fmt::format("looks like a factor: ratio {} everywhere", ratio_text(*factor));
    if (offset) {
      return fmt::format("looks like an offset: {} everywhere",
                         base::with_unit(fmt::format("{:+.3g}", *offset), scales_.unit));
    }
    if (const auto late = delay()) {
      return fmt::format("looks like a delay: the result is {} {}",
                         base::with_unit(fmt::format("{:.3g}", std::abs(*late)), scales_.time_unit),
                         *late > 0.0 ? "late" : "early");
    }
    return {};
  }

 private:
  double allowed(const Point& p) const {
    return std::max(kOfTolerance * scales_.tolerance, kOfDeviation * p.deviation());
  }
  bool meets(const Point& p, double expected) const {
    return std::abs(p.f - expected) <= allowed(p);
  }

  /// Tells whether f is what `expected(point)` says, everywhere.
  template <class Expected>
  bool explains(Expected&& expected) const {
    Count all, failing;
    for (const Point& p : points_) {
      const bool explained = meets(p, expected(p));
      all.add(explained);
      if (p.failing) failing.add(explained);
    }
    return all.share() <= kOutliers && failing.share() <= kOutliers;
  }

  /// The median of (f - f0)/(r - r0) over the failing points of a status (-1: of any, from 0), and
  /// the largest |r - r0| of these.
  struct Ratio {
    double value = 0.0;
    double largest = 0.0;
  };
  std::optional<Ratio> ratio_of(int status, bool since_slip) const {
    Ratio out;
    const auto start = [&](const Point& p) { return since_slip ? p.r0 : 0.0; };
    const auto counts = [&](const Point& p) {
      return p.failing && (status < 0 || p.status == status);
    };
    for (const Point& p : points_) {
      if (counts(p)) out.largest = std::max(out.largest, std::abs(p.r - start(p)));
    }
    std::vector<double> ratios;
    for (const Point& p : points_) {
      const double below = p.r - start(p);
      if (!counts(p) || below == 0.0 || std::abs(below) < kOfLargest * out.largest) continue;
      ratios.push_back((p.f - (since_slip ? p.f0 : 0.0)) / below);
    }
    if (ratios.size() < kFewest) return std::nullopt;
    out.value = median(std::move(ratios));
    if (!std::isfinite(out.value)) return std::nullopt;
    return out;
  }

  bool is_negative() const {
    return explains([](const Point& p) { return -p.r; });
  }

  std::optional<double> factor_everywhere() const {
    const auto ratio = ratio_of(-1, false);
    if (!ratio || !explains([&](const Point& p) { return ratio->value * p.r; })) {
      return std::nullopt;
    }
    // The few points of a first stick say as much as all the slip that follows.
    Count sticking;
    for (const Point& p : points_) {
      if (p.failing && p.status == kStick) sticking.add(meets(p, ratio->value * p.r));
    }
    if (sticking.wrong >= kFewest && sticking.share() > kOutliers) return std::nullopt;
    return ratio->value;
  }

  /// Returns what a factor that holds in stick may come from.
  const char* in_stick_and_slip() const {
    if (!fails_in(kSlip)) return "the stick stiffness (or the motion), or a factor";
    return scales_.stiffness_follows_limit ? "the coefficient (or the normal force), or a factor"
                                           : "a factor";
  }

  bool fails_in(int status) const {
    return std::any_of(points_.begin(), points_.end(),
                       [&](const Point& p) { return p.failing && p.status == status; });
  }

  /// Tells whether a factor holds where it cannot be that of the limit: in stick, well below it.
  bool holds_in_stick(double factor) const {
    constexpr double kBelowLimit = 0.9;
    double largest = 0.0;
    for (const Point& p : points_) largest = std::max(largest, std::abs(p.r));
    const auto count = std::count_if(points_.begin(), points_.end(), [&](const Point& p) {
      return p.failing && p.status == kStick && std::abs(p.r) < kBelowLimit * largest &&
             meets(p, factor * p.r);
    });
    return static_cast<std::size_t>(count) >= kFewest;
  }

  /// Tells whether the reference may have reached its limit while the result, whose limit is
  /// `ratio` times as large, still sticks as both did from the start.
  bool awaits_limit(const Point& p, double ratio) const {
    constexpr double kNearLimit = 0.9;
    const double limit = ratio * p.r;
    return std::abs(p.r) >= kNearLimit * std::abs(*p.first_limit) &&
           p.f >= std::min(p.r, limit) - allowed(p) && p.f <= std::max(p.r, limit) + allowed(p);
  }

  std::optional<double> offset_everywhere() const {
    std::vector<double> differences;
    for (const Point& p : points_) {
      if (p.failing) differences.push_back(p.f - p.r);
    }
    const double offset = median(std::move(differences));
    if (!explains([&](const Point& p) { return p.r + offset; })) return std::nullopt;
    return offset;
  }

  /// In loops a stick branch starts from the limit, so it is off by as much, and near the limit one
  /// of the curves slips while the other one still sticks.
  std::optional<double> coefficient() const {
    constexpr double kExactInSlip = 0.8;
    constexpr double kOfFailing = 0.2;
    const auto ratio = ratio_of(kSlip, false);
    if (!ratio || !(ratio->value > 0.0)) return std::nullopt;
    const double most = (1.0 + kOfDeviation) * std::abs(ratio->value - 1.0) * ratio->largest +
                        kOfTolerance * scales_.tolerance;
    Count slipping, failing_slip, explained, before_slip;
    for (const Point& p : points_) {
      const bool exact = meets(p, ratio->value * p.r);
      if (p.status == kSlip) slipping.add(exact || p.failing);
      if (!p.failing) continue;
      const bool friction = p.status == kSlip || p.status == kStick;
      if (p.status == kSlip) failing_slip.add(exact);
      if (p.first_limit) before_slip.add(awaits_limit(p, ratio->value));
      explained.add(friction && ((exact && p.status == kSlip) || p.deviation() <= most));
    }
    const bool enough =
        static_cast<double>(failing_slip.points) >= kOfFailing * static_cast<double>(failing_);
    // However many points slip: what fails before the first slip is no matter of the limit.
    if (before_slip.wrong >= kFewest && before_slip.share() > kOutliers) return std::nullopt;
    if (!enough || failing_slip.share() > 1.0 - kExactInSlip || explained.share() > kOutliers ||
        slipping.share() > kOutliers) {
      return std::nullopt;
    }
    return ratio->value;
  }

  /// Returns where one of the curves has reached the limit and the other one has not, the result
  /// lies between the two lines; where both have, they agree.
  std::optional<double> stick_stiffness() const {
    constexpr double kExact = 0.6;
    const auto ratio = ratio_of(kStick, true);
    if (!ratio || !(ratio->value > 0.0)) return std::nullopt;
    Count sticking, slipping, exactly, explained;
    for (const Point& p : points_) {
      const double line = p.f0 + ratio->value * (p.r - p.r0);
      const double other = p.f0 + (p.r - p.r0);
      const bool exact = p.status == kStick && meets(p, line);
      const bool between =
          p.f >= std::min(line, other) - allowed(p) && p.f <= std::max(line, other) + allowed(p);
      if (p.status == kStick) sticking.add(exact || p.failing);
      if (p.status == kSlip) slipping.add(meets(p, p.r) || between);
      if (!p.failing) continue;
      exactly.add(exact);
      explained.add(exact || (between && (p.status == kStick || p.status == kSlip)));
    }
    if (exactly.share() > 1.0 - kExact || explained.share() > kOutliers ||
        sticking.share() > kOutliers || slipping.share() > kOutliers) {
      return std::nullopt;
    }
    return ratio->value;
  }

  /// The reference at a time; nothing outside of its range.
  std::optional<double> reference_at(double time) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), time,
                                       [](double t, const Point& p) { return t < p.at; });
    if (next == points_.begin()) return std::nullopt;
    const Point& a = *(next - 1);
    if (next == points_.end()) return time > a.at ? std::nullopt : std::optional<double>(a.r);
    return a.r + (time - a.at) / (next->at - a.at) * (next->r - a.r);
  }

  /// Returns how much later than the reference the result has the value of point `i`.
  std::optional<double> lateness(std::size_t i) const {
    const double wanted = points_[i].f;
    const auto crossing = [&](std::size_t k) -> std::optional<double> {
      const Point &a = points_[k], &b = points_[k + 1];
      if (a.r == b.r || (a.r < wanted && b.r < wanted) || (a.r > wanted && b.r > wanted)) {
        return std::nullopt;
      }
      return a.at + (wanted - a.r) / (b.r - a.r) * (b.at - a.at);
    };
    for (std::size_t away = 0; away < points_.size(); ++away) {
      std::optional<double> found;
      if (i + away + 1 < points_.size()) found = crossing(i + away);
      if (away < i) {
        const auto before = crossing(i - away - 1);
        if (before && (!found || points_[i].at - *before < *found - points_[i].at)) found = before;
      }
      if (found) return points_[i].at - *found;
    }
    return std::nullopt;
  }

  std::optional<double> delay() const {
    if (!scales_.over_time || failing_ < kFewestOfDelay) return std::nullopt;
    const auto earlier = [](const Point& a, const Point& b) { return a.at < b.at; };
    if (!std::is_sorted(points_.begin(), points_.end(), earlier)) return std::nullopt;

    constexpr std::size_t kProbes = 33;
    constexpr double kLargestShare = 0.2;  // of the time compared, and of the points left out
    const std::size_t stride = std::max<std::size_t>(1, failing_ / kProbes);
    std::vector<double> found;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!points_[i].failing || count++ % stride != 0) continue;
      if (const auto late = lateness(i)) found.push_back(*late);
    }
    if (found.size() < kFewest) return std::nullopt;
    const double late = median(std::move(found));
    if (late == 0.0 || std::abs(late) > kLargestShare * (points_.back().at - points_.front().at)) {
      return std::nullopt;
    }
    Count all, failing;
    for (const Point& p : points_) {
      const auto expected = reference_at(p.at - late);
      if (!expected) continue;
      const bool explained = meets(p, *expected);
      all.add(explained);
      if (p.failing) failing.add(explained);
    }
    const bool enough = static_cast<double>(failing.points) >=
                        (1.0 - kLargestShare) * static_cast<double>(failing_);
    if (!enough || all.share() > kOutliers || failing.share() > kOutliers) return std::nullopt;
    return late;
  }

  std::vector<Point> points_;
  const CauseScales& scales_;
  std::size_t failing_ = 0;
};

}  // namespace

std::string likely_cause(std::span<const CausePoint> points, const CauseScales& scales) {
  return Inquiry(prepared(points), scales).cause();
}

}  // namespace slipbench::driver::check
