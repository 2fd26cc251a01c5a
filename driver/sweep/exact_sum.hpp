// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace slipbench::driver::sweep {

/// Sum of doubles that is rounded only when it is asked for (the long accumulator of Kulisch and
/// Miranker 1981), so that it does not depend on the order of what is added, nor on how that was
/// divided among threads, parts and ranks. One that is not finite makes the sum what a plain one
/// would be.
class ExactSum {
 public:
  void add(double value);
  /// Adds a b, exactly unless the product underflows.
  void add_product(double a, double b);
  void add(const ExactSum& other) { add_digits(other, 1); }
  /// Adds a sum times a factor, as exactly.
  void add_times(ExactSum sum, double factor);
  void subtract(const ExactSum& other) { add_digits(other, -1); }

  /// The double that is nearest to the sum.
  double value() const;

  void fields(auto& archive) {
    carry();
    archive(digits_, special_);
  }

 private:
  // 32 bits each, the first that of 2^-1074; the last ones take what carries beyond any double.
  static constexpr std::size_t kDigits = 68;
  static constexpr int kBits = 32;

  void add_digits(const ExactSum& other, std::int64_t sign);
  void carry();

  std::array<std::int64_t, kDigits> digits_{};
  std::uint32_t since_carry_ = 0;  ///< additions, so that no digit overflows
  double special_ = 0.0;           ///< sum of all that are not finite
};

/// Returns the sum of (x - mean of x) (y - mean of y), rounded once at the end.
/// \param count how many pairs
/// \param x,y sums of each
/// \param products sum of x y
double sum_about_means(double count, const ExactSum& x, const ExactSum& y, ExactSum products);

}  // namespace slipbench::driver::sweep
