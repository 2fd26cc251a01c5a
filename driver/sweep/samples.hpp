// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Values of the varied parameters, sample after sample. The same sweep gives the same samples, on
/// every machine and in whatever pieces they are taken.
///   - Grid: all combinations of the lists, the last parameter fastest.
///   - Sobol and Halton (reverse Halton) of GSL, shifted modulo 1 by a random number for each
///     parameter (Cranley and Patterson 1976).
///   - Latin hypercube: of n equal parts of each range every one is met once (McKay, Beckman and
///     Conover 1979).
///   - Random: a hash of seed, sample and parameter (SplitMix64), so that no sample depends on
///     those before it.
///   - CSV: the rows of a file.
/// With Sobol' indices a point has twice the coordinates, and makes a row of samples.
class Samples {
 public:
  explicit Samples(const Sweep& sweep);

  /// Passes over samples that are not wanted.
  void skip(std::size_t count);

  /// Writes the values of the next samples, row by row, until `values` is full or none is left.
  /// \return how many samples
  std::size_t take(std::span<double> values);

 private:
  void advance();
  double part(std::size_t coordinate) const;

  const Sweep* sweep_;
  std::size_t row_length_;
  std::size_t next_ = 0;
  std::shared_ptr<void> sequence_;  ///< GSL's gsl_qrng
  std::vector<double> point_;       ///< of the sequence; with Sobol' indices A, then B
  std::vector<std::vector<std::size_t>> strata_;  ///< of the hypercube, for each parameter
};

/// Returns the most coordinates of a point of a sampler.
std::size_t most_coordinates(Sampler sampler);

}  // namespace slipbench::driver::sweep
