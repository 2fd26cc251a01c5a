// SPDX-License-Identifier: Apache-2.0
// Files of a functional mock-up unit: what a host reads, and what the unit reads itself.
#pragma once

#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/export/fmu/fmu_variables.hpp"
#include "driver/export/fmu/parameter_map.hpp"

namespace slipbench::driver::exports {

/// Name of a unit: the identifier of its library, which a host may build symbols of, and its
/// fingerprint.
struct FmuIdentity {
  std::string identifier;
  std::string guid;
};

/// Writes the text that the unit's library reads from its resources: starts, roles, parameters, the
/// law's numbers.
std::string fmu_resource(const cases::Case& problem, const std::vector<FmuVariable>& variables,
                         const ParameterMap& map, const std::vector<double>& numbers);

/// Returns why the units of a case cannot be told in SI units, in a sentence, or nothing.
std::string units_fault(const cases::Case& problem);

/// Writes modelDescription.xml. Source: Functional Mock-up Interface 2.0.3, section 2.2 and 4.3.1.
std::string model_description(const cases::Case& problem, const std::vector<FmuVariable>& variables,
                              const FmuIdentity& identity);

}  // namespace slipbench::driver::exports
