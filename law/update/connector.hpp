// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "law/connection/connection_type.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// Form in which a definition was written; the rules on mixing depend on it.
enum class FrictionForm : std::uint8_t { kComponent, kPotential, kPredefined };

/// Traits that the rules of several definitions on one connector look at.
struct FrictionOutline {
  FrictionForm form = FrictionForm::kComponent;
  ComponentSet components;
};

/// A broken rule of docs/theory, section 13.1; the indices count the definitions as written.
struct FrictionRuleViolation {
  enum class Rule : std::uint8_t {
    kNotAvailable,       ///< friction on a component the connection holds or does not have
    kSharedComponent,    ///< a free component used by two definitions
    kTwoPotentials,      ///< more than one potential-based definition
    kPredefinedNotAlone  ///< predefined friction together with another definition
  };
  Rule rule = Rule::kNotAvailable;
  int definition = 0;
  int other = -1;
  int component = -1;  ///< index 0..5
};

std::vector<FrictionRuleViolation> check_rules(const ConnectionInfo& connection,
                                               std::span<const FrictionOutline> definitions);

}  // namespace slipbench::law
