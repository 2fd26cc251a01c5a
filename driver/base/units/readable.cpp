// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/readable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

#include "driver/base/units/derived_units.hpp"

namespace slipbench::driver::base {
namespace {

struct Joules {
  std::string_view name;
  int exponent = 0;  ///< of ten
};
constexpr Joules kJoules[] = {{"nJ", -9}, {"uJ", -6}, {"mJ", -3}, {"J", 0},
                              {"kJ", 3},  {"MJ", 6},  {"GJ", 9}};

}  // namespace

std::string rounded(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  // "105.0" is a measured quantity, "105" could be a count.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::string energy_unit(const UnitSystem& units) {
  if (const auto exponent = joule_exponent(units)) {
    for (const Joules& unit : kJoules) {
      if (unit.exponent == *exponent) return std::string(unit.name);
    }
  }
  return unit_text(kMoment, units);
}

std::string energy_text(double value, const UnitSystem& units) {
  constexpr int kDigits = 3;
  const auto exponent = joule_exponent(units);
  if (!exponent || value == 0.0 || !std::isfinite(value)) {
    return with_unit(rounded(value, kDigits), energy_unit(units));
  }
  const double joules = value * std::pow(10.0, *exponent);
  // 999.7 has three digits as 1000.
  constexpr double kNext = 999.5;
  auto unit = std::begin(kJoules);
  while (std::next(unit) != std::end(kJoules) &&
         std::abs(joules) >= kNext * std::pow(10.0, unit->exponent)) {
    ++unit;
  }
  return with_unit(rounded(joules * std::pow(10.0, -unit->exponent), kDigits),
                   std::string(unit->name));
}

}  // namespace slipbench::driver::base
