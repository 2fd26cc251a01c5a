// SPDX-License-Identifier: Apache-2.0
// Friction models of an OpenSees script, and the bearings that have them.
#pragma once

#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/import/contact/contact_case.hpp"
#include "driver/import/opensees/script.hpp"

namespace slipbench::driver::opensees {

/// frictionModel of a script.
struct Found {
  int tag = 0;
  std::string type;  ///< Coulomb, VelDependent, ..
  import::ContactFriction friction;
};

/// Reads the friction models of a script, with v the velocity and N the normal force:
///   Coulomb            mu
///   VelDependent       mu = muFast - (muFast - muSlow) exp(-transRate v)
///   VelDepMultiLinear  mu(v) piecewise linear
///   VelPressureDep     the same with muFast = muFast0 - deltaMu tanh(alpha N/A)
///   VelNormalFrcDep    muSlow = aSlow N^(nSlow-1), muFast = aFast N^(nFast-1), transRate = alpha0
///   +
///                      alpha1 N + alpha2 N^2, mu <= maxMuFact muFast
/// The last two become tables. kInit of a flatSliderBearing is the tangential stiffness. Faults are
/// reported, and what has some left out. Source: OpenSees documentation, frictionModel.
std::vector<Found> read_models(const Script& script, base::Diagnostics& out);

}  // namespace slipbench::driver::opensees
