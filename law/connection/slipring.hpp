// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

/// SLIPRING: a belt that runs from node a over a ring at node b. Its components are the distance of
/// the nodes, the flow of material at b and the flow at a; none is held.
/// Predefined (docs/theory, section 4.1): the capstan, one check a ring. A chain of rings shares
/// the flow; the contact force of each is the tension it meets, that of the first is f1.
struct SlipRing {
  static constexpr ConnectionInfo kInfo{
      "SLIPRING",
      "A belt runs from node a over a ring at node b; 1 is the distance, 2 the flow at b, 3 at a.",
      "complex", ComponentSet{}, ComponentSet::of(1, 2, 3)};

  std::vector<double> wrap_angles = {0.0};  ///< of the connection: one a ring, in the belt's order

  static constexpr auto fields() { return std::tuple{}; }

  std::vector<PredefinedFriction> predefined() const {
    std::vector<PredefinedFriction> checks;
    for (std::size_t i = 0; i < wrap_angles.size(); ++i) {
      const bool chain = wrap_angles.size() > 1;
      checks.push_back({chain ? "ring" : "", slip_space({2}), ComponentContactForce{0}, 0.0,
                        Capstan{wrap_angles[i]}, chain ? static_cast<int>(i) + 1 : 0});
    }
    return checks;
  }
};

}  // namespace slipbench::law
