// SPDX-License-Identifier: Apache-2.0
// Dead zones and coefficients for each direction: options of the bench around the friction of one
// component, and what they do not go together with.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "law/base/component.hpp"

namespace slipbench::driver::read {
namespace {

/// Tells whether a definition slips in one component, by the return mapping of the connector.
bool is_single(const law::FrictionDefinition& definition) {
  return definition.slip.dimension == 1 &&
         std::holds_alternative<law::EuclideanPotential>(definition.criterion);
}

/// Reports what in the case an option around the friction of component c does not go with.
bool suits_case(yaml::Binder& binder, const cases::Case& problem, int c,
                const law::FrictionDefinition& friction, const yaml::Node& node,
                const yaml::Path& path, std::string_view what) {
  const std::string subject(what);
  const std::string number = "component " + std::to_string(c + 1);
  bool good = true;
  const auto refuse = [&](std::string message, std::string hint) {
    binder.error(node, path, std::move(message), std::move(hint));
    good = false;
  };
  if (friction.formulation) {
    refuse(subject + " needs the connector's stick and return mapping, and the friction of " +
               number + " has a 'formulation'",
           "give 'stick' in its place");
  }
  if (problem.dynamics && problem.dynamics->component == c) {
    refuse(subject + " needs an elastic stick, and the mass of 'dynamics:' sticks rigidly",
           "leave out 'dynamics:', and prescribe the motion " + cases::motion_name(c));
  }
  if (!problem.force_driven.empty()) {
    refuse(subject + " needs a connector driven by its motion, and " +
               motion_names(problem.force_driven) + " is driven by force",
           "prescribe its motion");
  }
  return good;
}

/// The play at the start, or nothing after an error.
std::optional<double> start_of(yaml::Binder& binder, const yaml::At<PlayPositionText>& at,
                               double width) {
  if (at.faulty()) return std::nullopt;
  const double half = 0.5 * width;
  if (const auto* place = std::get_if<PlayPlace>(&at.value.value)) {
    return *place == PlayPlace::kCentred ? 0.0 : (*place == PlayPlace::kLower ? -half : half);
  }
  const double play = std::get<double>(at.value.value);
  if (std::abs(play) <= half) return play;
  binder.error(*at.node, at.path,
               "the play lies between -width/2 and width/2, " + base::format_number(-half) +
                   " and " + base::format_number(half) + ": found " + base::format_number(play));
  return std::nullopt;
}

void resolve_dead_zone(yaml::Binder& binder, const yaml::At<DeadZoneText>& at, bool friction_known,
                       cases::Case& out) {
  const DeadZoneText& text = at.value;
  if (!text.component.sound || is_any_connection(out.connection)) return;
  const int c = text.component.value - 1;
  const std::string number = "component " + std::to_string(c + 1);
  const yaml::Node& node = *text.component.node;
  const yaml::Path& path = text.component.path;
  if (cases::is_belt(out.connection)) {
    binder.error(*at.node, at.path, "a SLIPRING takes no dead zone: a belt has no backlash");
    return;
  }
  if (!out.connection.info.available.contains(c)) {
    binder.error(node, path,
                 connector_words(out.connection) +
                     (out.connection.info.held.contains(c) ? " holds " : " has no ") + number +
                     ": a dead zone lies along a free component; free are " +
                     motion_names(out.connection.info.available));
    return;
  }
  binder.settle_slip_units(at.path, law::is_rotation(c));
  for (cases::CaseDefinition& definition : out.definitions) {
    const law::SlipSpace& slip = definition.law.slip;
    const auto begin = slip.component.begin();
    if (std::find(begin, begin + slip.dimension, c) == begin + slip.dimension) continue;
    if (!is_single(definition.law)) {
      binder.error(node, path,
                   "the friction '" + definition.name + "' of " + number +
                       (slip.dimension > 1 ? " couples it with others" : " has a potential") +
                       ": a dead zone is in series with the friction of one component alone",
                   "write the friction with 'component: " + std::to_string(c + 1) + "'");
      return;
    }
    if (definition.dead_zone) {
      binder.error(node, path, number + " already has a dead zone");
      return;
    }
    if (!suits_case(binder, out, c, definition.law, *at.node, at.path, "a dead zone")) return;
    if (!text.width.sound) return;
    const auto start = start_of(binder, text.position, text.width.value);
    if (start) definition.dead_zone = cases::DeadZone{text.width.value, *start};
    return;
  }
  if (friction_known) {
    binder.error(node, path,
                 number +
                     " has no friction: a dead zone is in series with the friction of its "
                     "component");
  }
}

/// The rules of the definition at `index` if its coefficient is one for each direction.
void check_directions(yaml::Binder& binder, const yaml::At<FrictionText>& friction,
                      const cases::CaseDefinition& definition, const cases::Case& problem) {
  const yaml::At<CoefficientText>& coefficient = friction.value.coefficient;
  const yaml::Node& node = *coefficient.node;
  const yaml::Path& path = coefficient.path;
  if (cases::is_belt(problem.connection)) {
    binder.error(node, path,
                 "the limit of a SLIPRING depends on the direction by itself: its coefficient does "
                 "not");
    return;
  }
  if (!is_single(definition.law)) {
    binder.error(
        node, path,
        "a coefficient for each direction needs a definition of one component, and '" +
            definition.name +
            (definition.law.slip.dimension > 1 ? "' couples several" : "' has a potential"),
        "write the friction with 'component: ..'");
    return;
  }
  suits_case(binder, problem, definition.law.slip.component[0], definition.law, node, path,
             "a coefficient for each direction");
}

}  // namespace

void resolve_bench_options(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const std::vector<yaml::At<FrictionText>>& all = text.friction.value;
  const bool predefined = all.size() == 1 && all.front().value.predefined.given();
  const bool known = !all.empty() && (predefined || all.size() == out.definitions.size());
  for (std::size_t i = 0; i < out.definitions.size() && known; ++i) {
    const yaml::At<FrictionText>& friction = predefined ? all.front() : all[i];
    const CoefficientText& coefficient = friction.value.coefficient.value;
    if (!coefficient.with_direction || !friction.value.coefficient.given()) continue;
    const std::size_t errors = binder.errors();
    check_directions(binder, friction, out.definitions[i], out);
    if (binder.errors() != errors) break;  // the same fault in each of them
  }
  for (const yaml::At<DeadZoneText>& at : text.dead_zone.value) {
    if (at.given() && at.node->is_map()) {
      resolve_dead_zone(binder, at, known && !out.definitions.empty(), out);
    }
  }
}

}  // namespace slipbench::driver::read
