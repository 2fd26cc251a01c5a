// SPDX-License-Identifier: Apache-2.0
// Many definitions under one history, updated together.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "law/batch/lanes.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::law {

/// Part of a definition that lanes must share to go the common path together.
struct BatchForm {
  bool fixed = false;  ///< constant kappa
  int dimension = 1;   ///< of the slip space, 1 or 2
  std::array<int, kLaneEntries> component{};

  friend bool operator==(const BatchForm&, const BatchForm&) = default;
};

/// Returns the form of a definition whose update needs no search; nothing for others.
/// It has the Euclidean norm of one or two components, no formulation, and a limit that does not
/// change with the slip of the increment: a coefficient that sees neither the slip rate (but that
/// of the relative motion) nor the contact force, and F_int a number, or a table over the
/// accumulated slip of the start.
std::optional<BatchForm> batch_form(const FrictionDefinition& definition) noexcept;

/// Summary of a lane over all its increments.
struct LaneSummary {
  double peak_force = 0.0;    ///< largest P = equivalent_force() [F]
  double dissipation = 0.0;   ///< sum of that of the increments [F L]
  double limit = 0.0;         ///< F_lim of the last increment [F]
  std::int64_t slipping = 0;  ///< increments that ended in slip
  std::int64_t open = 0;      ///< increments that ended without a limit
  /// Increments with several roots, with a jump of the force, or without a solution
  /// (FrictionUpdate::multiple_roots, jumps, converged); the common path has none.
  std::int64_t doubtful = 0;
};

/// Up to kLanes definitions under one history. Lanes of the form of the first that has one go the
/// common path together, the others by update() one by one: every number of every lane has the bits
/// that update() gives it. Nothing is allocated, nothing is thrown.
class Pack {
 public:
  /// \param definitions at most kLanes; kept by reference
  /// \param begin a state for each of them; or none, and all begin at rest
  explicit Pack(std::span<const FrictionDefinition> definitions,
                std::span<const FrictionState> begin = {}) noexcept;

  /// Goes on over increments that all lanes share.
  void advance(std::span<const ConnectorIncrement> increments,
               InstructionSet set = widest_instructions()) noexcept;

  FrictionState state(std::size_t lane) const noexcept;
  LaneSummary summary(std::size_t lane) const noexcept;
  /// Tells whether a lane goes the common path.
  bool is_common(std::size_t lane) const noexcept { return common_[lane]; }

 private:
  void advance_common(std::span<const ConnectorIncrement> increments, InstructionSet set) noexcept;
  void advance_alone(std::size_t lane, std::span<const ConnectorIncrement> increments) noexcept;
  void enter(std::size_t lane, const FrictionState& begin) noexcept;
  void enter_segment(std::size_t lane) noexcept;
  void take_contact(const ConnectorIncrement& increment) noexcept;
  void take_coefficient(const ConnectorIncrement& increment) noexcept;

  std::span<const FrictionDefinition> definitions_;
  std::optional<BatchForm> form_;  ///< of the common lanes; nothing if there are none
  std::bitset<kLanes> common_;
  std::size_t first_ = 0;           ///< the first common lane
  bool wears_ = false;              ///< F_int of a common lane is a table
  bool is_constant_ = true;         ///< mu of all common lanes
  bool shares_contact_ = true;      ///< the common lanes have one F_C,
  bool shares_coefficient_ = true;  ///< and one mu
  Lanes lanes_;
  /// A lane beside the common path.
  struct Alone {
    FrictionState state;
    LaneSummary summary;
  };
  std::array<Alone, kLanes> alone_;
};

}  // namespace slipbench::law
