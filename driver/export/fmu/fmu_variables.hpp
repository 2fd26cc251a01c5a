// SPDX-License-Identifier: Apache-2.0
// Variables of a case as a functional mock-up unit (FMI 2.0).
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/case/case.hpp"
#include "driver/export/fmu/parameter_map.hpp"

namespace slipbench::driver::exports {

/// Use of a variable as the host sees it.
enum class Causality : std::uint8_t { kInput, kParameter, kOutput };

/// Kind of a variable's value. All are kept as numbers, one after another: the value reference
/// counts them.
enum class FmuType : std::uint8_t { kReal, kInteger, kBoolean };

/// One variable: what the host knows, and its role in the unit, a word that the unit's library
/// knows too (c/fmu.cpp).
struct FmuVariable {
  std::string name;
  Causality causality = Causality::kInput;
  FmuType type = FmuType::kReal;
  base::Dimension dimension{};
  std::string text;
  double start = 0.0;
  std::string role;  ///< "position", "force", "limit", ..
  int index = 0;     ///< component, field, definition or parameter that it is of
};

/// The variables of a case: as inputs positions and rates of the free components, constraint
/// forces, temperature and fields with the values that the history begins with; as parameters those
/// of the case that the friction follows; as outputs the friction forces and, of each definition,
/// what the result columns of the same names have. A parameter that is called as another variable
/// is, `increments` or `MU`, has "parameter_" before its name. \return a sentence where the history
/// does not begin
tl::expected<std::vector<FmuVariable>, std::string> fmu_variables(const cases::Case& problem,
                                                                  const ParameterMap& map);

}  // namespace slipbench::driver::exports
