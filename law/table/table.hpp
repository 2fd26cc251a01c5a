// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "law/base/notation.hpp"

namespace slipbench::law {

/// Independents one table may have: six motions, accumulated slip or slip rate and contact force,
/// temperature and all fields fit.
inline constexpr int kMaxIndependents = 2 * kComponents + 3 + kMaxFields;

enum class Extrapolation : std::uint8_t {
  kConstant,  ///< the end value holds outside the table, slope zero
  kLinear     ///< the end segment is prolonged
};

/// The most combinations of neighbouring points over which the extremes of a table of four
/// independents or more are looked for. A table whose blocks have the same points has one a row.
inline constexpr int kMostCorners = 2'000'000;

/// Fault of the rows of a table; `row` and `other_row` are 0-based.
struct TableError {
  enum class Kind : std::uint8_t {
    kNoRows,
    kRowLength,      ///< a row has not dependents + independents items
    kNotFinite,      ///< NaN or infinity in `row`
    kNotAscending,   ///< `row` goes back against `other_row` in independent `column`
    kRepeatedPoint,  ///< `row` repeats all independents of `other_row`
    kOneRowLinear,   ///< a block of one row cannot be extrapolated linearly
    kTooManyIndependents,
    kTooManyCorners  ///< blocks of four independents or more with too few points in common
  };
  Kind kind = Kind::kNoRows;
  int row = -1;
  int other_row = -1;
  int column = -1;
};

/// Place of a point along one independent of a table.
struct TableInterval {
  enum class Place : std::uint8_t { kInside, kBelow, kAbove };
  double lower = 0.0;  ///< neighbouring grid points; the same where the block has only one
  double upper = 0.0;
  /// Of the way from `lower` to `upper`, as used: 0 or 1 where the end value is held, outside
  /// [0, 1] where the end segment is prolonged.
  double fraction = 0.0;
  Place place = Place::kInside;
};

/// The cell a value is taken from.
struct TableCell {
  int independents = 0;
  std::array<TableInterval, kMaxIndependents> along{};
  /// True if the blocks between which the value is interpolated have different grids; `along` is
  /// of the block that counts for more.
  bool ragged = false;
};

/// A value of a table over at most two independents, made of four rows (of which some may be the
/// same) by lerp(lerp(row 0, row 1, f_0), lerp(row 2, row 3, f_1), f_2), lerp(a, b, f) = a + f (b -
/// a).
struct TableMix {
  std::array<std::size_t, 4> row{};
  std::array<double, 3> fraction{};
};

/// Piecewise linear table of any number of dependents over any number of independents, with ragged
/// blocks (docs/theory, section 9.1): the first independent varies fastest, every block of fixed
/// later independents has its own grid of the earlier ones. Interpolation runs inside the two
/// neighbouring blocks first and then between them, from the last independent inwards.
///
/// Evaluation is const, noexcept, and allocates nothing. The slope at a knot is the right-hand one.
class Table {
 public:
  Table() = default;

  /// Builds from rows of `dependents` values followed by the independents.
  /// \param rows row-major, each of `dependents + independents` numbers
  /// \param[out] error why there is no table; untouched on success
  /// \return true on success
  static bool build(std::span<const std::vector<double>> rows, int dependents, int independents,
                    Extrapolation extrapolation, Table* table, TableError* error);

  int dependents() const { return dependents_; }
  int independents() const { return static_cast<int>(levels_.size()); }
  Extrapolation extrapolation() const { return extrapolation_; }
  /// Tells whether it has two independents, and all blocks of the first the same points.
  bool is_grid() const { return is_grid_; }

  /// Returns how many rows it was built from; rows are numbered from 0 in the order given.
  std::size_t rows() const {
    return dependents_ > 0 ? ordinates_.size() / static_cast<std::size_t>(dependents_) : 0;
  }
  double ordinate(std::size_t row, int column = 0) const { return ordinates_[index(row, column)]; }
  /// \param value finite; whether it is admissible, the user of the table has to know
  void set_ordinate(std::size_t row, int column, double value);
  /// The independents of a row; for reading, not for the update path.
  std::vector<double> point(std::size_t row) const;
  /// Tells whether the other has the same points, dependents and extrapolation: all but the
  /// ordinates.
  bool same_grid(const Table& other) const;

  /// Value of dependent `column` at `x` (as many entries as independents) without slopes.
  double value(std::span<const double> x, int column = 0) const noexcept {
    if (levels_.size() == 1) return between(0, bracket(0, 0, x[0]), column);
    return is_grid_ ? grid_value(x[0], x[1], column) : ragged_value(x, column);
  }

  /// Returns what value() is made of, in all bits, whatever the ordinates; at most two
  /// independents.
  TableMix mix(std::span<const double> x) const noexcept;

  /// As value(), and adds the slope to each independent to `slopes` (same length as `x`),
  /// each multiplied by `weight`.
  double value_and_slopes(std::span<const double> x, std::span<double> slopes, int column = 0,
                          double weight = 1.0) const noexcept;

  /// Calls visit(row, weight) for every row that has a part in a value:
  ///   value(x, column) = sum of weight * ordinate(row, column),
  /// the weights being the slopes of the value to the ordinates. They sum to 1, and where the end
  /// segment is prolonged some are negative. At most two rows an independent are multiplied out.
  template <class Visit>
  void for_each_weight(std::span<const double> x, Visit visit) const {
    if (!ordinates_.empty()) weigh(independents() - 1, 0, x.data(), 1.0, visit);
  }

  /// All distinct coordinates of independent `k` over all blocks, ascending.
  std::span<const double> knots(int k) const { return levels_[static_cast<std::size_t>(k)].knots; }

  /// Smallest and largest ordinate of a dependent.
  double smallest(int column = 0) const;
  double largest(int column = 0) const { return largest_[static_cast<std::size_t>(column)]; }

  /// The most negative slope to independent `k` between neighbouring grid points (0 if none falls).
  /// \param[out] knot coordinate `k` of the cell's begin, if asked for and if something falls
  double steepest_fall(int k, int column = 0, double* knot = nullptr) const;

  /// The largest slope of y x_k to x_k, i.e. of y + x_k dy/dx_k, over all cells and at x_k = 0..:
  /// with y = mu and x_k = F_N, how fast a limiting force can grow with its normal force.
  /// \param[out] knot coordinate `k` of the cell's begin, if asked for
  double largest_growth(int k, int column = 0, double* knot = nullptr) const;

  /// The cell that `value` takes its result from; for reading, not for the update path.
  TableCell cell(std::span<const double> x) const noexcept;

  /// Tells whether some coordinate of `x` lies outside its (union) range.
  bool outside(std::span<const double> x) const noexcept;

 private:
  /// One independent. Block b of level k covers entries first[b] .. first[b+1]-1 of `x`;
  /// entry i of level k > 0 is block i of level k-1; entry i of level 0 is row i.
  struct Level {
    std::vector<double> x;
    std::vector<std::uint32_t> first;
    std::vector<double> knots;
  };

  std::size_t index(std::size_t row, int column) const {
    return row * static_cast<std::size_t>(dependents_) + static_cast<std::size_t>(column);
  }

  /// Finds the largest ordinate of a dependent anew, by a walk over all rows.
  void find_largest(int column);

  /// The entries of a block that a coordinate lies between, and how far along; the same entry twice
  /// where an end value is held.
  struct Bracket {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    double fraction = 0.0;
  };
  Bracket bracket(int level, std::uint32_t index, double v) const noexcept {
    const Level& here = levels_[static_cast<std::size_t>(level)];
    const std::uint32_t first = here.first[index];
    const std::uint32_t count = here.first[index + 1] - first;
    const double* grid = here.x.data() + first;
    if (extrapolation_ == Extrapolation::kConstant || count == 1) {
      if (count == 1 || v < grid[0]) return {first, first, 0.0};
      if (v >= grid[count - 1]) return {first + count - 1, first + count - 1, 0.0};
    }
    const std::uint32_t i = segment(grid, count, v);
    return {first + i, first + i + 1, (v - grid[i]) / (grid[i + 1] - grid[i])};
  }

  /// Index i of the segment [x_i, x_i+1] that holds v (right-hand at a knot), in 0 .. count-2.
  /// Tables of friction are short: a linear scan beats a binary search until some 32 points.
  static std::uint32_t segment(const double* x, std::uint32_t count, double v) noexcept {
    if (count > 32) {
      const double* const end = x + count - 1;
      return static_cast<std::uint32_t>(std::upper_bound(x + 1, end, v) - x) - 1;
    }
    // Counted to the end: where it stops is hard to foretell.
    std::uint32_t i = 0;
    for (std::uint32_t k = 1; k + 1 < count; ++k) i += v >= x[k] ? 1U : 0U;
    return i;
  }

  /// Value along a bracket of the first independent, whose rows begin `offset` further on.
  double between(std::uint32_t offset, const Bracket& b, int column) const noexcept {
    const double low = ordinates_[index(offset + b.low, column)];
    if (b.low == b.high) return low;
    return low + b.fraction * (ordinates_[index(offset + b.high, column)] - low);
  }
  double grid_value(double x, double y, int column) const noexcept {
    const Bracket along = bracket(0, 0, x);
    const Bracket across = bracket(1, 0, y);
    const std::uint32_t rows = levels_[0].first[1];
    const double low = between(across.low * rows, along, column);
    if (across.low == across.high) return low;
    return low + across.fraction * (between(across.high * rows, along, column) - low);
  }
  double ragged_value(std::span<const double> x, int column) const noexcept;

  template <class Visit>
  void weigh(int level, std::uint32_t index, const double* x, double weight, Visit& visit) const {
    if (level < 0) {
      visit(static_cast<std::size_t>(index), weight);
      return;
    }
    const Bracket b = bracket(level, index, x[level]);
    if (b.fraction != 1.0) weigh(level - 1, b.low, x, weight * (1.0 - b.fraction), visit);
    if (b.fraction != 0.0) weigh(level - 1, b.high, x, weight * b.fraction, visit);
  }

  TableInterval interval(int level, std::uint32_t index, double v) const noexcept;
  void find_cell(int level, std::uint32_t index, const double* x, TableCell* cell) const noexcept;

  /// Along the first independent: entries first .. first + count - 1.
  template <bool kSlopes>
  double line(std::uint32_t first, std::uint32_t count, double v, double weight, double* slope,
              int column) const noexcept;
  template <bool kSlopes>
  double block(int level, std::uint32_t index, const double* x, double weight, double* slopes,
               int column) const noexcept;

  /// Blocks of a level that have a part where for_each_corner is, and their knots.
  struct Front {
    std::vector<std::uint32_t> blocks;
    std::vector<double> knots;
  };

  /// Calls visit(x, next) at the corners of the pieces of the table, until it returns false: each
  /// coordinate of x is a knot of a block that has a part there, and x_k the begin of a cell that
  /// ends at `next` (infinity: at no knot). The slope to independent k on the right of x_k, and
  /// y + x_k dy/dx_k at both ends of the cell, have their extremes among those there. Up to three
  /// independents make about as many corners as rows, whatever their blocks are.
  /// \return true unless visit returned false
  template <class Visit>
  bool for_each_corner(int k, Visit visit) const;
  template <class Visit>
  bool descend(int level, int k, std::vector<Front>& fronts, std::vector<double>& x, double next,
               Visit& visit) const;

  int dependents_ = 0;
  Extrapolation extrapolation_ = Extrapolation::kConstant;
  bool is_grid_ = false;
  std::vector<Level> levels_;
  std::vector<double> ordinates_;  ///< row-major rows x dependents
  /// Largest ordinate of each dependent: exact integration asks for it in every increment.
  std::vector<double> largest_;
};

}  // namespace slipbench::law
