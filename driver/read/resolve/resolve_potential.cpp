// SPDX-License-Identifier: Apache-2.0
#include "driver/read/resolve/resolve_potential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/quantity_dimension.hpp"
#include "law/base/component.hpp"

namespace slipbench::driver::read {
namespace {

/// Terms that a potential, and each derived component in it, may have: those of six components,
/// each of which enters once, are far fewer. All of a derived component is copied for each use.
constexpr std::size_t kMostTerms = 50;

/// Returns what a term is of, where that can be said.
std::optional<law::PotentialContribution> contribution(
    yaml::Binder& binder, const yaml::At<PotentialTermText>& at,
    const std::function<const law::DerivedComponent*(const yaml::At<std::string>&)>& derived) {
  if (!at.node->is_map()) return std::nullopt;
  const PotentialTermText& text = at.value;
  law::PotentialContribution result;
  result.scale = text.scale.value;
  result.shift = text.shift.value;
  result.sign = text.sign.value;
  if (text.of.sound) result.function = text.of.value;
  if (text.exponent.sound) result.exponent = text.exponent.value;
  if (text.sign.sound && text.sign.value == 0) {
    binder.error(*text.sign.node, text.sign.path, "the sign of a term is 1 or -1, found 0");
  }
  if (text.component.given() == text.derived.given()) {
    if (text.component.given() || !yaml::has_unknown_key<PotentialTermText>(*at.node)) {
      binder.error(*at.node, at.path,
                   std::string(text.component.given() ? "takes only" : "needs") +
                       " one of 'component' and 'derived'");
    }
    return std::nullopt;
  }
  if (text.component.given()) {
    if (!text.component.sound) return std::nullopt;
    const int c = text.component.value - 1;
    binder.settle_units(text.scale.path, law::is_rotation(c) ? base::kLength : base::Dimension{});
    binder.settle_units(text.shift.path, cases::dimension_of(cases::kFirstForce + c));
    result.of = text.component.value - 1;
    return result;
  }
  const law::DerivedComponent* component = text.derived.sound ? derived(text.derived) : nullptr;
  if (component == nullptr) return std::nullopt;
  if (component->size() > kMostTerms) {
    binder.error(*text.derived.node, text.derived.path,
                 fmt::format("a derived component of a potential has at most {} terms, '{}' has {}",
                             kMostTerms, base::printable(text.derived.value), component->size()),
                 "each component of the connector enters once");
    return std::nullopt;
  }
  result.of = *component;
  return result;
}

void report(yaml::Binder& binder, const PotentialText& text, const yaml::At<PotentialTermText>& at,
            const law::PotentialViolation& violation) {
  using Rule = law::PotentialViolation::Rule;
  const PotentialTermText& term = at.value;
  const auto error = [&](const auto& key, std::string message, std::string hint = {}) {
    if (key.given()) {
      binder.error(*key.node, key.path, std::move(message), std::move(hint));
    } else {
      binder.error(*at.node, at.path, std::move(message), std::move(hint));
    }
  };
  const std::string component = "component " + std::to_string(violation.component + 1);
  const std::string name = "'" + base::printable(term.derived.value) + "'";
  const std::string b = base::format_number(text.exponent.value);
  switch (violation.rule) {
    case Rule::kSign:
      if (term.sign.value == 0) return;
      error(term.sign,
            "the contributions of a friction potential have sign 1: one that takes away would "
            "leave the limit open");
      break;
    case Rule::kExponent:
      error(term.exponent,
            "the exponent of every term must be that of the potential (" + b + "), found " +
                base::format_number(term.exponent.value),
            "leave it out");
      break;
    case Rule::kOneSided:
      error(term.of,
            "the value itself of a component or a sum is a contribution of the sum kind, which "
            "makes the limit one-sided: friction needs the norm kind",
            "use abs or macauley");
      break;
    case Rule::kIdentityExponent:
      error(term.of, "none needs the exponent 1, that of the potential is " + b,
            "abs is the same for a norm or a macauley_sum");
      break;
    case Rule::kIdentityShift:
      error(term.shift, "a shift needs abs or macauley");
      break;
    case Rule::kConcave:
      error(term.shift,
            "abs of a norm or a macauley_sum takes no positive shift: the limit surface would bend "
            "inwards",
            "use macauley");
      break;
    case Rule::kMixedTerms:
      error(term.derived, "derived component " + name +
                              " has sum terms beside others: a contribution is of the sum kind or "
                              "of the norm kind (norm, macauley_sum)");
      break;
    case Rule::kTermSign:
      error(term.derived, "derived component " + name +
                              " has a norm or a macauley_sum with sign -1: in a potential all have "
                              "sign 1");
      break;
    case Rule::kWeightTable:
      error(term.derived, "derived component " + name +
                              " has a table of weights: in a potential weights are numbers, since "
                              "they scale the slip");
      break;
    case Rule::kNoWeight:
      error(term.derived, "derived component " + name + " gives " + component +
                              " the weight 0: it would slip without a force");
      break;
    case Rule::kTwice:
      if (term.component.given()) {
        error(term.component, component + " stands twice in the potential");
      } else {
        error(term.derived, component + " of " + name +
                                " stands twice in the potential: each component enters once");
      }
      break;
  }
}

}  // namespace

ResolvedPotential resolve_potential(
    yaml::Binder& binder, const yaml::At<PotentialText>& text,
    const std::function<const law::DerivedComponent*(const yaml::At<std::string>&)>& derived) {
  ResolvedPotential result;
  const PotentialText& potential = text.value;
  result.components_known = potential.terms.given();
  if (potential.terms.sound && potential.terms.value.empty()) {
    result.components_known = false;
    binder.error(*potential.terms.node, potential.terms.path,
                 "a potential needs at least one term");
  }
  if (potential.exponent.given() && potential.combine == law::PotentialOperator::kMax) {
    binder.note(*potential.exponent.node, potential.exponent.path,
                "operator max has no exponent: it is ignored");
  }
  std::vector<law::PotentialContribution> contributions;
  std::vector<const yaml::At<PotentialTermText>*> terms;
  std::span<const yaml::At<PotentialTermText>> stated = potential.terms.value;
  if (stated.size() > kMostTerms) {
    binder.error(
        *potential.terms.node, potential.terms.path,
        fmt::format("a potential has at most {} terms, found {}", kMostTerms, stated.size()),
        "each component of the connector enters once");
    result.components_known = false;
    stated = {};
  }
  for (const yaml::At<PotentialTermText>& term : stated) {
    auto read = contribution(binder, term, derived);
    if (!read) {
      result.components_known = false;
      continue;
    }
    contributions.push_back(std::move(*read));
    terms.push_back(&term);
  }
  law::BuiltPotential built = law::build_potential(
      contributions, potential.combine, potential.exponent.sound ? potential.exponent.value : 2.0);
  for (const law::PotentialViolation& violation : built.violations) {
    report(binder, potential, *terms[static_cast<std::size_t>(violation.contribution)], violation);
  }
  if (!contributions.empty()) {
    for (int i = 0; i < built.slip.dimension; ++i) {
      result.components.insert(built.slip.component[static_cast<std::size_t>(i)]);
    }
  }
  // A component that was refused with its whole term slips, too.
  for (const law::PotentialContribution& c : contributions) {
    if (const auto* terms_of = std::get_if<law::DerivedComponent>(&c.of)) {
      for (const law::DerivedTerm& term : *terms_of) {
        for (std::size_t j = 0; j < static_cast<std::size_t>(term.count); ++j) {
          result.components.insert(term.component[j]);
        }
      }
    }
  }
  result.slip = built.slip;
  result.criterion = built.criterion;
  return result;
}

std::pair<yaml::Node, yaml::Path> place_in_potential(const yaml::At<PotentialText>& text,
                                                     const CaseText& all, int component) {
  const auto uses = [&](const std::string& name) {
    for (const auto& named : all.derived_components.value) {
      if (named.name != name) continue;
      for (const yaml::At<DerivedTermText>& term : named.value) {
        for (const yaml::At<int>& number : term.value.components.value) {
          if (number.sound && number.value == component + 1) return true;
        }
      }
    }
    return false;
  };
  for (const yaml::At<PotentialTermText>& term : text.value.terms.value) {
    const yaml::At<int>& number = term.value.component;
    if (number.sound && number.value == component + 1) return {*number.node, number.path};
    const yaml::At<std::string>& name = term.value.derived;
    if (name.sound && uses(name.value)) return {*name.node, name.path};
  }
  return {*text.node, text.path};
}

}  // namespace slipbench::driver::read
