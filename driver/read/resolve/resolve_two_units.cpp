// SPDX-License-Identifier: Apache-2.0
// One coefficient for sliding and spinning: its rates are lengths and angles per time, its contact
// forces are forces and moments.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "driver/base/text/format_number.hpp"
#include "driver/base/units/unit_dimension.hpp"
#include "driver/read/resolve/resolve_definition.hpp"

namespace slipbench::driver::read {
namespace {

/// Coefficients that one surface speed and one force give in the two units.
struct Disagreement {
  double speed = 0.0;
  double force = 0.0;
  double sliding = 0.0;
  double spinning = 0.0;

  [[nodiscard]] double size() const { return std::abs(sliding - spinning); }
};

/// The largest one over round speeds and forces.
Disagreement worst_of(const law::FrictionLaw& law, double arm) {
  const std::array<double, law::kMaxFields> no_fields{};
  law::Ambient ambient;
  ambient.fields = no_fields;
  const auto mu = [&](double rate, double force) {
    return law::evaluate(law, ambient, {.slip_rate = rate, .contact_force = force}).mu;
  };
  Disagreement worst;
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 30; ++k) {
      constexpr std::array<double, 3> kRound = {1.0, 2.0, 5.0};
      const auto round = [&](int n) {
        return kRound[static_cast<std::size_t>(n % 3)] * std::pow(10.0, n / 3 - 3);
      };
      const double speed = round(i);
      const double force = round(k);
      const Disagreement here{speed, force, mu(speed, force), mu(speed / arm, force * arm)};
      if (std::isfinite(here.size()) && here.size() > worst.size() * (1.0 + 1e-9)) worst = here;
    }
  }
  return worst;
}

}  // namespace

bool slip_in_two_units(const cases::Case& problem, std::span<const std::size_t> group) {
  const auto rotational = [&](std::size_t i) {
    return law::is_rotational(problem.definitions[i].law.slip);
  };
  return std::any_of(group.begin(), group.end(), rotational) &&
         !std::all_of(group.begin(), group.end(), rotational);
}

bool warn_of_two_units(yaml::Binder& binder, const yaml::At<CoefficientText>& coefficient,
                       const law::FrictionLaw& law, const base::UnitSystem& units, double arm) {
  const bool rate = law::depends_on_slip_rate(law);
  const bool force = law::depends_on_contact_force(law);
  if (!coefficient.sound || (!rate && !force)) return false;
  const auto unit = [&](const base::Dimension& dimension, std::string_view otherwise) {
    const std::string text = base::unit_text(dimension, units);
    return text.empty() ? std::string(otherwise) : text;
  };
  std::string units_of;
  if (rate) {
    constexpr base::Dimension kSpeed{.length = 1, .time = -1};
    units_of = fmt::format("slip rates in {} for sliding and {} for spinning",
                           unit(kSpeed, "length/time"), unit(base::rotated(kSpeed), "rad/time"));
  }
  if (force) {
    units_of +=
        fmt::format("{}contact forces in {} {} {}", rate ? ", " : "", unit(base::kForce, "force"),
                    rate ? "and" : "for sliding and", unit(base::kMoment, "force*length"));
    if (!rate) units_of += " for spinning";
  }
  std::string message = fmt::format("'{}' is asked for {}", law::name_of(law), units_of);
  std::string radius = "R";
  if (arm > 0.0) {
    radius = fmt::format("{:.6g}", arm);
    const Disagreement worst = worst_of(law, arm);
    const auto with_unit = [&](double value, const base::Dimension& dimension) {
      const std::string text = base::unit_text(dimension, units);
      return base::format_number(value) + (text.empty() ? "" : " " + text);
    };
    if (worst.size() > 0.0) {
      std::string where;
      if (rate) where = "speed " + with_unit(worst.speed, {.length = 1, .time = -1});
      if (force) where += (rate ? " and force " : "force ") + with_unit(worst.force, base::kForce);
      message += fmt::format(
          "; at the same {} at the radius {} mu is {:.4g} sliding and {:.4g} "
          "spinning",
          where, with_unit(base::rounded_number(arm, 6), base::kLength), worst.sliding,
          worst.spinning);
    }
  }
  binder.warning(*coefficient.node, coefficient.path, std::move(message),
                 fmt::format("'connector: {{friction_radius: {}}}' asks for both at that radius{}",
                             radius, arm > 0.0 ? ", the puck's mean arm of friction" : ""));
  return true;
}

}  // namespace slipbench::driver::read
