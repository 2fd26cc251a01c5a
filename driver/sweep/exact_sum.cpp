// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/exact_sum.hpp"

#include <bit>
#include <cmath>

namespace slipbench::driver::sweep {
namespace {

constexpr int kFraction = 52;  ///< bits of a double
constexpr std::uint64_t kDigit = 0xffffffffU;

}  // namespace

void ExactSum::add(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto power = static_cast<std::uint32_t>(bits >> kFraction) & 0x7ffU;
  if (power == 0x7ffU) {
    special_ += value;
    return;
  }
  std::uint64_t fraction = bits & ((std::uint64_t{1} << kFraction) - 1);
  if (power > 0) fraction |= std::uint64_t{1} << kFraction;
  // In units of 2^-1074: the least power of a normal number is that of the others, too.
  const std::uint32_t place = power > 0 ? power - 1 : 0;
  const std::uint32_t shift = place % kBits;
  const std::uint64_t low = fraction << shift;
  const std::uint64_t high = shift == 0 ? 0 : fraction >> (64U - shift);
  const std::int64_t sign = bits >> 63U == 0 ? 1 : -1;
  std::int64_t* digit = &digits_[place / kBits];
  digit[0] += sign * static_cast<std::int64_t>(low & kDigit);
  digit[1] += sign * static_cast<std::int64_t>(low >> kBits);
  digit[2] += sign * static_cast<std::int64_t>(high);
  constexpr std::uint32_t kMostAdditions = 1U << 30U;
  if (++since_carry_ == kMostAdditions) carry();
}

void ExactSum::add_product(double a, double b) {
  const double product = a * b;
  add(product);
  if (std::isfinite(product)) add(std::fma(a, b, -product));
}

void ExactSum::add_times(ExactSum sum, double factor) {
  // A sum is more than one double: of what is left after each comes the next.
  for (double part = sum.value(); part != 0.0; part = sum.value()) {
    add_product(part, factor);
    if (!std::isfinite(part)) return;
    sum.add(-part);
  }
}

void ExactSum::add_digits(const ExactSum& other, std::int64_t sign) {
  ExactSum carried = other;
  carried.carry();
  carry();
  for (std::size_t i = 0; i < kDigits; ++i) digits_[i] += sign * carried.digits_[i];
  special_ += static_cast<double>(sign) * carried.special_;
  carry();
}

/// Brings all digits but the last, which has the sign, to 0 .. 2^32 - 1.
void ExactSum::carry() {
  std::int64_t over = 0;
  for (std::size_t i = 0; i + 1 < kDigits; ++i) {
    const std::int64_t digit = digits_[i] + over;
    over = digit >> kBits;
    digits_[i] = digit & static_cast<std::int64_t>(kDigit);
  }
  digits_.back() += over;
  since_carry_ = 0;
}

double ExactSum::value() const {
  if (special_ != 0.0) return special_;
  ExactSum magnitude = *this;
  magnitude.carry();
  const bool negative = magnitude.digits_.back() < 0;
  if (negative) {
    for (std::int64_t& digit : magnitude.digits_) digit = -digit;
    magnitude.carry();
  }
  const auto& digits = magnitude.digits_;
  std::size_t top = kDigits - 1;
  while (top > 0 && digits[top] == 0) --top;
  const auto digit = [&](std::size_t below) {
    return below <= top ? static_cast<std::uint64_t>(digits[top - below]) : 0U;
  };
  const std::uint64_t two = digit(0) << kBits | digit(1);
  if (two == 0) return 0.0;
  // The first 64 bits; the last of them stands for all that follow, so that one rounding is enough.
  const int empty = std::countl_zero(two);
  std::uint64_t first = two << empty;
  if (empty > 0) first |= digit(2) >> (kBits - empty);
  bool more = (digit(2) << empty & kDigit) != 0;
  for (std::size_t below = 3; below <= top && !more; ++below) more = digit(below) != 0;
  const double rounded = static_cast<double>(first | (more ? 1U : 0U));
  constexpr int kLeast = -1074;
  const int power = kBits * (static_cast<int>(top) - 1) - empty + kLeast;
  return std::ldexp(negative ? -rounded : rounded, power);
}

double sum_about_means(double count, const ExactSum& x, const ExactSum& y, ExactSum products) {
  const double mean_x = x.value() / count;
  const double mean_y = y.value() / count;
  if (!std::isfinite(mean_x) || !std::isfinite(mean_y)) return products.value() - mean_x * mean_y;
  products.add_times(x, -mean_y);
  products.add_times(y, -mean_x);
  const double both = mean_x * mean_y;
  products.add_product(count, both);
  products.add_product(count, std::fma(mean_x, mean_y, -both));
  return products.value();
}

}  // namespace slipbench::driver::sweep
