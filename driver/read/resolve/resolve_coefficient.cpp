// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <type_traits>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve_definition.hpp"
#include "law/friction/at_radius.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::read {
namespace {

/// The place of a key in the map of a law: the key's value if it was written, else the law's.
std::pair<yaml::Node, yaml::Path> place_of(const yaml::Node& law, const yaml::Path& path,
                                           std::string_view key) {
  const auto value = law.find(key);
  return value ? std::pair{*value, path / key} : std::pair{law, path};
}

/// A law by name stands below its name.
std::pair<yaml::Node, yaml::Path> below_name(const yaml::Node& node, const yaml::Path& path) {
  if (!node.is_map() || node.size() != 1) return {node, path};
  return {node.entry(0).value, path / node.entry(0).key.text()};
}

/// Gives a law of the pressure its area, its own or the connector's.
template <class Law>
bool complete_area(yaml::Binder& binder, Law& law, const yaml::Node& node, const yaml::Path& path,
                   const yaml::At<double>& connector_area) {
  if (law.area) return true;
  if (connector_area.sound) law.area = connector_area.value;
  if (law.area || connector_area.faulty() || !law.needs_area()) return true;
  binder.error(node, path, "its coefficients see the pressure p = F_N/A, but there is no area A",
               "give 'area' here, or 'connector: {area: ..}' for all coefficients of the case");
  return false;
}

/// Gives a law whose constants hide a unit of speed its factor.
template <class Law>
bool complete_speed_unit(yaml::Binder& binder, Law& law, const yaml::Node& node,
                         const yaml::Path& path, bool rotational, const base::UnitSystem& units) {
  if ((units.length.empty() && !rotational) || units.time.empty()) {
    binder.error(node, path, std::string(Law::kWithoutUnits),
                 "units: {length: mm, time: s}, and 'speed_unit' here if the constants are of "
                 "another system");
    return false;
  }
  if (law.speed_unit.empty()) return true;
  const base::Dimension speed{
      .length = rotational ? 0 : 1, .time = -1, .angle = rotational ? 1 : 0};
  const auto conversion = base::conversion_to_case(law.speed_unit.name(), speed, units);
  if (!conversion) {
    const auto [at, where] = place_of(node, path, "speed_unit");
    binder.history_error(at, where, conversion.error());
    if (rotational) {
      binder.note(
          at, where,
          "this definition slips in a rotation: its V is in " + base::unit_text(speed, units));
    }
    return false;
  }
  law.speed_factor = 1.0 / conversion->scale;
  return true;
}

/// Warns of what a user may not expect of the coefficients given.
template <class Law>
void warn_of(yaml::Binder& binder, const Law& law, const yaml::Node& node, const yaml::Path& path) {
  if constexpr (requires { law.remark(); }) {
    const law::Remark remark = law.remark();
    if (remark.key.empty()) return;
    const auto [at, where] = place_of(node, path, remark.key);
    binder.warning(at, where, std::string(remark.text));
  }
}

/// A coefficient that starts below zero is more often a slip of the sign than meant.
template <class Law>
void warn_of_negative_start(yaml::Binder& binder, const Law& law, const yaml::Node& node,
                            const yaml::Path& path) {
  double start = 0.0;
  if constexpr (requires { law.raw_coefficient(0.0, 0.0); }) {
    start = law.raw_coefficient(0.0, 0.0);
  } else if constexpr (law::OfRate<Law, double> || law::OfRateAndForce<Law, double> ||
                       law::OfRateForceAndAmbient<Law, double>) {
    start = law::coefficient_of(law, law::Ambient{}, 0.0, 0.0);
  }
  if (law::keeps_floor<Law>() && start < 0.0) {
    binder.warning(node, path,
                   "mu = " + base::format_number(start) +
                       " at rest and without pressure: a coefficient below 0 is kept at 1e-30, "
                       "which is no friction");
  }
}

template <class Law>
bool complete(yaml::Binder& binder, Law& law, const yaml::Node& node, const yaml::Path& path,
              const LawSurroundings& surroundings) {
  bool good = true;
  if constexpr (requires { law.area; }) {
    good = complete_area(binder, law, node, path, surroundings.area);
  }
  warn_of(binder, law, node, path);
  warn_of_negative_start(binder, law, node, path);
  return good;
}

}  // namespace

std::optional<law::FrictionLaw> coefficient_law(yaml::Binder& binder,
                                                const CoefficientText& coefficient,
                                                const yaml::Node& node, const yaml::Path& path,
                                                const LawSurroundings& surroundings) {
  if (const auto* table_text = std::get_if<TableText>(&coefficient.value)) {
    auto function = table_function(binder, *table_text, node, path, kCoefficientTable);
    if (!function) return std::nullopt;
    return law::FrictionLaw(law::TabularCoefficient{std::move(*function)});
  }
  law::FrictionLaw law = std::get<law::FrictionLaw>(coefficient.value);
  const auto [below, place] = below_name(node, path);
  const bool good =
      law::visit_law([&, &at = below, &where = place](
                         auto& one) { return complete(binder, one, at, where, surroundings); },
                     law);
  if (!good) return std::nullopt;
  return law;
}

std::optional<law::FrictionLaw> coefficient_law(yaml::Binder& binder,
                                                const yaml::At<CoefficientText>& coefficient,
                                                const LawSurroundings& surroundings) {
  const CoefficientText& text = coefficient.value;
  if (!coefficient.sound || text.orthotropic || text.with_direction) return std::nullopt;
  return coefficient_law(binder, text, *coefficient.node, coefficient.path, surroundings);
}

bool suit_to_slip(yaml::Binder& binder, const yaml::At<CoefficientText>& coefficient,
                  const law::SlipSpace& slip, const base::UnitSystem& units,
                  std::optional<double> radius, law::FrictionLaw& law) {
  if (!coefficient.sound) return true;
  // At a radius the law goes on seeing the speed and the force that its numbers are of.
  const bool at_radius = radius && law::is_rotational(slip);
  const bool rotational = law::is_rotational(slip) && !at_radius;
  const auto [node, path] = below_name(*coefficient.node, coefficient.path);
  const bool good = law::visit_law(
      [&, &at = node, &where = path](auto& one) {
        if constexpr (requires { one.speed_unit; }) {
          return complete_speed_unit(binder, one, at, where, rotational, units);
        } else if constexpr (requires { one.area; }) {
          if (rotational && one.depends_on_contact_force()) {
            const std::string unit = base::unit_text({.force = 1, .length = -1}, units);
            binder.warning(at, where,
                           "F_N of this definition is a moment: its p = F_N/A is no pressure but " +
                               (unit.empty() ? "a moment over an area" : "in " + unit) +
                               ", and V an angle per time");
          }
          return true;
        } else {
          return true;
        }
      },
      law);
  if (at_radius) law = law::at_radius(std::move(law), *radius);
  return good;
}

}  // namespace slipbench::driver::read
