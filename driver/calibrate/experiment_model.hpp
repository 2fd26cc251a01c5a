// SPDX-License-Identifier: Apache-2.0
// The responses of one experiment as functions of the unknowns.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/calibrate/measurements.hpp"
#include "driver/calibrate/observation.hpp"
#include "driver/calibrate/replay.hpp"
#include "driver/calibrate/run_trace.hpp"
#include "driver/calibrate/varied_case.hpp"

namespace slipbench::driver::results {
class Coverage;
}

namespace slipbench::driver::calibrate {

/// Choices of a model, whatever the experiment.
struct ModelOptions {
  std::vector<fit::UnknownRange> unknowns;
  std::vector<VariedOrdinates> ordinates;
  unsigned threads = 1;
  bool whole_runs = false;  ///< replay nothing, even what could be
  bool with_hash = true;    ///< of the data files
  /// Find how a definition's numbers follow from the parameters anew at every point, also where it
  /// looks the same everywhere (expressions in pieces: min, max, conditions).
  bool slopes_anew = false;
};

/// A response with the measurements it is compared with.
struct ComparedResponse {
  MeasuredSeries measured;  ///< the points that the run reaches
  std::vector<double>
      positions;          ///< of the force's component at these points; empty if it has none
  std::string position;   ///< name of the column
  std::size_t first = 0;  ///< place of its first point among those of the experiment
};

/// Model values at the compared points of an experiment.
///
/// Where the history does not depend on what is varied and the responses are friction forces, the
/// history is recorded once and only the law runs again, with exact derivatives; else the case is
/// resolved and run anew for every set of unknowns, and derivatives are central differences.
class ExperimentModel {
 public:
  /// Errors, in a sentence: data that cannot be read, a run that fails at the start values, nothing
  /// to compare. `environment` says that the machine is at fault.
  struct Failure {
    std::string message;
    bool environment = false;
    bool numerical = false;
  };
  static tl::expected<ExperimentModel, Failure> make(const Fit& fit,
                                                     const ExperimentFit& experiment,
                                                     const ModelOptions& options);

  const ExperimentFit& experiment() const { return *experiment_; }
  /// Their rows used are those that are compared.
  const Measurements& measurements() const { return measurements_; }
  std::span<const ComparedResponse> responses() const { return responses_; }
  std::size_t points() const { return points_; }
  /// Rows of its run.
  std::size_t run_rows() const { return run_rows_; }
  /// Returns what was left out, a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The values at all points, response by response; false if there are none for these unknowns.
  bool values(std::span<const double> x, std::span<double> values) const;

  /// The same with derivatives to all unknowns, row-major points x unknowns.
  bool derivatives(std::span<const double> x, std::span<double> values,
                   std::span<double> jacobian) const;

  /// Counts the cells that the experiment visits at some unknowns; nothing where there is no run.
  /// \param coverage of the case there
  void count_cells(std::span<const double> x, const cases::Case& problem,
                   results::Coverage& coverage) const;

  /// The whole case at some unknowns.
  tl::expected<cases::Case, std::string> case_at(std::span<const double> x) const {
    return varied_.case_at(x);
  }

  /// Unknowns of this case whose derivatives are exact, and those whose are differences.
  std::span<const std::size_t> exact() const { return exact_; }
  std::span<const std::size_t> by_differences() const { return by_differences_; }
  /// Returns why runs are whole runs; empty where they are replays.
  const std::string& whole_runs_because() const { return because_; }
  /// Tells whether a replay is still right for a case at other unknowns.
  bool replays(const cases::Case& problem) const {
    return !replay_ || replay_->same_history(problem);
  }
  /// Tells whether numbers that followed linearly from a parameter at the start do so at other
  /// unknowns.
  bool keeps_slopes(std::span<const double> x) const;

 private:
  /// Line by which the quantity of a response follows from its force: gain * force + offset.
  struct Line {
    double gain = 1.0;
    double offset = 0.0;
  };

  ExperimentModel(VariedCase varied, const ExperimentFit& experiment, const ModelOptions& options)
      : experiment_(std::make_shared<const ExperimentFit>(experiment)),
        varied_(std::move(varied)),
        options_(options) {}

  tl::expected<void, Failure> prepare();
  /// Records the history if it can be replayed.
  /// \param trace of its run
  /// \param positions names of its position columns
  void try_replay(RunTrace& trace, std::vector<std::string>& positions);
  void choose_derivatives();
  std::vector<double> starts() const;
  std::string dependent_history() const;
  /// Tells whether the quantities stay linear in their forces over the measured range.
  bool check_lines();
  Observations observe(const MeasuredSeries& measured, std::size_t response,
                       const RunTrace& trace) const;

  bool values_by_replay(std::span<const double> x, std::span<double> values) const;
  bool values_by_run(std::span<const double> x, std::span<double> values) const;
  std::optional<std::vector<Line>> lines_at(std::span<const double> x) const;
  /// Returns where unknown `u` is moved to, for differences, within its bounds.
  /// \param step as a part of the unknown
  std::pair<double, double> sides(std::span<const double> x, std::size_t u, double step) const;
  /// Slopes of all definitions to the unknown, as a column; false where they are not covered.
  /// \param step to both sides, as a part of the unknown
  bool add_slopes(std::span<const double> x, std::size_t unknown, std::size_t column, double step,
                  std::vector<law::DefinitionSlopes>& slopes) const;
  bool exact_derivatives(std::span<const double> x, std::span<double> values,
                         std::span<double> jacobian) const;
  /// From forces to quantities, in values and derivatives.
  bool take_lines(std::span<const double> x, std::span<double> values,
                  std::span<double> jacobian) const;
  bool add_differences(std::span<const double> x, std::span<const std::size_t> unknowns,
                       std::span<const double> values, std::span<double> jacobian) const;

  std::shared_ptr<const ExperimentFit> experiment_;
  VariedCase varied_;
  ModelOptions options_;
  Measurements measurements_;
  std::vector<ComparedResponse> responses_;
  std::vector<std::vector<Replay::Point>> where_;  ///< of each response, at the start values
  std::size_t points_ = 0;
  std::size_t run_rows_ = 0;
  std::vector<std::string> notes_;
  std::string because_;

  std::optional<Replay> replay_;
  std::vector<ForceResponse> forces_;  ///< where it is replayed
  std::vector<Replay::Response> read_;
  bool plain_ = false;          ///< all quantities are the forces themselves
  std::vector<char> relevant_;  ///< definitions that a response reads
  std::vector<law::DefinitionSlopes> constant_slopes_;
  std::vector<std::size_t> exact_;
  std::vector<char> constant_;  ///< of those, whose slopes are in constant_slopes_
  std::vector<std::size_t> by_differences_;
};

}  // namespace slipbench::driver::calibrate
