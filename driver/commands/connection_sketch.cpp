// SPDX-License-Identifier: Apache-2.0
// The drawings of the connection types, ASCII, the 1-axis to the right or up.
#include <array>

#include "driver/commands/minimal_case.hpp"

namespace slipbench::driver::commands {
namespace {

struct Sketch {
  std::string_view type;
  std::string_view lines;
};

constexpr std::array<Sketch, 25> kSketches{{
    {"SLOT", R"(
             | f2, f3
             v
 a ========[ b ]========> 1     b slides along 1 (CP1), friction force along 1
)"},
    {"SLIDE-PLANE", R"(
 1 ^     | f1 (or pulled up: |f1| counts)
   |     v
   |   [ b ]
 a +---------------> 2, 3       b slides in the plane (CP2, CP3), friction force in it
)"},
    {"CYLINDRICAL", R"(
      +---- L ----+             sleeve a, overlap L
 =====|===========|=====> 1     shaft b, radius R: slides (CP1) and turns (CPR1)
      +-----------+             f2, f3 press across, m2, m3 tilt the shaft in the sleeve
)"},
    {"TRANSLATOR", R"(
      +---- L ----+             guide a, overlap L
 =====|===========|=====> 1     bar b slides (CP1) and cannot turn
      +-----------+             f2, f3 press across, m1 twists (R_r), m2, m3 tilt (L)
)"},
    {"HINGE", R"(
      +--- L_s ---+             sleeve of a
 -----|-----------|-----> 1     pin of b, radius R_p: turns about 1 (CPR1)
      +-----------+             f2, f3 press across, m2, m3 tilt the pin (L_s),
                                f1 presses on the face (R_a); friction is a moment about 1
)"},
    {"PLANAR", R"(
 1 ^     | f1                   m2, m3 tilt the puck
   |     v
   |  [--b--]                   puck of radius R
 a +---------------> 2, 3       b slides (CP2, CP3) and spins about 1 (CPR1): two checks
)"},
    {"UJOINT", R"(
           3b                   axis 3 of b
           |                    four pins of radius R_p at the ends of a cross,
 1a -------+------- 1a          arms of length L_a; axis 1 of a
           |                    the joint turns about both (CPR1, CPR3): two checks;
           3b                   f1, f2, f3 pull at the cross, m2 twists it
)"},
    {"JOIN", R"(
 a
 o=b       b sits on a: f1, f2, f3 are held, nothing is free
)"},
    {"LINK", R"(
 a o-----------o b   a pinned rod: f1 along it is held, nothing is free
)"},
    {"AXIAL", R"(
 a o---->-<----o b   the distance of the nodes is free (CP1); the line turns with them
)"},
    {"RADIAL-THRUST", R"(
 3 ^     b
   |<-1->o           b moves freely: CP1 is its distance from axis 3 of a, CP3 along it
 a +
)"},
    {"CARTESIAN", R"(
 2 ^  o b
   |.'         b moves freely along the axes 1, 2, 3 of a (CP1, CP2, CP3)
 a +-----> 1
)"},
    {"PROJECTION CARTESIAN", R"(
 2 ^  o b
   |.'         as CARTESIAN, along axes that turn with both nodes, midway (CP1, CP2, CP3)
 a +-----> 1
)"},
    {"ALIGN", R"(
 a |->  |-> b  the axes of b stay parallel to those of a: m1, m2, m3 are held
)"},
    {"REVOLUTE", R"(
  _ CPR1
 ( )-----> 1   b turns about axis 1 of a; m2, m3 are held
)"},
    {"UNIVERSAL", R"(
        3b
        |
 1a ----+---- 1a   b turns about axis 1 of a (CPR1) and its own axis 3 (CPR3); m2 is held
        |
        3b
)"},
    {"CONSTANT VELOCITY", R"(
      .-> 3b
 3a --o              two shafts that meet at an angle turn as one: m2, the torque, is held
)"},
    {"CARDAN", R"(
 1 -> 2' -> 3''    b turns freely: angles about 1, the turned 2, the turned 3 (CPR1, CPR2, CPR3)
)"},
    {"EULER", R"(
 3 -> 1' -> 3''    b turns freely: angles about 3, the turned 1, the turned 3 (CPR1, CPR2, CPR3)
)"},
    {"ROTATION", R"(
 a ~~> b           b turns freely: CPR1, CPR2, CPR3 are the parts of one rotation vector
)"},
    {"FLEXION-TORSION", R"(
      .-> 3b         two shafts: CPR1 the angle between them, CPR2 how far they twist,
 3a --o              CPR3 the direction of the bend
)"},
    {"PROJECTION FLEXION-TORSION", R"(
      .-> 3b         two shafts: CPR1 and CPR2 the angle between them in two planes,
 3a --o              CPR3 how far they twist
)"},
    {"BUSHING", R"(
 a (((o))) b         a rubber bush: nothing is held, CP1 to CP3 and CPR1 to CPR3 are free
)"},
    {"SLIPRING", R"(
        __b__       ring at b, wrap angle alpha
       /     \      CP1 distance a-b, CP2 belt that flows over the ring, CP3 belt fed in at a
 f1 <-/       \-> f_bc
     a         c    the belt slips where the tensions differ by more than e^(mu alpha)
)"},
    {"CONTACT", R"(
 1 ^     | f1 > 0 presses, f1 <= 0 is open
   |     v
   |   ( b )
 a +---------------> 2, 3       b rubs on the plane (CP2, CP3), friction force in it
)"},
}};

}  // namespace

std::string_view connection_sketch(std::string_view type) {
  for (const Sketch& sketch : kSketches) {
    if (sketch.type == type) return sketch.lines.substr(1);
  }
  return {};
}

}  // namespace slipbench::driver::commands
