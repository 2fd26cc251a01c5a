// SPDX-License-Identifier: Apache-2.0
// Types for user-defined friction: they have no predefined one (docs/theory, section 2).
#pragma once

#include "law/connection/predefined_friction.hpp"

namespace slipbench::law {

struct Join {
  static constexpr ConnectionInfo kInfo{"JOIN", "Node b sits on a.", "basic",
                                        ComponentSet::of(1, 2, 3), ComponentSet()};
};

struct Link {
  static constexpr ConnectionInfo kInfo{
      "LINK", "The distance between the nodes is held; f1 is the force along the line.", "basic",
      ComponentSet::of(1), ComponentSet()};
};

struct Axial {
  static constexpr ConnectionInfo kInfo{
      "AXIAL", "The distance between the nodes is free; 1 is the line that joins them.", "basic",
      ComponentSet(), ComponentSet::of(1)};
};

struct RadialThrust {
  static constexpr ConnectionInfo kInfo{
      "RADIAL-THRUST", "Node b moves freely; 1 is its distance from the 3-axis of a, 3 along it.",
      "basic", ComponentSet(), ComponentSet::of(1, 3)};
};

struct Cartesian {
  static constexpr ConnectionInfo kInfo{
      "CARTESIAN", "Node b moves freely; translations are measured along the axes of a.", "basic",
      ComponentSet(), ComponentSet::of(1, 2, 3)};
};

struct ProjectionCartesian {
  static constexpr ConnectionInfo kInfo{
      "PROJECTION CARTESIAN",
      "Node b moves freely; translations are measured along axes midway between those of a and b.",
      "basic", ComponentSet(), ComponentSet::of(1, 2, 3)};
};

struct Align {
  static constexpr ConnectionInfo kInfo{"ALIGN", "The axes of b stay parallel to those of a.",
                                        "basic", ComponentSet::of(4, 5, 6), ComponentSet()};
};

struct ConstantVelocity {
  static constexpr ConnectionInfo kInfo{
      "CONSTANT VELOCITY", "Two shafts along their 3-axes turn as one; m2 is the torque.", "basic",
      ComponentSet::of(5), ComponentSet()};
};

struct Cardan {
  static constexpr ConnectionInfo kInfo{
      "CARDAN", "Rotations are free and measured as Cardan angles in the sequence 1-2-3.", "basic",
      ComponentSet(), ComponentSet::of(4, 5, 6)};
};

struct Euler {
  static constexpr ConnectionInfo kInfo{
      "EULER", "Rotations are free and measured as Euler angles in the sequence 3-1-3.", "basic",
      ComponentSet(), ComponentSet::of(4, 5, 6)};
};

struct Rotation {
  static constexpr ConnectionInfo kInfo{
      "ROTATION", "Rotations are free and measured as the components of the rotation vector.",
      "basic", ComponentSet(), ComponentSet::of(4, 5, 6)};
};

struct FlexionTorsion {
  static constexpr ConnectionInfo kInfo{
      "FLEXION-TORSION",
      "Two shafts along their 3-axes: 4 is the angle between them, 5 torsion, 6 sweep.", "basic",
      ComponentSet(), ComponentSet::of(4, 5, 6)};
};

struct ProjectionFlexionTorsion {
  static constexpr ConnectionInfo kInfo{
      "PROJECTION FLEXION-TORSION",
      "Two shafts along their 3-axes: 4 and 5 are the angles between them, 6 torsion.", "basic",
      ComponentSet(), ComponentSet::of(4, 5, 6)};
};

struct Bushing {
  static constexpr ConnectionInfo kInfo{
      "BUSHING", "Nothing is held: friction acts along and about the axes that a bush has.",
      "PROJECTION CARTESIAN + PROJECTION FLEXION-TORSION", ComponentSet(),
      ComponentSet::of(1, 2, 3, 4, 5, 6)};
};

}  // namespace slipbench::law
