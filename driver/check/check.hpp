// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/check_labels.hpp"
#include "driver/check/criteria/point_judge.hpp"
#include "driver/check/curves/series.hpp"
#include "driver/check/row_reference.hpp"
#include "driver/check/row_values.hpp"
#include "driver/check/series_judge.hpp"
#include "driver/check/verdict.hpp"

namespace slipbench::driver::check {

/// Choice of keeping the compared series, for a picture.
enum class Trace : std::uint8_t { kNone, kKeep };

/// Series that a check compared, in the case's units: two series over one abscissa.
struct CheckTrace {
  std::string abscissa_label;  ///< "t", "CU1", "= CU1 + CU2"
  std::string abscissa_unit;   ///< empty if unknown
  Series value;                ///< the quantity, at the rows of the run that the check selects
  Series reference;            ///< at its own points
  double tube = 0.0;           ///< +- around the reference; 0 unless the criterion is pointwise
};

/// One check of a case on its way through the rows of a run.
///
/// Compared are the rows of the check's step (row 0 belongs to the first) between its times. A
/// closed form is fed with every row from the first on, since it follows the whole path; if an
/// input has no value in some row, compared or not, the check fails.
///
/// Point by point against an expression or a closed form, rows are judged as they come and nothing
/// grows with their number (PointJudge). Against a curve, and by any other criterion, the compared
/// rows are kept and judged at the end (docs/theory, section 16).
class CheckProgress {
 public:
  /// `problem` and `check` must outlive it.
  CheckProgress(const cases::Case& problem, const cases::Check& check, Trace trace = Trace::kNone);

  void add(std::span<const bench::Row> rows);
  void add(const bench::Row& row) { add({&row, 1}); }
  Verdict verdict() const;
  /// Returns what was compared so far; empty unless the check was told to keep it.
  CheckTrace trace() const;

 private:
  void add_row(const bench::Row& row);
  void reserve_rows();
  bool selected(const bench::Row& row) const;
  std::optional<double> reference(const bench::Row& row, bool compared);
  void stop(std::string message);
  void fault(const bench::Row& row, std::string message);
  void compare(const bench::Row& row, double abscissa, double value, double reference);
  ComparedRows kept_rows() const;

  const cases::Case* case_;
  const cases::Check* check_;
  bool streamed_;
  bool kept_;
  std::optional<RowExpression> quantity_;
  std::optional<RowExpression> abscissa_;
  std::optional<RowReference> reference_;
  std::optional<std::size_t> definition_;  ///< whose friction force the quantity is

  std::string fault_;        ///< the first thing that makes the check fail whatever the numbers
  std::int64_t faults_ = 0;  ///< rows without a number
  std::int64_t compared_ = 0;
  PointJudge judge_;
  ComparedRows rows_;  ///< over time without abscissas: they are the times
};

}  // namespace slipbench::driver::check
