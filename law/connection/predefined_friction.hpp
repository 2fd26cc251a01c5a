// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "law/base/component.hpp"
#include "law/base/field.hpp"
#include "law/contact/contact_force.hpp"
#include "law/contact/internal_contact_force.hpp"
#include "law/definition/friction_definition.hpp"

namespace slipbench::law {

/// Components that a connection type holds and leaves free (docs/theory, section 2). Components in
/// neither set are not part of the connection: no motion is measured and no reaction acts there.
struct ConnectionInfo {
  std::string_view name;
  std::string_view text;      ///< one sentence for `slipbench describe`
  std::string_view assembly;  ///< the basic types it is made of, or "basic"
  ComponentSet held;          ///< constrained: forces are reactions
  ComponentSet available;     ///< free: motions are prescribed, friction may act
};

/// One stick-slip check that predefined friction stands for: predefined friction is nothing but an
/// automatic choice of potential and contact force.
struct PredefinedFriction {
  std::string_view suffix;  ///< tells the checks of PLANAR, UJOINT and a chain of rings apart
  SlipSpace slip;
  ContactForce contact_force;
  InternalContactForce internal_contact_force;
  SlipCriterion criterion{};  ///< the Euclidean norm unless said otherwise
  int number = 0;             ///< follows the suffix in a chain of rings; 0 does not
};

}  // namespace slipbench::law
