// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "law/friction/friction_law.hpp"

namespace slipbench::driver::results {

/// A point of a coefficient over the slip rate that has a name of its own.
struct Landmark {
  std::string name;        ///< "C3"
  double slip_rate = 0.0;  ///< [L/T]
};

/// Range over which a coefficient is drawn to be understood; 0 where the law has no scale of its
/// own.
struct LawRange {
  double slip_rate = 0.0;      ///< [L/T]
  double contact_force = 0.0;  ///< F_N [F]
  std::vector<Landmark> landmarks;
};

LawRange law_range(const law::FrictionLaw& law);

/// The area that a law divides the normal force by [L^2]; 0 for a law of the force itself, or
/// without an area because it does not need one.
double area_of(const law::FrictionLaw& law);

}  // namespace slipbench::driver::results
