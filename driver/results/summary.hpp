// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"
#include "driver/simulation.hpp"
#include "driver/text/json.hpp"

namespace slipbench::driver {

/// What one friction definition did over a run.
struct DefinitionSummary {
  std::string name;
  double slip_time = 0.0;         ///< total length of the increments that ended in slip [T]
  double open_time = 0.0;         ///< likewise without contact [T]
  std::int64_t events = 0;        ///< how often stick (or no contact) turned into slip
  std::optional<Row> first_slip;  ///< the row that first ended in slip
  double lowest_force = 0.0;      ///< of representative_force [F]
  double highest_force = 0.0;
  double accumulated_slip = 0.0;  ///< [L]
  double dissipation = 0.0;       ///< [F L]
  double stored_energy = 0.0;     ///< at the end [F L]
  double work = 0.0;              ///< [F L]
  double largest_normal_force = 0.0;
  double stiffness_there = 0.0;     ///< kappa where the normal force was largest [F/L]
  double shortest_increment = 0.0;  ///< of the increments with several solutions [T]
  std::int64_t multiple_roots = 0;  ///< increments that may have more than one solution

  /// (work - dissipation - stored energy) over the largest of them: what the time stepping lost.
  /// 0 where nothing moved.
  double energy_gap() const;
};

/// Collects what is told about a run, row by row; nothing grows with the number of rows.
class Summary {
 public:
  explicit Summary(const Case& problem);
  void add(const Row& row);

  std::int64_t increments() const { return increments_; }
  double end_time() const { return end_time_; }
  std::span<const DefinitionSummary> definitions() const { return definitions_; }

  /// What happened, in lines indented by two blanks, with the case's units. Four digits.
  std::string text() const;
  /// What the user should change or know, one sentence each: several solutions in an increment
  /// (with the increment below which that may happen), motions that jump at the start of a step.
  std::vector<std::string> warnings(std::span<const MotionJump> jumps) const;
  /// The same numbers, unrounded.
  json::Value to_json() const;

 private:
  std::string definition_text(const DefinitionSummary& definition, std::size_t index) const;

  const Case* case_;
  std::vector<Column> positions_;
  std::vector<DefinitionSummary> definitions_;
  std::vector<law::Regime> regimes_;
  std::int64_t increments_ = 0;
  double start_time_ = 0.0;
  double end_time_ = 0.0;
};

/// A number for people, of at most `digits` significant digits: "105.0", "0.0143", "1.25e+06".
std::string rounded(double value, int digits = 4);

/// A number for people with a unit, a blank between them where there is a unit.
std::string with_unit(const std::string& number, const std::string& unit);

/// The unit of energies, mJ rather than N mm where the case's units make one.
std::string energy_unit(const UnitSystem& units);

}  // namespace slipbench::driver
