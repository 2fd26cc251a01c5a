// SPDX-License-Identifier: Apache-2.0
// From the parameters of a case to the numbers of its friction.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::exports {

/// One number that follows a parameter p: factor * p where it is in proportion to it, in all bits,
/// else number + factor * (p - value), to rounding.
struct FollowingNumber {
  std::size_t index = 0;  ///< in the packed numbers
  bool in_proportion = true;
  double factor = 1.0;
};

/// A parameter, its value in the case, and all numbers that follow it.
struct MappedParameter {
  std::string name;
  double value = 0.0;
  std::vector<FollowingNumber> numbers;
};

/// A parameter that keeps its value, and why: "the friction follows it by a curve, ..".
struct FixedParameter {
  std::string name;
  std::string reason;
};

struct ParameterMap {
  std::vector<MappedParameter> parameters;
  std::vector<FixedParameter> fixed;
};

/// Finds the numbers that follow each parameter in a straight line: at some thirty other values,
/// near and far, the friction is read again; and no formula that mentions it may have pieces, as
/// max(p, 1) has. A parameter that moves the place where the connector begins, too or only, or that
/// other parameters have a part in, is fixed. Parameters that are defined by others follow those,
/// and those that neither friction nor begin depend on are left out. \param numbers of the case as
/// it is: law_numbers
ParameterMap map_parameters(const read::ParsedCase& parsed, const cases::Case& problem,
                            const std::vector<base::ParameterText>& settings,
                            const std::vector<double>& numbers);

}  // namespace slipbench::driver::exports
