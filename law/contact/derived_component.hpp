// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "law/table/table_function.hpp"

namespace slipbench::law {

enum class TermOperator : std::uint8_t {
  kNorm,        ///< s sqrt(sum (w_j f_j)^2)
  kSum,         ///< s sum w_j f_j
  kMacauleySum  ///< s sum max(w_j f_j, 0)
};

/// One term of a derived component (docs/theory, section 6). Weights carry the unit that makes
/// the sum a force or a moment; they are numbers or the dependents of one table.
struct DerivedTerm {
  TermOperator combine = TermOperator::kNorm;
  double sign = 1.0;                         ///< +1 or -1
  int count = 0;                             ///< entries used of `component` and `weight`
  std::array<int, kComponents> component{};  ///< index 0..5
  std::array<double, kComponents> weight{};
  std::optional<TableFunction> weight_table;  ///< dependents are the weights, in the same order
};

/// g(f), the contact force of a friction definition: terms of one name are added.
using DerivedComponent = std::vector<DerivedTerm>;

/// Adds up the terms of g(f).
double evaluate_terms(const DerivedComponent& component, const ConnectorForce& force,
                      const Ambient& ambient) noexcept;

/// Value g(f) [F] or [F L].
inline double evaluate(const DerivedComponent& component, const ConnectorForce& force,
                       const Ambient& ambient) noexcept {
  if (component.size() == 1) {
    const DerivedTerm& term = component.front();
    if (term.count == 1 && term.combine == TermOperator::kNorm && !term.weight_table) {
      // A number is the root of its square, unless that leaves the range of normal numbers.
      const double x = term.weight[0] * force[term.component[0]];
      if (std::isnormal(x * x)) return term.sign * std::abs(x);
    }
  }
  return evaluate_terms(component, force, ambient);
}

/// Adds dg/df to `to_force` and dg/d(position) (through the weights) to `to_position`. At a corner
/// (a norm of zero, a Macauley argument of zero) the one-sided slope taken is 0.
void add_gradient(const DerivedComponent& component, const ConnectorForce& force,
                  const Ambient& ambient, ConnectorForce* to_force,
                  RelativePosition* to_position) noexcept;

/// A norm term with constant weights; `number` are the users' component numbers 1..6.
DerivedTerm norm_term(std::initializer_list<int> number, double weight);

}  // namespace slipbench::law
