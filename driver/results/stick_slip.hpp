// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/events.hpp"

namespace slipbench::driver::results {

/// A range that grows with what it is given.
struct Extremes {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void add(double value) {
    lowest = value < lowest ? value : lowest;
    highest = value > highest ? value : highest;
  }
  void add(const Extremes& other) {
    add(other.lowest);
    add(other.highest);
  }
};

/// Stick-slip vibration of one definition, from its events: a cycle lasts from where it breaks
/// loose to where it breaks loose again in the same sense. Loops that are driven to and fro have
/// none.
struct StickSlip {
  std::int64_t cycles = 0;
  double first = 0.0;      ///< total time at which the first cycle begins [T]
  double last = 0.0;       ///< and the last one ends
  Extremes period;         ///< [T]
  double time = 0.0;       ///< all periods [T]
  double slip_time = 0.0;  ///< of them, in slip
  Extremes force;          ///< of limited_force [F]
  Extremes place;          ///< of the mass of a dynamic case, between rows too [L]

  double frequency() const { return static_cast<double>(cycles) / time; }
};

/// Collects the cycles of one definition, row by row; nothing grows with their number.
class StickSlipCounter {
 public:
  StickSlipCounter(const cases::Case& problem, std::size_t definition);
  /// An event of this definition on the way to `row`.
  void add(const Event& event, const bench::Row& row);
  /// After the events on the way to it.
  /// \param force limited_force of the row [F]
  void add(const bench::Row& row, double force) {
    force_.add(force);
    if (component_ >= 0) add_place(row);
  }

  const StickSlip& cycles() const { return done_; }

 private:
  void add_place(const bench::Row& row);

  int component_ = -1;  ///< of the mass, if this definition rubs on it
  StickSlip done_;
  std::optional<double> loose_;  ///< total time at which it last broke loose
  double slip_time_ = 0.0;       ///< since then
  Extremes force_;
  Extremes place_;
  double slips_since_ = 0.0;
  bool slips_ = false;
  double velocity_ = 0.0;  ///< at the row before [L/T]
};

}  // namespace slipbench::driver::results
