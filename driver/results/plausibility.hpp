// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::results {

/// Extremes of one friction definition, to judge whether its result is plausible.
struct DefinitionExtremes {
  /// The slip-space motion s [L] of each entry.
  std::array<double, law::kComponents> lowest_motion{};
  std::array<double, law::kComponents> highest_motion{};
  double highest_normal_force = 0.0;   ///< [F]
  double highest_mu = 0.0;             ///< [1]
  double smallest_elastic_slip = 0.0;  ///< at the limit, of all rows that stick [L]; 0 for none
  bool slips = false;                  ///< in a row, or within an increment
  bool opens = false;                  ///< the limit was 0 somewhere
  bool open_under_force = false;       ///< the limit was 0 somewhere although something pressed
  bool falls = false;                  ///< the coefficient falls with the slip rate
  double work = 0.0, dissipation = 0.0, stored = 0.0;  ///< at the end [F L]
  double lost = 0.0;                                   ///< in jumps, at the end [F L]
  double largest_energy = 0.0;                         ///< of these three, of all rows [F L]
  /// Energy that came into the stick spring because its stiffness changed [F L].
  double stiffening = 0.0;
};

/// Collects, row by row, what a user should doubt in a result; nothing grows with the rows.
class Plausibility {
 public:
  explicit Plausibility(const cases::Case& problem);
  void add(std::span<const bench::Row> rows);
  void add(const bench::Row& row) { add({&row, 1}); }

  /// In the order of the case's definitions.
  const std::vector<DefinitionExtremes>& definitions() const { return definitions_; }

  /// Returns what is found, one sentence each with its numbers and what helps: nothing that ever
  /// moves or presses, an elastic slip above the motion, an energy balance that is open by more
  /// than 1 %.
  std::vector<std::string> findings() const;

 private:
  struct Spring {
    double stiffness = 0.0;  ///< |y|/|s_el| [F/L]; 0 where it is not stretched
    double stretch = 0.0;    ///< |s_el|^2 [L^2]
  };
  void add(std::span<const bench::Row> rows, std::size_t index);
  void add_springs(std::span<const bench::Row> rows, std::size_t index);
  std::string no_motion() const;
  std::string no_pressure(std::size_t index) const;
  std::string mere_spring(std::size_t index) const;
  std::string open_balance(std::size_t index) const;

  const cases::Case* case_;
  std::vector<DefinitionExtremes> definitions_;
  std::vector<Spring> springs_;
};

}  // namespace slipbench::driver::results
