// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "driver/base/text/suggestions.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/read/resolve/resolve_definition.hpp"
#include "law/friction/part_pairs.hpp"

namespace slipbench::driver::read {
namespace {

/// The name of a group is told from the id of a part by its first character.
bool begins_with_letter(std::string_view name) {
  return !name.empty() && ((name.front() >= 'A' && name.front() <= 'Z') ||
                           (name.front() >= 'a' && name.front() <= 'z'));
}

/// Returns what kind of law a coefficient is, as a word. A number goes with every law that has a
/// constant part of its own.
std::string_view kind_of(const CoefficientText& text) {
  if (text.orthotropic) return kind_of(text.orthotropic->direction1.value.coefficient);
  if (text.with_direction) return kind_of(text.with_direction->forward.value.coefficient);
  if (std::holds_alternative<TableText>(text.value)) return "table";
  return law::name_of(std::get<law::FrictionLaw>(text.value));
}

/// Reads the table of part pairs against its own rules and looks up the connector's parts.
class PairTable {
 public:
  PairTable(yaml::Binder& binder, const yaml::At<FrictionPairsText>& text)
      : binder_(binder), text_(text) {
    for (const yaml::At<int>& part : text.value.parts.value) known_.push_back(part.value);
    std::sort(known_.begin(), known_.end());
  }

  /// The sides of every record as lists of parts.
  /// \return whether the table is sound
  bool resolve() {
    const FrictionPairsText& table = text_.value;
    bool good = text_.sound;
    for (const auto& group : table.groups) {
      good = check_group(group) && good;
      std::vector<int> parts;
      for (const yaml::At<int>& part : group.value) parts.push_back(part.value);
      std::sort(parts.begin(), parts.end());
      groups_.try_emplace(group.name, std::move(parts));
    }
    for (const yaml::At<PartPairText>& record : table.pairs.value) {
      good = resolve_record(record) && good;
    }
    warn_of_mixed_laws();
    return good;
  }

  /// Tells whether a part is one of the known ones, which is reported.
  bool known(int part, const yaml::Node& node, const yaml::Path& path) {
    const yaml::At<std::vector<yaml::At<int>>>& list = text_.value.parts;
    if (!list.given() || list.faulty()) return true;
    if (std::binary_search(known_.begin(), known_.end(), part)) return true;
    binder_.error(node, path,
                  "part " + std::to_string(part) + " is not among those of friction_pairs.parts");
    return false;
  }

  /// The index of the record in force; only of a sound table.
  [[nodiscard]] std::optional<std::size_t> find(int a, int b) const {
    // Of all parts only these two count: long sides need not be copied for each record.
    const auto of_two = [&](const Side& side) {
      std::vector<int> parts;
      for (const int part : {a, b}) {
        if (side.group == nullptr
                ? side.part == part
                : std::binary_search(side.group->begin(), side.group->end(), part)) {
          parts.push_back(part);
        }
      }
      return parts;
    };
    std::vector<law::PartPair> pairs;
    pairs.reserve(records_.size());
    for (const auto& [side1, side2] : records_) pairs.push_back({of_two(side1), of_two(side2)});
    return law::last_joining(pairs, a, b);
  }

 private:
  /// A side of a record.
  struct Side {
    int part = 0;
    const std::vector<int>* group = nullptr;  ///< its parts, ascending; null: a part alone
  };

  bool check_group(const yaml::Named<std::vector<yaml::At<int>>>& group) {
    bool good = group.sound;
    if (!begins_with_letter(group.name)) {
      binder_.error(*group.key, group.path,
                    "a group's name begins with a letter, found '" + base::printable(group.name) +
                        "': a number is the id of a part");
      good = false;
    }
    if (group.sound && group.value.empty()) {
      binder_.error(*group.node, group.path, "a group needs at least one part",
                    "list the ids of its parts");
      good = false;
    }
    for (const yaml::At<int>& part : group.value) {
      if (part.sound) good = known(part.value, *part.node, part.path) && good;
    }
    return good;
  }

  bool resolve_record(const yaml::At<PartPairText>& record) {
    auto& [side1, side2] = records_.emplace_back();
    const yaml::At<std::vector<yaml::At<PartOrGroup>>>& sides = record.value.parts;
    bool good = record.sound;
    if (sides.sound && sides.value.size() != 2) {
      binder_.error(*sides.node, sides.path,
                    "a pair has two sides, found " + std::to_string(sides.value.size()),
                    "a group with itself is written twice");
      return false;
    }
    if (!sides.given() || sides.value.size() != 2) return false;
    good = read_side(sides.value[0], side1) && good;
    return read_side(sides.value[1], side2) && good;
  }

  bool read_side(const yaml::At<PartOrGroup>& at, Side& side) {
    if (!at.sound) return false;
    if (const int* part = std::get_if<int>(&at.value.value)) {
      side.part = *part;
      return known(*part, *at.node, at.path);
    }
    const std::string& name = std::get<std::string>(at.value.value);
    if (const auto group = groups_.find(name); group != groups_.end()) {
      side.group = &group->second;
      return true;
    }
    // A search for the name that was meant; so many messages are not read.
    if (++unknown_groups_ > base::Diagnostics::kMaxKept) {
      binder_.error(*at.node, at.path, "unknown group '" + base::printable(name) + "'");
      return false;
    }
    std::vector<std::string_view> names;
    for (const auto& group : text_.value.groups) names.push_back(group.name);
    binder_.error(*at.node, at.path, "unknown group '" + base::printable(name) + "'",
                  binder_.nearest_or(name, names,
                                     names.empty() ? "name its parts under friction_pairs.groups"
                                                   : "known: " + base::few_in_words(names)));
    return false;
  }

  /// One Ifric holds for a whole table of the solver.
  void warn_of_mixed_laws() {
    std::string_view first;
    std::string first_path;
    const auto look = [&](const yaml::At<CoefficientText>& coefficient) {
      if (!coefficient.sound) return false;
      const std::string_view kind = kind_of(coefficient.value);
      const bool number = kind == law::ConstantCoefficient::kName;
      if (number || kind == first) return false;
      if (first.empty()) {
        first = kind;
        first_path = coefficient.path.text();
        return false;
      }
      binder_.warning(*coefficient.node, coefficient.path,
                      "is " + std::string(kind) + " where " + first_path + " is " +
                          std::string(first) +
                          ": a Radioss table has one law (Ifric) for all its records");
      return true;
    };
    if (look(text_.value.otherwise.value.coefficient)) return;
    for (const yaml::At<PartPairText>& record : text_.value.pairs.value) {
      if (look(record.value.coefficient)) return;
    }
  }

  yaml::Binder& binder_;
  const yaml::At<FrictionPairsText>& text_;
  std::vector<int> known_;  ///< of friction_pairs.parts, ascending
  std::map<std::string_view, std::vector<int>> groups_;
  std::vector<std::array<Side, 2>> records_;
  std::size_t unknown_groups_ = 0;
};

/// The two parts that meet, or nothing, which is reported.
std::optional<std::array<int, 2>> parts_of(yaml::Binder& binder,
                                           const yaml::At<std::vector<yaml::At<int>>>& parts,
                                           PairTable& table) {
  if (!parts.sound) return std::nullopt;
  if (parts.value.size() != 2) {
    binder.error(*parts.node, parts.path,
                 "two parts meet in a connector, found " + std::to_string(parts.value.size()));
    return std::nullopt;
  }
  bool good = true;
  for (const yaml::At<int>& part : parts.value) {
    good = table.known(part.value, *part.node, part.path) && good;
  }
  if (!good) return std::nullopt;
  return std::array{parts.value[0].value, parts.value[1].value};
}

/// Gives a definition the friction of the record.
template <class Record>
void take(yaml::Binder& binder, FrictionText& friction, const Record& record) {
  friction.coefficient = record.coefficient;
  if (record.force_limit.given()) friction.force_limit = record.force_limit;
  const yaml::At<double>& visf = record.visf;
  if (!visf.sound) return;
  FormulationText& form = friction.formulation.value;
  const bool viscous = friction.formulation.given() && form.penalty.sound &&
                       form.penalty.value == PenaltyKind::kViscous &&
                       !form.viscous_coefficient.given();
  if (viscous) {
    form.visf = visf;
  } else {
    binder.note(*visf.node, visf.path,
                "has no effect: it is a factor of the coefficient that a viscous penalty makes of "
                "K and m");
  }
}

/// A definition whose coefficient is not missing, only not known.
void await(FrictionText& friction, const yaml::At<FrictionPairsText>& pairs) {
  if (friction.coefficient.given()) return;
  friction.coefficient.node = pairs.node;
  friction.coefficient.path = pairs.path;
}

}  // namespace

CaseText with_friction_of_parts(yaml::Binder& binder, CaseText text, bool table_known,
                                cases::Case& out) {
  const yaml::At<std::vector<yaml::At<int>>>& parts = text.connector.value.parts;
  const yaml::At<FrictionPairsText>& pairs = text.friction_pairs;
  if (!pairs.given()) {
    if (parts.given() && table_known) {
      binder.error(*parts.node, parts.path,
                   "parts pick a record of 'friction_pairs:', and there is none");
    }
    return text;
  }
  if (!pairs.node->is_map()) {
    for (yaml::At<FrictionText>& friction : text.friction.value) await(friction.value, pairs);
    return text;
  }
  PairTable table(binder, pairs);
  const bool sound = table.resolve();
  std::optional<std::array<int, 2>> meeting;
  if (parts.given()) {
    meeting = parts_of(binder, parts, table);
  } else if (text.connector.given() &&
             !yaml::is_misspelt<ConnectorText>(*text.connector.node, "parts")) {
    binder.error(*pairs.node, pairs.path,
                 "which record holds? Give the two parts that meet: connector: {parts: [a, b]}");
  }

  // What is not picked is judged here, what is picked where it is used.
  const yaml::At<CoefficientText>* coefficient = nullptr;
  std::variant<const PairDefaultText*, const PartPairText*> record;
  std::optional<std::size_t> picked;
  if (sound && meeting) {
    const PairDefaultText& otherwise = pairs.value.otherwise.value;
    const auto [a, b] = *meeting;
    picked = table.find(a, b);
    if (picked) {
      const PartPairText& pair = pairs.value.pairs.value[*picked].value;
      coefficient = &pair.coefficient;
      record = &pair;
    } else if (pairs.value.otherwise.given()) {
      coefficient = &otherwise.coefficient;
      record = &otherwise;
    } else {
      binder.error(*parts.node, parts.path,
                   "no record of friction_pairs joins the parts " + std::to_string(a) + " and " +
                       std::to_string(b) + ", and there is no default");
    }
  }
  const auto judge = [&](const yaml::At<CoefficientText>& other) {
    if (&other == coefficient || !other.sound) return;
    const LawSurroundings surroundings{text.connector.value.area, out.units};
    const auto judge_both = [&](const yaml::At<DirectionText>& first,
                                const yaml::At<DirectionText>& second) {
      for (const yaml::At<DirectionText>* direction : {&first, &second}) {
        coefficient_law(binder, direction->value.coefficient, *direction->node, direction->path,
                        surroundings);
      }
    };
    if (const auto& two = other.value.orthotropic) {
      judge_both(two->direction1, two->direction2);
    } else if (const auto& senses = other.value.with_direction) {
      judge_both(senses->forward, senses->backward);
    } else {
      coefficient_law(binder, other, surroundings);
    }
  };
  if (pairs.value.otherwise.given()) judge(pairs.value.otherwise.value.coefficient);
  for (const yaml::At<PartPairText>& pair : pairs.value.pairs.value) judge(pair.value.coefficient);

  for (yaml::At<FrictionText>& friction : text.friction.value) {
    if (friction.value.coefficient.given()) {
      binder.error(
          *friction.value.coefficient.node, friction.value.coefficient.path,
          "the coefficient comes from 'friction_pairs:', a definition has none of its own");
    } else if (coefficient != nullptr) {
      std::visit([&](const auto* one) { take(binder, friction.value, *one); }, record);
    } else {
      await(friction.value, pairs);
    }
  }
  if (coefficient != nullptr) {
    out.pair = cases::PickedPair{*meeting, picked};
    binder.note(*parts.node, parts.path,
                "parts " + std::to_string((*meeting)[0]) + " and " + std::to_string((*meeting)[1]) +
                    " take the friction of " + out.pair->record());
  }
  return text;
}

}  // namespace slipbench::driver::read
