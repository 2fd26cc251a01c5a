// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include "driver/base/text/suggestions.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/quantity_dimension.hpp"
#include "driver/read/keys/degrees.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

std::string names_of(law::ComponentSet set, std::string (*name)(int)) {
  std::string text;
  for (int c = 0; c < law::kComponents; ++c) {
    if (!set.contains(c)) continue;
    if (!text.empty()) text += ", ";
    text += name(c);
  }
  return text.empty() ? "none" : text;
}

std::optional<law::Connection> one_type(yaml::Binder& binder, const yaml::At<std::string>& name,
                                        int dimension) {
  if (auto found = law::find_connection(name.value, dimension)) return found;
  if (dimension == 2 && law::find_connection(name.value)) {
    binder.error(
        *name.node, name.path,
        name.value + " has no two-dimensional form; only SLOT and CONTACT may say dimension: 2");
    return std::nullopt;
  }
  if (const auto later = later_key(name.value)) {
    binder.error(*name.node, name.path, std::string(later->why));
    return std::nullopt;
  }
  std::vector<std::string_view> known;
  law::for_each_connection_type(
      [&]<class Type>(std::type_identity<Type>) { known.push_back(Type::kInfo.name); });
  binder.error(*name.node, name.path,
               "unknown connection type '" + base::printable(name.value) + "'",
               base::did_you_mean(name.value, known, "'slipbench list connections' shows all"));
  return std::nullopt;
}

void read_positions(yaml::Binder& binder, const yaml::NamedMap<double>& text,
                    const cases::Case& problem, law::RelativePosition& out) {
  const law::ComponentSet measured =
      problem.connection.info.held | problem.connection.info.available;
  for (const yaml::Named<double>& entry : text) {
    const auto component = cases::component_of_motion(entry.name);
    if (!component) {
      binder.error(*entry.key, entry.path, "unknown position '" + base::printable(entry.name) + "'",
                   nearest_component(entry.name, measured, cases::motion_name,
                                     "positions are " + motion_names(measured)));
    } else if (!measured.contains(*component)) {
      binder.error(*entry.key, entry.path,
                   connector_words(problem.connection) + " has no component " +
                       std::to_string(*component + 1) + "; it has " + motion_names(measured));
    } else if (entry.sound) {
      if (law::is_rotation(*component)) {
        doubt_angle(binder, *entry.node, entry.path, AngleUse::kSwing);
      }
      binder.settle_units(entry.path, cases::dimension_of(cases::kFirstMotion + *component));
      out[*component] = entry.value;
    }
  }
}

/// "SLOT, SLIDE-PLANE, ..", the basic types of one kind of motion.
std::string basic_types(bool rotations) {
  std::string text;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    const law::ConnectionInfo& info = Type::kInfo;
    const law::ComponentSet all = info.held | info.available;
    const bool turns = all.contains(3) || all.contains(4);
    if (info.assembly != "basic" || turns != rotations) return;
    text += (text.empty() ? "" : ", ") + std::string(info.name);
  });
  return text;
}

std::optional<law::Connection> connection_of(yaml::Binder& binder, const ConnectorText& connector) {
  const std::vector<yaml::At<std::string>>& names = connector.type.value.names;
  if (!connector.type.sound || names.empty()) return std::nullopt;
  std::vector<law::Connection> parts;
  for (const yaml::At<std::string>& name : names) {
    const int dimension = names.size() == 1 ? connector.dimension.value : 3;
    if (auto part = one_type(binder, name, dimension)) parts.push_back(std::move(*part));
  }
  if (parts.size() < names.size()) return std::nullopt;
  if (parts.size() == 1) return std::move(parts[0]);
  if (connector.dimension.value != 3) {
    binder.error(*connector.dimension.node, connector.dimension.path,
                 "a pair of basic types lives in three dimensions");
  }
  auto whole = law::assemble(parts[0], parts[1]);
  if (!whole) {
    binder.error(*connector.type.node, connector.type.path,
                 names[0].value + " and " + names[1].value +
                     " do not make a pair: it takes one basic type for translations and one for "
                     "rotations",
                 "translations: " + basic_types(false) + "; rotations: " + basic_types(true));
  }
  return whole;
}

}  // namespace

std::string component_words(int component) { return "component " + std::to_string(component + 1); }

std::string connector_words(const law::Connection& connection) {
  if (connection.info.name.empty()) return "this connector";
  // A U of these names is spoken as in "union".
  const bool vowel = std::string_view("AEIO").find(connection.info.name[0]) != std::string::npos;
  return (vowel ? "an " : "a ") + std::string(connection.info.name) + " connector";
}
std::string nearest_component(std::string_view name, law::ComponentSet set,
                              std::string (*name_of_component)(int), std::string otherwise) {
  // One wrong digit is as near as another: only a slip in letter case is certain.
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  for (int c = 0; c < law::kComponents; ++c) {
    const std::string known = name_of_component(c);
    if (set.contains(c) && std::equal(known.begin(), known.end(), name.begin(), name.end(), same)) {
      return "did you mean '" + known + "'?";
    }
  }
  return otherwise;
}
std::string motion_names(law::ComponentSet set) { return names_of(set, cases::motion_name); }
std::string force_names(law::ComponentSet set) { return names_of(set, cases::force_name); }

law::Connection any_connection() {
  law::Connection connection;
  for (int c = 0; c < law::kComponents; ++c) {
    connection.info.held.insert(c);
    connection.info.available.insert(c);
  }
  return connection;
}
bool is_any_connection(const law::Connection& connection) {
  return !(connection.info.held & connection.info.available).empty();
}

void resolve_connector(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const ConnectorText& connector = text.connector.value;
  out.connection = any_connection();
  if (auto connection = connection_of(binder, connector)) out.connection = std::move(*connection);
  read_positions(binder, connector.initial, out, out.initial);
  out.reference = out.initial;
  read_positions(binder, connector.reference, out, out.reference);
}

}  // namespace slipbench::driver::read
