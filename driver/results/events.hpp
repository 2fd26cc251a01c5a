// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::results {

/// A change between open, stick and slip, slip that turns to the opposite sense (slip to slip), or
/// a jump of the force at constant motion while it slips.
struct Event {
  double time = 0.0;      ///< total time [T]
  double fraction = 0.0;  ///< of the increment that is over
  std::size_t definition = 0;
  law::Regime from = law::Regime::kStick;
  law::Regime to = law::Regime::kStick;
  bool reversal = false;          ///< it slips against the sense of its last slip
  double force = 0.0;             ///< as of limited_force [F]
  double limit = 0.0;             ///< F_lim [F]
  double accumulated_slip = 0.0;  ///< [L]
  bool jump = false;              ///< the force jumps (snap-back), the regime does not change
  std::size_t row = 0;            ///< which of the rows that were given together ends it
};

/// Returns where within its increment a position stood at the event; the motion is straight within
/// it.
double position_at(const Event& event, const bench::Row& row, int component);

/// Finds the events of a run, row by row. Where the integration has located them, they are its own.
/// Otherwise the increment is judged by its ends:
///   - slip begins where the trial force meets the limit (FrictionUpdate::onset), with the force
///   and
///     the limit of the increment's end;
///   - stick begins where the increment begins that ends in stick, with the force and limit there:
///     exact for a motion that turns at a breakpoint, late or early by at most an increment else;
///   - contact is lost at the end of the increment that ends open, and found at the begin of the
///     one that does not; where slip within the increment wore it away, that slip begins where the
///     trial force meets the limit before it;
///   - the force jumps where the trial force meets the fold of its limit.
/// Nothing grows with the number of rows.
class EventDetector {
 public:
  explicit EventDetector(const cases::Case& problem);
  /// The events of the increments that rows end, in the order of their times; valid until the
  /// next call. Rows have to come one after the other, row 0 first, which has none.
  std::span<const Event> take(std::span<const bench::Row> rows);
  std::span<const Event> take(const bench::Row& row) { return take({&row, 1}); }

 private:
  struct Memory {
    law::Regime regime = law::Regime::kStick;
    double force = 0.0;
    double limit = 0.0;
    std::array<double, law::kComponents> slip_direction{};  ///< of the last slip
  };
  void take(std::span<const bench::Row> rows, std::size_t definition);
  void remember_force(const bench::Row& row, std::size_t definition);
  void judge(const bench::Row& row, std::size_t definition);
  void add_located(const bench::Row& row, std::size_t definition);
  bool turns(std::size_t definition, const bench::DefinitionRow& here) const;

  const cases::Case* case_;
  std::vector<Memory> memory_;
  std::vector<Event> events_;
  double begin_time_ = 0.0;
};

/// Writes the events of a run as CSV: when, which definition, from which regime to which, at what
/// force, limit and accumulated slip, and where.
class EventWriter {
 public:
  EventWriter(const cases::Case& problem, base::OutputFile& file);
  void write(std::span<const bench::Row> rows);

 private:
  const cases::Case* case_;
  EventDetector detector_;
  std::vector<Column> positions_;
  base::OutputFile* file_;
};

/// "open", "stick" or "slip".
const char* regime_name(law::Regime regime);
/// The same of the regime that an event leads to, or kJumpWord.
const char* goal_name(const Event& event);
inline constexpr const char* kJumpWord = "jump";

}  // namespace slipbench::driver::results
