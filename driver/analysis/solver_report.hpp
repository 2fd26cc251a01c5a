// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// Demands of one definition on an implicit solver over one increment. The tangents are taken
/// in the scaled slip space, so that forces and moments compare.
struct SolverDemand {
  double asymmetry = 0.0;  ///< |K - K^T|/|K| of K = dy/ds, Frobenius norms [1]
  /// |K - K^T| over the norm of the stick stiffness, which K is small against in steady slip: the
  /// part from a contact force that depends on the position, and
  double by_position = 0.0;
  double by_rate = 0.0;         ///< the part from a coefficient over the rate of the motion [1]
  double force_coupling = 0.0;  ///< largest dy_i/df_j over the size of dg/df: dF_lim/dF_C [1]
  double snap_back = 0.0;       ///< dF_lim/dF_C |F_int'|/kappa; at 1 the force jumps [1]
};

/// \param increment what the law was given, with the definition in force
/// \param kinetic what presses in free components: such a contact force follows the position
SolverDemand solver_demand(const law::FrictionDefinition& definition,
                           const law::ConnectorIncrement& increment,
                           const law::FrictionUpdate& update, const law::KineticBehavior& kinetic);

/// Collects `SolverDemand` over a run, writes it as CSV row by row, and judges it.
class SolverReport {
 public:
  /// \param file null if nothing is to be written; else it and `problem` must outlive the report
  SolverReport(const cases::Case& problem, base::OutputFile* file);
  /// The row the simulation stands at; row 0 counts nothing.
  void add(const bench::Simulation& simulation);

  /// The summary of each definition and the verdict, in lines indented by two blanks.
  std::string text() const;

 private:
  struct Worst {
    SolverDemand demand;  ///< each the largest
    double asymmetry_time = 0.0;
    double coupling_time = 0.0;
    double snap_back_time = 0.0;
    double unique = 0.0;       ///< longer increments have one solution [T]
    double shortest = 0.0;     ///< increment [T]
    std::int64_t below = 0;    ///< increments shorter than their own `unique`
    std::int64_t several = 0;  ///< increments that may have several solutions
  };
  std::string definition_text(const Worst& worst, std::size_t index) const;

  const cases::Case* case_;
  base::OutputFile* file_;
  std::vector<Worst> worst_;
  std::int64_t increments_ = 0;
};

}  // namespace slipbench::driver::analysis
