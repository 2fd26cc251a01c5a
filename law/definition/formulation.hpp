// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "law/base/component.hpp"
#include "law/base/convention.hpp"
#include "law/definition/filter.hpp"
#include "law/friction/friction_law.hpp"

namespace slipbench::law {

/// K [F/L] of the normal penalty: a number, or a table over contact_force and what tables of motion
/// may depend on.
using NormalStiffness = std::variant<double, TableFunction>;

/// Viscous penalty (Radioss Iform 1): F = min(C V, mu N) v/V. It has no stick: a load below the
/// limit creeps at P/C. C [F T/L] is given, or follows from the normal penalty:
///   C = VISF sqrt(2 K m)         as documented,
///   C = sqrt(VISF) sqrt(2 K m)   as coded.
struct ViscousPenalty {
  double visf = 1.0;                  ///< VISF [1], > 0
  NormalStiffness stiffness = 0.0;    ///< K [F/L], >= 0
  double mass = 0.0;                  ///< m [F T^2/L], >= 0
  std::optional<double> coefficient;  ///< C [F T/L], >= 0, in place of the three
};

/// Stiffness penalty (Radioss Iform 2), incremental: F* = F_prev + K_t v dt, returned to the limit.
struct StiffnessPenalty {
  double stiffness = 1.0;  ///< K_t [F/L], > 0
};

/// Two coefficients at right angles (Radioss Idir 1); the definition's law is that of direction 1.
struct Orthotropy {
  enum class Speed : std::uint8_t {
    kComponent,  ///< V_i = |v . d_i|; as coded max(1e-30, v . d_i), signed
    kTotal       ///< V_i = |v|
  };
  FrictionLaw second;  ///< the coefficient along direction 2
  std::array<double, 2> first{
      1.0, 0.0};  ///< d1, a unit vector in the slip space; d2 is d1 turned by +90 deg
  Speed speed = Speed::kComponent;
};

/// A contact penalty in place of the connector's own return mapping, as a contact of the Radioss
/// reference guide has it (/FRICTION, key RADIOSS). The coefficient sees the speed of the relative
/// motion; update_penalty integrates it.
struct Formulation {
  std::variant<ViscousPenalty, StiffnessPenalty> penalty;
  Filter filter{};
  Convention convention = Convention::kDocumented;
  std::optional<Orthotropy> orthotropy{};  ///< needs a slip space of two entries
};

/// Record of a formulation over one increment, beside the update. Vectors are in the slip space.
struct PenaltyDetail {
  double speed = 0.0;                       ///< V = |v| [L/T]
  std::array<double, 2> speeds{};           ///< V_1, V_2 of an orthotropic law [L/T]
  std::array<double, 2> mu{};               ///< mu_1, mu_2 of an orthotropic law [1]
  double alpha = 1.0;                       ///< filter coefficient of the increment [1]
  double viscous_coefficient = 0.0;         ///< C [F T/L] of a viscous penalty
  std::array<double, kComponents> trial{};  ///< F* [F]
  std::array<double, kComponents> raw{};    ///< force on or below the limit, before the filter [F]
};

}  // namespace slipbench::law
