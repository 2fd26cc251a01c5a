// SPDX-License-Identifier: Apache-2.0
// The free oscillation of a mass on its spring: what a mass in a wrong unit gives away.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "driver/base/units/derived_units.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

std::string amount(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// The slope of the spring where the mass starts [F/L]; 0 where it depends on more than the place.
double spring_stiffness(const cases::Case& problem, int component) {
  const auto i = static_cast<std::size_t>(component);
  const auto& own = problem.kinetic.elasticity[i];
  if (own && own->table() != nullptr && own->table()->independents().size() > 1) return 0.0;
  law::Ambient start;
  start.motion = law::constitutive_motion(problem.initial, problem.reference);
  return law::elastic_force(problem.kinetic, component, start).slope[i];
}

/// "0.3 t (300 kg; N s^2/mm is t)", as far as its unit has a name.
std::string mass_words(double mass, const base::UnitSystem& units, bool rotation) {
  const base::Dimension dimension = rotation ? base::Dimension{.force = 1, .length = 1, .time = 2}
                                             : base::Dimension{.force = 1, .length = -1, .time = 2};
  const std::string product = base::unit_text(dimension, units);
  const std::string name = base::mass_name(units);
  if (name.empty()) return amount(mass, product);
  const std::string named = rotation ? name + " " + units.length + "^2" : name;
  const auto exponent = base::kilogram_exponent(units);
  std::string in_kilograms;
  if (exponent && *exponent != 0 && !rotation) {
    in_kilograms = amount(mass * std::pow(10.0, *exponent), "kg") + "; ";
  }
  return fmt::format("{} ({}{} is {})", amount(mass, named), in_kilograms, product, named);
}

/// The shortest increments of the steps [T]; infinite for a measured history.
double shortest_increment(const cases::Case& problem) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const cases::Step& step : problem.steps) {
    shortest = std::min(shortest, step.duration / step.increments);
  }
  return shortest;
}

}  // namespace

void tell_oscillator(yaml::Binder& binder, const CaseText& text, const cases::Case& problem) {
  if (!problem.dynamics || !text.dynamics.value.mass.sound) return;
  const yaml::At<double>& at = text.dynamics.value.mass;
  const base::UnitSystem& units = problem.units;
  const bool rotation = law::is_rotation(problem.dynamics->component);
  const double mass = problem.dynamics->reduced_mass();
  const double stiffness = spring_stiffness(problem, problem.dynamics->component);
  if (!(mass > 0.0 && stiffness > 0.0)) return;
  const double frequency = std::sqrt(stiffness / mass) / (2.0 * std::numbers::pi);
  const double period = 1.0 / frequency;
  const base::Dimension of_spring =
      rotation ? base::kMoment : base::Dimension{.force = 1, .length = -1};
  const std::string unit = base::frequency_name(units);
  binder.note(
      *at.node, at.path,
      fmt::format(
          "{}{} on the spring of {} swings at {} (period {})",
          problem.dynamics->driver ? "with its driver as one mass of " : "",
          mass_words(mass, units, rotation), amount(stiffness, base::unit_text(of_spring, units)),
          unit.empty() ? amount(frequency, "") + " a unit of time" : amount(frequency, unit),
          amount(period, units.time)));
  constexpr double kFewest = 10.0;
  const double increment = shortest_increment(problem);
  if (!std::isfinite(increment) || period >= kFewest * increment) return;
  binder.warning(
      *at.node, at.path,
      fmt::format("the mass swings with a period of {}, and no increment is shorter than "
                  "{}: fewer than 10 rows a period do not show it",
                  amount(period, units.time), amount(increment, units.time)),
      fmt::format("look at the unit of the mass, or take increments of {} or less",
                  amount(period / kFewest, units.time)));
}

}  // namespace slipbench::driver::read
