// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/base/units/units.hpp"
#include "driver/case/criterion.hpp"
#include "driver/case/integration.hpp"
#include "driver/case/quantity.hpp"
#include "driver/history/measured_history.hpp"
#include "driver/history/profile.hpp"
#include "law/base/stop.hpp"
#include "law/component/kinetic_force.hpp"
#include "law/connection/belt.hpp"
#include "law/update/connector.hpp"

namespace slipbench::driver::cases {

class CurveFile;

/// A free travel between the connector and its friction, in the unit of the component [L], [1].
struct DeadZone {
  double width = 0.0;  ///< g >= 0: from one end to the other
  double start = 0.0;  ///< play p at the start, in [-g/2, g/2]
};

/// One friction definition of the case, ready for the law; predefined PLANAR and UJOINT give two.
struct CaseDefinition {
  std::string name;      ///< suffix of its result columns where there are several definitions
  bool coupled = false;  ///< a potential: reported as CSFC, CNFC, CASUC, CIVC
  law::FrictionDefinition law;
  /// Law of the other direction: `law.law` then holds for forward slip only. One component.
  std::optional<law::FrictionLaw> backward = {};
  std::optional<DeadZone> dead_zone = {};  ///< in series with the friction of one component
  std::size_t entry = 0;                   ///< of `friction:`, that it comes from
  /// Geometry of predefined friction, that the law was expanded from; null of any other.
  std::shared_ptr<const law::ConnectionType> predefined = {};
};

/// The record of a table of part pairs whose friction is in force.
struct PickedPair {
  std::array<int, 2> parts{};        ///< ids, as the case names them
  std::optional<std::size_t> index;  ///< of friction_pairs.pairs; nothing: the default

  /// The record's path in the case.
  std::string record() const {
    return index ? "friction_pairs.pairs[" + std::to_string(*index) + "]"
                 : "friction_pairs.default";
  }
};

/// The belt of a SLIPRING connector; the wrap angles are the connection type's.
struct Belt {
  /// Initial positions of a, b, c: the distance CP1 follows from them.
  std::optional<std::array<law::Point, 3>> nodes;
  bool nodes_move = false;
  bool angle_from_nodes = false;  ///< else it is given
  /// The angle follows the nodes through whole turns, from so many half turns on.
  std::optional<int> half_turns;
  double initial_strain = 0.0;
  bool has_length = false;      ///< the distance is known, and so reference length and strain
  std::vector<double> lengths;  ///< of the segments behind the rings [L]; empty: not modelled
  bool both_tensions =
      false;  ///< f_bc is prescribed beside f1: stick is judged, no flow integrated
};

/// Tells whether a connection is a SLIPRING.
inline bool is_belt(const law::Connection& connection) {
  return connection.type && std::holds_alternative<law::SlipRing>(*connection.type);
}

/// A second mass, that the first one rubs on in place of a belt.
struct DriverData {
  double mass = 1.0;      ///< [F T^2/L], inertia [F L T^2] of a rotation
  double velocity = 0.0;  ///< at the start [L/T]
};

/// One free component as a mass on a belt of constant velocity, or on a driver.
struct DynamicsData {
  int component = 0;                         ///< index 0..5
  double mass = 1.0;                         ///< [F T^2/L], inertia [F L T^2] of a rotation
  double belt_velocity = 0.0;                ///< [L/T]
  double initial_velocity = 0.0;             ///< [L/T]
  std::optional<double> static_coefficient;  ///< of stick [1]; else the law's at rate 0
  std::optional<DriverData> driver = {};

  /// Returns the mass that the forces of the connector accelerate: one, or the reduced mass of
  /// both.
  double reduced_mass() const { return driver ? mass / (1.0 + mass / driver->mass) : mass; }
};

/// One prescribed quantity of a step.
struct Drive {
  int quantity = 0;  ///< flat numbering of quantity.hpp
  history::Profile profile;
};

/// Friction that changes in the course of a step (docs/theory, section 9.2).
struct FrictionChange {
  std::size_t definition = 0;  ///< in Case::definitions
  history::Profile amplitude =
      history::LinearTo{1.0};               ///< A(t), 0 at the start of the step and 1 at its end
  law::FrictionLaw law;                     ///< in force where A = 1
  double force_limit = law::kNoForceLimit;  ///< from the start of the step on
  law::StickStiffness stick;                ///< where A = 1, or from the start of the step on
  bool blends_elastic_slip = false;         ///< the elastic slip follows A too
};

struct Step {
  std::string name;
  double duration = 1.0;  ///< [T]
  int increments = 1;     ///< equal ones; breakpoints of profiles are added
  int repeat = 1;
  std::vector<Drive> drives;  ///< quantities not mentioned keep their value
  std::vector<FrictionChange> friction_changes = {};
};

/// A value to hold a check against, or to drive a closed form with.
struct ExpressionReference {
  base::Expression expression;  ///< over t, T and result columns: `variables` in this order
  std::vector<std::string> variables;
};
struct ClosedFormReference {
  std::string name;                             ///< in reference::catalogue()
  std::vector<std::vector<double>> parameters;  ///< in the order of the form's parameters
  std::vector<ExpressionReference> inputs;      ///< what drives each of its inputs
  int output = 0;                               ///< which of its outputs is compared
};

/// A column of a CSV file, and how its numbers become those of the case.
struct CurveColumn {
  std::vector<std::string> names;  ///< the first of these that the file has
  base::UnitConversion conversion;
};
/// A curve from a file: another program's, a measurement, or the case's own past.
struct CurveReference {
  std::filesystem::path file;
  std::string shown_name;  ///< as the case names it
  CurveColumn abscissa;
  CurveColumn column;
  std::shared_ptr<CurveFile> data;  ///< its columns, for all checks of the case that name it
  bool shipped = false;             ///< comes with the program
  base::CsvFormat format = {};
};

/// deviation <= max(absolute, relative * scale); what both are, the criterion says (docs/theory,
/// section 16): pointwise, |quantity - reference| and the range of the reference.
struct Tolerance {
  std::optional<double> absolute;
  std::optional<double> relative;
  std::string why;
  std::optional<double> abscissa = {};  ///< of positions, in the abscissa's unit
};

struct Check {
  std::string name;
  base::Expression quantity;  ///< over t, T and result columns
  std::string quantity_text;
  std::vector<std::string> variables;  ///< of `quantity`, in this order
  std::variant<ExpressionReference, ClosedFormReference, CurveReference> against;
  Criterion criterion = Criterion::kPointwise;
  /// Abscissa of the comparison; total time if there is none.
  std::optional<ExpressionReference> abscissa = {};
  std::string abscissa_text = "time";  ///< as the case names it
  std::optional<std::string> step;     ///< only the rows of this step
  std::optional<double> from;          ///< only rows with T in [from, to]
  std::optional<double> to;
  Tolerance tolerance;
  base::SourcePosition where;
};

/// A case, checked and with all expressions evaluated: what the simulation runs.
struct Case {
  std::string file;                     ///< as the user typed it
  std::vector<std::string> data_files;  ///< that it names: histories, tables, curves
  std::string title;
  base::UnitSystem units;
  base::NamedNumbers parameters;
  law::Connection connection;
  std::optional<Belt> belt;         ///< of a SLIPRING
  law::RelativePosition reference;  ///< constitutive reference positions
  law::RelativePosition initial;    ///< CP at the start, held components included
  std::vector<CaseDefinition> definitions;
  std::optional<PickedPair> pair;  ///< of a case with a table of part pairs
  Integration integration;
  law::KineticBehavior kinetic;  ///< springs and dampers along free components
  std::array<std::optional<law::Stop>, law::kComponents> stop;  ///< of each component
  std::optional<DynamicsData> dynamics;
  law::ComponentSet force_driven;  ///< free components that are driven by force at some time
  std::vector<Step> steps;         ///< empty if `measured`
  std::optional<history::MeasuredSource>
      measured;             ///< drives the case row by row; opened by each run
  int measured_pieces = 1;  ///< increments from one row to the next
  int output_every = 1;
  std::vector<std::string> output_columns;  ///< empty: all
  std::vector<Check> checks;
};

/// Returns whether the history prescribes a quantity (quantity.hpp) at some time.
inline bool is_driven(const Case& problem, int quantity) {
  for (const Step& step : problem.steps) {
    for (const Drive& drive : step.drives) {
      if (drive.quantity == quantity) return true;
    }
  }
  if (!problem.measured) return false;
  for (const history::MeasuredColumn& column : problem.measured->columns) {
    if (column.quantity == static_cast<std::size_t>(quantity)) return true;
  }
  return false;
}

/// Returns whether a spring, a damper or a stop acts along a component beside its friction.
inline bool acts_beside_friction(const Case& problem, int component) {
  return problem.kinetic.is_elastic(component) || problem.kinetic.is_damped(component) ||
         problem.stop[static_cast<std::size_t>(component)].has_value();
}

}  // namespace slipbench::driver::cases
