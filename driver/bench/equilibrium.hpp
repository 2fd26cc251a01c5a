// SPDX-License-Identifier: Apache-2.0
// The static equilibrium of components that are driven by force.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/component_forces.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::bench {

/// One increment of one definition, without memory: the case's integration method.
using IntegrateDefinition = std::function<law::FrictionUpdate(
    std::size_t definition, const law::ConnectorIncrement&, const law::FrictionState& old)>;

/// Reason why an increment has no equilibrium.
struct NoEquilibrium {
  double fraction = 0.0;  ///< of the increment that could be solved
  std::string message;    ///< names components, loads and what holds against them
};

/// An order in which the definitions of a case can be evaluated: where a contact force names a
/// component that is driven by force, which in equilibrium is minus the friction of that component,
/// after the definition that slips there. As they stand where nothing asks for another order.
/// Fails with definitions that wait for each other, or for themselves, in the order of waiting.
tl::expected<std::vector<std::size_t>, std::vector<std::size_t>> order_of_evaluation(
    const cases::Case& problem);

/// Finds the positions q of all components that are driven by force, together, at the end of an
/// increment (theory, force-driven components):
///   CEF_i(q) + CVF_i((q - q_n)/dt) + CSF_i(q) + CRF_i = CCF_i(q),
/// where the reaction CRF_i of a stop acts at the stop only, towards the inside. Newton's method
/// with the law's consistent tangent and a line search, projected on the stops; where it fails, a
/// search along one component after the other, which finds the answer beyond a jump too. Where that
/// fails, the increment is cut in halves, down to 2^-12 of it: everything prescribed then goes
/// linearly through the increment.
///
/// Where a contact force names a component that is driven by its motion, its kinetic force follows
/// the unknown positions through coupled springs; of an unknown component it is -CSF_i, by (13.4)
/// at whatever holds the load. Both are in the tangent.
///
/// Solving allocates nothing.
class Equilibrium {
 public:
  explicit Equilibrium(const cases::Case& problem);

  /// Solves one increment: sets the positions of `unknown` in the row, the updates, dissipation and
  /// work of its definitions, and its component forces but CCF and CRF of other components.
  /// \param begin all quantities at the end of the last increment
  /// \param row with everything prescribed at its end; its definitions hold the old states
  /// \param definitions in force
  /// \param follow sets the forces that follow the positions; empty if none do
  tl::expected<void, NoEquilibrium> solve(law::ComponentSet unknown, const Quantities& begin,
                                          std::span<const law::FrictionDefinition> definitions,
                                          const IntegrateDefinition& integrate,
                                          const FollowPositions& follow, Row& row);

 private:
  static constexpr int kSize = law::kComponents;
  using Vector = std::array<double, kSize>;

  /// The imbalance CEF + CVF + CSF - CCF of the unknowns at trial positions, and its slopes.
  struct Trial {
    Vector q{};
    Vector imbalance{};
    Vector tolerance{};  ///< rounding of the imbalance
    std::array<Vector, kSize> tangent{};
  };

  void prepare(double from, double to, const Quantities& begin, const Row& row);
  void evaluate(Trial& trial);
  /// Sets the forces of a contact force's components that no definition has a part in, and the
  /// slopes of all forces that press to the unknowns.
  void press();
  void follow_positions(const Trial& trial);
  bool solve_piece(Trial& trial);
  bool newton(Trial& trial);
  bool search_along(int k, Trial& trial);
  bool at_stop(const Trial& trial, int k) const;
  /// Returns false for a balance that a load which follows the positions leaves with any shift: at
  /// rest the determinant of the slopes is positive, and along a way of balances that hold it stays
  /// so. Newton's method does not look where it goes.
  bool holds(const Trial& trial) const;
  bool balanced(const Trial& trial, int k) const;
  double merit(const Trial& trial) const;
  void accept(double from, double to, Row& row);
  std::string explain(const Trial& trial) const;

  const cases::Case* case_;
  std::span<const law::FrictionDefinition> definitions_;
  const IntegrateDefinition* integrate_ = nullptr;
  const FollowPositions* follow_ = nullptr;  ///< null where no force follows a position
  double part_ = 1.0;                        ///< of the increment, at the end of the piece
  /// Slopes dF_c/du_j of the forces that follow the positions.
  Eigen::Matrix<double, kSize, kSize> following_slopes_;

  int count_ = 0;                     ///< unknowns
  std::array<int, kSize> component_;  ///< of each
  Vector lower_{}, upper_{};          ///< stops of each
  Vector load_{}, scale_{};           ///< load and size of forces of each
  Vector begin_friction_{};           ///< size of the friction at the begin of the piece
  Vector held_{};                     ///< the most that held against a load in the last search
  bool jumped_ = false;               ///< the last search ended at a jump

  std::vector<std::size_t> order_;  ///< of the definitions
  Quantities end_{};                ///< of the piece of the increment that is being solved
  law::ConnectorIncrement increment_;
  /// Slopes dF_c/du_j of the forces that press and of those that follow the positions.
  Eigen::Matrix<double, kSize, kSize> pressing_slopes_;
  std::vector<law::FrictionState> old_;       ///< at its begin
  std::vector<law::FrictionUpdate> updates_;  ///< at the last trial
};

}  // namespace slipbench::driver::bench
