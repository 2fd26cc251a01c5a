// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/base/units/readable.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/coverage.hpp"
#include "driver/results/cycles.hpp"
#include "driver/results/events.hpp"
#include "driver/results/plausibility.hpp"
#include "driver/results/stick_slip.hpp"
#include "law/update/uniqueness.hpp"

namespace slipbench::driver::results {

/// Increments in which a coefficient is kept at its floor.
struct FloorCount {
  std::int64_t increments = 0;
  std::int64_t blended = 0;  ///< of these, in a blend with another coefficient that is above it
  double lowest = 0.0;       ///< before the floor
};

/// Summary of one friction definition over a run.
struct DefinitionSummary {
  std::string name;
  law::CompensatedSum slip_time;  ///< between the events that begin and end slip [T]
  law::CompensatedSum open_time;  ///< likewise without contact [T]
  std::int64_t events = 0;        ///< how often stick (or no contact) turned into slip
  std::int64_t reversals = 0;     ///< slips against the sense of the slip before
  std::optional<Event> first_slip;
  std::vector<double> first_place;  ///< the free positions there, as in the result columns
  /// The largest |s_el| of an increment that ended in stick [L].
  double largest_elastic_slip = 0.0;
  /// The farthest the elastic slip went within one time of stick [L]: what creeps although it
  /// sticks, where rigid friction would not move at all.
  double largest_creep = 0.0;
  double lowest_force = 0.0;  ///< of representative_force [F]
  double highest_force = 0.0;
  double accumulated_slip = 0.0;  ///< [L]
  double dissipation = 0.0;       ///< [F L]
  double stored_energy = 0.0;     ///< at the end [F L]
  double work = 0.0;              ///< [F L]
  double lost = 0.0;              ///< in jumps at constant motion [F L]
  std::int64_t jumps = 0;
  std::optional<double> first_jump;   ///< total time of it [T]
  double largest_energy = 0.0;        ///< of these three, at any time [F L]
  std::int64_t multiple_roots = 0;    ///< increments that may have more than one solution
  std::int64_t short_increments = 0;  ///< increments in which backward Euler may not settle
  /// Of the increment that is shortest against the smooth threshold.
  law::IncrementThresholds worst;
  double worst_time = 0.0;            ///< total time at its end [T]
  double worst_duration = 0.0;        ///< [T]; 0 before the first
  double unique = 0.0;                ///< longer increments have one solution all along [T]
  std::int64_t clamped = 0;           ///< increments whose coefficient is kept at its floor
  std::array<FloorCount, 2> floor;    ///< of the coefficient, or of those of both directions
  std::int64_t alpha_limited = 0;     ///< increments at which 2 pi f dt > 1 is cut to alpha 1
  std::int64_t alpha_overshoots = 0;  ///< increments with alpha > 1, which only as coded has
  double largest_alpha = 0.0;         ///< 2 pi f dt of those two, before the cut
  double largest_use = 0.0;           ///< of limit_use
  double largest_use_time = 0.0;      ///< total time of that [T]

  StickSlip stick_slip;  ///< its cycles, if it vibrates

  /// (work - dissipation - what jumps lost - stored energy) over the largest energy of the run:
  /// what the time stepping lost. 0 where nothing moved.
  double energy_gap() const;
};

/// Collects what is told about a run, row by row; nothing grows with the number of rows.
class Summary {
 public:
  explicit Summary(const cases::Case& problem);
  void add(std::span<const bench::Row> rows);
  void add(const bench::Row& row) { add({&row, 1}); }

  std::int64_t increments() const { return increments_; }
  double end_time() const { return end_time_; }
  std::span<const DefinitionSummary> definitions() const { return definitions_; }
  std::span<const TableCoverage> tables() const { return coverage_.tables(); }

  /// Returns what happened, in lines indented by two blanks, with the case's units. Four digits.
  std::string text() const;
  /// Returns what the user should change or know, one sentence each: what is not plausible,
  /// increments too short for a falling coefficient (with the thresholds), motions that jump at the
  /// start of a step.
  std::vector<std::string> warnings(std::span<const bench::MotionJump> jumps) const;
  /// The same numbers, unrounded.
  base::json::Value to_json() const;

 private:
  std::string definition_text(const DefinitionSummary& definition, std::size_t index) const;
  base::json::Value to_json(const StickSlip& cycles, bool rotational) const;
  std::string open_text(std::size_t index) const;
  std::string stick_slip_text(const DefinitionSummary& definition, std::size_t index) const;
  std::string why_text(const DefinitionSummary& definition, std::size_t index) const;
  void add_start(const bench::Row& row);
  void note_first_slip(const Event& event, const bench::Row& row);
  void add(std::span<const bench::Row> rows, std::span<const Event> events, std::size_t index);
  /// Returns the fraction of the increment that is behind an event [1].
  /// \param since that of the event before
  double add_event(const Event& event, const bench::Row& row, double since);
  void add_thresholds(const bench::Row& row, std::size_t index);
  void add_creep(std::span<const bench::Row> rows, std::size_t index);
  void add_formulation(const bench::Row& row, std::size_t index);
  /// Warns of a coefficient that falls too fast for the increments; empty if none does.
  std::string falling_warning(const DefinitionSummary& definition, std::size_t index) const;
  std::vector<std::string> formulation_warnings(const DefinitionSummary& definition,
                                                std::size_t index) const;

  void add_belt(const bench::Row& row);
  std::vector<std::string> belt_warnings() const;

  const cases::Case* case_;
  std::vector<Column> positions_;
  std::vector<DefinitionSummary> definitions_;
  EventDetector detector_;
  CycleCounter cycles_;
  Coverage coverage_;
  Plausibility plausibility_;
  std::vector<StickSlipCounter> stick_slip_;
  std::vector<law::FrictionState> stick_start_;  ///< where the current stick began
  /// Shortest distance CP1 of a belt, and most negative prescribed tension, and when.
  struct Least {
    double value = 0.0;
    double time = 0.0;
  };
  std::optional<Least> shortest_;
  Least most_slack_;
  std::int64_t slack_ = 0;  ///< increments under a negative prescribed tension
  std::int64_t increments_ = 0;
  double start_time_ = 0.0;
  double end_time_ = 0.0;
};

}  // namespace slipbench::driver::results
