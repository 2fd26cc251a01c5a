// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/behavior.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/import/abaqus/keyword_list.hpp"
#include "driver/import/abaqus/rows.hpp"

namespace slipbench::driver::abaqus {
namespace {

std::optional<double> number_of(const KeywordDeck& deck, const Block& block, std::string_view name,
                                double lowest) {
  const Parameter* const one = block.find(name);
  if (one == nullptr) return std::nullopt;
  const auto number = deck.number(one->value.value_or(""));
  if (!number) {
    deck.error(one->where, block, fmt::format("{}: {}", name, number.error()));
  } else if (*number < lowest) {
    deck.error(one->where, block, fmt::format("{} must be at least {}", name, lowest));
  } else {
    return *number;
  }
  return std::nullopt;
}

int count_of(const KeywordDeck& deck, const Block& block, std::string_view name) {
  constexpr double kMost = 100.0;
  const auto number = number_of(deck, block, name, 0.0);
  if (!number) return 0;
  if (*number != std::floor(*number) || *number > kMost) {
    deck.error(block.find(name)->where, block, fmt::format("{} is a whole number", name));
    return 0;
  }
  return static_cast<int>(*number);
}

std::optional<int> component_of(const KeywordDeck& deck, const Block& block) {
  const Parameter* const one = block.find("COMPONENT");
  if (one == nullptr) return std::nullopt;
  const auto component = component_in(deck, one->value.value_or(""));
  if (!component) deck.error(one->where, block, "COMPONENT is a number from 1 to 6");
  return component;
}

/// Reads the line of component numbers of INDEPENDENT COMPONENTS.
std::vector<int> components_in(const KeywordDeck& deck, const Block& block, const Items& items) {
  std::vector<int> components;
  for (const std::string_view item : items) {
    if (item.empty()) continue;
    const auto component = component_in(deck, item);
    if (!component) {
      deck.error(item, block, "wanted numbers of components, from 1 to 6");
      return {};
    }
    components.push_back(*component);
  }
  return components;
}

/// Reads independent components, where there are some: the kind, and the first line.
void read_independents(const KeywordDeck& deck, const Block& block, std::vector<Items>& lines,
                       bool& constitutive, std::vector<int>& independents) {
  if (!block.has("INDEPENDENT COMPONENTS")) return;
  constitutive = word_of(deck, block, "INDEPENDENT COMPONENTS",
                         {"POSITION", "CONSTITUTIVE MOTION"}) == "CONSTITUTIVE MOTION";
  if (block.find("INDEPENDENT COMPONENTS")->value == std::nullopt) constitutive = false;
  if (lines.empty()) {
    deck.error(block.where, block, "wanted a line with the numbers of the independent components");
    return;
  }
  independents = components_in(deck, block, lines.front());
  lines.erase(lines.begin());
}

std::variant<int, std::string> component_or_label(const KeywordDeck& deck, std::string_view item) {
  if (const auto component = component_in(deck, item)) return *component;
  return label_of(item);
}

DerivedTerm read_derived(const KeywordDeck& deck, const Block& block) {
  DerivedTerm term{.where = block.where};
  term.op = word_of(deck, block, "OPERATOR", {"NORM", "SUM", "MACAULEY SUM"});
  const std::string sign = word_of(deck, block, "SIGN", {"POSITIVE", "NEGATIVE"});
  term.sign = sign == "NEGATIVE" ? -1 : 1;
  term.fields = count_of(deck, block, "DEPENDENCIES");
  std::vector<Items> lines = deck.lines(block);
  read_independents(deck, block, lines, term.constitutive, term.independents);
  if (lines.empty()) {
    deck.error(block.where, block, "wanted a line with the numbers of the components");
    return term;
  }
  term.components = components_in(deck, block, lines.front());
  lines.erase(lines.begin());
  const std::size_t most =
      term.components.size() + term.independents.size() + 1 + static_cast<std::size_t>(term.fields);
  term.rows = read_rows(deck, block, lines, most,
                        "a factor for each component, independents, temperature, fields");
  return term;
}

Potential read_potential(const KeywordDeck& deck, const Block& block) {
  constexpr std::size_t kItems = 6;
  Potential potential;
  potential.maximum = word_of(deck, block, "OPERATOR", {"SUM", "MAX"}) == "MAX";
  potential.exponent = number_of(deck, block, "EXPONENT", 0.0).value_or(2.0);
  for (const Items& items : deck.lines(block)) {
    if (items.size() > kItems) {
      deck.error(items[kItems], block, "wanted at most: component, R, exponent, H, shift, sign");
      continue;
    }
    PotentialTerm term{.where = items.front()};
    term.of = component_or_label(deck, items.front());
    const auto item = [&](std::size_t i) {
      return i < items.size() ? items[i] : std::string_view();
    };
    const auto number = [&](std::size_t i, auto& target) {
      if (item(i).empty()) return;
      const auto found = deck.number(item(i));
      if (found) {
        target = *found;
      } else {
        deck.error(item(i), block, found.error());
      }
    };
    number(1, term.scale);
    number(2, term.exponent);
    if (!item(3).empty()) {
      constexpr std::array<std::string_view, 3> kUses{"ABS", "MACAULEY", "NONE"};
      const FoundName use = find_name(item(3), kUses);
      if (use.name.empty()) deck.error(item(3), block, "wanted ABS, MACAULEY or NONE");
      term.use = use.name;
    }
    number(4, term.shift);
    double sign = 1.0;
    constexpr std::array<std::string_view, 2> kSigns{"POSITIVE", "NEGATIVE"};
    const FoundName word = find_name(item(5), kSigns);
    if (word.name.empty()) {
      number(5, sign);
    } else if (word.name == "NEGATIVE") {
      sign = -1.0;
    }
    term.sign = sign < 0.0 ? -1 : 1;
    potential.terms.push_back(term);
  }
  if (potential.terms.empty()) deck.error(block.where, block, "has no contributions");
  return potential;
}

Friction read_friction(const KeywordDeck& deck, const Block& block) {
  Friction friction{.where = block.where, .name = block.name};
  friction.fields = count_of(deck, block, "DEPENDENCIES");
  friction.stick_stiffness = number_of(deck, block, "STICK STIFFNESS", 0.0);
  std::vector<Items> lines = deck.lines(block);
  if (block.has("PREDEFINED")) {
    for (const std::string_view other : {"COMPONENT", "CONTACT FORCE", "INDEPENDENT COMPONENTS"}) {
      if (const Parameter* const one = block.find(other)) {
        deck.error(
            one->where, block,
            fmt::format("PREDEFINED goes with no {}: it states the contact force itself", other));
      }
    }
    constexpr std::size_t kMost = 6;
    const std::vector<Row> rows = read_rows(deck, block, lines, kMost, "one line of numbers");
    if (rows.size() > 1) {
      deck.error(lines[1].front(), block, "PREDEFINED has one line of numbers");
    }
    friction.predefined = rows.empty() ? Row() : rows.front();
    return friction;
  }
  friction.component = component_of(deck, block);
  if (const Parameter* const contact = block.find("CONTACT FORCE")) {
    friction.contact_force = component_or_label(deck, contact->value.value_or(""));
  }
  if (block.parameters.empty() && lines.size() == 1 && lines[0].size() == 3) {
    deck.error(lines[0].front(), block,
               "three numbers without a parameter are a form that is no longer read",
               "predefined friction is *CONNECTOR FRICTION, PREDEFINED");
    return friction;
  }
  read_independents(deck, block, lines, friction.constitutive, friction.independents);
  const std::size_t most =
      3 + friction.independents.size() + static_cast<std::size_t>(friction.fields);
  friction.rows =
      read_rows(deck, block, lines, most,
                "internal contact force, independents, accumulated slip, temperature, fields");
  return friction;
}

Spring read_spring(const KeywordDeck& deck, const Block& block, Behavior& behavior) {
  Spring spring{.where = block.where};
  spring.component = component_of(deck, block);
  spring.nonlinear = block.has("NONLINEAR");
  spring.fields = count_of(deck, block, "DEPENDENCIES");
  const std::string name = fmt::format("*{} ({})", block.keyword, deck.place(block.where));
  for (const std::string_view other :
       {"INDEPENDENT COMPONENTS", "FREQUENCY DEPENDENCE", "UNSYMM"}) {
    if (block.has(other)) behavior.not_taken.push_back(name + ": " + std::string(other));
  }
  if (const Parameter* const type = block.find("TYPE")) {
    if (folded(type->value.value_or("")) != "VISCOUS") {
      behavior.not_taken.push_back(name + ": TYPE=" + std::string(type->value.value_or("")));
    }
  }
  if (block.has("RIGID")) {
    behavior.not_taken.push_back(name + ": RIGID");
    return spring;
  }
  constexpr std::size_t kCoupled = 21;
  const std::size_t most = spring.component ? (spring.nonlinear ? 3U : 2U) : kCoupled + 1;
  const std::vector<Items> lines = deck.lines(block);
  spring.rows = read_rows(deck, block, lines, most + static_cast<std::size_t>(spring.fields),
                          "force or stiffness, motion, temperature, fields");
  if (lines.empty()) deck.error(block.where, block, "has no data line");
  return spring;
}

Stop read_stop(const KeywordDeck& deck, const Block& block) {
  Stop stop{.where = block.where};
  const auto component = component_of(deck, block);
  if (!component && !block.has("COMPONENT")) {
    deck.error(block.where, block, "COMPONENT is missing");
  }
  stop.component = component.value_or(1);
  const std::vector<Row> rows = read_rows(deck, block, deck.lines(block), 2, "lower, upper");
  if (rows.empty()) return stop;
  stop.lower = rows[0][0];
  if (rows[0].size() > 1) stop.upper = rows[0][1];
  return stop;
}

}  // namespace

Coefficient read_coefficient(const KeywordDeck& deck, const Block& block) {
  Coefficient coefficient{.where = block.where};
  for (const std::string_view other : {"ROUGH", "LAGRANGE", "USER", "ANISOTROPIC"}) {
    if (const Parameter* const one = block.find(other)) {
      deck.error(one->where, block, fmt::format("{} is not for connectors", other));
      return coefficient;
    }
  }
  if (const Parameter* const slope = block.find("SHEAR TRACTION SLOPE")) {
    deck.warning(slope->where, block, "SHEAR TRACTION SLOPE is not read",
                 "a connector's stiffness in stick is STICK STIFFNESS of *CONNECTOR FRICTION");
  }
  coefficient.fields = count_of(deck, block, "DEPENDENCIES");
  coefficient.force_limit = number_of(deck, block, "TAUMAX", 0.0);
  coefficient.slip_tolerance = number_of(deck, block, "SLIP TOLERANCE", 0.0);
  coefficient.elastic_slip = number_of(deck, block, "ELASTIC SLIP", 0.0);
  if (block.has("ELASTIC SLIP") && !(coefficient.elastic_slip > 0.0)) {
    deck.error(block.find("ELASTIC SLIP")->where, block, "wanted an elastic slip above 0");
  }
  const std::vector<Items> lines = deck.lines(block);
  if (block.has("EXPONENTIAL DECAY")) {
    coefficient.kind =
        block.has("TEST DATA") ? Coefficient::Kind::kTestData : Coefficient::Kind::kDecay;
    if (const Parameter* const one = block.find("TAUMAX")) {
      deck.error(one->where, block, "TAUMAX goes with no EXPONENTIAL DECAY");
    }
    const bool test = coefficient.kind == Coefficient::Kind::kTestData;
    coefficient.rows =
        read_rows(deck, block, lines, test ? 2 : 3, test ? "mu, slip rate" : "mu_s, mu_k, decay");
    const std::size_t count = coefficient.rows.size();
    if (test ? count < 2 || count > 3 : count != 1 || coefficient.rows[0].size() != 3) {
      deck.error(block.where, block,
                 test ? "wanted two or three lines: mu at rest, mu and its slip rate, mu far beyond"
                      : "wanted one line: mu_s, mu_k, decay");
    }
    return coefficient;
  }
  if (const Parameter* const one = block.find("TEST DATA")) {
    deck.error(one->where, block, "TEST DATA goes with EXPONENTIAL DECAY");
  }
  coefficient.rows = read_rows(deck, block, lines, 4 + static_cast<std::size_t>(coefficient.fields),
                               "mu, slip rate, contact force, temperature, fields");
  if (lines.empty()) deck.error(block.where, block, "has no coefficient");
  return coefficient;
}

Behavior read_behavior(const KeywordDeck& deck, std::size_t& at) {
  const std::vector<Block>& blocks = deck.blocks();
  const Block& head = blocks[at];
  Behavior behavior{.name = {}, .where = head.where};
  const Parameter* const name = head.find("NAME");
  if (name == nullptr || !name->value) {
    deck.error(head.where, head, "NAME is missing");
  } else {
    behavior.name = *name->value;
  }
  behavior.linear_extrapolation =
      word_of(deck, head, "EXTRAPOLATION", {"CONSTANT", "LINEAR"}) == "LINEAR";
  const auto friction_before = [&](const Block& block) -> Friction* {
    if (!behavior.frictions.empty()) return &behavior.frictions.back();
    deck.error(block.where, block, "belongs behind a *CONNECTOR FRICTION");
    return nullptr;
  };
  for (++at; at < blocks.size(); ++at) {
    const Block& block = blocks[at];
    const std::string_view keyword = block.keyword;
    if (keyword == "CONNECTOR FRICTION") {
      behavior.frictions.push_back(read_friction(deck, block));
    } else if (keyword == "FRICTION") {
      if (Friction* const friction = friction_before(block)) {
        if (friction->coefficient) deck.error(block.where, block, "is the second of one friction");
        friction->coefficient = read_coefficient(deck, block);
      }
    } else if (keyword == "CONNECTOR POTENTIAL") {
      if (Friction* const friction = friction_before(block)) {
        friction->potential = read_potential(deck, block);
      }
    } else if (keyword == "CONNECTOR DERIVED COMPONENT") {
      const Parameter* const own = block.find("NAME");
      if (own == nullptr || !own->value) {
        deck.error(block.where, block, "NAME is missing");
        continue;
      }
      const std::string label = label_of(*own->value);
      auto found = std::find_if(behavior.derived.begin(), behavior.derived.end(),
                                [&](const auto& one) { return one.first == label; });
      if (found == behavior.derived.end()) {
        behavior.derived.emplace_back(label, std::vector<DerivedTerm>());
        found = std::prev(behavior.derived.end());
      }
      found->second.push_back(read_derived(deck, block));
    } else if (keyword == "CONNECTOR ELASTICITY") {
      behavior.elasticity.push_back(read_spring(deck, block, behavior));
    } else if (keyword == "CONNECTOR DAMPING") {
      behavior.damping.push_back(read_spring(deck, block, behavior));
    } else if (keyword == "CONNECTOR STOP") {
      behavior.stops.push_back(read_stop(deck, block));
    } else if (keyword == "CONNECTOR CONSTITUTIVE REFERENCE") {
      const std::vector<Row> rows = read_rows(deck, block, deck.lines(block), 6, "six positions");
      for (std::size_t i = 0; !rows.empty() && i < rows[0].size(); ++i) {
        behavior.reference[i] = rows[0][i];
      }
    } else if (keyword.starts_with("CONNECTOR") && keyword != "CONNECTOR BEHAVIOR" &&
               keyword != "CONNECTOR SECTION" && keyword != "CONNECTOR MOTION" &&
               keyword != "CONNECTOR LOAD") {
      behavior.not_taken.push_back(fmt::format("*{} ({})", keyword, deck.place(block.where)));
    } else {
      return behavior;
    }
  }
  return behavior;
}

}  // namespace slipbench::driver::abaqus
