// SPDX-License-Identifier: Apache-2.0
#include "law/contact/derived_component.hpp"

#include <cmath>

namespace slipbench::law {
namespace {

double weight_of(const DerivedTerm& term, int j, const Ambient& ambient) noexcept {
  if (!term.weight_table) return term.weight[static_cast<std::size_t>(j)];
  return term.weight_table->value(ambient, SlipArguments{}, j);
}

double value_of(const DerivedTerm& term, const ConnectorForce& force,
                const Ambient& ambient) noexcept {
  double total = 0.0;
  for (int j = 0; j < term.count; ++j) {
    const double x =
        weight_of(term, j, ambient) * force[term.component[static_cast<std::size_t>(j)]];
    switch (term.combine) {
      case TermOperator::kNorm:
        total += x * x;
        break;
      case TermOperator::kSum:
        total += x;
        break;
      case TermOperator::kMacauleySum:
        total += x > 0.0 ? x : 0.0;
        break;
    }
  }
  if (term.combine == TermOperator::kNorm) total = std::sqrt(total);
  return term.sign * total;
}

}  // namespace

double evaluate_terms(const DerivedComponent& component, const ConnectorForce& force,
                      const Ambient& ambient) noexcept {
  double total = 0.0;
  for (const DerivedTerm& term : component) total += value_of(term, force, ambient);
  return total;
}

void add_gradient(const DerivedComponent& component, const ConnectorForce& force,
                  const Ambient& ambient, ConnectorForce* to_force,
                  RelativePosition* to_position) noexcept {
  for (const DerivedTerm& term : component) {
    const double magnitude =
        term.combine == TermOperator::kNorm ? std::abs(value_of(term, force, ambient)) : 0.0;
    for (int j = 0; j < term.count; ++j) {
      const int c = term.component[static_cast<std::size_t>(j)];
      const double weight = weight_of(term, j, ambient);
      const double x = weight * force[c];
      double slope = 0.0;  // of the term to x
      switch (term.combine) {
        case TermOperator::kNorm:
          slope = magnitude > 0.0 ? x / magnitude : 0.0;
          break;
        case TermOperator::kSum:
          slope = 1.0;
          break;
        case TermOperator::kMacauleySum:
          slope = x > 0.0 ? 1.0 : 0.0;
          break;
      }
      slope *= term.sign;
      (*to_force)[c] += slope * weight;
      if (term.weight_table) {
        term.weight_table->add_motion_slopes(ambient, SlipArguments{}, slope * force[c],
                                             to_position, j);
      }
    }
  }
}

DerivedTerm norm_term(std::initializer_list<int> number, double weight) {
  DerivedTerm term;
  for (const int n : number) {
    term.component[static_cast<std::size_t>(term.count)] = n - 1;
    term.weight[static_cast<std::size_t>(term.count)] = weight;
    ++term.count;
  }
  return term;
}

}  // namespace slipbench::law
