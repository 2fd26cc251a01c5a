// SPDX-License-Identifier: Apache-2.0
#include "law/definition/potential_terms.hpp"

#include <algorithm>
#include <cmath>

#include "law/base/component.hpp"

namespace slipbench::law {
namespace {

using Rule = PotentialViolation::Rule;

class Builder {
 public:
  Builder(PotentialOperator combine, double exponent) {
    potential_.combine = combine;
    potential_.exponent = exponent;
    built_.slip.dimension = 0;
  }

  void add(const PotentialContribution& contribution) {
    here_ = contribution_++;
    const auto* terms = std::get_if<DerivedComponent>(&contribution.of);
    if (terms != nullptr && terms->empty()) return fault(Rule::kNoWeight);
    // More contributions than components: this one names a component that is taken.
    if (here_ >= kComponents) {
      return fault(Rule::kTwice,
                   terms != nullptr ? terms->front().component[0] : std::get<int>(contribution.of));
    }
    if (contribution.sign < 0.0) fault(Rule::kSign);
    const bool sum = potential_.combine == PotentialOperator::kSum;
    if (sum && contribution.exponent && *contribution.exponent != potential_.exponent) {
      fault(Rule::kExponent);
    }
    if (const int* component = std::get_if<int>(&contribution.of)) {
      add_line(contribution, {{*component, 1.0}});
      return;
    }
    const auto& derived = std::get<DerivedComponent>(contribution.of);
    const auto is_sum = [](const DerivedTerm& t) { return t.combine == TermOperator::kSum; };
    if (std::any_of(derived.begin(), derived.end(),
                    [](const DerivedTerm& t) { return t.weight_table.has_value(); })) {
      fault(Rule::kWeightTable);
    } else if (std::all_of(derived.begin(), derived.end(), is_sum)) {
      add_line(contribution, weights_of_sum(derived));
    } else if (std::any_of(derived.begin(), derived.end(), is_sum)) {
      fault(Rule::kMixedTerms);
    } else {
      add_norms(contribution, derived);
    }
  }

  BuiltPotential finish() {
    potential_.parts = contribution_;
    if (built_.violations.empty() && !is_euclidean()) built_.criterion = potential_;
    if (built_.slip.dimension == 0) built_.slip.dimension = 1;
    return std::move(built_);
  }

 private:
  using Weights = std::vector<std::pair<int, double>>;  // component index, weight

  void fault(Rule rule, int component = -1) {
    built_.violations.push_back({rule, here_, component});
  }

  static Weights weights_of_sum(const DerivedComponent& derived) {
    Weights weights;
    for (const DerivedTerm& term : derived) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(term.count); ++j) {
        const int c = term.component[j];
        const auto same = std::find_if(weights.begin(), weights.end(),
                                       [&](const auto& entry) { return entry.first == c; });
        if (same == weights.end()) {
          weights.emplace_back(c, term.sign * term.weight[j]);
        } else {
          same->second += term.sign * term.weight[j];
        }
      }
    }
    return weights;
  }

  /// Takes a component into the slip space; its weight in X_i is `weight` / R_i.
  /// \return its entry, or nothing after noting a violation
  std::optional<std::size_t> take(int component, double weight, double scale) {
    if (used_.contains(component)) {
      fault(Rule::kTwice, component);
      return std::nullopt;
    }
    used_.insert(component);
    const auto k = static_cast<std::size_t>(built_.slip.dimension++);
    built_.slip.component[k] = component;
    if (weight == 0.0) {
      fault(Rule::kNoWeight, component);
      return std::nullopt;
    }
    built_.slip.scale[k] = scale / std::abs(weight);
    return k;
  }

  PotentialLeaf& new_leaf(PotentialLeaf::Kind kind) {
    PotentialLeaf& leaf = potential_.leaf[static_cast<std::size_t>(potential_.leaves++)];
    leaf.kind = kind;
    leaf.part = here_;
    leaf.direction = {};
    return leaf;
  }

  /// X = |sum w_j f_j - a| / R or its Macauley form: one line across its components.
  void add_line(const PotentialContribution& contribution, const Weights& weights) {
    if (contribution.function == ContributionFunction::kIdentity) fault(Rule::kOneSided);
    SlipVector direction{};
    int count = 0;
    for (const auto& [component, weight] : weights) {
      const auto k = take(component, weight, contribution.scale);
      if (!k) continue;
      direction[*k] = weight > 0.0 ? 1.0 : -1.0;
      ++count;
    }
    if (count == 0) return;
    PotentialLeaf& leaf = new_leaf(contribution.function == ContributionFunction::kMacauley
                                       ? PotentialLeaf::Kind::kHalfLine
                                       : PotentialLeaf::Kind::kLine);
    leaf.factor = std::sqrt(count);
    for (std::size_t k = 0; k < direction.size(); ++k) {
      leaf.direction[k] = direction[k] / leaf.factor;
    }
    leaf.center = contribution.shift / contribution.scale / leaf.factor;
    if (leaf.center != 0.0) potential_.homogeneous = false;
  }

  /// X = H(sum of norms and Macauley sums - a) / R: a leaf for each norm and each <w_j f_j>.
  void add_norms(const PotentialContribution& contribution, const DerivedComponent& derived) {
    if (contribution.function == ContributionFunction::kIdentity) {
      if (potential_.combine == PotentialOperator::kSum && potential_.exponent != 1.0) {
        fault(Rule::kIdentityExponent);
      }
      if (contribution.shift != 0.0) fault(Rule::kIdentityShift);
    }
    if (contribution.function == ContributionFunction::kAbs && contribution.shift > 0.0) {
      fault(Rule::kConcave);
    }
    for (const DerivedTerm& term : derived) {
      if (term.sign < 0.0) fault(Rule::kTermSign);
      SlipVector members{};
      int count = 0;
      for (std::size_t j = 0; j < static_cast<std::size_t>(term.count); ++j) {
        const double weight = term.weight[j];
        const auto k = take(term.component[j], weight, contribution.scale);
        if (!k) continue;
        if (term.combine == TermOperator::kNorm) {
          members[*k] = 1.0;
          ++count;
        } else {
          PotentialLeaf& leaf = new_leaf(PotentialLeaf::Kind::kHalfLine);
          leaf.direction[*k] = weight > 0.0 ? 1.0 : -1.0;
        }
      }
      if (count > 0) {
        new_leaf(count == 1 ? PotentialLeaf::Kind::kLine : PotentialLeaf::Kind::kNorm).direction =
            members;
      }
    }
    const double offset = contribution.shift / contribution.scale;
    if (here_ < kComponents) potential_.offset[static_cast<std::size_t>(here_)] = offset;
    if (offset != 0.0) potential_.homogeneous = false;
  }

  /// Tells whether P is the norm of the slip space: then the closed return of the Euclidean
  /// potential serves.
  bool is_euclidean() const {
    const bool squares = potential_.parts == 1 || (potential_.combine == PotentialOperator::kSum &&
                                                   potential_.exponent == 2.0);
    if (!squares || !potential_.homogeneous || potential_.leaves != potential_.parts) return false;
    return std::all_of(potential_.leaf.begin(), potential_.leaf.begin() + potential_.leaves,
                       [](const PotentialLeaf& leaf) {
                         return leaf.kind != PotentialLeaf::Kind::kHalfLine && leaf.factor == 1.0;
                       });
  }

  BuiltPotential built_;
  Potential potential_;
  ComponentSet used_;
  int contribution_ = 0;
  int here_ = 0;
};

}  // namespace

BuiltPotential build_potential(std::span<const PotentialContribution> contributions,
                               PotentialOperator combine, double exponent) {
  Builder builder(combine, exponent);
  for (const PotentialContribution& contribution : contributions) builder.add(contribution);
  return builder.finish();
}

}  // namespace slipbench::law
