// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/key_index.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "driver/case/quantity.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::read {
namespace {

/// Returns "generalized_viscous, renard, ..".
std::string laws_with_floor() {
  std::string names;
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    const auto add = [&](bool has_floor, std::string_view name) {
      if (has_floor) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    (add(law::keeps_floor<Law>(), Law::kName), ...);
  }(std::type_identity<law::LawList>{});
  return names;
}

/// Returns how this format says what an option of a Radioss /FRICTION block says (Ifric, Ifiltr,
/// Iform, Idir), or a key of old drafts; empty for other keys.
std::string_view key_for_option(std::string_view option) {
  struct Option {
    std::string_view name;
    std::string_view text;
  };
  static constexpr std::array<Option, 11> kOptions{{
      {"Ifric",
       "the law stands by its name in 'coefficient': Ifric 0 is a number, 1 generalized_viscous, 2 "
       "modified_darmstad, 3 renard, 4 exponential_decay"},
      {"Ifiltr",
       "a definition has 'filter': Ifiltr 1 is {simple: alpha}, 2 {period: T} or {Xfreq: .., "
       "xfreq_convention: ..}, 3 {frequency: f}"},
      {"Iform",
       "a definition has 'formulation': Iform 1 is {penalty: viscous, K: .., m: ..}, 2 {penalty: "
       "stiffness, K_t: ..}"},
      {"Idir",
       "two directions stand in 'coefficient': Idir 1 is {orthotropic: {direction1: .., "
       "direction2: ..}}"},
      {"mu", "the coefficient is 'coefficient: 0.2', or '= mu' for a parameter"},
      {"stick_stiffness", "write 'stick: {stiffness: ..}'"},
      {"steps", "steps stand under 'history:', each begins with '- step: NAME'"},
      {"displacement", "what moves stands under 'motion:', as {CP1: {to: 0.1}}"},
      {"velocity",
       "a motion is a position over time: 'motion: {CP1: {to: 0.1}}' goes there evenly within the "
       "step's duration"},
      {"rows", "a table is {columns: [..], rows: [..]}: which column is what, and their numbers"},
      {"load", "what is held is loaded under 'force:', as {f2: 100}"},
  }};
  for (const Option& known : kOptions) {
    if (known.name == option) return known.text;
  }
  return {};
}

/// Returns what is written in place of a key of other programs or of another place; empty for other
/// keys.
std::string other_name(std::string_view key) {
  if (const std::string_view here = key_for_option(key); !here.empty()) return std::string(here);
  if (key.starts_with('*')) return "a case has keys of its own, such as 'connector' and 'friction'";
  const std::string quantity = place_of_quantity(key);
  return quantity.empty() ? "" : "'" + std::string(key) + "' belongs to " + quantity;
}

}  // namespace

std::string place_of_quantity(std::string_view key) {
  if (cases::component_of_motion(key)) return "history[].motion";
  if (cases::component_of_force(key) || key == "f_bc") return "history[].force";
  if (cases::field_of(key)) return "history[].fields";
  return "";
}

std::string places_of_key(std::string_view key) {
  static const std::vector<yaml::KeyRow> rows = case_rows();
  return places_of_key(key, rows);
}

std::string places_of_key(std::string_view key, std::span<const yaml::KeyRow> rows) {
  std::vector<std::string> places;
  for (const yaml::KeyRow& row : rows) {
    const std::size_t dot = row.path.rfind('.');
    const std::string_view last = dot == std::string::npos
                                      ? std::string_view(row.path)
                                      : std::string_view(row.path).substr(dot + 1);
    if (last != key) continue;
    std::string place = dot == std::string::npos ? "the top level" : row.path.substr(0, dot);
    // The rows of all profiles stand under the temperature.
    constexpr std::string_view kProfile = "history[].temperature";
    if (place.starts_with(kProfile)) {
      place = place == kProfile ? "a profile"
                                : "a profile's" + (" " + place.substr(kProfile.size() + 1));
    }
    if (std::find(places.begin(), places.end(), place) == places.end()) {
      places.push_back(std::move(place));
    }
  }
  if (places.size() > 3) places.resize(3);
  const std::vector<std::string_view> views(places.begin(), places.end());
  return base::in_words(views);
}

std::optional<yaml::LaterKey> later_key(std::string_view key) {
  static constexpr std::string_view kRetractor =
      "a RETRACTOR is JOIN + FLOW-CONVERTER: node b sits on a (x, y, z are held, with the forces "
      "f1, "
      "f2, f3), and the relative turn about axis 3 of a spools belt, e3a.(theta_a - theta_b) = "
      "beta_s "
      "Psi_b, under the moment m3; nothing is free, so there is no friction and nothing to test "
      "here; "
      "the belt itself is a SLIPRING, whose flow CP3 or CP2 takes what the spool gives";
  static constexpr std::string_view kNothingFree =
      "this type (JOIN + ALIGN) has no free component, so there is no friction; where something "
      "slips in truth, take the type that leaves it free: SLOT, HINGE, CYLINDRICAL, BUSHING ..";
  static constexpr std::array kLater{
      yaml::LaterKey{"WELD", kNothingFree},
      yaml::LaterKey{"BEAM", kNothingFree},
      yaml::LaterKey{
          "CVJOINT",
          "a CVJOINT (JOIN + CONSTANT VELOCITY) has no free component, so there is no "
          "friction; for friction in its bend take JOIN + FLEXION-TORSION, whose torsion "
          "CPR2 is then held at 0 by 'motion:'"},
      yaml::LaterKey{"adaptive", "adaptive increments are not in this version; give their number",
                     "increments"},
      yaml::LaterKey{"calibrate", "belongs to a fit file: slipbench calibrate FIT.yaml"},
      yaml::LaterKey{"sweep", "belongs to a sweep file: slipbench sweep SWEEP.yaml"},
      yaml::LaterKey{
          "plasticity",
          "a connector of this bench has no plasticity: it tests friction, and what acts beside "
          "friction (elasticity, damping, stops) does not change with what was; leave it out"},
      yaml::LaterKey{
          "damage",
          "a connector of this bench has no damage: it tests friction, and what acts beside "
          "friction (elasticity, damping, stops) does not change with what was; leave it out"},
      yaml::LaterKey{"failure",
                     "a connector of this bench does not fail: every run goes to its end with all "
                     "components; leave it out"},
      yaml::LaterKey{
          "lock",
          "a connector of this bench does not lock for good: 'stops' bound a component as long "
          "as it is pushed against them, and friction sticks"},
      yaml::LaterKey{
          "uniaxial_behavior",
          "a connector of this bench has no uniaxial behavior with loading and unloading curves: "
          "'elasticity' takes one table over the displacement, 'damping' one over the velocity"},
      yaml::LaterKey{"RETRACTOR", kRetractor},
      yaml::LaterKey{"FLOW-CONVERTER", kRetractor}};
  for (const yaml::LaterKey& later : kLater) {
    if (later.name == key) return later;
  }
  return std::nullopt;
}

std::string origin_of_column(std::string_view name) {
  // Columns of one definition of several carry its name.
  const std::string_view column = name.substr(0, name.find('.'));
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), column) != names.end();
  };
  std::string origin;
  if (column.starts_with("CS") && (column.ends_with("_RAW") || column.ends_with("_TRIAL"))) {
    origin = "a 'formulation'";
  } else if (is({"VISC_C"})) {
    origin = "'formulation: {penalty: viscous}'";
  } else if (is({"ALPHA"})) {
    origin = "a 'filter' behind its 'formulation'";
  } else if (is({"MU1", "MU2", "V1", "V2"})) {
    origin = "an 'orthotropic' coefficient";
  } else if (is({"MU_RAW", "CLAMPED"})) {
    origin = "a law with a floor (" + laws_with_floor() + ")";
  } else if (is({"SPEED"})) {
    origin = "a 'formulation' or a law with a floor";
  } else if (column.starts_with("PLAY")) {
    origin = "a 'dead_zone'";
  } else if (is({"PRESSURE"})) {
    origin = "a law of the pressure and an 'area'";
  } else if (is({"UTILISATION"})) {
    origin = "a 'formulation', and of a belt with both tensions prescribed";
  } else {
    return {};
  }
  return "'" + std::string(column) + "' is a column of a definition with " + origin;
}

const yaml::FileWords kCaseWords{later_key, other_name, places_of_key, origin_of_column,
                                 "define it under 'parameters:'"};

}  // namespace slipbench::driver::read
