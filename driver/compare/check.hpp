// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/compare/series.hpp"
#include "driver/results/columns.hpp"
#include "driver/simulation.hpp"
#include "driver/text/json.hpp"
#include "reference/closed_form.hpp"

namespace slipbench::driver {

/// How far a check's quantity was off at one row.
struct Deviation {
  double time = 0.0;  ///< total time
  double value = 0.0;
  double reference = 0.0;
  double size() const;
};

/// The outcome of one check.
struct Verdict {
  std::string name;
  Criterion criterion = Criterion::kPointwise;
  bool passed = false;
  std::string message;       ///< in a sentence what is wrong; empty if passed
  std::string likely_cause;  ///< "looks like the coefficient: ratio 1.07 everywhere in slip"
  std::vector<std::string> warnings;    ///< in sentences what is doubtful about the check itself
  std::vector<Measure> measures;        ///< of criteria other than pointwise
  std::string unit;                     ///< of the quantity; empty if unknown
  std::string abscissa;                 ///< what was compared over, with its unit: "CU1 [mm]"
  std::int64_t compared = 0;            ///< rows
  std::int64_t failing = 0;             ///< rows beyond the tolerance
  double tolerance = 0.0;               ///< in the quantity's unit
  double scale = 0.0;                   ///< what a relative tolerance was relative to
  Deviation worst;                      ///< of all compared rows
  std::optional<double> first_failing;  ///< total times
  std::optional<double> last_failing;

  /// The worst deviation as a part of the tolerance; infinite if the tolerance is 0 and it is not.
  double worst_fraction() const;
};

/// One check of a case on its way through the rows of a run.
///
/// Compared are the rows of the check's step (row 0 belongs to the first) between its times. The
/// tolerance is the larger of the absolute one and the relative one times the range (largest minus
/// smallest) of the reference over the compared rows; a reference that is constant but for
/// rounding (range below 1e-9 of its largest magnitude) counts with that magnitude instead.
/// A closed form is fed with every row from the first on, since it follows the whole path; if an
/// input has no value in some row, compared or not, the check fails.
class CheckProgress {
 public:
  /// `problem` and `check` must outlive it.
  CheckProgress(const Case& problem, const Check& check);

  void add(const Row& row);
  Verdict verdict() const;

 private:
  /// Where the numbers of an expression's variables come from.
  struct Input {
    enum class Kind { kStepTime, kTotalTime, kColumn } kind = Kind::kColumn;
    Column column;
  };
  struct Suspect {
    double time;
    double deviation;
  };

  /// What drives one input of a closed form.
  struct FormInput {
    std::vector<Input> inputs;
    const ExpressionReference* value;
  };

  std::optional<std::vector<Input>> inputs_of(const std::vector<std::string>& names);
  bool gather_form_inputs(const Row& row);
  void gather(const std::vector<Input>& inputs, const Row& row);
  bool selected(const Row& row) const;
  std::optional<double> reference(const Row& row, bool compared);
  void fault(const Row& row, std::string message);
  void compare(double time, double value, double reference_value);
  double scale() const;
  double certain_tolerance() const;

  const Case* case_;
  const Check* check_;
  std::vector<Column> columns_;
  std::vector<Input> quantity_inputs_;
  std::vector<Input> reference_inputs_;
  reference::PathEvaluator closed_form_;
  std::vector<FormInput> form_inputs_;
  std::vector<double> form_arguments_;
  std::vector<double> outputs_;
  std::vector<double> arguments_;

  std::string fault_;        ///< the first thing that makes the check fail whatever the numbers
  std::int64_t faults_ = 0;  ///< rows without a number
  std::int64_t compared_ = 0;
  double lowest_ = 0.0;  ///< of the reference
  double highest_ = 0.0;
  Deviation worst_;
  std::vector<Suspect> suspects_;  ///< rows that may turn out to fail
  std::size_t prune_at_ = 4096;
};

/// "CSF2 off by 3.1 N (limit 0.5) at t = 0.84, first at 0.80, 41 of 400 points" is a failed
/// verdict's message; this is the unit of the check's quantity in it, empty if it is no column.
std::string check_unit(const Case& problem, const Check& check);

json::Value to_json(const Verdict& verdict);

}  // namespace slipbench::driver
