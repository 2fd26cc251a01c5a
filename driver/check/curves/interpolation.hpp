// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The value of a curve at one place, and the time, NaN where it is not known.
struct Interpolated {
  double value = 0.0;
  double time = 0.0;
};

/// Appends row `i` of a curve, or what is `fraction` of the way from it to the next one: abscissa,
/// value and time.
void append_between(Series& to, const Series& curve, std::size_t i, double fraction);

/// Reads one branch of a curve between its rows. Abscissas that differ by no more than a slack are
/// the same place; a place in which time passes is a rest.
class BranchInterpolation {
 public:
  /// `curve` must outlive it.
  BranchInterpolation(const Series& curve, const Branch& branch, double slack);

  /// At an abscissa, linearly between rows; nothing outside of the branch. Where there are several
  /// rows at this place, the value nearest to `wanted` that one of them has, or that lies between
  /// two of them if time passes between these.
  ///
  /// No further than one increment away from a rest, which is where a row of another curve may find
  /// itself whose rest lies elsewhere by its own increments, the values count that the curve has
  /// between this abscissa and the rest, and those of the rest with the increments beside it.
  /// `reach`, of a row where the other curve rests itself, widens this increment.
  ///
  /// Costs the logarithm of the rows, but for the first question about a place with many rows.
  std::optional<Interpolated> at(double abscissa, double wanted, double reach = 0.0);

  /// Tells whether a row may be met by a rest: only then `reach` matters.
  bool has_rests() const { return rests_possible_; }

  /// Matches rests: where the other curve has several rows in the place of a rest, too, the two do
  /// not lie apart, and rows beside this rest are not met by it.
  void match_rests(const Series& other, const Branch& branch);

 private:
  /// Rows [from, to) of `way_` that lie in one place, at least two.
  struct Place {
    std::size_t from = 0;
    std::size_t to = 0;
  };
  /// Course of the curve in a place: its values in order, and the ranges of values it goes through
  /// while time passes, in order and apart.
  struct PlaceValues {
    std::size_t from = 0;
    std::size_t to = 0;
    std::vector<std::pair<double, std::size_t>> values;
    std::vector<Interval> traversed;
  };
  /// The values of rows [from, to).
  struct Passage {
    std::size_t from = 0;
    std::size_t to = 0;
    Interval values;
  };
  class Nearest;

  void find_places();
  bool is_rest(const Place& place) const;
  const PlaceValues& gathered(const Place& place);
  void offer_place(const Place& place, Nearest& nearest);
  void offer_rest(const Place& rest, Nearest& nearest);
  bool offer_window(std::size_t from, std::size_t to, double reach, Nearest& nearest);
  void offer_rests(double way, std::size_t from, std::size_t to, double reach, Nearest& nearest);
  Interval passed(std::size_t from, std::size_t to);
  Interpolated row(std::size_t i) const;
  bool time_passes(std::size_t from, std::size_t to) const;

  const Series* curve_;
  Branch branch_;
  double slack_;
  std::vector<double> way_;  ///< the branch's abscissas times its direction, never decreasing
  std::vector<Place> places_;
  std::vector<Place> rests_;  ///< those that lie apart from the other curve's, once it is known
  bool rests_possible_ = false;

  /// Answers are asked for in the order of a curve: the latest few are kept.
  std::array<PlaceValues, 4> kept_;
  std::size_t next_kept_ = 0;
  std::array<Passage, 2> kept_passages_;
  std::size_t next_passage_ = 0;
};

}  // namespace slipbench::driver::check
