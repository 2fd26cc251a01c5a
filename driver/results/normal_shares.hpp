// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "law/definition/increment.hpp"
#include "law/update/connector.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::results {

/// One part of what presses, with its sign [F] (a moment [F L] where the definition has one).
struct NormalShare {
  std::string name;  ///< "forces across axis 1 (f2 f3)", "internal contact force"
  double value = 0.0;
};

/// Returns what the components of a term carry: "forces across axis 1", "moment about axis 2".
std::string term_words(const law::DerivedTerm& term);

/// The value of one term of a derived component [F], [F L].
double term_value(const law::DerivedTerm& term, const law::ConnectorForce& force,
                  const law::Ambient& ambient);

/// The parts of a contact force F_C, whose sum it is: of a derived component its terms, of a
/// universal joint the loads of its hinges' faces and pins; none without a contact force.
std::vector<NormalShare> contact_shares(const law::ContactForce& contact,
                                        const law::ConnectorIncrement& increment);

/// The accumulated slip that the internal contact force of an increment was taken at [L].
double slip_of_internal_force(const law::FrictionDefinition& definition,
                              const law::FrictionUpdate& update);

/// All that F_N = |F_C + F_int| of an increment is made of: the parts of the contact force and the
/// internal one; of a belt the tension before its ring. As many, in the same order and of the same
/// names, for every increment of a definition.
std::vector<NormalShare> normal_shares(const law::FrictionDefinition& definition,
                                       const law::FrictionUpdate& update,
                                       const law::ConnectorIncrement& increment);

}  // namespace slipbench::driver::results
