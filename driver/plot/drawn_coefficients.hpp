// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/friction/friction_law.hpp"

namespace slipbench::driver::plot {

/// A run that goes further than so many times what the law has to show is cut off, and that is
/// said.
inline constexpr double kFarthest = 6.0;

/// Abscissa of a drawn coefficient.
using DrawnArgument = law::Independent;

/// A state that a run visited.
struct Visited {
  double slip_rate = 0.0;      ///< [L/T]
  double contact_force = 0.0;  ///< F_N [F]
  double mu = 0.0;
  int status = 1;                    ///< 1 stick, 2 slip
  std::array<double, 2> argument{};  ///< the numbers of the arguments asked for
};

/// The states of a run of any length: of a long one every second, every fourth and so on.
class VisitedStates {
 public:
  void add(const Visited& state);
  const std::vector<Visited>& states() const { return states_; }
  double largest_slip_rate() const { return slip_rate_; }
  double largest_contact_force() const { return contact_force_; }
  /// The smallest and the largest number of an argument.
  std::array<double, 2> range(std::size_t argument) const { return range_[argument]; }

 private:
  static constexpr std::size_t kMost = 20000;
  std::vector<Visited> states_;
  long count_ = 0;
  long stride_ = 1;
  double slip_rate_ = 0.0;
  double contact_force_ = 0.0;
  std::array<std::array<double, 2>, 2> range_{};
};

/// One coefficient that is drawn: of a definition, or of one direction of it.
struct DrawnCoefficient {
  std::string title;
  law::FrictionLaw law;
  bool rotational = false;
  bool creeps = false;  ///< below the limit, in place of stick
  /// The arguments of a map: the first two the law depends on; the slip rate or the normal force in
  /// place of one it has not.
  std::array<DrawnArgument, 2> arguments{};
  VisitedStates visited;
};

/// The coefficients of a case that depend on something, directions of an orthotropic one apart.
class DrawnCoefficients {
 public:
  /// \param any also those that depend on temperature or fields only
  DrawnCoefficients(const cases::Case& problem, bool any);
  DrawnCoefficients(const DrawnCoefficients&) = delete;
  DrawnCoefficients& operator=(const DrawnCoefficients&) = delete;

  /// Notes the states of a row of the run.
  void visit(const bench::Simulation& simulation);

  const std::vector<DrawnCoefficient>& list() const { return list_; }
  /// Returns what tables may depend on besides the slip, as the run left it.
  const law::Ambient& ambient() const { return ambient_; }
  /// The accumulated slip of the definition of an entry, as the run left it.
  double accumulated_slip(std::size_t entry) const { return slips_[entry]; }

 private:
  const cases::Case* case_;
  std::vector<DrawnCoefficient> list_;
  /// Of each definition, the entries of direction 1 and 2 in `list_`; -1 for none.
  std::vector<std::array<int, 2>> of_definition_;
  std::vector<double> slips_;
  std::array<double, law::kMaxFields> fields_{};
  law::Ambient ambient_;
};

}  // namespace slipbench::driver::plot
