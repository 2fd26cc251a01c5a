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
  // Two pairs may hold and free the same and measure it otherwise: BUSHING is no CARTESIAN +
  // CARDAN.
  const auto is_made_of = [](std::string_view assembly, const Connection& one,
                             const Connection& other) {
    const std::string_view left = one.info.name;
    const std::string_view right = other.info.name;
    return assembly.size() == left.size() + 3 + right.size() && assembly.starts_with(left) &&
           assembly.ends_with(right);
  };
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    constexpr std::string_view kMadeOf = Type::kInfo.assembly;
    if (whole.info.name.empty() &&
        (is_made_of(kMadeOf, first, second) || is_made_of(kMadeOf, second, first))) {
      whole = Connection{Type::kInfo, Type{}};
    }
  });
  return whole;
}

}  // namespace slipbench::law
