// SPDX-License-Identifier: Apache-2.0
#include "driver/report/packed_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "driver/report/series_digits.hpp"

namespace slipbench::driver::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Whole numbers below are exact, and so are three of them together.
constexpr double kMostWhole = 1e15;

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// 10^decimals, as the decimal text gives it: exact up to 22, and the same in any program.
double power_of_ten(int decimals) {
  return std::strtod(fmt::format("1e{}", decimals).c_str(), nullptr);
}

/// 10^d for a d of either sign; |d| up to 22 is exact.
class DecimalScale {
 public:
  explicit DecimalScale(int decimals = 0)
      : decimals_(decimals), power_(power_of_ten(std::abs(decimals))) {}

  int decimals() const { return decimals_; }
  /// The number in units of 10^-d, and back.
  double in_units(double number) const { return decimals_ < 0 ? number / power_ : number * power_; }
  double from_units(double k) const { return decimals_ < 0 ? k * power_ : k / power_; }
  static std::int64_t whole(double units) {
    return static_cast<std::int64_t>(std::floor(units + 0.5));
  }

 private:
  int decimals_;
  double power_;
};

class Packer {
 public:
  void begin_block(int decimals) {
    flush();
    put(folded(decimals - scale_.decimals()));
    if (decimals == scale_.decimals()) return;
    scale_ = DecimalScale(decimals);
    for (Known& one : before_) {
      const double units = scale_.in_units(one.value);
      one.k = std::abs(units) < kMostWhole ? DecimalScale::whole(units) : 0;
    }
  }

  void add(double number) {
    if (!std::isfinite(number)) {
      flush();
      put(1);
      return;
    }
    const std::int64_t k = DecimalScale::whole(scale_.in_units(number));
    const std::int64_t off = k - (2 * before_[0].k - before_[1].k);
    before_[1] = before_[0];
    before_[0] = {k, scale_.from_units(static_cast<double>(k))};
    if (off == 0) {
      ++zeros_;
      return;
    }
    flush();
    put(folded(off) + 1);
  }

  std::string take() && {
    flush();
    return base64(bytes_);
  }

 private:
  struct Known {
    std::int64_t k = 0;
    double value = 0.0;  ///< as the page has it
  };

  static std::uint64_t folded(std::int64_t number) {
    const auto size = static_cast<std::uint64_t>(number < 0 ? -(number + 1) : number);
    return 2 * size + (number < 0 ? 1 : 0);
  }
  void put(std::uint64_t number) {
    for (; number >= 128; number >>= 7) bytes_ += static_cast<char>(number % 128 + 128);
    bytes_ += static_cast<char>(number);
  }
  void flush() {
    if (zeros_ == 0) return;
    put(0);
    put(zeros_);
    zeros_ = 0;
  }

  std::string bytes_;
  DecimalScale scale_;
  Known before_[2];
  std::uint64_t zeros_ = 0;
};

double largest_of(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) {
    if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
  }
  return largest;
}

/// The median of the steps above `least`; infinite if there are none.
double usual_step(std::span<const double> numbers, double least) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double step = std::abs(numbers[i] - numbers[i - 1]);
    if (step > least && std::isfinite(step)) steps.push_back(step);
  }
  if (steps.empty()) return kInfinity;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

double to_decimals(double number, int decimals) {
  const DecimalScale scale(decimals);
  return scale.from_units(std::floor(scale.in_units(number) + 0.5));
}

int decimals_within(double resolution, double largest) {
  const double wanted = std::ceil(-std::log10(2.0 * resolution) - 1e-9);
  const double most = largest > 0.0 ? kMostDigits - 1 - std::floor(std::log10(largest)) : 0.0;
  // 10^308 is the largest there is; a resolution of 0 wants all digits.
  return static_cast<int>(std::clamp(std::min(wanted, most), -300.0, 300.0));
}

std::string packed_numbers(std::span<const double> numbers, int decimals) {
  Packer packer;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % kPackedBlock == 0) packer.begin_block(decimals);
    packer.add(numbers[i]);
  }
  return std::move(packer).take();
}

std::string packed_series(std::span<const double> numbers) {
  constexpr double kRounding = 1e-12;
  constexpr double kStepOfRange = 1e-8;
  constexpr double kOfStep = 1e-3;
  double low = kInfinity;
  double high = -kInfinity;
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    low = std::min(low, number);
    high = std::max(high, number);
  }
  const double largest = largest_of(numbers);
  // Of a constant, the digits of the number itself.
  const double range = high - low > kRounding * largest ? high - low : 1e-4 * largest;
  const double of_range = range * std::pow(10.0, -kFewestDigits);
  Packer packer;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % kPackedBlock == 0) {
      // With the number before: the step into a block is one of its steps.
      const std::size_t first = i > 0 ? i - 1 : 0;
      const auto block = numbers.subspan(first, std::min(numbers.size(), i + kPackedBlock) - first);
      const double step = usual_step(block, kStepOfRange * range);
      const double resolution = std::min(of_range, kOfStep * step);
      packer.begin_block(resolution > 0.0 ? decimals_within(resolution, largest_of(block)) : 0);
    }
    packer.add(numbers[i]);
  }
  return std::move(packer).take();
}

}  // namespace slipbench::driver::report
