// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// A curve whose abscissa never decreases; two rows in the same place are a jump.
struct AscendingCurve {
  std::vector<double> at;
  std::vector<double> value;
};

/// Common part of two curves, of an abscissa that does not turn.
struct AscendingCurves {
  std::string fault;  ///< why the two cannot be compared; empty if they can
  AscendingCurve result;
  AscendingCurve reference;
  Interval interval;
  std::int64_t compared = 0;  ///< rows of the reference in it
};

/// Cuts both curves to their common range and turns the ones that run downwards.
/// Faults: those of common_range, an abscissa that goes back and forth, a range of one point only.
AscendingCurves ascending_curves(const Series& result, const Series& reference);

/// Reads a curve from left to right, linearly between its rows.
class AscendingReader {
 public:
  /// `curve`, not empty, must outlive it.
  explicit AscendingReader(const AscendingCurve& curve) : curve_(&curve) {}

  /// Moves on to the segment that begins at or before `x` and ends beyond it.
  void advance(double x) {
    while (next_ < curve_->at.size() && curve_->at[next_] <= x) ++next_;
  }
  /// Returns where the next row is; the last one's place after the end.
  double next() const { return next_ < curve_->at.size() ? curve_->at[next_] : curve_->at.back(); }
  /// The value at a place of the present segment; that of the nearest row outside of the curve.
  double operator()(double x) const {
    if (next_ == 0) return curve_->value.front();
    if (next_ == curve_->at.size()) return curve_->value.back();
    const double x0 = curve_->at[next_ - 1], x1 = curve_->at[next_];
    const double y0 = curve_->value[next_ - 1], y1 = curve_->value[next_];
    if (x >= x1) return y1;
    const double part = (x - x0) / (x1 - x0);
    return (1.0 - part) * y0 + part * y1;
  }

 private:
  const AscendingCurve* curve_;
  std::size_t next_ = 0;  ///< the first row beyond the present place
};

/// Calls `visit(width, f0, f1, r0, r1)` for each interval in which both curves are straight, with
/// their values at its two ends.
template <class Visit>
void for_each_piece(const AscendingCurves& curves, Visit&& visit) {
  AscendingReader f(curves.result), r(curves.reference);
  double from = curves.interval.from;
  while (from < curves.interval.to) {
    f.advance(from);
    r.advance(from);
    double to = curves.interval.to;
    if (f.next() > from) to = std::min(to, f.next());
    if (r.next() > from) to = std::min(to, r.next());
    visit(to - from, f(from), f(to), r(from), r(to));
    from = to;
  }
}

/// The means of a curve over `n` equal parts of an interval that it covers.
std::vector<double> cell_means(const AscendingCurve& curve, const Interval& interval,
                               std::size_t n);

}  // namespace slipbench::driver::check
