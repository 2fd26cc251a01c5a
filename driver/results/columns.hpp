// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver {

/// Where the number of a result column comes from.
enum class ColumnSource : std::uint8_t {
  kTotalTime,        ///< total time
  kPosition,         ///< CP, and with an offset CU and CCU
  kVelocity,         ///< CV
  kConstraintForce,  ///< a prescribed constraint force
  kFrictionForce,    ///< R_i y_i of one entry of a definition's slip space
  kNoFriction,       ///< 0: an available component without friction
  kElasticForce,     ///< CEF
  kViscousForce,     ///< CVF
  kReaction,         ///< CRF of a stop
  kApplied,          ///< CCF
  kTotalForce,       ///< CEF + CVF + CSF + CRF - CCF
  kStopFlag,         ///< CSLST
  kMassVelocity,     ///< CV of the mass of a dynamic case
  kDrivenVelocity,   ///< of a mass on a driver
  kDriverVelocity,   ///< of its driver
  kElasticEnergy,
  kViscousDissipation,
  kKineticEnergy,
  kExternalWork,
  kFrictionTotal,  ///< P of a definition
  kSlipVelocity,   ///< n . ds/dt
  kAccumulatedSlip,
  kNormalForce,
  kStatus,
  kMu,
  kLimit,
  kPhi,
  kElasticSlip,
  kPlay,  ///< of a dead zone
  kDissipation,
  kLost,  ///< in jumps of the force
  kStoredEnergy,
  kWork,
  kQuantity,         ///< temperature or a field
  kStrain,           ///< of a belt, CU1
  kReferenceLength,  ///< of a belt
  kWrapAngle,        ///< of a belt with nodes
  kBeltTension,      ///< f_ab, 0 of a slack belt
  kLengthBehind,     ///< of the segment behind a ring, which stays
  kMaterialBehind,   ///< its unstrained length
  kStrainBehind,     ///< its strain
  kFlowBehind,       ///< out of that segment at its end
  kChainForce,       ///< the sum of the friction forces of all rings
  kRingTension,      ///< f_bc behind the ring of a definition
  kLargestForce,     ///< the upper end of a belt's stick band
  kSmallestForce,    ///< its lower end, negative
  kUtilisation,      ///< |ln(f_bc/f_ab)|/(mu alpha) of a belt whose tensions are both prescribed
  kPressure,         ///< F_N/A of a law with an area
  kSpeed,            ///< the rate the coefficient saw
  kSpeedAlong,       ///< along one direction of an orthotropic coefficient
  kMuAlong,
  kRawMu,    ///< before the floor
  kClamped,  ///< 1 where a coefficient is kept at its floor
  kFilterAlpha,
  kViscousCoefficient,
  kTrialForce,  ///< R_i F*_i of a formulation
  kRawForce,    ///< before the filter
  kLimitUse     ///< |F| over the limit of a formulation
};

/// One column of the result: its name, the dimension its unit follows from, one sentence, and how
/// its number is read off a row.
struct Column {
  std::string name;
  Dimension dimension;
  std::string text;
  ColumnSource source = ColumnSource::kTotalTime;
  int index = 0;        ///< component 0..5, entry of the slip space, or flat quantity
  int definition = -1;  ///< of the case's definitions; -1 if it belongs to none
  double offset = 0.0;  ///< is subtracted
};

/// All columns a case has, in the order of the result file (specification, section 13; the case
/// format, section 3). Names of one definition's columns end in `.name` where there are several
/// definitions.
std::vector<Column> result_columns(const Case& problem);

/// The columns of the result file: those the case selects under `output.columns`, in its order and
/// after `t`, or all of them. Names that do not exist are left out; the reader reports them.
std::vector<Column> output_columns(const Case& problem);

/// The column of a name, for checks: besides the names of `result_columns`, those that belong to a
/// definition may carry its `.name` even where the file omits it (CSF1.sleeve, FLIM.sleeve), and
/// the positions of held components, which are constant (CPR2 of a universal joint).
std::optional<Column> find_column(const Case& problem, std::span<const Column> columns,
                                  std::string_view name);

/// Every name a check may use, for suggestions.
std::vector<std::string> column_names(const Case& problem);

/// The number of a column in a row of a run of `problem`.
double column_value(const Column& column, const Case& problem, const Row& row);

/// From here on law::limit_use says only that the limit is 0, or kept at a floor next to it.
inline constexpr double kUseWithoutLimit = 1e9;

/// Whether y of the definition is a moment: its slip space has rotations only, none of them scaled
/// to a force.
bool is_rotational(const law::FrictionDefinition& definition);

}  // namespace slipbench::driver
