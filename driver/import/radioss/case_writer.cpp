// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/case_writer.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/json.hpp"
#include "driver/import/radioss/check_writer.hpp"

namespace slipbench::driver::radioss {
namespace {

constexpr std::size_t kWidth = 96;

/// "key: number" for the numbers that are not 0.
std::string entry(std::string_view key, double value) {
  return value == 0.0 ? std::string() : fmt::format(", {}: {}", key, base::format_number(value));
}

std::string flow_map(std::string_view name, std::string entries) {
  if (entries.starts_with(", ")) entries.erase(0, 2);
  return fmt::format("{{{}: {{{}}}}}", name, entries);
}

/// A list that breaks into lines behind `indent` blanks.
std::string list_text(const std::vector<int>& numbers, std::size_t indent) {
  std::string text = "[";
  std::size_t column = indent;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string one = std::to_string(numbers[i]) + (i + 1 < numbers.size() ? "," : "");
    if (column + one.size() > kWidth) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (i > 0) {
      text += " ";
      ++column;
    }
    text += one;
    column += one.size();
  }
  return text + "]";
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

/// "coefficient: .." and "VISF: .." of a record, each line behind `indent` blanks.
std::string friction_lines(const DeckFriction& friction, const DeckCoefficients& first,
                           const std::optional<DeckCoefficients>& second, std::size_t indent) {
  const std::string blanks(indent, ' ');
  std::string text = blanks + "coefficient:";
  if (second) {
    text += fmt::format("\n{0}  orthotropic:\n{0}    direction1: {1}\n{0}    direction2: {2}\n",
                        blanks, coefficient(friction, first), coefficient(friction, *second));
  } else {
    text += " " + coefficient(friction, first) + "\n";
  }
  if (friction.formulation == 1 && first.visf != 0.0) {
    text += blanks + "VISF: " + base::format_number(first.visf) + "\n";
  }
  return text;
}

/// Text that a person wrote, in a comment.
std::string comment(const std::string& text) { return text.empty() ? "" : ": " + text; }

class Skeleton {
 public:
  Skeleton(const DeckContents& deck, const DeckFriction& friction, const SkeletonOptions& options)
      : deck_(deck), friction_(friction), options_(options) {
    table_ = !friction.pairs.empty();
    viscous_ = friction.formulation == 1;
    orthotropic_ = is_orthotropic(friction);
    pressure_ = sees_pressure(friction, friction.otherwise) || options.shear_limit > 0.0;
    for (const DeckPair& pair : friction.pairs) {
      pressure_ = pressure_ || sees_pressure(friction, pair.first) ||
                  (pair.second && sees_pressure(friction, *pair.second));
    }
  }

  std::string text() {
    heading();
    parameters();
    connector();
    if (table_) table();
    definition();
    history();
    return std::move(out_);
  }

 private:
  template <class... Argument>
  void line(fmt::format_string<Argument...> text, Argument&&... arguments) {
    out_ += fmt::format(text, std::forward<Argument>(arguments)...) + "\n";
  }

  void heading() {
    line("# {} of {}, written by slipbench import{}", name_of(friction_),
         base::printable(options_.deck), comment(friction_.title));
    for (const std::string& note : options_.notes) line("# {}", base::printable(note));
    line("# The deck has no values for the parameters below: give each one here, or with --set.");
    line("slipbench: 1");
    const std::string title =
        friction_.title.empty() ? "Radioss " + name_of(friction_).substr(1) : friction_.title;
    line("title: {}", base::json::Value(title).dump());
    if (options_.units) {
      line("units: {{length: {}, force: {}, time: {}}}", options_.units->length,
           options_.units->force, options_.units->time);
    } else {
      line("# State the units the deck is in{}:",
           friction_.law == 3 ? "; the Renard law does not run without" : "");
      line("# units: {{length: mm, force: N, time: s}}");
    }
    line("");
  }

  void parameter(std::string_view name, std::string_view text) {
    line("  {:<16}# {}", std::string(name) + ":", text);
  }

  void parameters() {
    line("parameters:");
    if (table_) {
      parameter("part1", "id of the part on one side of the contact");
      parameter("part2", "id of the part on the other side");
    }
    if (pressure_) {
      parameter("area", "of the contact; the solver divides the force by that of one segment");
    }
    if (viscous_) {
      parameter("K", "stiffness of the normal penalty, as the solver's listing gives it");
      parameter("m", "mass of the secondary node");
    } else {
      parameter("K_t", "tangential stiffness of the contact");
    }
    parameter("normal_force", "what presses the contact");
    parameter("speed", "at which it slides");
    parameter("time_step", "of the solver's run");
    line("");
  }

  void connector() {
    line("connector:");
    line("  type: CONTACT");
    if (pressure_) line("  area: = area");
    if (table_) line("  parts: [= part1, = part2]");
    line("");
  }

  void table() {
    line("friction_pairs:");
    // Without all of the deck's parts a list would refuse good ids.
    if (has_all_parts(deck_)) {
      line("  parts: {}", list_text(deck_.parts, 10));
    }
    std::vector<int> groups;
    std::set<int> met;
    for (const DeckPair& pair : friction_.pairs) {
      for (const DeckSide& side : pair.sides) {
        if (side.group > 0 && met.insert(side.group).second) groups.push_back(side.group);
      }
    }
    if (!groups.empty()) line("  groups:");
    for (const int id : groups) {
      const DeckGroup* group = find_group(deck_, id);
      if (group != nullptr && !group->title.empty()) line("    # {}", group->title);
      const std::string name = "G" + std::to_string(id);
      if (group == nullptr || group->parts.empty()) {
        line("    {}: []    # the deck does not list its parts: fill in their ids", name);
      } else {
        line("    {}: {}", name, list_text(group->parts, 7 + name.size()));
      }
    }
    line("  default:");
    out_ += friction_lines(friction_, friction_.otherwise, std::nullopt, 4);
    line("  pairs:    # the last record that joins both parts holds");
    for (const DeckPair& pair : friction_.pairs) {
      line("    - parts: [{}, {}]    # line {} of the deck", side_text(pair.sides[0]),
           side_text(pair.sides[1]), pair.line);
      out_ += friction_lines(friction_, pair.first, pair.second, 6);
    }
    line("");
  }

  void definition() {
    line("friction:");
    line("  - predefined: {{}}");
    if (!table_) {
      DeckCoefficients alone = friction_.otherwise;
      alone.visf = 0.0;  // stands in the formulation
      out_ += friction_lines(friction_, alone, std::nullopt, 4);
    }
    if (options_.shear_limit > 0.0) {
      line("    force_limit: = {}*area   # Ptlim", base::format_number(options_.shear_limit));
    }
    line(
        "    # convention: as_coded in the formulation computes as OpenRadioss (2026) does where "
        "that differs");
    if (viscous_) {
      const double visf = table_ ? 0.0 : friction_.otherwise.visf;
      line("    formulation: {{penalty: viscous{}, K: = K, m: = m}}", entry("VISF", visf));
      line(
          "    # interfaces of TYPE21, 24 and 25 take {{penalty: stiffness, K_t: ..}} all the "
          "same");
    } else {
      line("    formulation: {{penalty: stiffness, K_t: = K_t}}");
    }
    filter();
    if (orthotropic_) orientation();
    line("");
  }

  void filter() {
    if (friction_.filter == 0) return;
    if (friction_.xfreq == 0.0) {
      line("    # the deck's Ifiltr {} has Xfreq 0: no filter", friction_.filter);
      return;
    }
    const std::string x = base::format_number(friction_.xfreq);
    if (friction_.filter == 1) line("    filter: {{simple: {}}}", x);
    if (friction_.filter == 2) line("    filter: {{Xfreq: {}, xfreq_convention: steps}}", x);
    if (friction_.filter == 3) line("    filter: {{frequency: {}}}", x);
  }

  void orientation() {
    line("    # Direction 1 of the orthotropic records is component 2 of this contact (CP2, f2).");
    const std::vector<DeckOrientation> used = used_orientations(deck_, friction_);
    if (used.empty()) {
      line("    # In the deck it is the global x axis, projected on the contact plane.");
    }
    for (const DeckOrientation& entry : used) {
      const auto& v = entry.vector;
      line("    # In the deck{}: ({}, {}, {}){}, projected on the contact plane{} (line {})",
           entry.of.group > 0  ? fmt::format(", group {}", entry.of.group)
           : entry.of.part > 0 ? fmt::format(", part {}", entry.of.part)
                               : "",
           base::format_number(v[0]), base::format_number(v[1]), base::format_number(v[2]),
           entry.skew > 0 ? fmt::format(" in skew {}", entry.skew) : "",
           entry.phi != 0.0
               ? fmt::format(" and turned by {} about its normal", base::format_number(entry.phi))
               : "",
           entry.line);
      if (!options_.normal || entry.skew > 0) continue;
      if (const auto d = direction_in_plane(entry, *options_.normal)) {
        line("    #   before the turn: ({}, {}, {})", base::format_number((*d)[0]),
             base::format_number((*d)[1]), base::format_number((*d)[2]));
      }
    }
  }

  void history() {
    line("history:");
    line("  - step: slide");
    line("    duration: = 1000*time_step");
    line("    increments: 1000");
    line("    force: {{f1: = normal_force}}");
    if (orthotropic_) {
      line("    # at 45 degrees to both directions");
      line(
          "    motion: {{CP2: {{to: = 1000*time_step*speed/sqrt(2)}}, CP3: {{to: = "
          "1000*time_step*speed/sqrt(2)}}}}");
    } else {
      line("    motion: {{CP2: {{to: = 1000*time_step*speed}}}}");
    }
    line("");
    out_ += checks_text(friction_);
  }

  const DeckContents& deck_;
  const DeckFriction& friction_;
  const SkeletonOptions& options_;
  bool table_ = false;
  bool viscous_ = false;
  bool orthotropic_ = false;
  bool pressure_ = false;
  std::string out_;
};

}  // namespace

std::string side_text(const DeckSide& side) {
  return (side.group > 0 ? "G" : "") + std::to_string(side.group > 0 ? side.group : side.part);
}

std::string skeleton(const DeckContents& deck, const DeckFriction& friction,
                     const SkeletonOptions& options) {
  return Skeleton(deck, friction, options).text();
}

}  // namespace slipbench::driver::radioss
