// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "driver/case/shared_numbers.hpp"

namespace slipbench::driver::check {

/// A quantity over an abscissa, in the order of its history: the abscissa may go back and forth.
struct Series {
  cases::SharedNumbers abscissa;
  cases::SharedNumbers value;  ///< as many
  cases::SharedNumbers time;   ///< total time; empty where only the abscissa is known
  double noise = 0.0;          ///< turns of the abscissa by no more may be those of its printing

  std::size_t size() const { return value.size(); }
};

/// Place on a curve, as it is looked up in the file.
struct CurvePoint {
  double abscissa = 0.0;
  double value = 0.0;
  double reference = 0.0;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< NaN where it is not known
};

/// Unit of the number of a measure.
enum class MeasureUnit : std::uint8_t {
  kQuantity,  ///< of the compared quantity
  kAbscissa,
  kProduct,  ///< quantity x abscissa: an area, the work of a loop
  kNone      ///< dimensionless
};

/// One number that a criterion judges: a peak, the energy of a loop, a phase error.
struct Measure {
  std::string name;  ///< "largest value", "energy of loop 2"
  MeasureUnit unit = MeasureUnit::kQuantity;
  double value = 0.0;
  double reference = 0.0;
  double deviation = 0.0;  ///< what the tolerance bounds, >= 0
  double scale = 0.0;      ///< what a relative tolerance is relative to, in the same unit
  double tolerance = 0.0;  ///< in the same unit; infinite for a measure that is only reported
  std::optional<CurvePoint> where;

  bool passed() const { return deviation <= tolerance; }
};

/// Findings of a criterion.
struct CurveComparison {
  std::string fault;          ///< why the two cannot be compared; empty if they can
  std::int64_t compared = 0;  ///< points of the reference in the common range
  std::vector<Measure> measures;
};

}  // namespace slipbench::driver::check
