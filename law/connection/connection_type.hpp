// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "law/connection/building_blocks.hpp"
#include "law/connection/contact.hpp"
#include "law/connection/cylindrical.hpp"
#include "law/connection/hinge.hpp"
#include "law/connection/planar.hpp"
#include "law/connection/revolute.hpp"
#include "law/connection/slide_plane.hpp"
#include "law/connection/slipring.hpp"
#include "law/connection/slot.hpp"
#include "law/connection/translator.hpp"
#include "law/connection/ujoint.hpp"
#include "law/connection/universal.hpp"

namespace slipbench::law {

/// The single list of connection types. A new type is one header and one entry here.
using ConnectionType =
    std::variant<Slot, SlidePlane, Cylindrical, Translator, Hinge, Planar, UJoint, Join, Link,
                 Axial, RadialThrust, Cartesian, ProjectionCartesian, Align, Revolute, Universal,
                 ConstantVelocity, Cardan, Euler, Rotation, FlexionTorsion,
                 ProjectionFlexionTorsion, Bushing, SlipRing, Contact>;

/// Types with predefined friction declare their parameters in fields() and expand themselves.
template <class Type>
concept HasPredefinedFriction = requires(const Type& type) {
  Type::fields();
  type.predefined();
};

/// Calls `visit(std::type_identity<T>{})` for every connection type, in the order of the list.
template <class Visit>
constexpr void for_each_connection_type(Visit&& visit) {
  [&]<class... T>(std::type_identity<std::variant<T...>>) {
    (visit(std::type_identity<T>{}), ...);
  }(std::type_identity<ConnectionType>{});
}

/// The connection of a case: what is held and free, and the type whose predefined friction it has.
struct Connection {
  ConnectionInfo info;
  /// The assembled (or single) type; of a pair that has no name of its own its part with predefined
  /// friction, or nothing.
  std::optional<ConnectionType> type;
};

/// A connection from its type's name, case as in the documentation (SLIDE-PLANE).
/// \param dimension of space; 2 exists for SLOT and CONTACT only
/// \return nothing for an unknown name, or for 2 where there is no plane version
std::optional<Connection> find_connection(std::string_view name, int dimension = 3);

/// Two basic types as one connection, e.g. SLOT + REVOLUTE = CYLINDRICAL; the order does not
/// matter. A pair that makes no assembled type has the predefined friction of its part, if one has.
/// \return nothing if both constrain or measure the same kind of motion, or one is not
/// basic
std::optional<Connection> assemble(const Connection& first, const Connection& second);

}  // namespace slipbench::law
