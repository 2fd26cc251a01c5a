// SPDX-License-Identifier: Apache-2.0
#pragma once

// The table has one row a line.
// clang-format off
/// \file
/// The notation of the whole code base. Dimensions are written in [F L T Θ] (force, length, time,
/// temperature); angles are radians and count as dimensionless. The model has no unit system of its
/// own: any consistent one will do.
///
/// | symbol     | code                     | meaning                                                 |
/// |------------|--------------------------|---------------------------------------------------------|
/// | a, b       | -                        | first and second node; the motion of b is seen from a   |
/// | 1..3, 4..6 | index 0..2, 3..5         | translations along, rotations about the local axes of a |
/// | CP         | RelativePosition         | relative position [L], [1] (rad)                        |
/// | CCU        | ConstitutiveMotion       | position minus constitutive reference [L], [1]          |
/// | f          | ConnectorForce           | forces f1..f3 [F] and moments m1..m3 = f4..f6 [F L]     |
/// | g(f) = F_C | ContactForce             | friction-generating contact force [F] or moment [F L]   |
/// | F_int      | InternalContactForce     | self-equilibrated contact force, never negative         |
/// | F_N        | normal_force             | effective normal force abs(F_C + F_int), never negative |
/// | mu         | mu                       | coefficient of friction [1]                             |
/// | F_lim      | limit                    | min(mu F_N, force_limit)                                |
/// | y, s       | FrictionState::force, .. | force and slip in the scaled slip space (SlipSpace)     |
/// | P          | potential                | magnitude of the tangential force, here abs(y)          |
/// | kappa      | -                        | stick stiffness [F/L] in the scaled slip space          |
/// | g_c        | -                        | allowable elastic slip [L]                              |
/// | dL         | slip_increment           | equivalent slip of an increment, never negative         |
///
/// Sign: the friction force a definition reports has the sign of the slip it goes with, as the
/// force k u of a spring has; the force on the other body is opposite.
// clang-format on

#include <limits>

namespace slipbench::law {

inline constexpr int kComponents = 6;  ///< three translations, three rotations
inline constexpr int kMaxFields = 16;  ///< field variables a case may have

/// A cap that never acts: the default of FrictionDefinition::force_limit.
inline constexpr double kNoForceLimit = std::numeric_limits<double>::infinity();

}  // namespace slipbench::law
