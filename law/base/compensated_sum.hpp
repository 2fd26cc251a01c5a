// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::law {

/// Adds a part to a sum, of which `left_out` is what rounding has left out so far (Kahan 1965, with
/// the exact error of an addition after Knuth 1969, section 4.2.2): the error does not grow with
/// the number of parts. Without it, equal parts are rounded to one side for as long as the sum
/// keeps its exponent: by 2e-9 of the sum after 10^8 of them. As `left_out` is at most half of the
/// sum's last digit, parts that are not negative never bring the sum down, and 0 does not move it.
[[gnu::always_inline]] inline void add_compensated(double part, double* sum,
                                                   double* left_out) noexcept {
  const double added = part + *left_out;
  const double before = *sum;
  const double after = before + added;
  const double taken = after - before;
  *sum = after;
  *left_out = (before - (after - taken)) + (added - taken);
}

/// A sum of parts that add_compensated adds.
class CompensatedSum {
 public:
  constexpr CompensatedSum(double value = 0.0, double left_out = 0.0) noexcept
      : value_(value), left_out_(left_out) {}

  CompensatedSum& operator+=(double part) noexcept {
    add_compensated(part, &value_, &left_out_);
    return *this;
  }
  constexpr operator double() const noexcept { return value_; }
  constexpr double left_out() const noexcept { return left_out_; }

 private:
  double value_;
  double left_out_;
};

}  // namespace slipbench::law
