// SPDX-License-Identifier: Apache-2.0
// A run whose history does not depend on what is varied: recorded once, then only the law is run
// again, with exact derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "law/sensitivity/sensitivity.hpp"

namespace slipbench::driver::bench {
struct Row;
}

namespace slipbench::driver::calibrate {

/// The increments of a case: all that the law is given, without the case.
///
/// Rows are those of the run, row 0 first: one an increment, however many of them the case writes.
/// A replay is const: several threads may run it at once.
class Replay {
 public:
  /// Place where a response is read: between rows `row` and `row + 1` of the run, `fraction` of the
  /// way. With fraction 0 the row alone counts, which may then be the last.
  struct Point {
    std::size_t row = 0;
    double fraction = 0.0;  ///< in [0, 1]
  };
  /// A response that is a friction force or moment of one component, CSF1 or CSM3 (all definitions
  /// of the case that act on it are added), times `factor`.
  struct Response {
    int component = 0;  ///< index 0..5
    double factor = 1.0;
    std::vector<Point> points;  ///< in any order; the fastest is that of the rows
  };

  /// Walks through the history once, without the law. Errors, in a sentence: why the case cannot be
  /// replayed (it has a mass, a component driven by force, a belt, a contact penalty, a friction
  /// that changes, a dead zone, a coefficient that depends on the direction, exact integration), or
  /// what is wrong with it.
  /// \param watch sees every row, row 0 first; they have no updates
  static tl::expected<Replay, std::string> record(
      const cases::Case& problem, const std::function<void(const bench::Row&)>& watch = {});

  /// Total times of all rows, row 0 first.
  std::span<const double> times() const { return times_; }

  /// Tells whether another case has the same history, bit by bit, and can be replayed: compares
  /// what the histories are made of, so that files are taken to be unchanged.
  bool same_history(const cases::Case& other) const;

  /// Runs the law with other definitions over the recorded increments: the forces are those of a
  /// Simulation, bit by bit. Definitions that no response reads are left out.
  /// \param definitions as many as the case has, in its order
  /// \param[out] values of all points, response by response
  /// \return false if the law has no finite value somewhere, or a point lies outside the rows
  bool run(std::span<const law::FrictionDefinition> definitions,
           std::span<const Response> responses, std::span<double> values) const;

  /// The same with derivatives to `unknowns` numbers. All definitions that a response reads have to
  /// be of the kind that law::add_slopes covers.
  /// \param slopes of each definition, how its numbers depend on the unknowns
  /// \param[out] jacobian row-major points x unknowns
  bool run(std::span<const law::FrictionDefinition> definitions,
           std::span<const law::DefinitionSlopes> slopes, std::size_t unknowns,
           std::span<const Response> responses, std::span<double> values,
           std::span<double> jacobian) const;

  /// Runs the law of all definitions, row 0 first, and shows every increment to `watch`: its end,
  /// and the results of the definitions in their order.
  /// \return false if the law has no finite value somewhere
  using Watch = std::function<void(const law::Ambient&, std::span<const law::FrictionUpdate>)>;
  bool show(std::span<const law::FrictionDefinition> definitions, const Watch& watch = {}) const;

 private:
  /// Columns of the numbers that a row of `increments_` holds behind its duration.
  struct Columns {
    std::vector<int> motions;  ///< components
    std::vector<int> others;   ///< quantities
    std::size_t stride() const { return 1 + motions.size() + others.size(); }
  };
  class Increments;

  Replay() = default;
  void record_row(double duration, std::span<const double> quantities);
  template <bool kSlopes>
  bool run_all(std::span<const law::FrictionDefinition> definitions,
               std::span<const law::DefinitionSlopes> slopes, std::size_t unknowns,
               std::span<const Response> responses, double* values, double* jacobian) const;

  Columns columns_;
  std::array<double, cases::kQuantities> first_{};  ///< all quantities of row 0
  std::vector<double> increments_;                  ///< row-major: duration, motions, others
  std::vector<double> times_;
  bool jumps_ = false;  ///< a run goes through jumps of the force (snap-back); else it ends there

  // What the history was made of.
  base::NamedNumbers parameters_;
  law::RelativePosition initial_;
  law::RelativePosition reference_;
  std::vector<cases::Step> steps_;
  std::optional<history::MeasuredSource> measured_;
  int measured_pieces_ = 1;
};

}  // namespace slipbench::driver::calibrate
