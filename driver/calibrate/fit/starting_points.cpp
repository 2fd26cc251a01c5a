// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/starting_points.hpp"

#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace slipbench::driver::fit {
namespace {

struct FreeSequence {
  void operator()(gsl_qrng* sequence) const { gsl_qrng_free(sequence); }
};

/// The value of an unknown at `part` in [0, 1) of its range.
double within(const UnknownRange& range, double part) {
  const bool log = range.scale == Scale::kLog;
  const bool below = std::isfinite(range.lower) && !(log && range.lower <= 0.0);
  const bool above = std::isfinite(range.upper);
  if (below && above) {
    if (log) return range.lower * std::pow(range.upper / range.lower, part);
    return range.lower + part * (range.upper - range.lower);
  }
  const double factor = std::pow(10.0, 2.0 * part - 1.0);
  if (log) {
    return std::clamp(range.start * factor, below ? range.lower : 0.0, range.upper);
  }
  if (below || above) {
    const double bound = below ? range.lower : range.upper;
    const double way = range.start != bound ? range.start - bound
                                            : (below ? 1.0 : -1.0) * std::max(std::abs(bound), 1.0);
    return bound + way * factor;
  }
  return range.start != 0.0 ? range.start * factor : 2.0 * part - 1.0;
}

}  // namespace

std::vector<std::vector<double>> starting_points(const ResidualProblem& problem, int count,
                                                 std::uint64_t seed) {
  std::vector<std::vector<double>> points;
  if (count <= 0 || problem.unknowns.empty()) return points;
  // The direction of every unknown: blocks share one.
  const std::size_t n = problem.unknowns.size();
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<const ShapedBlock*> block_of(n, nullptr);
  for (const ShapedBlock& block : problem.shapes) {
    for (std::size_t k = 0; k < block.count; ++k) block_of[block.first + k] = &block;
  }
  std::vector<std::size_t> direction(n, kNone);
  std::size_t directions = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const bool first = block_of[j] == nullptr || block_of[j]->first == j;
    direction[j] = first ? directions++ : direction[block_of[j]->first];
  }

  constexpr std::size_t kMostSobol = 40;
  const std::unique_ptr<gsl_qrng, FreeSequence> sequence(
      gsl_qrng_alloc(directions <= kMostSobol ? gsl_qrng_sobol : gsl_qrng_reversehalton,
                     static_cast<unsigned>(directions)));
  std::mt19937_64 engine(seed);
  std::vector<double> shift(directions);
  for (double& s : shift) s = static_cast<double>(engine() >> 11) * 0x1p-53;
  std::vector<double> part(directions);
  for (int i = 0; i < count; ++i) {
    if (sequence) {
      gsl_qrng_get(sequence.get(), part.data());
    } else {
      // more directions than any of the sequences has
      for (double& p : part) p = static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    std::vector<double>& point = points.emplace_back(n);
    for (std::size_t j = 0; j < n; ++j) {
      double where = part[direction[j]] + shift[direction[j]];
      where -= std::floor(where);
      const ShapedBlock* block = block_of[j];
      if (block == nullptr) {
        point[j] = within(problem.unknowns[j], where);
        continue;
      }
      constexpr double kTilt = 0.02;
      const double level = within(problem.unknowns[block->first], where);
      const double along = static_cast<double>(j - block->first) /
                           static_cast<double>(std::max<std::size_t>(block->count - 1, 1));
      const double sense = block->shape.monotone == Shape::Monotone::kIncreasing   ? 1.0
                           : block->shape.monotone == Shape::Monotone::kDecreasing ? -1.0
                                                                                   : 0.0;
      const UnknownRange& range = problem.unknowns[j];
      point[j] = std::clamp(level * (1.0 + kTilt * sense * along), range.lower, range.upper);
    }
  }
  return points;
}

}  // namespace slipbench::driver::fit
