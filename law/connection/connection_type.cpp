// SPDX-License-Identifier: Apache-2.0
#include "law/connection/connection_type.hpp"

namespace slipbench::law {
namespace {

constexpr ComponentSet kTranslations = ComponentSet::of(1, 2, 3);

bool is_basic(const Connection& connection) { return connection.info.assembly == "basic"; }

bool is_translational(const Connection& connection) {
  return !((connection.info.held | connection.info.available) & kTranslations).empty();
}

bool has_predefined_friction(const Connection& connection) {
  return std::visit([]<class Type>(const Type&) { return HasPredefinedFriction<Type>; },
                    *connection.type);
}

}  // namespace

std::optional<Connection> find_connection(std::string_view name, int dimension) {
  std::optional<Connection> found;
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if (Type::kInfo.name != name) return;
    if (dimension == 3) {
      found = Connection{Type::kInfo, Type{}};
    } else if constexpr (requires { Type::kPlaneInfo; }) {
      Type plane;
      plane.dimension = 2;
      found = Connection{Type::kPlaneInfo, plane};
    }
  });
  return found;
}

std::optional<Connection> assemble(const Connection& first, const Connection& second) {
  if (!is_basic(first) || !is_basic(second)) return std::nullopt;
  if (is_translational(first) == is_translational(second)) return std::nullopt;
  Connection whole;
  whole.info = {.name = {},
                .text = "Two basic types together.",
                .assembly = "pair of basic types",
                .held = first.info.held | second.info.held,
                .available = first.info.available | second.info.available};
  // A pair that makes no assembled type rubs as its part that has predefined friction does: SLOT +
  // CARDAN as SLOT. Without such a part, as in JOIN + CARDAN, there is user-defined friction only.
  for (const Connection* part : {&first, &second}) {
    if (has_predefined_friction(*part)) whole.type = part->type;
  }
  // An assembled type is recognised by what it holds and frees.
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if (Type::kInfo.held == whole.info.held && Type::kInfo.available == whole.info.available) {
      whole = Connection{Type::kInfo, Type{}};
    }
  });
  return whole;
}

}  // namespace slipbench::law
