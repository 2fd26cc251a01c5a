// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/table_place.hpp"

#include <array>

namespace slipbench::driver::calibrate {
namespace {

std::optional<Place> below(const std::optional<Place>& place, std::string_view key) {
  return place ? place->find(key) : std::nullopt;
}

/// Finds the record of part pairs that gives a case its coefficient.
std::optional<Place> record_of(const Place& root, const cases::PickedPair& pair) {
  const auto table = root.find("friction_pairs");
  if (!pair.index) return below(table, "default");
  const auto pairs = below(table, "pairs");
  return pairs ? std::optional(pairs->at(*pair.index)) : std::nullopt;
}

/// Finds the internal contact force of a definition in predefined friction.
std::optional<Place> predefined_internal_force(const Place& predefined, std::size_t definition,
                                               std::size_t definitions) {
  constexpr std::array<std::array<std::string_view, 2>, 2> kKeys{
      {{"internal_contact_force", "internal_contact_moment_1"},
       {"internal_contact_moment", "internal_contact_moment_3"}}};
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    if (definitions > 1 && i != definition) continue;
    for (const std::string_view key : kKeys[i]) {
      if (auto value = predefined.find(key)) return value;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Place> Place::find(std::string_view key) const {
  for (std::size_t i = 0; node.is_map() && i < node.size(); ++i) {
    if (node.entry(i).key.text() == key) return at(i);
  }
  return std::nullopt;
}

Place Place::at(std::size_t i) const {
  Place below{node[i], way, node.is_map() ? path / node.entry(i).key.text() : path / i};
  below.way.push_back(i);
  return below;
}

std::string_view word_of(VariedTable::Use use) {
  return use == VariedTable::Use::kCoefficient ? "coefficient" : "internal_contact_force";
}

std::vector<std::string> entry_names(const yaml::Node& root) {
  std::vector<std::string> names;
  const auto list = root.find("friction");
  for (std::size_t i = 0; list && list->is_sequence() && i < list->size(); ++i) {
    const auto name = (*list)[i].find("name");
    names.push_back(name ? std::string(name->text()) : "friction" + std::to_string(i + 1));
  }
  return names;
}

std::optional<Place> table_place(const yaml::Node& root, const cases::Case& problem,
                                 std::size_t definition, VariedTable::Use use) {
  const Place whole{root};
  const auto friction = whole.find("friction");
  const std::size_t index = problem.definitions[definition].entry;
  if (!friction || !friction->node.is_sequence() || index >= friction->node.size()) {
    return std::nullopt;
  }
  const Place entry = friction->at(index);
  if (auto own = entry.find(word_of(use))) return own;
  if (use == VariedTable::Use::kCoefficient) {
    return problem.pair ? below(record_of(whole, *problem.pair), word_of(use)) : std::nullopt;
  }
  const auto predefined = entry.find("predefined");
  if (!predefined) return std::nullopt;
  return predefined_internal_force(*predefined, definition, problem.definitions.size());
}

}  // namespace slipbench::driver::calibrate
