// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "driver/sweep/sweep.hpp"
#include "law/batch/pack.hpp"

namespace slipbench::driver::sweep {

/// A number of a sweep as a pack of definitions gives it.
struct PackedNumber {
  enum class Kind : std::uint8_t { kLast, kExtreme, kChanges } kind = Kind::kLast;
  law::LaneNumber number = law::LaneNumber::kForce;
  std::size_t entry = 0;  ///< of the slip space, of a force
  law::LaneKept kept = law::LaneKept::kMaximum;
  law::Regime from = law::Regime::kStick;
  law::Regime to = law::Regime::kSlip;
};

/// Returns how a pack gives what is collected of a case with one definition; nothing where only a
/// run of its own does. A pack knows CSF1 .. CSM3, FLIM, MU, STATUS, DISS and the accumulated slip,
/// their extremes and last values, and how often stick and slip follow one another.
std::optional<PackedNumber> packed_number(const cases::Case& problem, const Collected& collected);

/// All numbers of a sweep; nothing where one of them is not known to a pack.
std::optional<std::vector<PackedNumber>> packed_numbers(const Sweep& sweep);

}  // namespace slipbench::driver::sweep
