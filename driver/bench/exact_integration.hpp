// SPDX-License-Identifier: Apache-2.0
// Exact integration in a simulation: what an increment began with, and which cases it is for.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/exact/continuous_update.hpp"

namespace slipbench::driver::bench {

/// Keeps what the straight piece of history under way began with, and integrates definitions over
/// it. Allocates nothing after its construction.
class ExactIntegration {
 public:
  explicit ExactIntegration(const cases::Case& problem);

  /// An increment begins: the quantities just after its begin, and the definitions in force there.
  void begin(const Quantities& quantities, std::span<const law::FrictionDefinition> definitions);

  /// The definition number `index` over the increment that has begun.
  law::FrictionUpdate update(std::size_t index, const law::FrictionDefinition& definition,
                             const law::ConnectorIncrement& increment,
                             const law::FrictionState& old, law::RegimeChanges& changes) const;

 private:
  struct Begin {
    law::CoefficientBlend blend;
    double stick = 1.0;
    double wrap_angle = 0.0;
  };
  const cases::Case* case_;
  law::KineticBehavior kinetic_;  ///< of the case; the spring of an elastic belt presses too
  Quantities quantities_{};
  std::vector<Begin> definitions_;
};

/// Reason why a case cannot be integrated exactly.
struct ExactRefusal {
  std::string message;  ///< begins with the definition it is about, if it is one
  std::string hint;
};
std::optional<ExactRefusal> refuse_exact(const cases::Case& problem);

}  // namespace slipbench::driver::bench
