// SPDX-License-Identifier: Apache-2.0
// Two curves, by every criterion. Each number is two bytes, hundredths, but for 0x7f.. and 0x80..:
// powers of ten. The first bytes are the tolerances and how many points the first curve has, 255
// for half of them.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "driver/check/criteria/criteria.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {
namespace {

using driver::check::Series;

double number_of(std::string_view bytes) {
  std::int16_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  constexpr int kPowers = 0x7f00;
  if (number >= kPowers) return std::pow(10.0, number - kPowers - 128);
  if (number < -kPowers) return -std::pow(10.0, -number - kPowers - 128);
  return 0.01 * number;
}

Series series_of(std::string_view bytes) {
  std::vector<double> abscissa;
  std::vector<double> value;
  std::vector<double> time;
  for (; bytes.size() >= 4; bytes.remove_prefix(4)) {
    time.push_back(static_cast<double>(time.size()));
    abscissa.push_back(number_of(bytes));
    value.push_back(number_of(bytes.substr(2)));
  }
  return {std::move(abscissa), std::move(value), std::move(time)};
}

void judge(const driver::check::CurveComparison& found) {
  for (const driver::check::Measure& measure : found.measures) {
    want(!measure.name.empty(), "a measure has a name");
    want(!(measure.deviation < 0.0), "a deviation is not negative");
    want(found.fault.empty(), "what cannot be compared has no measures");
  }
}

}  // namespace

void comparison(std::string_view input) {
  constexpr std::size_t kHead = 3;
  if (input.size() < kHead) return;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(input[i]); };
  driver::cases::Tolerance tolerance;
  if ((byte(0) & 1U) != 0) tolerance.absolute = std::pow(10.0, byte(1) / 16 - 8);
  if ((byte(0) & 2U) != 0) tolerance.relative = std::pow(10.0, byte(1) % 16 - 12);
  if ((byte(0) & 4U) != 0) tolerance.abscissa = 0.1;
  const std::string_view rest = input.substr(kHead);
  constexpr std::size_t kHalf = 255;
  const std::size_t points = byte(2) == kHalf ? rest.size() / 8 : byte(2);
  const std::size_t first = std::min(rest.size(), 4 * points);
  const Series result = series_of(rest.substr(0, first));
  Series reference = series_of(rest.substr(first));
  if ((byte(0) & 8U) != 0) reference.time = std::vector<double>();
  for (const driver::check::CriterionInfo& criterion : driver::check::kCriteria) {
    judge(compare(criterion.criterion, result, reference, tolerance));
    judge(compare(criterion.criterion, result, result, tolerance));
  }
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(comparison)
