// SPDX-License-Identifier: Apache-2.0
// Codecs of the values that may be written in several ways, and the table reader they share.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "driver/read/keys/case_text.hpp"
#include "driver/yaml/declare_codec.hpp"
#include "law/table/table_function.hpp"

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

SLIPBENCH_DECLARE_CODEC(read::TypeNames);
SLIPBENCH_DECLARE_CODEC(read::NumberOrTable);
SLIPBENCH_DECLARE_CODEC(read::NumberOrMatrix);
SLIPBENCH_DECLARE_CODEC(read::WeightsText);
SLIPBENCH_DECLARE_CODEC(read::CoefficientText);
SLIPBENCH_DECLARE_CODEC(read::DirectionText);
SLIPBENCH_DECLARE_CODEC(read::ContactForceText);
SLIPBENCH_DECLARE_CODEC(read::PlayPositionText);
SLIPBENCH_DECLARE_CODEC(read::PartOrGroup);
SLIPBENCH_DECLARE_CODEC(read::PredefinedText);
SLIPBENCH_DECLARE_CODEC(read::ProfileText);
SLIPBENCH_DECLARE_CODEC(read::AmplitudeText);
SLIPBENCH_DECLARE_CODEC(read::MeasuredColumnText);
SLIPBENCH_DECLARE_CODEC(read::HistoryText);
SLIPBENCH_DECLARE_CODEC(read::NumberOrList);
SLIPBENCH_DECLARE_CODEC(read::ParameterValue);
SLIPBENCH_DECLARE_CODEC(law::InternalContactForce);
SLIPBENCH_DECLARE_CODEC(law::Table);

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::read {

/// Independents that a table may have.
struct TableUse {
  std::string_view what;  ///< "an internal contact force", for messages
  bool slip_rate = false;
  bool contact_force = false;
  bool accumulated_slip = false;
  bool motion = false;
  bool not_negative = true;  ///< ordinates must not be negative
  bool displacement = false;
  bool velocity = false;
  bool of_behavior = false;  ///< prolonged as the case's 'extrapolation' says
};
inline constexpr TableUse kInternalForceTable{.what = "an internal contact force",
                                              .accumulated_slip = true,
                                              .motion = true,
                                              .of_behavior = true};
inline constexpr TableUse kCoefficientTable{
    .what = "a coefficient of friction", .slip_rate = true, .contact_force = true};
inline constexpr TableUse kNormalStiffnessTable{.what = "a normal stiffness",
                                                .contact_force = true};
inline constexpr TableUse kWeightTable{.what = "weights of a derived component",
                                       .motion = true,
                                       .not_negative = false,
                                       .of_behavior = true};

inline constexpr TableUse kElasticityTable{
    .what = "an elasticity", .not_negative = false, .displacement = true, .of_behavior = true};
inline constexpr TableUse kDampingTable{
    .what = "a damping", .not_negative = false, .velocity = true, .of_behavior = true};

/// Builds a table function with `dependents` leading columns; every fault is reported at its row.
std::optional<law::TableFunction> table_function(yaml::Binder& binder, const TableText& text,
                                                 const yaml::Node& node, const yaml::Path& path,
                                                 const TableUse& use, int dependents = 1);

/// Builds a bare table of `dependents` columns over `independents`.
std::optional<law::Table> table(yaml::Binder& binder, const TableText& text, const yaml::Node& node,
                                const yaml::Path& path, int dependents, int independents,
                                bool not_negative, law::Extrapolation extrapolation);

}  // namespace slipbench::driver::read
