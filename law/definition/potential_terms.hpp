// SPDX-License-Identifier: Apache-2.0
// From the terms of a case to a potential and its slip space; not on the update path.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "law/contact/derived_component.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/potential.hpp"

namespace slipbench::law {

/// H of a contribution: what becomes of X = (E - a)/R.
enum class ContributionFunction : std::uint8_t {
  kAbs,       ///< |X|
  kMacauley,  ///< max(X, 0)
  kIdentity   ///< X
};

/// One contribution s H((E - a)/R)^p of a potential (docs/theory, section 7).
struct PotentialContribution {
  std::variant<int, DerivedComponent> of = 0;  ///< E: a component (index 0..5) or a derived one
  double scale = 1.0;                          ///< R > 0
  double shift = 0.0;                          ///< a, in the unit of E
  ContributionFunction function = ContributionFunction::kAbs;
  double sign = 1.0;               ///< s
  std::optional<double> exponent;  ///< p; without it the b of the potential
};

/// Reason why terms make no potential of friction.
struct PotentialViolation {
  enum class Rule : std::uint8_t {
    kSign,              ///< s = -1
    kExponent,          ///< p != b
    kOneSided,          ///< identity of a component or of a sum: a sum-kind contribution
    kIdentityExponent,  ///< identity with b != 1
    kIdentityShift,     ///< identity with a shift
    kConcave,           ///< abs of a norm or Macauley sum with a > 0
    kMixedTerms,        ///< a derived component of sum terms and others
    kTermSign,          ///< a norm or Macauley term with sign -1
    kWeightTable,       ///< weights that vary
    kNoWeight,          ///< weight 0 in all terms
    kTwice              ///< a component in two terms or contributions
  };
  Rule rule = Rule::kSign;
  int contribution = 0;
  int component = -1;  ///< index 0..5 where the rule concerns one
};

/// Potential that the terms make. With violations slip space and criterion are incomplete.
struct BuiltPotential {
  SlipSpace slip;
  SlipCriterion criterion;  ///< EuclideanPotential where P is the norm of the slip space
  std::vector<PotentialViolation> violations;
};

/// The slip space is the set of components that enter, in the order of the terms; entry c has the
/// scale R_c = 1 / P(unit force in c), shifts left out, so that P = 1 for a unit along each entry
/// and one stick stiffness serves all.
/// \param exponent b >= 1; ignored by kMax, as are those of the contributions
BuiltPotential build_potential(std::span<const PotentialContribution> contributions,
                               PotentialOperator combine, double exponent);

}  // namespace slipbench::law
