// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::law {

/// Adds a part to a sum, of which `left_out` is what rounding has left out so far (Kahan 1965): the
/// error does not grow with the number of parts. Without it, equal parts are rounded to one side
/// for as long as the sum keeps its exponent: by 2e-9 of the sum after 10^8 of them.
/// \param grows whether the part is not negative: then the sum never becomes smaller
[[gnu::always_inline]] inline void add_compensated(double part, bool grows, double* sum,
                                                   double* left_out) noexcept {
  const double added = part + *left_out;
  const double before = *sum;
  const double moved = before + added;
  // Behind a part that was larger than the sum, what is left out may be too large by a rounding.
  const double after = grows && moved < before ? before : moved;
  *sum = after;
  *left_out = added - (after - before);
}

/// A sum of parts that add_compensated adds.
class CompensatedSum {
 public:
  constexpr CompensatedSum(double value = 0.0, double left_out = 0.0) noexcept
      : value_(value), left_out_(left_out) {}

  CompensatedSum& operator+=(double part) noexcept {
    add_compensated(part, part >= 0.0, &value_, &left_out_);
    return *this;
  }
  constexpr operator double() const noexcept { return value_; }
  constexpr double left_out() const noexcept { return left_out_; }

 private:
  double value_;
  double left_out_;
};

}  // namespace slipbench::law
