// SPDX-License-Identifier: Apache-2.0
#include "law/update/connector.hpp"

namespace slipbench::law {

std::vector<FrictionRuleViolation> check_rules(const ConnectionInfo& connection,
                                               std::span<const FrictionOutline> definitions) {
  using Rule = FrictionRuleViolation::Rule;
  std::vector<FrictionRuleViolation> violations;
  const int count = static_cast<int>(definitions.size());
  int first_potential = -1;
  for (int d = 0; d < count; ++d) {
    const FrictionOutline& here = definitions[static_cast<std::size_t>(d)];
    for (int c = 0; c < kComponents; ++c) {
      if (here.components.contains(c) && !connection.available.contains(c)) {
        violations.push_back({Rule::kNotAvailable, d, -1, c});
      }
    }
    if (here.form == FrictionForm::kPredefined && count > 1) {
      violations.push_back({Rule::kPredefinedNotAlone, d, d == 0 ? 1 : 0});
      continue;
    }
    if (here.form == FrictionForm::kPotential) {
      if (first_potential >= 0) {
        violations.push_back({Rule::kTwoPotentials, d, first_potential});
      } else {
        first_potential = d;
      }
    }
    for (int e = 0; e < d; ++e) {
      const FrictionOutline& earlier = definitions[static_cast<std::size_t>(e)];
      if (earlier.form == FrictionForm::kPredefined) continue;
      for (int c = 0; c < kComponents; ++c) {
        if (here.components.contains(c) && earlier.components.contains(c)) {
          violations.push_back({Rule::kSharedComponent, d, e, c});
        }
      }
    }
  }
  return violations;
}

}  // namespace slipbench::law
