// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/friction/friction_law.hpp"

namespace slipbench::law {

/// The law as a rotation sees it that rubs at one radius: at an angular rate w [1/T] and a normal
/// moment M [F L] its coefficient is that of `law` at the speed w R and the force M/R
/// (docs/theory, section 4.2). Once converted it costs nothing: rates enter a law with its
/// numbers per time, forces through its area, and both as columns of a table.
/// \param radius R [L], above 0
FrictionLaw at_radius(FrictionLaw law, double radius);

}  // namespace slipbench::law
