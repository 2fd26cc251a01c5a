// SPDX-License-Identifier: Apache-2.0
// Many definitions under one history, updated together.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "law/base/compensated_sum.hpp"
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
  double peak_force = 0.0;     ///< largest P = equivalent_force() [F]
  CompensatedSum dissipation;  ///< sum of that of the increments [F L]
  double limit = 0.0;          ///< F_lim of the last increment [F]
  std::int64_t slipping = 0;   ///< increments that ended in slip
  std::int64_t open = 0;       ///< increments that ended without a limit
  /// Increments with several roots, with a jump of the force, or without a solution
  /// (FrictionUpdate::multiple_roots, jumps, converged); the common path has none.
  std::int64_t doubtful = 0;
};

/// Number of a lane that can be followed over the increments: R_k y_k of one entry of the slip
/// space, and what an increment ends with besides.
enum class LaneNumber : std::uint8_t {
  kForce,
  kLimit,
  kCoefficient,
  kRegime,
  kAccumulatedSlip,
  kDissipation
};

/// An extreme of one number of every lane.
struct LaneExtreme {
  LaneExtreme(LaneNumber of, std::size_t of_entry, LaneKept what) noexcept;

  LaneNumber number;
  std::size_t entry;  ///< of the slip space, of a force
  LaneKept kept;
  LaneColumn so_far{};  ///< infinite, or -1 of a magnitude, before the first increment
};

/// Count of the changes of a lane from one regime to another, from one increment to the next.
struct LaneChanges {
  LaneChanges(Regime begin, Regime end) noexcept : from(begin), to(end) { before.fill(-1.0); }

  Regime from;
  Regime to;
  LaneColumn before;  ///< regime of the increment before; -1 for none
  LaneColumn count{};
};

/// A constraint force that differs from lane to lane.
struct LaneForce {
  int component = 0;                ///< index 0..5
  std::span<const double> of_lane;  ///< [F], [F L]
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

  /// Follows numbers of the common lanes from the next increment on; kept by reference.
  void follow(std::span<LaneExtreme> extremes, std::span<LaneChanges> changes) noexcept;

  /// Puts forces of each lane in place of those of the increments, from the next one on; kept by
  /// reference.
  void press(std::span<const LaneForce> forces) noexcept;

  /// Goes on over increments that all lanes share.
  void advance(std::span<const ConnectorIncrement> increments,
               InstructionSet set = widest_instructions()) noexcept;

  FrictionState state(std::size_t lane) const noexcept;
  LaneSummary summary(std::size_t lane) const noexcept;
  /// Returns a number of a common lane at the end of the last increment.
  double last(LaneNumber number, std::size_t entry, std::size_t lane) const noexcept;
  /// Tells whether a lane goes the common path.
  bool is_common(std::size_t lane) const noexcept { return common_[lane]; }

 private:
  void advance_common(std::span<const ConnectorIncrement> increments, InstructionSet set) noexcept;
  void advance_alone(std::size_t lane, std::span<const ConnectorIncrement> increments) noexcept;
  void enter(std::size_t lane, const FrictionState& begin) noexcept;
  void enter_segment(std::size_t lane) noexcept;
  void take_contact(const ConnectorIncrement& increment) noexcept;
  double contact_of(std::size_t lane, const ConnectorIncrement& increment) const noexcept;
  ConnectorForce force_of(std::size_t lane, const ConnectorIncrement& increment) const noexcept;
  const LaneColumn& column(LaneNumber number, std::size_t entry) const noexcept;
  void take_coefficient(const ConnectorIncrement& increment, InstructionSet set) noexcept;
  void mix_coefficients(const ConnectorIncrement& increment, InstructionSet set) noexcept;

  std::span<const FrictionDefinition> definitions_;
  std::optional<BatchForm> form_;  ///< of the common lanes; nothing if there are none
  std::bitset<kLanes> common_;
  std::size_t first_ = 0;              ///< the first common lane
  bool wears_ = false;                 ///< F_int of a common lane is a table
  bool is_constant_ = true;            ///< mu of all common lanes
  bool shares_contact_ = true;         ///< the common lanes have one F_C,
  bool shares_coefficient_ = true;     ///< and one mu
  bool shares_cells_ = true;           ///< their laws are tables of one grid, in one slip space
  std::array<std::size_t, 4> rows_{};  ///< of the tables, that `corners_` are of
  bool has_corners_ = false;
  LaneCorners corners_{};
  bool contact_follows_ = false;           ///< F_C of a common lane depends on more than forces
  std::optional<ConnectorForce> pressed_;  ///< forces that F_C was last taken of
  std::span<const LaneForce> own_forces_;
  std::span<LaneExtreme> extremes_;
  std::span<LaneChanges> changes_;
  Lanes lanes_;
  /// A lane beside the common path.
  struct Alone {
    FrictionState state;
    LaneSummary summary;
  };
  std::array<Alone, kLanes> alone_;
};

}  // namespace slipbench::law
