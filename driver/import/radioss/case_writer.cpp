// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/case_writer.hpp"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <string_view>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/import/radioss/check_writer.hpp"

namespace slipbench::driver::radioss {
namespace {

/// "key: number" for the numbers that are not 0.
std::string entry(std::string_view key, double value) {
  return value == 0.0 ? std::string() : fmt::format(", {}: {}", key, base::format_number(value));
}

std::string flow_map(std::string_view name, std::string entries) {
  if (entries.starts_with(", ")) entries.erase(0, 2);
  return fmt::format("{{{}: {{{}}}}}", name, entries);
}

/// The coefficient of a parameter set, as one value in YAML.
std::string coefficient(const DeckFriction& friction, const DeckCoefficients& set) {
  if (is_empty(friction.law, set)) return "0";
  const auto& c = set.c;
  const auto constants = [&](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += entry("C" + std::to_string(i + 1), c[i]);
    return text;
  };
  switch (friction.law) {
    case 1:
      return flow_map("generalized_viscous", entry("Fric", set.fric) + constants(5));
    case 2:
      return flow_map("modified_darmstad", entry("Fric", set.fric) + constants(6));
    case 3: {
      std::string all;
      for (std::size_t i = 0; i < 6; ++i)
        all += fmt::format(", C{}: {}", i + 1, base::format_number(c[i]));
      if (!renard_faults(set).lenient.empty()) all += ", rules: lenient";
      return flow_map("renard", std::move(all));
    }
    case 4:
      if (falls(set)) {
        return fmt::format("{{exponential_decay: {{static: {}, kinetic: {}, decay: {}}}}}",
                           base::format_number(set.fric), base::format_number(c[0]),
                           base::format_number(c[1]));
      }
      // Rising, or negative: the same curve as the part of another law without pressure.
      return flow_map("modified_darmstad",
                      entry("Fric", c[0]) + entry("C5", set.fric - c[0]) + entry("C6", -c[1]));
    default:
      return base::format_number(set.fric);
  }
}

/// Friction of a record. VISF matters to a viscous penalty only.
import::ContactRecord record(const DeckFriction& friction, const DeckCoefficients& first){
    return {.coefficient = coefficient(friction, first),
            .visf = friction.formulation == 1 ? first.visf : 0.0};
}  // namespace

std::string filter(const DeckFriction& friction) {
  if (friction.xfreq == 0.0) return {};
  const std::string x = base::format_number(friction.xfreq);
  if (friction.filter == 1) return fmt::format("{{simple: {}}}", x);
  if (friction.filter == 2) return fmt::format("{{Xfreq: {}, xfreq_convention: steps}}", x);
  if (friction.filter == 3) return fmt::format("{{frequency: {}}}", x);
  return {};
}

std::vector<std::shared_ptr<const import::ContactGroup>> groups_of(const DeckContents& deck,
                                                                   const DeckFriction& friction) {
  std::vector<std::shared_ptr<const import::ContactGroup>> groups;
  std::set<int> met;
  for (const DeckPair& pair : friction.pairs) {
    for (const DeckSide& side : pair.sides) {
      if (side.group == 0 || !met.insert(side.group).second) continue;
      const DeckGroup* const group = find_group(deck, side.group);
      groups.push_back(std::make_shared<import::ContactGroup>(
          import::ContactGroup{.name = side_text(side),
                               .title = group == nullptr ? "" : group->title,
                               .parts = group == nullptr ? std::vector<int>() : group->parts}));
    }
  }
  return groups;
}

/// Sentences on direction 1 of orthotropic records.
std::vector<std::string> orientation(const DeckContents& deck, const DeckFriction& friction,
                                     const SkeletonOptions& options) {
  std::vector<std::string> lines;
  const std::vector<DeckOrientation> used = used_orientations(deck, friction);
  if (used.empty()) {
    lines.emplace_back("In the deck it is the global x axis, projected on the contact plane.");
  }
  for (const DeckOrientation& entry : used) {
    const auto& v = entry.vector;
    lines.push_back(fmt::format(
        "In the deck{}: ({}, {}, {}){}, projected on the contact plane{} (line {})",
        entry.of.group > 0  ? fmt::format(", group {}", entry.of.group)
        : entry.of.part > 0 ? fmt::format(", part {}", entry.of.part)
                            : "",
        base::format_number(v[0]), base::format_number(v[1]), base::format_number(v[2]),
        entry.skew > 0 ? fmt::format(" in skew {}", entry.skew) : "",
        entry.phi != 0.0
            ? fmt::format(" and turned by {} about its normal", base::format_number(entry.phi))
            : "",
        entry.line));
    if (!options.normal || entry.skew > 0) continue;
    if (const auto d = direction_in_plane(entry, *options.normal)) {
      lines.push_back(fmt::format("  before the turn: ({}, {}, {})", base::format_number((*d)[0]),
                                  base::format_number((*d)[1]), base::format_number((*d)[2])));
    }
  }
  return lines;
}

}  // namespace slipbench::driver::radioss

std::string side_text(const DeckSide& side) {
  return (side.group > 0 ? "G" : "") + std::to_string(side.group > 0 ? side.group : side.part);
}

import::ContactFriction contact_friction(const DeckContents& deck, const DeckFriction& friction,
                                         const SkeletonOptions& options){
    import::ContactFriction contact{.name = name_of(friction),
                                    .title = friction.title,
                                    .deck = options.deck,
                                    .notes = options.notes,
                                    .losses = options.losses,
                                    .units = options.units,
                                    .needs_units = friction.law == 3,
                                    .groups = groups_of(deck, friction),
                                    .otherwise = record(friction, friction.otherwise),
                                    .viscous = friction.formulation == 1,
                                    .filter = filter(friction),
                                    .checks = checks_text(friction)};
contact.otherwise.shear_limit = options.shear_limit;
contact.as_coded = options.as_coded;
contact.sees_pressure = sees_pressure(friction, friction.otherwise) || options.shear_limit > 0.0;
// Without all of the deck's parts a list would refuse good ids.
if (has_all_parts(deck)) contact.parts = deck.parts;
for (const DeckPair& pair : friction.pairs) {
  import::ContactRecord& one = contact.pairs.emplace_back(record(friction, pair.first));
  one.sides = {side_text(pair.sides[0]), side_text(pair.sides[1])};
  one.remark = fmt::format("line {} of the deck", pair.line);
  if (pair.second) one.second = coefficient(friction, *pair.second);
  contact.sees_pressure = contact.sees_pressure || sees_pressure(friction, pair.first) ||
                          (pair.second && sees_pressure(friction, *pair.second));
}
if (!contact.as_coded) {
  contact.remarks.emplace_back(
      "convention: as_coded in the formulation computes as OpenRadioss (2026) does where that "
      "differs");
}
if (contact.viscous) {
  contact.remarks.emplace_back(
      "interfaces of TYPE21, 24 and 25 take {penalty: stiffness, K_t: ..} all the same");
}
if (friction.filter != 0 && friction.xfreq == 0.0) {
  contact.remarks.push_back(
      fmt::format("the deck's Ifiltr {} has Xfreq 0: no filter", friction.filter));
}
if (is_orthotropic(friction)) contact.orientation = orientation(deck, friction, options);
return contact;
}

}  // namespace slipbench::driver::radioss
