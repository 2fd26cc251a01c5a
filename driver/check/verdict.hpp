// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/case/criterion.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Deviation of a check's quantity at one place.
struct Deviation {
  double time = 0.0;  ///< total time; NaN where a curve does not tell
  double value = 0.0;
  double reference = 0.0;
  double abscissa = 0.0;  ///< what was compared over; the time if that is time
  double size() const;
};

/// The outcome of one check.
struct Verdict {
  std::string name;
  cases::Criterion criterion = cases::Criterion::kPointwise;
  bool passed = false;
  std::string message;                  ///< in a sentence what is wrong; empty if passed
  std::string likely_cause;             ///< "looks like an offset: +1 N everywhere"
  std::vector<std::string> warnings;    ///< in sentences what is doubtful about the check itself
  std::vector<Measure> measures;        ///< of criteria other than pointwise
  std::string unit;                     ///< of the quantity; empty if unknown
  std::string abscissa;                 ///< what was compared over, with its unit: "CU1 [mm]"
  std::string abscissa_unit;            ///< empty if unknown
  std::string product_unit;             ///< of quantity x abscissa: "mJ"; empty if unknown
  std::int64_t compared = 0;            ///< points
  std::int64_t failing = 0;             ///< points, or measures, beyond the tolerance
  double tolerance = 0.0;               ///< in the quantity's unit, or that of the worst measure
  double scale = 0.0;                   ///< what a relative tolerance was relative to
  Deviation worst;                      ///< of all compared points, or of the worst measure
  std::optional<double> first_failing;  ///< total times, of pointwise checks
  std::optional<double> last_failing;

  /// Returns what the tolerance bounds: of the worst point, or of the worst measure.
  double worst_deviation() const;
  /// The worst deviation as a part of the tolerance; infinite if the tolerance is 0 and it is not.
  double worst_fraction() const;
};

/// The measure that is nearest to its tolerance or farthest beyond it; null if none is bounded.
const Measure* worst_measure(const Verdict& verdict);

/// The unit of a measure's number; empty if unknown or none.
const std::string& unit_of(const Measure& measure, const Verdict& verdict);

/// All of it; what is not finite is null.
base::json::Value to_json(const Verdict& verdict);

}  // namespace slipbench::driver::check
