// SPDX-License-Identifier: Apache-2.0
// A run whose history does not depend on what is varied: recorded once, then only the law is run
// again, with exact derivatives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/case/case.hpp"
#include "law/sensitivity.hpp"

namespace slipbench::driver {

/// The increments of a case, and the force component that each response reads.
class Replay {
 public:
  /// Where a response is read: between rows `row` and `row + 1` of the run, `fraction` of the way.
  struct Point {
    std::size_t row = 0;
    double fraction = 0.0;
  };
  /// A response that is a friction force or moment of one component, CSF1 or CSM3 (all definitions
  /// of the case that act on it are added), times `factor`.
  struct Response {
    int component = 0;  ///< index 0..5
    double factor = 1.0;
    std::vector<Point> points;
  };

  /// Runs the history once. Errors, in a sentence: why the case cannot be replayed (it has a mass,
  /// a component driven by force, a belt, a contact penalty, a friction that changes, exact
  /// integration), or why its run failed.
  static tl::expected<Replay, std::string> record(const Case& problem);

  /// Total times of all rows, row 0 first.
  std::span<const double> times() const;
  /// Whether another case has the same history, bit by bit.
  bool same_history(const Case& other) const;

  /// Runs the law with other definitions over the recorded increments.
  /// \param[out] values of all points, response by response
  /// \return false if the law has no finite value somewhere
  bool run(std::span<const law::FrictionDefinition> definitions,
           std::span<const Response> responses, std::span<double> values) const;

  /// The same with derivatives to `unknowns` numbers.
  /// \param slopes of each definition, how its numbers depend on the unknowns
  /// \param[out] jacobian row-major points x unknowns
  bool run(std::span<const law::FrictionDefinition> definitions,
           std::span<const law::DefinitionSlopes> slopes, std::size_t unknowns,
           std::span<const Response> responses, std::span<double> values,
           std::span<double> jacobian) const;

 private:
  // The recorded increments.
};

}  // namespace slipbench::driver
