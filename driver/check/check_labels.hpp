// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/case/case.hpp"

namespace slipbench::driver::check {

/// Names and units of a check's numbers for messages; a unit is empty where it is not known or
/// there is none.
struct CheckLabels {
  std::string unit;      ///< of the quantity
  std::string abscissa;  ///< "t", "CU1", "= CU1 + CU2"
  std::string abscissa_unit;
  std::string product_unit;  ///< quantity x abscissa, "mJ" rather than "N mm"
  std::string time_unit;
  /// Of a friction force: its stick stiffness is that of an allowed elastic slip.
  bool stiffness_follows_limit = false;
};
CheckLabels labels_of(const cases::Case& problem, const cases::Check& check);

}  // namespace slipbench::driver::check
