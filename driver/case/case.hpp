// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/case/quantity.hpp"
#include "driver/history/expression.hpp"
#include "driver/history/measured_history.hpp"
#include "driver/history/profile.hpp"
#include "driver/history/units.hpp"
#include "driver/text/diagnostic.hpp"
#include "law/connector.hpp"

namespace slipbench::driver {

/// One friction definition of the case, ready for the law; predefined PLANAR and UJOINT give two.
struct CaseDefinition {
  std::string name;      ///< suffix of its result columns where there are several definitions
  bool coupled = false;  ///< a potential: reported as CSFC, CNFC, CASUC, CIVC
  law::FrictionDefinition law;
};

/// One prescribed quantity of a step.
struct Drive {
  int quantity = 0;  ///< flat numbering of quantity.hpp
  Profile profile;
};

struct Step {
  std::string name;
  double duration = 1.0;  ///< [T]
  int increments = 1;     ///< equal ones; breakpoints of profiles are added
  int repeat = 1;
  std::vector<Drive> drives;  ///< quantities not mentioned keep their value
};

/// A value to hold a check against.
struct ExpressionReference {
  Expression expression;  ///< over t, T and result columns: `variables` in this order
  std::vector<std::string> variables;
};
struct ClosedFormReference {
  std::string name;                             ///< in reference::catalogue()
  std::vector<std::vector<double>> parameters;  ///< in the order of the form's parameters
  std::vector<std::string> inputs;  ///< a result column for each of its inputs; empty: 0
  int output = 0;                   ///< which of its outputs is compared
};

/// |quantity - reference| <= max(absolute, relative * range of the reference), at every row.
struct Tolerance {
  std::optional<double> absolute;
  std::optional<double> relative;
  std::string why;
};

struct Check {
  std::string name;
  Expression quantity;  ///< over t, T and result columns
  std::string quantity_text;
  std::vector<std::string> variables;  ///< of `quantity`, in this order
  std::variant<ExpressionReference, ClosedFormReference> against;
  std::optional<std::string> step;  ///< only the rows of this step
  std::optional<double> from;       ///< only rows with T in [from, to]
  std::optional<double> to;
  Tolerance tolerance;
  SourcePosition where;
};

/// A case, checked and with all expressions evaluated: what the simulation runs.
struct Case {
  std::string file;  ///< as the user typed it
  std::string title;
  UnitSystem units;
  NamedNumbers parameters;
  law::Connection connection;
  law::RelativePosition reference;  ///< constitutive reference positions
  law::RelativePosition initial;    ///< CP at the start, held components included
  std::vector<CaseDefinition> definitions;
  std::vector<Step> steps;                 ///< empty if `measured`
  std::optional<MeasuredSource> measured;  ///< drives the case row by row; opened by each run
  int output_every = 1;
  std::vector<std::string> output_columns;  ///< empty: all
  std::vector<Check> checks;
};

}  // namespace slipbench::driver
