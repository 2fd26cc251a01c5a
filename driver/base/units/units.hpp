// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// The consistent system of units a case states under `units:`; an empty name means not stated.
/// Angles are radians whatever the system.
struct UnitSystem {
  std::string length;
  std::string force;
  std::string time;
  std::string temperature;
};

/// Exponents of a quantity's dimension: force^a length^b time^c temperature^d angle^e.
struct Dimension {
  int force = 0;
  int length = 0;
  int time = 0;
  int temperature = 0;
  int angle = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

inline constexpr Dimension kLength{.length = 1};
inline constexpr Dimension kForce{.force = 1};
inline constexpr Dimension kMoment{.force = 1, .length = 1};
inline constexpr Dimension kTime{.time = 1};
inline constexpr Dimension kTemperature{.temperature = 1};
inline constexpr Dimension kAngle{.angle = 1};

/// A change of unit: in the case's unit, a number is scale * number + offset.
struct UnitConversion {
  double scale = 1.0;
  double offset = 0.0;

  double operator()(double number) const { return scale * number + offset; }
  friend bool operator==(const UnitConversion&, const UnitConversion&) = default;
};

/// The text of the case's unit for `dimension`, for labels and messages: "mm", "N mm", "N/mm^2",
/// "rad"; empty when the dimension needs a unit the case does not state, or none at all.
std::string unit_text(const Dimension& dimension, const UnitSystem& system);

/// Tells whether `text` names a unit that a case may have ("kN", "mm/s", "%"), and no number.
bool is_unit(std::string_view text);

/// Checks one entry of `units:`; `dimension` is the entry's (kLength, kForce, kTime, kTemperature).
/// Everyday names (mm, in, kN, lbf, ms, degC, ...) are known by heart, so that a case in those does
/// not wait for the unit data base. Errors: an unknown unit, a unit of another dimension.
tl::expected<void, HistoryError> check_base_unit(std::string_view unit, const Dimension& dimension);

/// The conversion from `unit`, as stated for a data column, to the case's unit for `dimension`.
///
/// `unit` is what UDUNITS-2 reads ("lbf", "N*mm", "mm/s", "degF"), and "deg" is the degree of
/// angle. It is the identity, without asking the data base, when `unit` is the case's own. Only a
/// temperature's conversion has an offset. Errors: an unknown unit; a unit of another dimension; a
/// case that does not state the unit to convert to; of the kind kEnvironment, a unit data base
/// that cannot be read. The data base is loaded once, at the first need; safe for threads.
tl::expected<UnitConversion, HistoryError> conversion_to_case(std::string_view unit,
                                                              const Dimension& dimension,
                                                              const UnitSystem& system);

}  // namespace slipbench::driver::base
