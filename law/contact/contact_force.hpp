// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "law/contact/derived_component.hpp"
#include "law/contact/universal_joint_contact.hpp"

namespace slipbench::law {

/// Only the internal contact force acts.
struct NoContactForce {};

/// F_C = f_i, signed (docs/theory, section 6).
struct ComponentContactForce {
  int component = 0;  ///< index 0..5
};

/// The friction-generating contact force F_C = g(f) [F] or moment [F L].
using ContactForce =
    std::variant<NoContactForce, ComponentContactForce, DerivedComponent, UniversalJointContact>;

inline double evaluate(const ContactForce& contact, const ConnectorForce& force,
                       const Ambient& ambient) noexcept {
  // A switch on the index keeps the hot path free of visit's table of function pointers.
  switch (contact.index()) {
    case 1:
      return force[std::get_if<ComponentContactForce>(&contact)->component];
    case 2:
      return evaluate(*std::get_if<DerivedComponent>(&contact), force, ambient);
    case 3:
      return evaluate(*std::get_if<UniversalJointContact>(&contact), force, ambient.position);
    default:
      return 0.0;
  }
}

/// Adds dg/df and dg/d(position).
inline void add_gradient(const ContactForce& contact, const ConnectorForce& force,
                         const Ambient& ambient, ConnectorForce* to_force,
                         RelativePosition* to_position) noexcept {
  if (const auto* component = std::get_if<ComponentContactForce>(&contact)) {
    (*to_force)[component->component] += 1.0;
  } else if (const auto* derived = std::get_if<DerivedComponent>(&contact)) {
    add_gradient(*derived, force, ambient, to_force, to_position);
  } else if (const auto* joint = std::get_if<UniversalJointContact>(&contact)) {
    add_gradient(*joint, force, ambient.position, to_force, to_position);
  }
}

}  // namespace slipbench::law
