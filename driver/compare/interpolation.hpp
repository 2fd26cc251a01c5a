// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "driver/compare/branches.hpp"
#include "driver/compare/common_range.hpp"
#include "driver/compare/series.hpp"

namespace slipbench::driver {

/// The value of a curve at one place, and the time, NaN where it is not known.
struct Interpolated {
  double value = 0.0;
  double time = 0.0;
};

/// Appends row `i` of a curve, or what is `fraction` of the way from it to the next one: abscissa,
/// value and time.
void append_between(Series& to, const Series& curve, std::size_t i, double fraction);

/// Reads one branch of a curve between its rows. Abscissas that differ by no more than a slack are
/// the same place.
class BranchInterpolation {
 public:
  /// `curve` must outlive it.
  BranchInterpolation(const Series& curve, const Branch& branch, double slack);

  /// At an abscissa, linearly between rows; nothing outside of the branch. Where there are several
  /// rows at this place, the value nearest to `wanted` that one of them has, or that lies between
  /// two of them if time passes between these. Costs the logarithm of the rows, but for the first
  /// question about a place with many rows.
  std::optional<Interpolated> at(double abscissa, double wanted);

 private:
  void gather_place(std::size_t from, std::size_t to);
  Interpolated row(std::size_t i) const;

  const Series* curve_;
  Branch branch_;
  double slack_;
  std::vector<double> way_;  ///< the branch's abscissas times its direction, never decreasing

  /// What the curve does at the place asked for last: rows of `way_`, their values in order, and
  /// ranges of values it goes through.
  std::size_t place_from_ = 0;
  std::size_t place_to_ = 0;
  std::vector<std::pair<double, std::size_t>> values_;
  std::vector<Interval> traversed_;
};

}  // namespace slipbench::driver
