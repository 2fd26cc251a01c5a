// SPDX-License-Identifier: Apache-2.0
// Bounded nonlinear least squares: what is asked, and what comes back. Knows nothing of cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/calibrate/fit/run_items.hpp"

namespace slipbench::driver::fit {

/// In what an unknown is searched.
enum class Scale : std::uint8_t { kLinear, kLog };

/// Start, bounds and scale of one unknown, in its natural unit.
struct UnknownRange {
  double start = 0.0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  Scale scale = Scale::kLinear;  ///< kLog needs 0 < start, 0 <= lower
};

/// Order that a row of unknowns, the ordinates of a curve, has to keep.
struct Shape {
  enum class Monotone : std::uint8_t { kFree, kIncreasing, kDecreasing } monotone = Monotone::kFree;
  enum class Curvature : std::uint8_t { kFree, kConvex, kConcave } curvature = Curvature::kFree;
  bool any() const { return monotone != Monotone::kFree || curvature != Curvature::kFree; }
};

/// Unknowns first .. first + count - 1 are the ordinates of one curve over `abscissa`.
struct ShapedBlock {
  std::size_t first = 0;
  std::size_t count = 0;
  std::vector<double> abscissa;  ///< as many, ascending
  Shape shape;
};

/// Weight of a residual r: the cost is the sum of rho(r^2)/2 (docs/theory, section 17).
struct Loss {
  enum class Kind : std::uint8_t { kSquares, kHuber, kSoftL1 } kind = Kind::kSquares;
  double threshold = 1.0;  ///< residual at which it turns from squares to magnitudes, > 0
};

/// Residuals r(x) over natural unknowns x. A start on a bound, beyond it, or without its block's
/// shape, is moved inside.
struct ResidualProblem {
  std::size_t rows = 0;
  /// The first rows are compared with data; rows beyond (smoothness) always count as squares and
  /// are no data for the statistics.
  std::size_t data_rows = 0;
  std::vector<UnknownRange> unknowns;
  std::vector<ShapedBlock> shapes;
  Loss loss;
  /// r(x), `rows` numbers. False: the model has no value there.
  /// Called from at most `threads` threads at a time, and not beside `derivatives`.
  std::function<bool(std::span<const double> x, std::span<double> r)> residuals;
  /// r(x) and dr/dx, row-major rows x unknowns; empty: central differences of `residuals`.
  std::function<bool(std::span<const double> x, std::span<double> r, std::span<double> jacobian)>
      derivatives;
  /// Effort of `derivatives`, in calls of `residuals`. Where that is little, points are tried with
  /// derivatives at once.
  double derivative_effort = 2.0;
  /// First row of every response, ascending, within the data: rows of one response follow each
  /// other in time and have one noise. Empty: all data are one response.
  std::vector<std::size_t> groups = {};
  /// Singular values of the Jacobian below this part of the largest (columns of unit length) are no
  /// more than the error of `derivatives`.
  double derivative_accuracy = 1e-12;
  unsigned threads = 1;  ///< that may call `residuals` at once, where that is worth it
  /// Starts of a search, resamplings and profiles; empty: here, one after the other.
  RunItems items = {};
};

struct SolverOptions {
  int starts = 1;          ///< 1: from the given start only; more: a low-discrepancy set besides
  std::uint64_t seed = 1;  ///< of the set, and of resamplings
  /// Of each search; a start that is lost is searched from up to 4 times. What converges at all
  /// from a sensible start takes tens; of NIST's problems, from their far starts, three take 280 to
  /// 560.
  int most_iterations = 1000;
  double step_tolerance = 1e-10;      ///< of the step, as a part of the unknowns
  double gradient_tolerance = 1e-10;  ///< of the scaled gradient, see LeastSquaresFit
  bool polish = true;                 ///< a derivative-free polish where kinks defeat the gradient
};

/// Reason why a search ended.
enum class StopReason : std::uint8_t {
  kStep,          ///< the steps have become negligible
  kGradient,      ///< the gradient has become negligible
  kCost,          ///< the cost has become rounding
  kIterations,    ///< the most iterations allowed
  kNoProgress,    ///< no step lowers the cost any more
  kZeroGradient,  ///< nothing that is varied changes any residual at the start
  kNoIteration,   ///< nothing was gained at all: the start is a minimum, or a kink
  kModelFailure,  ///< the model has no value at the start
  kTooFewData,    ///< fewer rows than unknowns
  kSilent         ///< an unknown has no effect at the end, though it has one elsewhere
};
/// Tells whether a search that ended so may be called converged.
bool is_convergence(StopReason reason);
/// A sentence for the user, which says what to look at where it is no convergence. Whether it is
/// one is left to is_convergence.
std::string stop_text(StopReason reason);

/// One search from one start.
struct SearchTrace {
  std::vector<double> start;
  std::vector<double> end;
  double start_cost = 0.0;
  double cost = 0.0;
  int iterations = 0;
  StopReason stop = StopReason::kNoIteration;
};

/// Findings of a fit.
struct LeastSquaresFit {
  std::vector<double> x;  ///< the best point, natural unknowns
  double start_cost = 0.0;
  double cost = 0.0;  ///< sum of rho(r^2)/2 over all rows
  StopReason stop = StopReason::kNoIteration;
  bool converged = false;
  std::string stop_sentence;
  int iterations = 0;             ///< of the best search
  long residual_evaluations = 0;  ///< of all
  long derivative_evaluations = 0;
  /// Part of the weighted residuals that lies in the range of the Jacobian, |Q^T f|/|f|: 0 at a
  /// minimum, whatever the units and the scales of the unknowns (docs/theory, section 17).
  double gradient_norm = 0.0;
  bool polished = false;          ///< the polish lowered the cost
  std::vector<double> residuals;  ///< at x
  std::vector<double> jacobian;   ///< dr/dx at x, row-major, natural unknowns
  std::vector<double> weights;    ///< of each row, 1 unless the loss is robust: rho'
  std::vector<char> frozen;       ///< unknowns no residual depends on: kept at their start
  std::vector<char> at_lower;     ///< unknowns that ended at a bound
  std::vector<char> at_upper;
  std::vector<char> moved_inside;  ///< unknowns whose start was on or beyond a bound, or not of
                                   ///< the wanted shape, and was moved in
  /// One a start, the given one first; behind them those from values at which unknowns that have no
  /// effect at their start, or at the end, have one.
  std::vector<SearchTrace> searches;
  /// Unknowns outside of curves that no residual depends on at x, though residuals do elsewhere.
  std::vector<char> silent = {};
};

/// Finds the least cost: GSL's trust region (Levenberg-Marquardt) on transformed unknowns, from
/// every start; robust losses by reweighting; steps by QR at the end, bounds held exactly. Errors
/// are stop reasons, never exceptions. Bounds of one unknown must differ, lower < upper. Keeps no
/// state; GSL's error handler is off from the first call on, for the whole program.
LeastSquaresFit solve_least_squares(const ResidualProblem& problem, const SolverOptions& options);

}  // namespace slipbench::driver::fit
