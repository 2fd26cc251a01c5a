// SPDX-License-Identifier: Apache-2.0
// Codecs of the values that may be written in several ways, and the table reader they share.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "driver/read/keys/case_text.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::driver {

#define SLIPBENCH_DECLARE_CODEC(Type)                                                         \
  template <>                                                                                 \
  struct Codec<Type> {                                                                        \
    static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info, \
                     Type& out);                                                              \
    static Json schema(const KeyInfo& info);                                                  \
    static std::string wanted(const KeyInfo& info);                                           \
    static void rows(const std::string& path, std::vector<KeyRow>& rows);                     \
  }

SLIPBENCH_DECLARE_CODEC(TypeNames);
SLIPBENCH_DECLARE_CODEC(NumberOrTable);
SLIPBENCH_DECLARE_CODEC(NumberOrMatrix);
SLIPBENCH_DECLARE_CODEC(WeightsText);
SLIPBENCH_DECLARE_CODEC(CoefficientText);
SLIPBENCH_DECLARE_CODEC(DirectionText);
SLIPBENCH_DECLARE_CODEC(ContactForceText);
SLIPBENCH_DECLARE_CODEC(PlayPositionText);
SLIPBENCH_DECLARE_CODEC(PartOrGroup);
SLIPBENCH_DECLARE_CODEC(PredefinedText);
SLIPBENCH_DECLARE_CODEC(ProfileText);
SLIPBENCH_DECLARE_CODEC(AmplitudeText);
SLIPBENCH_DECLARE_CODEC(MeasuredColumnText);
SLIPBENCH_DECLARE_CODEC(HistoryText);
SLIPBENCH_DECLARE_CODEC(NumberOrList);
SLIPBENCH_DECLARE_CODEC(ParameterValue);
SLIPBENCH_DECLARE_CODEC(law::InternalContactForce);
SLIPBENCH_DECLARE_CODEC(law::Table);

#undef SLIPBENCH_DECLARE_CODEC

/// Which independents a table may have.
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
std::optional<law::TableFunction> table_function(Binder& binder, const TableText& text,
                                                 const Node& node, const Path& path,
                                                 const TableUse& use, int dependents = 1);

/// Builds a bare table of `dependents` columns over `independents`.
std::optional<law::Table> table(Binder& binder, const TableText& text, const Node& node,
                                const Path& path, int dependents, int independents,
                                bool not_negative, law::Extrapolation extrapolation);

}  // namespace slipbench::driver
