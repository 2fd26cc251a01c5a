// SPDX-License-Identifier: Apache-2.0
#include "driver/case/key_index.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/resolve.hpp"

namespace slipbench::driver {
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

std::optional<law::Connection> one_type(Binder& binder, const At<std::string>& name,
                                        int dimension) {
  if (auto found = law::find_connection(name.value, dimension)) return found;
  if (dimension == 2 && law::find_connection(name.value)) {
    binder.error(*name.node, name.path,
                 name.value + " has no two-dimensional form; only SLOT may say dimension: 2");
    return std::nullopt;
  }
  if (const auto why = later_key(name.value)) {
    binder.error(*name.node, name.path, std::string(*why));
    return std::nullopt;
  }
  std::vector<std::string_view> known;
  law::for_each_connection_type(
      [&]<class Type>(std::type_identity<Type>) { known.push_back(Type::kInfo.name); });
  std::string hint = "known: " + in_words(known, "and");
  if (const auto nearest = nearest_name(name.value, known)) {
    hint = "did you mean '" + std::string(*nearest) + "'?";
  }
  binder.error(*name.node, name.path, "unknown connection type '" + printable(name.value) + "'",
               std::move(hint));
  return std::nullopt;
}

void read_positions(Binder& binder, const NamedMap<double>& text, const Case& problem,
                    law::RelativePosition& out) {
  const law::ComponentSet measured =
      problem.connection.info.held | problem.connection.info.available;
  for (const Named<double>& entry : text) {
    const auto component = component_of_motion(entry.name);
    if (!component) {
      std::string hint = "positions are " + motion_names(measured);
      binder.error(*entry.key, entry.path, "unknown position", std::move(hint));
    } else if (!measured.contains(*component)) {
      binder.error(*entry.key, entry.path,
                   connector_words(problem.connection) + " has no component " +
                       std::to_string(*component + 1) + "; it has " + motion_names(measured));
    } else {
      out[*component] = entry.value;
    }
  }
}

}  // namespace

std::string connector_words(const law::Connection& connection) {
  if (connection.info.name.empty()) return "this connector";
  const bool vowel = connection.info.name == "ALIGN";
  return (vowel ? "an " : "a ") + std::string(connection.info.name) + " connector";
}
std::string motion_names(law::ComponentSet set) { return names_of(set, motion_name); }
std::string force_names(law::ComponentSet set) { return names_of(set, force_name); }

void resolve_connector(Binder& binder, const CaseText& text, Case& out) {
  const ConnectorText& connector = text.connector.value;
  const std::vector<At<std::string>>& names = connector.type.value.names;
  std::vector<law::Connection> parts;
  for (const At<std::string>& name : names) {
    if (auto part = one_type(binder, name, names.size() == 1 ? connector.dimension.value : 3)) {
      parts.push_back(std::move(*part));
    }
  }
  if (parts.size() < names.size()) return;
  if (parts.size() == 1) {
    out.connection = std::move(parts[0]);
  } else {
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
                   "translations: SLOT, SLIDE-PLANE, JOIN, CARTESIAN; rotations: REVOLUTE, ALIGN, "
                   "UNIVERSAL, CARDAN, ROTATION");
      return;
    }
    out.connection = std::move(*whole);
  }
  read_positions(binder, connector.initial, out, out.initial);
  out.reference = out.initial;
  read_positions(binder, connector.reference, out, out.reference);
}

}  // namespace slipbench::driver
