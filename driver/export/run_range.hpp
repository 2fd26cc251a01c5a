// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/case/case.hpp"

namespace slipbench::driver::exports {

/// Rates, forces and surroundings that the run of a case meets.
struct RunRange {
  double slip_rate = 0.0;                                 ///< the largest [L/T]
  double contact_force = 0.0, least_contact_force = 0.0;  ///< F_N [F]
  double duration = 0.0;                                  ///< of its first increment [T]
  double temperature = 0.0;                               ///< at its start
  std::vector<double> fields = {};                        ///< at its start

  law::Ambient ambient() const { return {{}, {}, temperature, fields}; }
};

/// Runs a case. Throws NotExported where it does not reach its end.
RunRange run_range(const cases::Case& problem);

}  // namespace slipbench::driver::exports
