// SPDX-License-Identifier: Apache-2.0
#include "law/exact/exact_segment.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::law {
namespace {

/// tan(psi/2) below which nothing is left beside the motion: on its way to 0 it would lose its
/// digits, and vanish, sooner or later as the units are.
constexpr double kNothingBeside = 1e-100;

}  // namespace

HalfAngle half_angle(const PlaneSlip& slip) noexcept {
  const double length = std::sqrt(slip.square());
  if (!(length > 0.0)) return {};
  // Of the two forms of each, the one whose sum does not cancel.
  if (slip.along >= 0.0) {
    const double cosine = std::sqrt(0.5 * (length + slip.along) / length);
    return {cosine, 0.5 * slip.across / (length * cosine)};
  }
  const double sine = std::sqrt(0.5 * (length - slip.along) / length);
  return {0.5 * slip.across / (length * sine), sine};
}

HalfAngle turned(const HalfAngle& from, double turn) noexcept {
  // Straight on, or straight back, nothing turns; `turn` may be infinite then.
  if (from.sine == 0.0 || from.cosine == 0.0) return from;
  const double sine = from.sine * std::exp(-turn);
  if (sine < kNothingBeside * from.cosine) return {};
  const double norm = std::sqrt(from.cosine * from.cosine + sine * sine);
  return {from.cosine / norm, sine / norm};
}

PlaneSlip on_radius(const HalfAngle& angle, double radius) noexcept {
  return {radius * angle.cosine_of_angle(), radius * angle.sine_of_angle()};
}

double stick_length(const PlaneSlip& slip, double radius) noexcept {
  const double reserve = std::max(radius * radius - slip.square(), 0.0);
  const double root = std::sqrt(slip.along * slip.along + reserve);
  return slip.along > 0.0 ? reserve / (slip.along + root) : root - slip.along;
}

double segment_slip(const HalfAngle& from, double travel, double radius) noexcept {
  const double decay = std::expm1(-2.0 * travel / radius);  // exp(-2 r/R) - 1
  return std::max(travel + radius * std::log1p(from.sine * from.sine * decay), 0.0);
}

SegmentEnd exact_segment(const PlaneSlip& begin, double travel, double radius) noexcept {
  SegmentEnd end;
  end.stick = stick_length(begin, radius);
  if (!(travel > end.stick)) {
    end.stick = travel;
    end.elastic_slip = {begin.along + travel, begin.across};
    return end;
  }
  const double rest = travel - end.stick;
  const HalfAngle onset = half_angle({begin.along + end.stick, begin.across});
  end.slip = segment_slip(onset, rest, radius);
  end.elastic_slip = on_radius(turned(onset, rest / radius), radius);
  return end;
}

}  // namespace slipbench::law
