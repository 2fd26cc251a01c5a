// SPDX-License-Identifier: Apache-2.0
// The common path of the update over many lanes at once: structure of arrays, no branches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "law/base/notation.hpp"

namespace slipbench::law {

/// Lanes that are updated together; all their columns stay in the first cache.
inline constexpr std::size_t kLanes = 128;
/// Entries a slip space of the common path may have.
inline constexpr std::size_t kLaneEntries = 2;

using LaneColumn = std::array<double, kLanes>;
using LaneVectors = std::array<LaneColumn, kLaneEntries>;

/// Numbers, states and summaries of the lanes, a column each. By default a lane is idle: open, and
/// without a force.
struct alignas(64) Lanes {
  Lanes() noexcept {
    stick.fill(1.0);
    segment_width.fill(1.0);
    segment_end.fill(kNoForceLimit);
  }

  // Of the definitions.
  LaneVectors scale{};       ///< R_k
  LaneColumn stick;          ///< kappa [F/L], or g_c [L]
  LaneColumn force_limit{};  ///< f_t^max [F]
  // F_int = low + (s - begin)/width rise up to an accumulated slip s of `end`.
  LaneColumn segment_low{};    ///< [F]
  LaneColumn segment_rise{};   ///< [F]
  LaneColumn segment_begin{};  ///< [L]
  LaneColumn segment_width;    ///< [L]
  LaneColumn segment_end;      ///< [L]
  // Of the increment.
  LaneColumn contact{};  ///< F_C [F]
  LaneColumn mu{};       ///< [1]
  // State.
  LaneVectors force{};            ///< y [F]
  LaneVectors elastic_slip{};     ///< s_el [L]; with a constant kappa none of its own
  LaneColumn accumulated_slip{};  ///< [L]
  LaneColumn slip_left_out{};     ///< of it, by rounding (add_compensated) [L]
  LaneColumn regime{};            ///< the number of the Regime
  // Summary of all increments.
  LaneColumn limit{};            ///< F_lim of the last one [F]
  LaneColumn peak{};             ///< largest |y| [F]; of two entries its square [F^2]
  LaneColumn dissipation{};      ///< sum of F_lim dL [F L]
  LaneColumn energy_left_out{};  ///< of it, by rounding [F L]
  LaneColumn slipping{};         ///< how many ended in slip
  LaneColumn open{};             ///< how many ended open
};

/// Machine instructions that the common path is compiled for. All give the same bits: each does
/// what IEEE 754 says, and none contracts.
enum class InstructionSet : std::uint8_t { kPortable, kAvx2, kAvx512 };

/// Tells whether the program has the common path for these instructions, and the machine has them.
bool is_available(InstructionSet set) noexcept;
/// Returns the widest instructions available.
InstructionSet widest_instructions() noexcept;

/// du of the increment, which all lanes share.
using LaneMotion = std::array<double, kLaneEntries>;

/// One increment of all lanes.
/// \return true if a lane's accumulated slip has come to the end of its segment of F_int
using LaneStep = bool (*)(Lanes* lanes, LaneMotion motion) noexcept;

/// Returns the step of lanes of one form.
/// \param dimension of the slip space, 1 or 2
/// \param fixed whether kappa is constant, else the elastic slip is
/// \param wears whether F_int changes with the accumulated slip at all
/// \param set available
LaneStep lane_step(int dimension, bool fixed, bool wears, InstructionSet set) noexcept;

/// Values at the ends of the cell of a table, TableMix's rows.
using LaneCorners = std::array<LaneColumn, 4>;

/// Coefficients of lanes whose tables differ in the ordinates only; none below 0.
using LaneMix = void (*)(const LaneCorners& corner, const std::array<double, 3>& fraction,
                         LaneColumn* mu) noexcept;
LaneMix lane_mix(InstructionSet set) noexcept;

/// Number that is left of a column over the increments.
enum class LaneKept : std::uint8_t { kMaximum, kMinimum, kMagnitude };

/// Brings the values of a column, times `scale`, to what is left of it so far.
using LaneKeep = void (*)(const LaneColumn& column, const LaneColumn& scale,
                          LaneColumn* so_far) noexcept;
LaneKeep lane_keep(LaneKept kept, InstructionSet set) noexcept;

/// Counts the lanes that were in one regime and are in another, and takes over the regimes.
using LaneCount = void (*)(const LaneColumn& regime, double from, double to, LaneColumn* before,
                           LaneColumn* count) noexcept;
LaneCount lane_count(InstructionSet set) noexcept;

}  // namespace slipbench::law
