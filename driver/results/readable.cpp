// SPDX-License-Identifier: Apache-2.0
#include "driver/results/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

namespace slipbench::driver {
namespace {

struct Power {
  std::string_view name;
  int exponent = 0;  ///< of ten
};
constexpr Power kForces[] = {{"mN", -3}, {"N", 0}, {"daN", 1}, {"kN", 3}, {"MN", 6}};
constexpr Power kLengths[] = {{"um", -6}, {"mm", -3}, {"cm", -2}, {"m", 0}, {"km", 3}};
constexpr Power kJoules[] = {{"nJ", -9}, {"uJ", -6}, {"mJ", -3}, {"J", 0},
                             {"kJ", 3},  {"MJ", 6},  {"GJ", 9}};

std::optional<int> exponent_of(std::span<const Power> powers, std::string_view name) {
  const auto found = std::find_if(powers.begin(), powers.end(),
                                  [&](const Power& power) { return power.name == name; });
  return found == powers.end() ? std::nullopt : std::optional(found->exponent);
}

/// The power of ten that makes joules of the case's energies.
std::optional<int> joule_exponent(const UnitSystem& units) {
  const auto force = exponent_of(kForces, units.force);
  const auto length = exponent_of(kLengths, units.length);
  return force && length ? std::optional(*force + *length) : std::nullopt;
}

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
    for (const Power& unit : kJoules) {
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

}  // namespace slipbench::driver
