// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/history_error.hpp"
#include "driver/bench/component_forces.hpp"
#include "driver/bench/friction_change.hpp"
#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "driver/history/profile_cursor.hpp"
#include "driver/history/step_grid.hpp"
#include "law/base/compensated_sum.hpp"
#include "law/connection/belt.hpp"
#include "law/definition/formulation.hpp"
#include "law/exact/regime_change.hpp"
#include "law/update/return_mapping.hpp"
#include "law/update/uniqueness.hpp"

namespace slipbench::driver::bench {

class Dynamics;
class Equilibrium;
class ExactIntegration;

/// Values of all quantities a case can prescribe, in the numbering of quantity.hpp.
using Quantities = std::array<double, cases::kQuantities>;

/// Sets the forces that follow the positions in `quantities`, at a part of an increment; NaN where
/// a formula has no value.
using FollowPositions = std::function<void(double part, Quantities& quantities)>;

/// State and work of one friction definition over an increment, and since the start.
struct DefinitionRow {
  law::FrictionUpdate update;
  law::CompensatedSum dissipation;  ///< since the start [F L]
  law::CompensatedSum work;  ///< of the friction force over the motion, since the start [F L]
  double lost = 0.0;       ///< of the spring's energy, FrictionUpdate::lost, since the start [F L]
  std::int64_t jumps = 0;  ///< so far
  /// Length that the increment should exceed; 0 where that does not matter.
  law::IncrementThresholds thresholds;
  /// Changes of regime within the increment, where the integration locates them.
  law::RegimeChanges changes;
  law::PenaltyDetail penalty;  ///< of a definition with a formulation
  /// Coefficients before their floor [1], of laws that have one: the definition's, or those of both
  /// directions.
  std::array<double, 2> raw_mu{};
  bool clamped = false;   ///< whether one of them is below it
  double play = 0.0;      ///< of a dead zone, at the end of the increment [L], [1]
  double travel = 0.0;    ///< of the play in the increment: motion that the friction does not see
  bool backward = false;  ///< whether the coefficient of backward slip was in force
  law::SegmentBehind behind;  ///< of a ring, where the segments' lengths are known
};

/// Adds an increment to the sums of its definition over the run.
inline void add_increment(const law::FrictionUpdate& increment, DefinitionRow& row) {
  row.dissipation += increment.dissipation;
  row.work += increment.work;
  row.lost += increment.lost;
  row.jumps += increment.jumps;
}

/// Tells whether the sums of energies are finite.
inline bool all_finite(const DefinitionRow& row) {
  return std::isfinite(double{row.dissipation}) && std::isfinite(double{row.work}) &&
         std::isfinite(row.lost);
}

/// The result of one increment. Row 0 is the initial state: forces, temperature and fields as the
/// history begins, no motion yet.
struct Row {
  std::int64_t index = 0;                  ///< how many increments lie behind
  int step = 0;                            ///< counts the case's steps; 0 in a measured history
  int pass = 0;                            ///< which repetition of the step, from 0
  double time = 0.0;                       ///< total time T [T]
  double step_time = 0.0;                  ///< time in the step t [T]
  double duration = 0.0;                   ///< of the increment [T]; 0 in row 0
  law::RelativePosition begin;             ///< CP where the increment began
  Quantities quantities{};                 ///< at its end
  law::BeltSegment belt;                   ///< of a SLIPRING, at its end
  law::BeltTurn turn;                      ///< of a belt whose angle follows its nodes
  ConnectorForces forces;                  ///< beside friction, where the case has any
  std::vector<DefinitionRow> definitions;  ///< in the order of the case's definitions
};

/// All that a run has to remember, apart from its case: a run that goes on from here gives the same
/// bytes as one that was never cut.
struct SimulationState {
  struct Definition {
    law::FrictionState friction;
    law::CompensatedSum dissipation;
    law::CompensatedSum work;
    double lost = 0.0;
    std::int64_t jumps = 0;
    double mu = 0.0;                 ///< coefficient of the last increment
    double mu_start = 0.0;           ///< that a change of friction in progress sets out from
    double play = 0.0;               ///< of a dead zone
    law::SegmentBehind behind = {};  ///< of a ring
  };
  std::int64_t increments = 0;  ///< position in the history
  std::vector<Definition> definitions;
};

/// A motion that does not start where the connector is: it is made up in the first increment.
struct MotionJump {
  int component = 0;  ///< index 0..5
  double size = 0.0;  ///< [L], [1]
  double time = 0.0;  ///< total time
  std::string step;
};

/// Reason why a run ended early.
struct SimulationFailure {
  enum class Kind {
    kInput,        ///< the history has no value, or its data are faulty
    kEnvironment,  ///< a data file cannot be read
    kNumerical     ///< an update is not finite, or has no solution
  };
  Kind kind = Kind::kNumerical;
  std::string message;  ///< with the file's position where data are at fault
  int step = -1;        ///< of the case's steps, where an increment failed
};

/// The reason why a run ended where its history could not be read.
SimulationFailure to_failure(const base::HistoryError& error);

/// A case on its way through its history, one increment after another. Increments end at the
/// points of each step's uniform grid and at every breakpoint of its profiles, or at the rows of a
/// measured history. An increment allocates nothing; nothing grows with the number of increments.
class Simulation {
 public:
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// The initial state; `problem` must outlive the simulation. Errors: a history that has no first
  /// value, an initial state that is not finite.
  static tl::expected<Simulation, SimulationFailure> start(const cases::Case& problem);

  /// The state in which another run of the same case was cut; its history is walked through again
  /// up to there, without the law where nothing that moves depends on it. The next row is the one
  /// the other run would have given; `row()` before it has no updates. Errors: those of `start`; a
  /// history shorter than that.
  static tl::expected<Simulation, SimulationFailure> resume(const cases::Case& problem,
                                                            const SimulationState& state);

  /// Walks through a history whose motions are prescribed, without friction: `watch` sees every
  /// row, row 0 first, with no updates in it. Errors: those of the history, and a motion beyond a
  /// stop.
  static tl::expected<void, SimulationFailure> walk(const cases::Case& problem,
                                                    const std::function<void(const Row&)>& watch);

  /// Goes to the end of the next increment; false at the end of the history. After an error or the
  /// end the simulation stays where it is.
  tl::expected<bool, SimulationFailure> advance();

  /// Goes on by one increment or several, as many as are quickest together; their rows hold until
  /// the next call, and there are none at the end of the history. A failure comes behind the rows
  /// of the increments before it. The tangents of rows that come together are not computed.
  tl::expected<std::span<const Row>, SimulationFailure> advance_rows();

  /// The last increment, or the initial state.
  const Row& row() const { return row_; }

  /// The definition in force in the last increment.
  const law::FrictionDefinition& definition(std::size_t index) const { return definitions_[index]; }

  SimulationState state() const;

  /// Motions that did not start where the connector was, so far; at most kMostJumps are kept.
  std::span<const MotionJump> jumps() const { return jumps_; }
  static constexpr std::size_t kMostJumps = 8;

 private:
  explicit Simulation(const cases::Case& problem);

  tl::expected<void, SimulationFailure> start_history();
  tl::expected<bool, SimulationFailure> advance_history();
  tl::expected<bool, SimulationFailure> advance_measured();
  /// Tells whether nothing of the case needs the increments one by one.
  bool is_plain() const;
  /// Fills `rows_` from their first on, and returns how many; 0 at the end of the history. A
  /// failure goes to `failed_`.
  std::size_t advance_one_by_one();
  std::size_t advance_together();
  /// Fills rows of the current pass, up to its next breakpoint, or of measured data, but for the
  /// definitions. Returns how many; the failure that ends them early goes to `failed_`.
  /// \param before the row before them; may be the first of them
  std::size_t walk_grid(std::span<Row> rows, const Row& before);
  std::size_t walk_measured(std::span<Row> rows);
  void take_measured_row(const Row& before, Row& row);
  /// Where a value of the history is no number.
  SimulationFailure history_failure(const Row& row) const;
  void pass_breakpoint();
  template <int D, bool kConstant>
  std::size_t update_known_rows(std::span<Row> rows, std::size_t definition);
  template <int D>
  std::size_t update_known_rows(std::span<Row> rows, std::size_t definition);
  std::size_t update_rows_one_by_one(std::span<Row> rows, std::size_t definition);
  bool limit_is_constant(std::size_t definition) const;
  tl::expected<void, SimulationFailure> begin_step();
  tl::expected<void, SimulationFailure> begin_pass();
  tl::expected<void, SimulationFailure> update_definitions();
  /// One increment of one definition by the case's integration method.
  law::FrictionUpdate integrate(std::size_t definition, const law::ConnectorIncrement& increment,
                                const law::FrictionState& old);
  /// The same for a definition with a dead zone or a coefficient for each direction.
  law::FrictionUpdate integrate_with_options(std::size_t definition,
                                             law::ConnectorIncrement increment,
                                             const law::FrictionState& old);
  /// Judges whether the update of a definition can be used; the error says why not.
  tl::expected<void, SimulationFailure> judge(const Row& row, std::size_t definition) const;
  /// That the force of a definition would jump in this increment, and what helps.
  SimulationFailure snap_back_failure(const Row& row, std::size_t definition) const;
  void note_raw_coefficients();
  /// Those of the current increment; empty where no force follows a position.
  FollowPositions following();
  void follow_positions(double step_time, Quantities& quantities);
  /// Chooses the components driven by force from now on, and the loads they start with.
  void choose_force_driven(const cases::Step& step);
  tl::expected<void, SimulationFailure> solve_equilibrium();
  tl::expected<void, SimulationFailure> advance_mass(bool start);
  /// Sets the kinetic forces that press, of an increment whose motions are known.
  void press();
  /// Springs, dampers and stops at the end of an increment whose motions are known.
  tl::expected<void, SimulationFailure> take_forces();
  double carried_force(int component) const;
  tl::expected<void, SimulationFailure> begin_friction_changes();
  /// Notes anew whether the coefficient of a definition may fall, by a walk through its tables.
  void note_falling(std::size_t definition);
  void note_thresholds(Row& row) const;
  void note_jump(int component, double from, double to);
  tl::expected<void, SimulationFailure> move_belt();
  /// "step 'cycle', t = 0.5 (total time 1.5)".
  /// \param before how long before the end of the increment [T]
  std::string place(const Row& row, double before = 0.0) const;
  std::string place(double before = 0.0) const { return place(row_, before); }
  SimulationFailure numerical_failure(const Row& row, std::size_t definition,
                                      const std::string& what) const;

  const cases::Case* case_;
  /// The definitions in force; a change of friction puts others in place of the case's.
  std::vector<law::FrictionDefinition> definitions_;
  FrictionChanges friction_changes_;
  /// A definition whose increments may be too short, with the bounds of its law.
  struct Falling {
    std::size_t definition = 0;
    law::CoefficientBounds bounds;
  };
  std::vector<Falling> falling_;
  std::vector<std::size_t> with_floor_;  ///< definitions whose coefficient is kept above a floor
  bool has_options_ = false;             ///< a dead zone, or a coefficient for each direction
  /// The law that is not in force, of definitions with one for each direction; else empty.
  std::vector<law::FrictionLaw> other_law_;
  Row row_;
  /// Of a case with components that are driven by force, and of a dynamic one.
  std::unique_ptr<Equilibrium> equilibrium_;
  std::unique_ptr<Dynamics> dynamics_;
  law::ComponentSet force_driven_;           ///< now
  bool has_forces_ = false;                  ///< beside friction
  std::unique_ptr<ExactIntegration> exact_;  ///< where the case asks for it
  Quantities begin_{};                       ///< at the begin of the increment, for those three
  std::vector<MotionJump> jumps_;
  std::array<double, law::kComponents> extent_{};  ///< largest magnitude of each position so far

  std::vector<history::ProfileCursor> cursors_;  ///< one for each drive of the current step
  std::vector<std::size_t> varying_;             ///< the drives that are not constant over the step
  std::vector<std::size_t> following_;           ///< those of them that follow the positions
  history::StepGrid grid_{1.0, 1};
  bool in_step_ = false;
  std::optional<history::MeasuredHistory> measured_;
  std::vector<double> earlier_;  ///< the row before, where increments divide the rows
  double earlier_time_ = 0.0;
  int piece_ = 0;       ///< how many of them lie behind since the row before
  bool plain_ = false;  ///< is_plain()
  /// So many rows together stay in the second cache.
  static constexpr std::size_t kMostRows = 64;
  std::array<double, kMostRows> times_{};   ///< in the step
  std::array<double, kMostRows> values_{};  ///< of a profile at these times
  std::vector<Row> rows_;                   ///< of increments that go together
  std::vector<std::int64_t> rows_pass_;     ///< `passes_` when the constants of each were set
  std::int64_t passes_ = 0;                 ///< begun so far
  std::optional<SimulationFailure> failed_;
  double pass_start_ = 0.0;  ///< total time at which the current pass began
  double breakpoint_ = 0.0;  ///< the next one
};

}  // namespace slipbench::driver::bench
