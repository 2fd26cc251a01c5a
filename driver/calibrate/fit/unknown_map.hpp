// SPDX-License-Identifier: Apache-2.0
// Unknowns with bounds, scales and shapes as functions of coordinates that have none of these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "driver/calibrate/fit/convex_step.hpp"
#include "driver/calibrate/fit/fold.hpp"
#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// Change of the unknowns with one coordinate: pairs of an unknown and dx/dz.
using CoordinateColumn = std::vector<std::pair<std::size_t, double>>;

/// Distance from a fold below which a coordinate is on it: 2e-9 of the way between two bounds.
inline constexpr double kOnFold = 1e-4;

/// x(z). A scalar unknown has one coordinate (see fold.hpp; the logarithm is folded where the scale
/// is one). The ordinates of a shaped block share as many coordinates, each ordinate moving between
/// limits that those before it leave (triangular; docs/theory, section 17):
/// - ascending: between the ordinate before it and the upper bound; descending: from the far end;
/// - convex: the first ordinate, the last one, then each between the extension of the last interval
///   and the chord to the last ordinate; concave: the same of -x. Curved blocks are searched
///   linearly whatever their scale, since a logarithm would keep another shape.
/// The bounds of a block are the tightest of its ordinates'.
class UnknownMap {
 public:
  enum class Unbounded : std::uint8_t {
    kLinear,     ///< an unknown without bounds is its own coordinate
    kMagnitudes  ///< one whose start is not 0 keeps its sign, its logarithm is the coordinate
  };
  /// \param frozen unknowns that keep their value and have no coordinate; one inside a shaped block
  ///        gives way only as far as the shape demands
  /// \param kept the values of the frozen ones, one an unknown; empty: their starts
  UnknownMap(const ResidualProblem& problem, std::span<const char> frozen,
             Unbounded unbounded = Unbounded::kLinear, std::span<const double> kept = {});

  /// Tells whether searching magnitudes makes a difference.
  static bool has_magnitudes(const ResidualProblem& problem);

  /// Number of coordinates.
  std::size_t size() const { return size_; }

  /// The coordinates of x, moved inside where x is on a bound or beyond, or does not have its
  /// shape. What is alone and inside, be it by little, stays where it is.
  /// \param inset how far inside, in coordinates
  std::vector<double> coordinates(std::span<const double> x, double inset) const;

  /// x(z), all unknowns, the frozen ones too.
  void unknowns(std::span<const double> z, std::span<double> x) const;

  /// dx/dz of every coordinate; for those `held` at a fold the change on the way inside instead.
  std::vector<CoordinateColumn> columns(std::span<const double> z,
                                        std::span<const char> held) const;

  /// Returns what bounds and shapes demand of the unknowns that are not frozen.
  std::vector<Inequality> inequalities() const;

  /// Tells whether a coordinate is one of a shaped block.
  std::vector<char> shaped() const;

  /// The nearest fold of every coordinate, whose principal value replaces it in z.
  std::vector<FoldPoint> folds(std::span<double> z) const;

 private:
  struct Piece {
    std::vector<std::size_t> unknown;  ///< in ascending order of the canonical shape
    std::vector<double> abscissa;
    bool log = false;
    bool ascending = false;
    bool convex = false;
    double sign = 1.0;
    double lower = 0.0;  ///< canonical
    double upper = 0.0;
    double unit = 1.0;
    std::size_t first = 0;  ///< coordinate
  };
  Piece scalar_piece(std::size_t unknown, Unbounded unbounded) const;
  Piece block_piece(const ShapedBlock& block, std::span<const char> frozen) const;
  void settle_frozen(const ShapedBlock& block, std::span<double> x) const;
  template <typename Choose>
  void walk(const Piece& piece, std::span<double> y, std::vector<double>* slopes,
            const Choose& choose) const;

  const ResidualProblem* problem_;
  std::vector<char> frozen_;
  std::vector<double> kept_;
  std::vector<Piece> pieces_;
  std::size_t size_ = 0;
};

}  // namespace slipbench::driver::fit
