// SPDX-License-Identifier: Apache-2.0
#include "law/friction/coefficient_curve.hpp"

#include <algorithm>

#include "law/friction/radioss_coefficient.hpp"

namespace slipbench::law {
namespace {

/// The first place of the curve's formula where `curvature` changes its sign, or the floor holds or
/// ends, as a slip.
double next_of(const CoefficientCurve& curve, const SlipLine& line,
               const ExponentialSum& curvature) noexcept {
  const double from = standing(line);
  const double to = std::min(curve.until, 1.0);
  double next = first_sign_change(curvature, from, to);
  ExponentialSum above_floor = curve.numerator;
  if (curve.denominator.count == 0) {
    above_floor.add(polynomial({1.0}), -kCoefficientFloor);
  } else {
    above_floor.add(curve.denominator, -kCoefficientFloor);
  }
  next = std::min(next, first_sign_change(above_floor, from, std::min(next, to)));
  next = std::min(next, curve.until);
  return next <= 1.0 ? line.slip + next * (line.end - line.slip) : kNoBend;
}

}  // namespace

double next_bend(const CoefficientCurve& curve, const SlipLine& line) noexcept {
  const double span = line.end - line.slip;
  if (!(span > 0.0)) return kNoBend;
  const ExponentialSum force = polynomial({line.force, line.force_per_slip * span});
  if (curve.denominator.count == 0) {
    return next_of(curve, line, derivative(derivative(product(curve.numerator, force))));
  }
  // (-N/q)'' q^3 = N (q'' q - 2 q'^2) + 2 N' q' q.
  const ExponentialSum& q = curve.denominator;
  const ExponentialSum dq = derivative(q);
  ExponentialSum bending = product(derivative(dq), q);
  bending.add(product(dq, dq), -2.0);
  ExponentialSum curvature = product(force, bending);
  curvature.add(product(product(derivative(force), dq), q), 2.0);
  return next_of(curve, line, curvature);
}

double next_belt_bend(const CoefficientCurve& curve, const SlipLine& line, double wrap_angle,
                      FlowSense sense) noexcept {
  if (!(line.end > line.slip)) return kNoBend;
  const double square = sense == FlowSense::kForward ? wrap_angle : -wrap_angle;
  if (curve.denominator.count == 0) {
    const ExponentialSum slope = derivative(curve.numerator);
    ExponentialSum curvature = derivative(slope);
    curvature.add(product(slope, slope), square);
    return next_of(curve, line, curvature);
  }
  // mu' = d q'/q^2, mu'' = d (q'' q - 2 q'^2)/q^3: both over q^4/d.
  const ExponentialSum& q = curve.denominator;
  const ExponentialSum dq = derivative(q);
  ExponentialSum bending = product(derivative(dq), q);
  bending.add(product(dq, dq), -2.0);
  ExponentialSum curvature = product(bending, q);
  curvature.add(product(dq, dq), square * curve.recovery);
  return next_of(curve, line, curvature);
}

}  // namespace slipbench::law
