// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/sweep/exact_sum.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// A part of the variance of a number [1], with its 95 % interval.
struct VariancePart {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Sobol' indices of a number and a parameter: the part of the variance that goes if the parameter
/// is known, and the part that stays if it alone is not.
struct SobolIndices {
  VariancePart first;
  VariancePart total;
};

/// Sobol' indices of a sweep whose samples are laid out for them: a row of k + 2 samples is a point
/// A, then A with each of its k coordinates in turn from a point B, then B. Over n rows
///   first_i = mean(f_B (f_ABi - f_A)) / V      Saltelli et al. 2010, f less its mean
///   total_i = mean((f_A - f_ABi)^2) / (2 V)    Jansen 1999
/// where V is the variance of all f_A and f_B. Intervals are those of a jackknife that leaves out a
/// sixty-fourth of the rows at a time, as if the rows were random: on the safe side for sequences
/// that fill the space more evenly. Indices have the same bits however the rows were divided;
/// memory does not grow with them.
class SobolEstimate {
 public:
  explicit SobolEstimate(const Sweep& sweep);

  /// Bytes that an estimate takes, however few rows there are.
  static std::size_t size(std::size_t parameters, std::size_t numbers);

  /// Takes a sample: those of a row one after the other, the rows in any order.
  void add(const SampleOutcome& outcome);
  /// Takes all rows of another estimate of the same sweep.
  void add(const SobolEstimate& other);

  /// Tells whether a number varies, so that there are indices of it.
  bool varies(std::size_t number) const;
  /// Indices of a number that varies, for each parameter.
  std::vector<SobolIndices> indices(std::size_t number) const;
  /// Rows of which some sample has no such number: they are left out.
  std::size_t dropped(std::size_t number) const { return dropped_[number]; }

  /// One line a number: its parameters by total index. Warns where intervals are wider than what
  /// they are to tell apart.
  std::string text() const;
  /// CSV, a row for each number and parameter.
  std::string csv() const;

  void fields(auto& archive) { archive(rows_, groups_, dropped_); }

 private:
  /// Sums over rows.
  struct Sums {
    /// Of a parameter.
    struct Change {
      ExactSum sum;       ///< f_ABi - f_A
      ExactSum products;  ///< f_B (f_ABi - f_A)
      ExactSum squares;   ///< (f_ABi - f_A)^2

      void add(const Change& other, bool subtract);
      void fields(auto& archive) { archive(sum, products, squares); }
    };
    std::size_t rows = 0;
    ExactSum both;     ///< f_A + f_B
    ExactSum squares;  ///< f_A^2 + f_B^2
    std::vector<Change> changes;

    void add(const Sums& other, bool subtract = false);
    double variance() const;
    void fields(auto& archive) { archive(rows, both, squares, changes); }
  };

  struct Basis;

  void end_row(std::size_t number, std::size_t row);
  Sums sum(std::size_t number) const;

  const Sweep* sweep_;
  std::size_t parameters_;
  std::size_t rows_ = 0;
  std::vector<std::vector<double>> row_;   ///< the samples of the row so far, a number each
  std::vector<std::vector<Sums>> groups_;  ///< of a number
  std::vector<std::size_t> dropped_;
};

}  // namespace slipbench::driver::sweep
