// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

constexpr int kDistance = cases::kFirstMotion;  // CP1
constexpr int kFlow = cases::kFirstMotion + 1;  // CP2
constexpr int kTension = cases::kFirstForce;    // f1
constexpr double kManyTurns = 4.0 * std::numbers::pi;

/// The key is there although the connection is no belt.
template <class T>
void belongs_to_slipring(yaml::Binder& binder, const yaml::At<T>& at,
                         const law::Connection& connection) {
  if (!at.given()) return;
  binder.error(*at.node, at.path,
               "belongs to SLIPRING: " + connector_words(connection) + " has no belt");
}

void read_wrap_angles(yaml::Binder& binder, const yaml::At<NumberOrList>& text,
                      law::SlipRing& ring) {
  if (text.sound && text.value.values.empty()) {
    binder.error(*text.node, text.path, "needs an angle for each ring, found an empty list");
    return;
  }
  constexpr std::size_t kMostRings = 100;
  if (text.sound && text.value.values.size() > kMostRings) {
    binder.error(
        *text.node, text.path,
        fmt::format("a belt has at most {} rings, found {}", kMostRings, text.value.values.size()));
    return;
  }
  for (std::size_t i = 0; i < text.value.values.size(); ++i) {
    const double angle = text.value.values[i];
    if (!(angle > kManyTurns)) continue;
    const bool list = text.value.list;
    binder.warning(
        list ? (*text.node)[i] : *text.node, list ? text.path / i : text.path,
        base::format_number(angle) + " rad is more than two turns of the belt (radians?)",
        "degrees are written '= 180*pi/180'");
  }
  if (text.sound) ring.wrap_angles = text.value.values;
}

std::optional<law::Point> point(yaml::Binder& binder, const yaml::At<std::vector<double>>& text) {
  if (!text.sound) return std::nullopt;
  if (text.value.size() != 3) {
    binder.error(*text.node, text.path,
                 "wanted three coordinates [x, y, z], found " + std::to_string(text.value.size()));
    return std::nullopt;
  }
  return law::Point{text.value[0], text.value[1], text.value[2]};
}

void read_nodes(yaml::Binder& binder, const yaml::At<NodesText>& text, law::SlipRing& ring,
                cases::Case& out) {
  const auto a = point(binder, text.value.a);
  const auto b = point(binder, text.value.b);
  const auto c = point(binder, text.value.c);
  if (!a || !b || !c) return;
  out.belt->nodes = {{*a, *b, *c}};
  const bool first = !(law::distance(*a, *b) > 0.0);
  const double angle = law::wrap_angle(*a, *b, *c);
  if (first || (out.belt->angle_from_nodes && !std::isfinite(angle))) {
    const yaml::At<std::vector<double>>& at = first ? text.value.a : text.value.c;
    binder.error(*at.node, at.path,
                 std::string("node ") + (first ? "a" : "c") +
                     " lies on node b: the belt has no direction there");
    return;
  }
  if (out.belt->angle_from_nodes) {
    const auto& turns = out.belt->half_turns;
    ring.wrap_angles = {turns ? law::begin_turn(*turns, *a, *b, *c).angle : angle};
  }
  out.initial[0] = out.reference[0] = law::distance(*a, *b);
}

const yaml::Named<double>* initial_distance(const ConnectorText& text) {
  const auto found = std::find_if(text.initial.begin(), text.initial.end(),
                                  [](const auto& entry) { return entry.name == "CP1"; });
  return found == text.initial.end() ? nullptr : &*found;
}

/// Reads the lengths of the segments behind the rings: one a ring.
void read_lengths(yaml::Binder& binder, const yaml::At<std::vector<double>>& text,
                  std::size_t rings, cases::Case& out) {
  if (!text.sound) return;
  if (text.value.size() != rings) {
    binder.error(*text.node, text.path,
                 "wanted the length of the segment behind each ring (" + std::to_string(rings) +
                     "), found " + std::to_string(text.value.size()),
                 "the segment between a and b is 'initial: {CP1: ..}'");
    return;
  }
  out.belt->lengths = text.value;
}

/// Tells whether the history drives a quantity.
bool drives(const cases::Case& problem, int quantity) {
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives) {
      if (drive.quantity == quantity) return true;
    }
  }
  if (!problem.measured) return false;
  const auto& columns = problem.measured->columns;
  return std::any_of(columns.begin(), columns.end(), [&](const history::MeasuredColumn& column) {
    return static_cast<int>(column.quantity) == quantity;
  });
}

/// Returns where a history drives a motion or tension: its key in the first step or column that
/// names it.
std::pair<yaml::Node, yaml::Path> place_of(const CaseText& text,
                                           yaml::NamedMap<ProfileText> StepText::*list,
                                           std::string_view name) {
  const HistoryText& history = text.history.value;
  for (const yaml::At<StepText>& step : history.steps) {
    for (const auto& entry : step.value.*list) {
      if (entry.name == name) return {*entry.key, entry.path};
    }
  }
  if (history.measured) {
    for (const auto& entry : history.measured->columns.value) {
      if (entry.name == name) return {*entry.key, entry.path};
    }
  }
  return {*text.history.node, text.history.path};
}

/// Follows the nodes of a belt through the steps that the case has got since the last call.
void follow(const cases::Case& problem, NodePlaces& places) {
  if (places.coordinates.empty()) {
    for (const law::Point& node : *problem.belt->nodes) {
      places.coordinates.insert(places.coordinates.end(), node.begin(), node.end());
    }
  }
  for (; places.steps < problem.steps.size(); ++places.steps) {
    for (const cases::Drive& drive : problem.steps[places.steps].drives) {
      if (drive.quantity < cases::kFirstNode) continue;
      auto& at = places.coordinates[static_cast<std::size_t>(drive.quantity - cases::kFirstNode)];
      at.reset();
      if (const auto* p = std::get_if<history::Constant>(&drive.profile)) at = p->value;
      if (const auto* p = std::get_if<history::LinearTo>(&drive.profile)) at = p->value;
      if (const auto* p = std::get_if<history::SmoothTo>(&drive.profile)) at = p->value;
    }
  }
}

/// Warns of a distance that is driven below a hundredth of the initial one, or near it, as far as
/// the text alone tells: the run says the rest.
void warn_of_short_distance(yaml::Binder& binder, const CaseText& text,
                            const cases::Case& problem) {
  const double locks = law::kShortestPart * problem.initial[0];
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives) {
      if (drive.quantity != kDistance) continue;
      double least = problem.initial[0];
      if (const auto* p = std::get_if<history::LinearTo>(&drive.profile)) least = p->value;
      if (const auto* p = std::get_if<history::SmoothTo>(&drive.profile)) least = p->value;
      if (const auto* p = std::get_if<history::Tabular>(&drive.profile)) {
        least = *std::min_element(p->values.begin(), p->values.end());
      }
      if (!(least < 2.0 * locks)) continue;
      const auto [node, path] = place_of(text, &StepText::motion, "CP1");
      binder.warning(node, path,
                     "CP1 goes down to " + base::format_number(least) + " in step '" + step.name +
                         "': below " + base::format_number(locks) +
                         ", a hundredth of the initial distance, a belt locks");
      return;
    }
  }
}

}  // namespace

void resolve_belt(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  if (is_any_connection(out.connection) || !text.connector.given()) return;
  const ConnectorText& connector = text.connector.value;
  if (!cases::is_belt(out.connection)) {
    belongs_to_slipring(binder, connector.wrap_angle, out.connection);
    belongs_to_slipring(binder, connector.nodes, out.connection);
    belongs_to_slipring(binder, connector.initial_strain, out.connection);
    belongs_to_slipring(binder, connector.half_turns, out.connection);
    belongs_to_slipring(binder, connector.lengths, out.connection);
    return;
  }
  out.belt.emplace().initial_strain = connector.initial_strain.value;
  auto& ring = std::get<law::SlipRing>(*out.connection.type);
  out.belt->angle_from_nodes = connector.nodes.given() && !connector.wrap_angle.given();
  if (connector.half_turns.sound && out.belt->angle_from_nodes) {
    out.belt->half_turns = connector.half_turns.value;
  } else if (connector.half_turns.sound) {
    binder.error(*connector.half_turns.node, connector.half_turns.path,
                 connector.nodes.given()
                     ? "give 'wrap_angle', which then stays, or 'half_turns', from which the angle "
                       "follows the nodes"
                     : "without 'nodes' there is no angle to add half turns to",
                 connector.nodes.given() ? "" : "'wrap_angle' may be of any size");
  }
  if (!connector.wrap_angle.given() && !connector.nodes.given() &&
      !yaml::has_unknown_key<ConnectorText>(*text.connector.node)) {
    binder.error(*text.connector.node, text.connector.path,
                 "a SLIPRING needs 'wrap_angle' or 'nodes'",
                 "half a turn is 'wrap_angle: = pi'; the angle is never taken as 0 silently");
  }
  read_wrap_angles(binder, connector.wrap_angle, ring);
  for (const auto& entry : connector.reference) {
    binder.error(*entry.key, entry.path,
                 "a SLIPRING has no reference positions; 'initial_strain' says how tight the belt "
                 "is at the start");
  }
  if (text.derived_components.given()) {
    binder.error(*text.derived_components.node, text.derived_components.path,
                 "a SLIPRING takes no derived components: what presses the belt on its ring is its "
                 "tension f1");
  }
  const auto* initial = initial_distance(connector);
  if (initial != nullptr && connector.nodes.given()) {
    binder.error(*initial->key, initial->path, "the distance CP1 follows from the nodes a and b");
  } else if (initial != nullptr && initial->sound && !(initial->value > 0.0)) {
    binder.error(*initial->node, initial->path,
                 "the distance of a and b must be greater than 0 (found " +
                     base::format_number(initial->value) + ")");
  }
  if (connector.nodes.sound) read_nodes(binder, connector.nodes, ring, out);
  if (connector.wrap_angle.sound) {
    read_lengths(binder, connector.lengths, ring.wrap_angles.size(), out);
  }
  if (connector.lengths.sound && connector.nodes.given()) {
    binder.error(*connector.lengths.node, connector.lengths.path,
                 "the segment behind the ring ends at node c: 'lengths' and 'nodes' say two things",
                 "give 'initial: {CP1: ..}' and 'wrap_angle' in place of the nodes");
  }
}

void drive_nodes(yaml::Binder& binder, const StepText& text, const cases::Case& problem,
                 NodePlaces& places,
                 const std::function<void(int quantity, const yaml::At<ProfileText>&)>& drive) {
  if (!text.nodes.given() || is_any_connection(problem.connection)) return;
  if (!problem.belt) {
    belongs_to_slipring(binder, text.nodes, problem.connection);
    return;
  }
  if (!problem.belt->nodes) {
    binder.error(*text.nodes.node, text.nodes.path, "this SLIPRING has no nodes to move",
                 "give 'connector: {nodes: ...}'");
    return;
  }
  follow(problem, places);
  const NodeMotionText& nodes = text.nodes.value;
  const std::array all{&nodes.a, &nodes.b, &nodes.c};
  for (std::size_t n = 0; n < all.size(); ++n) {
    const yaml::At<std::vector<yaml::At<ProfileText>>>& node = *all[n];
    if (!node.given() || !node.node->is_sequence()) continue;
    if (node.value.size() != 3) {
      binder.error(*node.node, node.path,
                   "wanted three profiles [x, y, z], found " + std::to_string(node.value.size()));
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const yaml::At<ProfileText>& profile = node.value[i];
      if (!profile.sound) continue;
      const int quantity = cases::kFirstNode + static_cast<int>(3 * n + i);
      if (const auto* stays = std::get_if<history::Constant>(&profile.value.profile)) {
        const std::optional<double> before = places.coordinates[3 * n + i];
        if (before && *before != stays->value) {
          binder.error(*profile.node, profile.path,
                       "a number is a coordinate that stays, and node " + std::string(1, "abc"[n]) +
                           " is at " + base::format_number(*before) + " there",
                       "{to: " + base::format_number(stays->value) + "} goes there over the step");
          continue;
        }
      }
      drive(quantity, profile);
    }
  }
}

void finish_belt(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  if (!out.belt || !text.history.given()) return;
  cases::Belt& belt = *out.belt;
  const ConnectorText& connector = text.connector.value;
  belt.has_length = out.initial[0] > 0.0;
  for (int q = cases::kFirstNode; q < cases::kQuantities; ++q) belt.nodes_move |= drives(out, q);
  belt.both_tensions = drives(out, cases::kTensionBehind);

  if (!belt.has_length && !connector.nodes.given() && initial_distance(connector) == nullptr) {
    const std::string hint = "give 'initial: {CP1: ...}', the distance of a and b";
    if (connector.initial_strain.given()) {
      binder.error(*connector.initial_strain.node, connector.initial_strain.path,
                   "without the distance of the nodes there is no length to strain", hint);
    }
    if (drives(out, kDistance)) {
      const auto [node, path] = place_of(text, &StepText::motion, "CP1");
      binder.error(node, path, "the distance at the start is not known", hint);
    }
    if (out.kinetic.elasticity[0]) {
      binder.error(*text.elasticity.node, text.elasticity.path,
                   "the strain of the belt is not known, and so its tension", hint);
    }
    if (out.stop[0]) {
      binder.error(*text.stops.node, text.stops.path,
                   "the distance of the nodes is not known, which the stop bounds", hint);
    }
    if (!belt.lengths.empty()) {
      binder.error(*connector.lengths.node, connector.lengths.path,
                   "the length of the segment before the first ring is not known", hint);
    }
  }
  warn_of_short_distance(binder, text, out);
  if (belt.both_tensions) {
    if (std::get<law::SlipRing>(*out.connection.type).wrap_angles.size() > 1) {
      binder.error(*connector.wrap_angle.node, connector.wrap_angle.path,
                   "both tensions are prescribed, so there is one ring only",
                   "give the sum of the angles: the ratio depends on nothing else");
    }
    if (drives(out, kFlow)) {
      const auto [node, path] = place_of(text, &StepText::motion, "CP2");
      binder.error(node, path,
                   "both tensions are prescribed, so the flow follows from nothing: prescribe f_bc "
                   "or CP2");
    }
  }
  const bool elastic = out.kinetic.elasticity[0].has_value();
  if (out.kinetic.damping[0] && !elastic && text.damping.sound && !text.elasticity.given()) {
    binder.error(*text.damping.node, text.damping.path,
                 "the damping of a belt acts beside its elasticity, and this belt has none",
                 "give 'elasticity: [{component: 1, stiffness: ..}]'; a tension that is prescribed "
                 "needs neither");
  }
  if (elastic && drives(out, kTension)) {
    const auto [node, path] = place_of(text, &StepText::force, "f1");
    binder.error(node, path,
                 "the tension f1 follows from the strain of the belt, by its elasticity");
  }
  // A faulty f1 is reported where it is written.
  const bool has_tension =
      place_of(text, &StepText::force, "f1").second.text() != text.history.path.text();
  if (text.history.sound && !elastic && !text.elasticity.given() && !has_tension) {
    binder.warning(*text.history.node, text.history.path,
                   "the belt has no tension, so there is no friction",
                   "prescribe 'force: {f1: ...}', or give it an elasticity of component 1");
  }
}

}  // namespace slipbench::driver::read
