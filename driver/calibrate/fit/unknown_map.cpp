// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/unknown_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/calibrate/fit/shape_projection.hpp"

namespace slipbench::driver::fit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double safe_log(double x) { return x > 0.0 ? std::log(x) : -kInfinity; }

/// An unknown that may be searched by its logarithm although its scale is linear.
bool is_magnitude(const UnknownRange& range) {
  return range.scale == Scale::kLinear && range.start != 0.0 && !std::isfinite(range.lower) &&
         !std::isfinite(range.upper);
}

/// The coordinates of a convex piece belong to the first ordinate, the last, then the others.
std::size_t ordinate_of(bool convex, std::size_t step, std::size_t count) {
  if (!convex || step == 0) return step;
  return step == 1 ? count - 1 : step - 1;
}

}  // namespace

UnknownMap::UnknownMap(const ResidualProblem& problem, std::span<const char> frozen,
                       Unbounded unbounded, std::span<const double> kept)
    : problem_(&problem), frozen_(frozen.begin(), frozen.end()), kept_(kept.begin(), kept.end()) {
  if (kept_.empty()) {
    for (const UnknownRange& range : problem.unknowns) kept_.push_back(range.start);
  }
  std::vector<char> shaped(problem.unknowns.size(), 0);
  for (const ShapedBlock& block : problem.shapes) {
    if (!block.shape.any()) continue;
    for (std::size_t k = 0; k < block.count; ++k) shaped[block.first + k] = 1;
    Piece piece = block_piece(block, frozen);
    if (!piece.unknown.empty()) pieces_.push_back(std::move(piece));
  }
  for (std::size_t j = 0; j < problem.unknowns.size(); ++j) {
    if (shaped[j] == 0 && frozen_[j] == 0) pieces_.push_back(scalar_piece(j, unbounded));
  }
  std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
    return *std::min_element(a.unknown.begin(), a.unknown.end()) <
           *std::min_element(b.unknown.begin(), b.unknown.end());
  });
  for (Piece& piece : pieces_) {
    piece.first = size_;
    size_ += piece.unknown.size();
  }
}

bool UnknownMap::has_magnitudes(const ResidualProblem& problem) {
  std::vector<char> shaped(problem.unknowns.size(), 0);
  for (const ShapedBlock& block : problem.shapes) {
    if (!block.shape.any()) continue;
    for (std::size_t k = 0; k < block.count; ++k) shaped[block.first + k] = 1;
  }
  for (std::size_t j = 0; j < shaped.size(); ++j) {
    if (shaped[j] == 0 && is_magnitude(problem.unknowns[j])) return true;
  }
  return false;
}

UnknownMap::Piece UnknownMap::scalar_piece(std::size_t unknown, Unbounded unbounded) const {
  const UnknownRange& range = problem_->unknowns[unknown];
  Piece piece;
  piece.unknown = {unknown};
  piece.abscissa = {0.0};
  if (unbounded == Unbounded::kMagnitudes && is_magnitude(range)) {
    piece.log = true;
    piece.sign = range.start < 0.0 ? -1.0 : 1.0;
    piece.lower = -kInfinity;
    piece.upper = kInfinity;
    return piece;
  }
  piece.log = range.scale == Scale::kLog;
  piece.lower = piece.log ? safe_log(range.lower) : range.lower;
  piece.upper = piece.log ? safe_log(range.upper) : range.upper;
  if (!piece.log) {
    const double bound = std::isfinite(range.lower) ? range.lower : range.upper;
    const double way = std::abs(range.start - bound);
    if (std::isfinite(way) && way > 0.0) {
      piece.unit = way;
    } else if (std::isfinite(bound) && bound != 0.0) {
      piece.unit = std::abs(bound);
    }
  }
  return piece;
}

UnknownMap::Piece UnknownMap::block_piece(const ShapedBlock& block,
                                          std::span<const char> frozen) const {
  Piece piece;
  const Shape& shape = block.shape;
  piece.convex = shape.curvature != Shape::Curvature::kFree;
  piece.ascending = shape.monotone != Shape::Monotone::kFree;
  piece.sign = shape.curvature == Shape::Curvature::kConcave ? -1.0 : 1.0;
  piece.lower = -kInfinity;
  piece.upper = kInfinity;
  double size = 0.0;
  bool all_log = !piece.convex;
  for (std::size_t k = 0; k < block.count; ++k) {
    const std::size_t j = block.first + k;
    const UnknownRange& range = problem_->unknowns[j];
    piece.lower = std::max(piece.lower, range.lower);
    piece.upper = std::min(piece.upper, range.upper);
    size = std::max(size, std::abs(range.start));
    all_log = all_log && range.scale == Scale::kLog;
    if (frozen[j] != 0) continue;
    piece.unknown.push_back(j);
    piece.abscissa.push_back(block.abscissa[k]);
  }
  piece.log = all_log;
  if (piece.log) {
    piece.lower = safe_log(piece.lower);
    piece.upper = safe_log(piece.upper);
    size = 1.0;
  }
  if (piece.sign < 0.0) {
    std::swap(piece.lower, piece.upper);
    piece.lower = -piece.lower;
    piece.upper = -piece.upper;
  }
  piece.unit =
      (size > 0.0 ? size : 1.0) / static_cast<double>(std::max<std::size_t>(block.count, 1));
  // Descending sequences are ascending ones from the far end; concave ones turn over, and so does
  // their sense.
  const bool falls = (shape.monotone == Shape::Monotone::kDecreasing) != (piece.sign < 0.0);
  if (piece.ascending && falls) {
    std::reverse(piece.unknown.begin(), piece.unknown.end());
    std::reverse(piece.abscissa.begin(), piece.abscissa.end());
    for (double& a : piece.abscissa) a = -a;
  }
  return piece;
}

/// Goes through the ordinates in the order of their coordinates.
/// \param choose gives the ordinate and its slopes from (step, ordinate, limits)
/// \param[out] slopes dy/dz, row-major ordinates x steps
template <typename Choose>
void UnknownMap::walk(const Piece& piece, std::span<double> y, std::vector<double>* slopes,
                      const Choose& choose) const {
  const std::size_t n = piece.unknown.size();
  if (slopes != nullptr) slopes->assign(n * n, 0.0);
  const auto add_row = [&](std::size_t to, double factor, std::size_t from) {
    if (slopes == nullptr || factor == 0.0) return;
    for (std::size_t i = 0; i < n; ++i) (*slopes)[to * n + i] += factor * (*slopes)[from * n + i];
  };
  const std::vector<double>& a = piece.abscissa;
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t k = ordinate_of(piece.convex, step, n);
    Limits limits{piece.lower, piece.upper, piece.unit};
    enum class Floor { kBound, kBefore, kExtension } floor = Floor::kBound;
    double chord = 0.0;  // part of the way to the last ordinate
    double extension = 0.0;
    if (!piece.convex) {
      if (piece.ascending && k > 0) floor = Floor::kBefore;
    } else if (step == 1) {
      if (piece.ascending) floor = Floor::kBefore;
    } else if (step > 1) {
      chord = (a[k] - a[k - 1]) / (a[n - 1] - a[k - 1]);
      limits.upper = y[k - 1] + chord * (y[n - 1] - y[k - 1]);
      if (piece.ascending && k == 1) floor = Floor::kBefore;
      if (k > 1) {
        extension = (a[k] - a[k - 1]) / (a[k - 1] - a[k - 2]);
        const double extended = y[k - 1] + extension * (y[k - 1] - y[k - 2]);
        if (extended > limits.lower) {
          floor = Floor::kExtension;
          limits.lower = extended;
        }
      }
    }
    const std::size_t before = piece.convex && step == 1 ? 0 : k - (k > 0 ? 1 : 0);
    if (floor == Floor::kBefore) limits.lower = y[before];
    limits.upper = std::max(limits.upper, limits.lower);
    const Folded folded = choose(step, k, limits);
    y[k] = folded.value;
    if (floor == Floor::kBefore) add_row(k, folded.by_lower, before);
    if (floor == Floor::kExtension) {
      add_row(k, folded.by_lower * (1.0 + extension), k - 1);
      add_row(k, -folded.by_lower * extension, k - 2);
    }
    if (chord > 0.0) {
      add_row(k, folded.by_upper * (1.0 - chord), k - 1);
      add_row(k, folded.by_upper * chord, n - 1);
    }
    if (slopes != nullptr) (*slopes)[k * n + step] += folded.by_coordinate;
  }
}

std::vector<double> UnknownMap::coordinates(std::span<const double> x, double inset) const {
  std::vector<double> z(size_);
  for (const Piece& piece : pieces_) {
    const std::size_t n = piece.unknown.size();
    std::vector<double> target(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double value = x[piece.unknown[k]];
      target[k] = piece.sign * value;
      if (piece.log) target[k] = std::log(std::max(target[k], std::numeric_limits<double>::min()));
    }
    if (n > 1) {
      if (piece.ascending) target = nearest_ascending(target);
      if (piece.convex) target = nearby_convex(piece.abscissa, target);
    }
    std::vector<double> y(n);
    walk(piece, y, nullptr, [&](std::size_t step, std::size_t k, const Limits& limits) {
      double& coordinate = z[piece.first + step];
      coordinate = unfold(limits, target[k], inset);
      if (n == 1 && limits.any() && inset > kOnFold) {
        const double own = unfold(limits, target[k], 0.0);
        if (nearest_fold(limits, own).distance >= kOnFold) coordinate = own;
      }
      return fold(limits, coordinate);
    });
  }
  return z;
}

void UnknownMap::unknowns(std::span<const double> z, std::span<double> x) const {
  for (std::size_t j = 0; j < frozen_.size(); ++j) {
    if (frozen_[j] != 0) x[j] = kept_[j];
  }
  std::vector<double> y;
  for (const Piece& piece : pieces_) {
    y.resize(piece.unknown.size());
    walk(piece, y, nullptr, [&](std::size_t step, std::size_t, const Limits& limits) {
      return fold(limits, z[piece.first + step]);
    });
    for (std::size_t k = 0; k < y.size(); ++k) {
      const std::size_t j = piece.unknown[k];
      const UnknownRange& range = problem_->unknowns[j];
      x[j] = piece.sign * (piece.log ? std::exp(y[k]) : y[k]);
      // exp(log(bound)) need not be the bound
      if (piece.log) x[j] = std::clamp(x[j], range.lower, range.upper);
    }
  }
  for (const ShapedBlock& block : problem_->shapes) {
    if (block.shape.any()) settle_frozen(block, x);
  }
}

void UnknownMap::settle_frozen(const ShapedBlock& block, std::span<double> x) const {
  const auto frozen = [&](std::size_t k) { return frozen_[block.first + k] != 0; };
  const double turn = block.shape.monotone == Shape::Monotone::kDecreasing ? -1.0 : 1.0;
  const double sign = block.shape.curvature == Shape::Curvature::kConcave ? -1.0 : 1.0;
  const std::vector<double>& a = block.abscissa;
  std::vector<std::size_t> left;  // settled ones so far
  for (std::size_t k = 0; k < block.count; ++k) {
    double& value = x[block.first + k];
    if (frozen(k)) {
      std::vector<std::size_t> right;
      for (std::size_t i = k + 1; i < block.count && right.size() < 2; ++i) {
        if (!frozen(i)) right.push_back(i);
      }
      const auto at = [&](std::size_t i) { return x[block.first + i]; };
      const auto line = [&](std::size_t i, std::size_t j) {
        return at(i) + (at(j) - at(i)) / (a[j] - a[i]) * (a[k] - a[i]);
      };
      if (block.shape.curvature != Shape::Curvature::kFree) {
        const std::size_t l = left.size();
        if (l > 1) value = sign * std::max(sign * value, sign * line(left[l - 2], left[l - 1]));
        if (right.size() > 1)
          value = sign * std::max(sign * value, sign * line(right[0], right[1]));
        if (l > 0 && !right.empty()) {
          value = sign * std::min(sign * value, sign * line(left[l - 1], right[0]));
        }
      }
      if (block.shape.monotone != Shape::Monotone::kFree) {
        if (!left.empty()) value = turn * std::max(turn * value, turn * at(left.back()));
        if (!right.empty()) value = turn * std::min(turn * value, turn * at(right[0]));
      }
      const UnknownRange& range = problem_->unknowns[block.first + k];
      value = std::clamp(value, range.lower, range.upper);
    }
    left.push_back(k);
  }
}

std::vector<CoordinateColumn> UnknownMap::columns(std::span<const double> z,
                                                  std::span<const char> held) const {
  std::vector<CoordinateColumn> columns(size_);
  std::vector<double> y;
  std::vector<double> slopes;
  for (const Piece& piece : pieces_) {
    const std::size_t n = piece.unknown.size();
    y.resize(n);
    walk(piece, y, &slopes, [&](std::size_t step, std::size_t, const Limits& limits) {
      const std::size_t c = piece.first + step;
      Folded folded = fold(limits, z[c]);
      if (held[c] != 0) folded.by_coordinate = nearest_fold(limits, z[c]).slope;
      return folded;
    });
    for (std::size_t k = 0; k < n; ++k) {
      const double outer = piece.sign * (piece.log ? std::exp(y[k]) : 1.0);
      for (std::size_t i = 0; i < n; ++i) {
        if (slopes[k * n + i] == 0.0) continue;
        columns[piece.first + i].emplace_back(piece.unknown[k], outer * slopes[k * n + i]);
      }
    }
  }
  return columns;
}

std::vector<Inequality> UnknownMap::inequalities() const {
  std::vector<Inequality> rows;
  for (const Piece& piece : pieces_) {
    const std::size_t n = piece.unknown.size();
    const std::vector<double>& a = piece.abscissa;
    const double lower = piece.log ? std::exp(piece.lower) : piece.lower;
    const double upper = piece.log ? std::exp(piece.upper) : piece.upper;
    for (std::size_t k = 0; k < n; ++k) {
      const bool ends = k == 0 || k + 1 == n;
      const bool needs_lower = piece.ascending ? k == 0 : piece.convex || n == 1;
      const bool needs_upper = piece.ascending ? k + 1 == n : ends;
      if (needs_lower && std::isfinite(lower)) {
        rows.push_back({{{piece.unknown[k], piece.sign}}, lower});
      }
      if (needs_upper && std::isfinite(upper)) {
        rows.push_back({{{piece.unknown[k], -piece.sign}}, -upper});
      }
      if (piece.ascending && k > 0 && !(piece.convex && k > 1)) {
        rows.push_back(
            {{{piece.unknown[k], piece.sign}, {piece.unknown[k - 1], -piece.sign}}, 0.0});
      }
      if (piece.convex && k > 0 && k + 1 < n) {
        const double before = piece.sign / (a[k] - a[k - 1]);
        const double after = piece.sign / (a[k + 1] - a[k]);
        rows.push_back({{{piece.unknown[k - 1], before},
                         {piece.unknown[k], -before - after},
                         {piece.unknown[k + 1], after}},
                        0.0});
      }
    }
  }
  return rows;
}

std::vector<char> UnknownMap::shaped() const {
  std::vector<char> shaped(size_, 0);
  for (const Piece& piece : pieces_) {
    if (piece.unknown.size() < 2) continue;
    for (std::size_t k = 0; k < piece.unknown.size(); ++k) shaped[piece.first + k] = 1;
  }
  return shaped;
}

std::vector<FoldPoint> UnknownMap::folds(std::span<double> z) const {
  std::vector<FoldPoint> folds(size_);
  std::vector<double> y;
  for (const Piece& piece : pieces_) {
    y.resize(piece.unknown.size());
    walk(piece, y, nullptr, [&](std::size_t step, std::size_t, const Limits& limits) {
      const std::size_t c = piece.first + step;
      z[c] = principal_coordinate(limits, z[c]);
      folds[c] = nearest_fold(limits, z[c]);
      return fold(limits, z[c]);
    });
  }
  return folds;
}

}  // namespace slipbench::driver::fit
