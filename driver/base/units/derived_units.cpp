// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/derived_units.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace slipbench::driver::base {
namespace {

struct Power {
  std::string_view name;
  int exponent = 0;  ///< of ten
};
constexpr Power kForces[] = {{"mN", -3}, {"N", 0}, {"daN", 1}, {"kN", 3}, {"MN", 6}};
constexpr Power kLengths[] = {{"um", -6}, {"mm", -3}, {"cm", -2}, {"m", 0}, {"km", 3}};
constexpr Power kTimes[] = {{"us", -6}, {"ms", -3}, {"s", 0}};
constexpr Power kMasses[] = {{"mg", -6}, {"g", -3}, {"kg", 0}, {"t", 3}, {"kt", 6}};

std::optional<int> exponent_of(std::span<const Power> powers, std::string_view name) {
  const auto found = std::find_if(powers.begin(), powers.end(),
                                  [&](const Power& power) { return power.name == name; });
  return found == powers.end() ? std::nullopt : std::optional(found->exponent);
}

}  // namespace

std::optional<int> joule_exponent(const UnitSystem& units) {
  const auto force = exponent_of(kForces, units.force);
  const auto length = exponent_of(kLengths, units.length);
  return force && length ? std::optional(*force + *length) : std::nullopt;
}

std::optional<int> kilogram_exponent(const UnitSystem& units) {
  const auto force = exponent_of(kForces, units.force);
  const auto length = exponent_of(kLengths, units.length);
  const auto time = exponent_of(kTimes, units.time);
  return force && length && time ? std::optional(*force - *length + 2 * *time) : std::nullopt;
}

std::string mass_name(const UnitSystem& units) {
  if (units.force == "lbf" && units.time == "s") {
    if (units.length == "ft") return "slug";
    if (units.length == "in") return "slinch";
  }
  const auto exponent = kilogram_exponent(units);
  if (!exponent) return {};
  const auto found = std::find_if(std::begin(kMasses), std::end(kMasses),
                                  [&](const Power& power) { return power.exponent == *exponent; });
  return found == std::end(kMasses) ? std::string() : std::string(found->name);
}

std::string frequency_name(const UnitSystem& units) {
  if (units.time == "s") return "Hz";
  if (units.time == "ms") return "kHz";
  if (units.time == "us") return "MHz";
  return units.time.empty() ? std::string() : "1/" + units.time;
}

}  // namespace slipbench::driver::base
