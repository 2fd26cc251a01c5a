// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "law/base/capstan.hpp"
#include "law/base/component.hpp"
#include "law/contact/contact_force.hpp"
#include "law/contact/internal_contact_force.hpp"
#include "law/definition/formulation.hpp"
#include "law/definition/potential.hpp"
#include "law/friction/coefficient_blend.hpp"
#include "law/friction/friction_law.hpp"

namespace slipbench::law {

/// The scaled slip space of a definition (docs/theory, section 7). Entry i belongs to component
/// c_i with the scale R_i of the potential P = sqrt(sum (f_i / R_i)^2):
///   y_i = f_i / R_i,   s_i = R_i u_i,   so that f.u = y.s, P = |y| and the equivalent slip is |s|.
/// One entry of scale 1 is the component form P = |f_i|.
struct SlipSpace {
  int dimension = 1;                         ///< 1..6
  std::array<int, kComponents> component{};  ///< index 0..5
  std::array<double, kComponents> scale{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
};

/// Tells whether y is a moment: rotations only, none of them scaled to a force.
inline bool is_rotational(const SlipSpace& space) {
  for (int k = 0; k < space.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!is_rotation(space.component[i]) || space.scale[i] != 1.0) return false;
  }
  return true;
}

/// A slip space with one common scale; `number` are the users' component numbers 1..6.
inline SlipSpace slip_space(std::initializer_list<int> number, double scale = 1.0) {
  SlipSpace space;
  space.dimension = 0;
  for (const int n : number) {
    const auto i = static_cast<std::size_t>(space.dimension++);
    space.component[i] = n - 1;
    space.scale[i] = scale;
  }
  return space;
}

/// Origin of the stick stiffness kappa (docs/theory, section 10).
struct StickStiffness {
  enum class Mode : std::uint8_t {
    kElasticSlip,  ///< kappa = F_lim / g_c with the allowable elastic slip g_c: follows the limit
    kStiffness     ///< kappa is constant, g_c = F_lim / kappa moves
  };
  Mode mode = Mode::kElasticSlip;
  double value = 1.0e-4;  ///< g_c [L] or kappa [F/L], > 0
};

/// Accumulated slip that the internal contact force sees.
enum class AccumulatedSlipTiming : std::uint8_t {
  kEnd,   ///< of the end of the increment: implicit, exact for linear wear
  kStart  ///< of its start: explicit
};

/// Rate that the coefficient sees.
enum class SlipRateMeasure : std::uint8_t {
  kSlip,           ///< equivalent slip increment / dt, zero in stick: the documented meaning
  kRelativeMotion  ///< |ds| / dt, known before the return mapping
};

/// P = |y|, the norm of the scaled slip space: all predefined friction but that of SLIPRING.
struct EuclideanPotential {};

/// Criterion of slip, and of its direction.
using SlipCriterion = std::variant<EuclideanPotential, Potential, Capstan>;

/// Everything one stick-slip calculation needs; immutable once built.
struct FrictionDefinition {
  SlipSpace slip;
  SlipCriterion criterion;
  ContactForce contact_force;
  InternalContactForce internal_contact_force = 0.0;
  FrictionLaw law;
  CoefficientBlend blend;              ///< of `law` with an earlier one, while friction changes
  double force_limit = kNoForceLimit;  ///< f_t^max [F], > 0
  StickStiffness stick;
  AccumulatedSlipTiming accumulated_slip = AccumulatedSlipTiming::kEnd;
  SlipRateMeasure slip_rate = SlipRateMeasure::kSlip;
  /// A contact penalty in place of the return mapping; `stick`, `slip_rate` and `accumulated_slip`
  /// then do not matter.
  std::optional<Formulation> formulation;
};

}  // namespace slipbench::law
