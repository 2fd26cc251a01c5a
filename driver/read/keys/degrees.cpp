// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/degrees.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/number.hpp"

namespace slipbench::driver::read {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

bool is_multiple(double value, double of) { return std::remainder(value, of) == 0.0; }

bool looks_like_degrees(double value, AngleUse use) {
  const double size = std::abs(value);
  if (size <= kTurn) return false;
  switch (use) {
    case AngleUse::kPhase:
      return true;
    case AngleUse::kSwing:
      return is_multiple(size, 2.5);
    case AngleUse::kWay:
      // Angles in radians are usually given as tens, hundreds or multiples of pi.
      return is_multiple(size, 15.0) && size <= 720.0;
  }
  return false;
}

}  // namespace

bool doubt_angle(yaml::Binder& binder, const yaml::Node& node, const yaml::Path& path,
                 AngleUse use) {
  if (!node.is_scalar() || node.quoted()) return false;
  const auto value = base::parse_number(node.text());
  if (!value || !looks_like_degrees(*value, use)) return false;
  const std::string number = base::format_number(*value);
  binder.warning(
      node, path, fmt::format("{} rad is {:.2g} turns", number, *value / kTurn),
      fmt::format("if degrees are meant write '= {0}*pi/180', if radians '= {0}'", number));
  return true;
}

void doubt_angles_of_profile(yaml::Binder& binder, const yaml::Node& profile,
                             const yaml::Path& path, bool rotation) {
  if (!profile.is_map()) return;
  for (const yaml::Entry entry : profile.entries()) {
    const std::string_view key = entry.key.text();
    const yaml::Path below = path / key;
    if (key == "phase") {
      doubt_angle(binder, entry.value, below, AngleUse::kPhase);
    } else if (entry.value.is_map()) {
      doubt_angles_of_profile(binder, entry.value, below, rotation);
    } else if (rotation && (key == "to" || key == "smooth_to")) {
      doubt_angle(binder, entry.value, below, AngleUse::kWay);
    } else if (rotation && (key == "amplitude" || key == "mean")) {
      doubt_angle(binder, entry.value, below, AngleUse::kSwing);
    } else if (rotation && key == "rows") {
      for (std::size_t i = 0; i < entry.value.size(); ++i) {
        const yaml::Node row = entry.value[i];
        if (!row.is_sequence() || row.size() == 0) continue;
        // One row is enough.
        if (doubt_angle(binder, row[0], below / i / 0, AngleUse::kWay)) return;
      }
    }
  }
}

}  // namespace slipbench::driver::read
