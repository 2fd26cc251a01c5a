// SPDX-License-Identifier: Apache-2.0
// One free component as a mass on a moving belt, with rigid stick.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "driver/bench/component_forces.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::driver::bench {

/// Reason why an increment of a dynamic case cannot be stepped.
struct DynamicsFailure {
  double fraction = 0.0;  ///< of the increment that is behind
  std::string message;
};

/// A mass m along one free component on a belt of constant velocity v_b (theory, dynamics):
///   m x'' = CCF - CEF(x) - CVF(x') - CSF,   w = x' - v_b,
///   slip:   CSF = sign(w) F_lim(|w|),
///   stick:  w = 0 and CSF = CCF - CEF - CVF while |CSF| <= F_lim,s = min(mu_s F_N, force limit).
/// Stick is rigid: the stick stiffness plays no part. Slip is integrated by an eighth-order
/// Runge-Kutta method with error control; where w comes to zero, and where a stuck mass breaks
/// loose, the instant is located to rounding. A stuck mass costs no integration. Load, constraint
/// forces, temperature, fields and the other positions go linearly through an increment.
///
/// With a driver of mass M in place of the belt, CP is the position of the mass relative to it and
/// w = CP' = x' - X'. What acts between the two accelerates them against each other,
///   m_r w' = m_r (CCF/m - F_driver/M) - CEF(CP) - CVF(w) - CSF,   1/m_r = 1/m + 1/M:
/// the equation of one mass on a fixed track. The loads alone move the two together,
///   (m + M) V' = CCF + F_driver,   V = (m x' + M X')/(m + M).
///
/// What is reported does not depend on the increments, apart from that.
class Dynamics {
 public:
  /// \pre problem.dynamics
  explicit Dynamics(const cases::Case& problem);
  Dynamics(Dynamics&&) noexcept;
  ~Dynamics();

  /// The initial regime and forces, from the row's quantities.
  void start(const law::FrictionDefinition* friction, Row& row);

  /// One increment: sets the position of the mass in the row, the update, sums and changes of its
  /// friction, and its component forces; adds its damper to the row's energies.
  /// \param begin all quantities where the increment begins, behind any jump
  /// \param friction the definition in force; null without friction
  /// \param follow sets the loads that follow the positions; empty if none do
  tl::expected<void, DynamicsFailure> advance(const Quantities& begin,
                                              const law::FrictionDefinition* friction,
                                              const FollowPositions& follow, Row& row);

  /// The definition that acts on the mass; -1 without friction.
  int definition() const { return definition_; }
  int component() const { return data_.component; }

 private:
  struct Stepper;

  /// Unknowns that are integrated while the mass slips: position x, velocity w over the belt,
  /// accumulated slip, heat of friction, work of load and belt, heat of the damper, velocity V of
  /// both masses.
  enum Entry : std::size_t {
    kMotion,
    kRelative,
    kSlip,
    kHeat,
    kLoadWork,
    kBeltWork,
    kViscous,
    kCommon
  };
  static constexpr std::size_t kEntries = 8;
  using State = std::array<double, kEntries>;

  /// Forces that drive the mass and that resist, at one time of the increment.
  struct Forces {
    double load = 0.0, elastic = 0.0, viscous = 0.0, driver = 0.0;
    double push =
        0.0;  ///< of the loads on the relative motion: the load, or m_r (load/m - driver/M)
    double drive() const { return push - elastic - viscous; }
  };

  law::ConnectorIncrement conditions(double time, double motion) const;
  /// Sets the kinetic forces of `here` that press, with the velocity of the mass.
  void press(double velocity, law::ConnectorIncrement& here) const;
  Forces forces(double time, double motion, double velocity) const;
  /// The limit at a slip rate; of stick at rate 0.
  law::Limit limit(double time, const State& state, double rate) const;
  law::Limit static_limit(double time, const State& state) const;
  State rates(double time, const State& state) const;
  double relative_acceleration(double time, const State& state) const;
  State step_from(double time, const State& state, double size);

  /// Each goes on until the end of the increment or the next event, and returns its time.
  double slip(double time);
  double stick(double time);
  /// Decides whether a mass that keeps up with its belt sticks, or in which sense it slips.
  void decide(double time);
  void choose_scales(double time);
  double friction_force(double time) const;
  /// Velocity of what the mass rubs on, belt or driver.
  double surface_velocity(const State& state) const;
  void move_together(double time, double end);
  bool changes_since(int old, double time) const;
  void note_change(double time, Row& row) const;
  void report(double time, Row& row);

  const cases::Case* case_;
  cases::DynamicsData data_;
  double mass_ = 1.0;          ///< m, or m_r
  double driver_share_ = 0.0;  ///< m/(m + M) of a driver: its part of w
  int definition_ = -1;
  std::unique_ptr<Stepper> stepper_;

  // Of the increment.
  const law::FrictionDefinition* friction_ = nullptr;
  const Quantities* begin_ = nullptr;
  const Quantities* end_ = nullptr;
  double duration_ = 0.0;
  long steps_ = 0;  ///< in time, taken or tried in this increment
  const FollowPositions* follow_ = nullptr;
  bool varying_ = false;
  const char* fault_ = nullptr;

  // Memory.
  State state_{};
  int sense_ = 0;  ///< of slip: 1, -1; 0 in stick
  State scale_{};  ///< sizes of what is integrated
  double step_ = 0.0;
  double reported_viscous_ = 0.0;  ///< heat of the damper that is in the row already
  mutable Quantities now_{};
};

}  // namespace slipbench::driver::bench
