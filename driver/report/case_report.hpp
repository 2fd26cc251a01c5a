// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "driver/check/check.hpp"
#include "driver/report/row_choice.hpp"
#include "driver/report/what_was_run.hpp"
#include "driver/results/plot_data.hpp"

namespace slipbench::driver::report {

/// One column of a case as the page shows it.
struct ReportColumn {
  std::string name;
  std::string unit;  ///< empty if there is none
  std::string text;  ///< one sentence; empty of a result, which does not carry it
};

/// One change of regime.
struct ReportEvent {
  double time = 0.0;
  std::string definition;
  std::string from;  ///< "open", "stick" or "slip"
  std::string to;
  bool reversal = false;
  double force = 0.0;
  double limit = 0.0;
  double accumulated_slip = 0.0;
  std::vector<std::pair<std::string, double>> positions;
};

/// One friction definition as the page draws it; columns by their names, empty for none.
struct ReportDefinition {
  std::string name;
  std::string force;                ///< the one it is known by: the total of a coupled definition
  std::vector<std::string> forces;  ///< of its components, and the positions they go with
  std::vector<std::string> positions;
  std::string limit;
  std::string limit_below;  ///< of a belt
  std::string status;
  std::string normal_force;
  std::string mu;
  bool filtered = false;     ///< an event's force is that before the filter, on no curve
  double slip_share = -1.0;  ///< part of the time that it slips; negative if unknown
  std::vector<results::RegimeSpan>
      spans;  ///< of slip and of no contact, in the order of their begin
};

/// Use of the parts of a table, small enough to be drawn.
struct ReportTable {
  struct Axis {
    std::string name;
    std::vector<double> knots;
    std::int64_t below = 0;
    std::int64_t above = 0;
    std::vector<std::int64_t> visits;  ///< of its intervals, over all others; empty if unknown
  };
  std::string name;
  std::vector<Axis> axes;
  std::vector<std::int64_t> visits;  ///< of one or two axes, the first one fastest
  std::int64_t increments = 0;
  std::int64_t outside = 0;
  bool coarser = false;  ///< neighbouring cells were taken together
};

/// A curve of a check.
struct ReportCurve {
  std::vector<std::int64_t> index;  ///< of each point: how many came before it
  std::vector<double> x;
  std::vector<double> y;
  std::int64_t piece = 1;    ///< points of a piece of a thinned curve
  std::vector<double> low;   ///< the smallest y of each
  std::vector<double> high;  ///< the largest
};

/// A check, with its quantity and reference as curves.
struct ReportCheck {
  check::Verdict verdict;
  std::string quantity;
  std::string against;
  std::string why;
  std::string abscissa;
  std::string abscissa_unit;
  ReportCurve value;
  ReportCurve reference;
  ReportCurve difference;  ///< of both, where they have the same abscissae
  double tube = -1.0;      ///< half width about the reference; negative for none
  bool thinned = false;    ///< whether points of the curves were left out
};

enum class ReportStatus : std::uint8_t { kPassed, kFailed, kNoChecks, kNotRun };

/// The events of a page: all of a run with few, else the first and the last ones.
class ReportEvents {
 public:
  void add(ReportEvent event);
  std::int64_t total() const { return total_; }
  /// In their order.
  std::vector<ReportEvent> take();

  static constexpr std::size_t kMostAtEachEnd = 100;

 private:
  std::vector<ReportEvent> first_;
  std::deque<ReportEvent> last_;
  std::int64_t total_ = 0;
};

/// The tale of one case or result for the page: numbers thinned, so that its size has a bound.
struct CaseReport {
  std::string name;
  std::string title;
  bool is_result = false;
  ReportStatus status = ReportStatus::kNoChecks;
  std::string message;  ///< of a case that was not run
  std::vector<std::pair<std::string, std::string>> units;
  std::vector<std::pair<std::string, double>> parameters;
  WhatWasRun run;
  std::vector<std::string> summary;
  std::vector<std::string> warnings;
  std::int64_t increments = 0;
  std::int64_t rows_total = 0;  ///< of the run, or of the file that it was read from
  std::vector<ReportColumn> columns;
  DrawnRows drawn;
  std::vector<ReportDefinition> definitions;
  std::vector<ReportEvent> events;  ///< as ReportEvents chooses them
  std::int64_t events_total = 0;
  std::vector<std::pair<std::string, std::vector<std::string>>> energies;  ///< kind, columns
  std::vector<ReportTable> coverage;
  std::vector<ReportCheck> checks;
  bool has_details = true;  ///< false once drop_details was called

  std::size_t row_count() const { return drawn.rows.size(); }
  /// Keeps what the table of verdicts needs: rows, curves, events and coverage go.
  void drop_details();
};

}  // namespace slipbench::driver::report
