// SPDX-License-Identifier: Apache-2.0
#include "law/connection/connection_type.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string_view>
#include <vector>

#include "law/update/return_mapping.hpp"
#include "reference/contact_force.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
namespace reference = slipbench::reference::contact_force;

struct Row {
  std::string_view name;
  ComponentSet held;
  ComponentSet available;
  bool predefined;
};

// docs/theory, section 2.
const std::vector<Row> kTypes = {
    {"SLOT", ComponentSet::of(2, 3), ComponentSet::of(1), true},
    {"SLIDE-PLANE", ComponentSet::of(1), ComponentSet::of(2, 3), true},
    {"JOIN", ComponentSet::of(1, 2, 3), ComponentSet(), false},
    {"REVOLUTE", ComponentSet::of(5, 6), ComponentSet::of(4), false},
    {"ALIGN", ComponentSet::of(4, 5, 6), ComponentSet(), false},
    {"UNIVERSAL", ComponentSet::of(5), ComponentSet::of(4, 6), false},
    {"CARDAN", ComponentSet(), ComponentSet::of(4, 5, 6), false},
    {"ROTATION", ComponentSet(), ComponentSet::of(4, 5, 6), false},
    {"CARTESIAN", ComponentSet(), ComponentSet::of(1, 2, 3), false},
    {"LINK", ComponentSet::of(1), ComponentSet(), false},
    {"AXIAL", ComponentSet(), ComponentSet::of(1), false},
    {"RADIAL-THRUST", ComponentSet(), ComponentSet::of(1, 3), false},
    {"PROJECTION CARTESIAN", ComponentSet(), ComponentSet::of(1, 2, 3), false},
    {"CONSTANT VELOCITY", ComponentSet::of(5), ComponentSet(), false},
    {"EULER", ComponentSet(), ComponentSet::of(4, 5, 6), false},
    {"FLEXION-TORSION", ComponentSet(), ComponentSet::of(4, 5, 6), false},
    {"PROJECTION FLEXION-TORSION", ComponentSet(), ComponentSet::of(4, 5, 6), false},
    {"BUSHING", ComponentSet(), ComponentSet::of(1, 2, 3, 4, 5, 6), false},
    {"TRANSLATOR", ComponentSet::of(2, 3, 4, 5, 6), ComponentSet::of(1), true},
    {"CYLINDRICAL", ComponentSet::of(2, 3, 5, 6), ComponentSet::of(1, 4), true},
    {"HINGE", ComponentSet::of(1, 2, 3, 5, 6), ComponentSet::of(4), true},
    {"PLANAR", ComponentSet::of(1, 5, 6), ComponentSet::of(2, 3, 4), true},
    {"UJOINT", ComponentSet::of(1, 2, 3, 5), ComponentSet::of(4, 6), true},
    {"SLIPRING", ComponentSet(), ComponentSet::of(1, 2, 3), true},
    {"CONTACT", ComponentSet::of(1), ComponentSet::of(2, 3), true},
};

/// The limiting force of check number `index` of a type's predefined friction.
template <class Type>
double limit(const Type& type, const ConnectorForce& force, double mu, std::size_t index = 0,
             double accumulated_slip = 0.0) {
  const PredefinedFriction friction = type.predefined().at(index);
  FrictionDefinition definition;
  definition.slip = friction.slip;
  definition.contact_force = friction.contact_force;
  definition.internal_contact_force = friction.internal_contact_force;
  definition.law = ConstantCoefficient{mu};
  ConnectorIncrement rest;
  rest.force = force;
  FrictionState state;
  state.accumulated_slip = accumulated_slip;
  return update(definition, rest, state).limit;
}

TEST_CASE("every connection type holds and frees what the theory says") {
  std::size_t seen = 0;
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    ++seen;
    bool listed = false;
    for (const Row& row : kTypes) {
      if (row.name != Type::kInfo.name) continue;
      listed = true;
      CHECK(Type::kInfo.held == row.held);
      CHECK(Type::kInfo.available == row.available);
      CHECK(HasPredefinedFriction<Type> == row.predefined);
    }
    INFO(Type::kInfo.name);
    CHECK(listed);
    CHECK((Type::kInfo.held & Type::kInfo.available).empty());
    CHECK_FALSE(Type::kInfo.text.empty());
  });
  CHECK(seen == kTypes.size());
}

TEST_CASE("predefined friction acts in available components only, each in one check") {
  for_each_connection_type([]<class Type>(std::type_identity<Type>) {
    if constexpr (HasPredefinedFriction<Type>) {
      ComponentSet used;
      for (const PredefinedFriction& friction : Type{}.predefined()) {
        for (int i = 0; i < friction.slip.dimension; ++i) {
          const int c = friction.slip.component[static_cast<std::size_t>(i)];
          CHECK(Type::kInfo.available.contains(c));
          CHECK_FALSE(used.contains(c));
          used.insert(c);
        }
      }
      // Of a belt only the flow at its ring rubs; distance and flow at a are free of friction.
      const bool belt = Type::kInfo.name == "SLIPRING";
      CHECK(used == (belt ? ComponentSet::of(2) : Type::kInfo.available));
    }
  });
}

TEST_CASE("the rings of a belt press by tension alone in their order") {
  SlipRing belt;
  belt.wrap_angles = {0.5, 2.0};
  int number = 0;
  for (const PredefinedFriction& ring : belt.predefined()) {
    CHECK(std::get<double>(ring.internal_contact_force) == 0.0);
    CHECK(std::get<Capstan>(ring.criterion).wrap_angle ==
          belt.wrap_angles.at(static_cast<std::size_t>(number)));
    CHECK(ring.number == ++number);
  }
  CHECK(number == 2);
}

TEST_CASE("a connection is found by its name, and not by another") {
  for (const Row& row : kTypes) {
    const auto found = find_connection(row.name);
    REQUIRE(found);
    CHECK(found->info.name == row.name);
    CHECK(found->type);
  }
  for (const char* name : {"", "slot", "RETRACTOR", "SLIDE_PLANE", "SLOT "}) {
    CHECK_FALSE(find_connection(name));
  }
}

TEST_CASE("SLOT and CONTACT exist in the plane, without component 3") {
  const auto plane = find_connection("SLOT", 2);
  REQUIRE(plane);
  CHECK(plane->info.held == ComponentSet::of(2));
  const auto* slot = std::get_if<Slot>(&*plane->type);
  REQUIRE(slot);
  const ConnectorForce force{{0, -4, std::nan(""), 0, 0, 0}};
  CHECK(limit(*slot, force, 0.5) == 2.0);
  CHECK(limit(Slot{}, ConnectorForce{{0, -4, 3, 0, 0, 0}}, 0.5) == 2.5);
  for (const Row& row : kTypes) {
    if (row.name != "SLOT" && row.name != "CONTACT") CHECK_FALSE(find_connection(row.name, 2));
  }
  const auto line = find_connection("CONTACT", 2);
  REQUIRE(line);
  CHECK(line->info.available == ComponentSet::of(2));
}

TEST_CASE("CONTACT presses on one side only") {
  CHECK(limit(Contact{}, ConnectorForce{{4, 0, 0, 0, 0, 0}}, 0.5) == 2.0);
  CHECK(limit(Contact{}, ConnectorForce{{-4, 0, 0, 0, 0, 0}}, 0.5) == 0.0);
  CHECK(limit(Contact{}, ConnectorForce{}, 0.5) == 0.0);
}

TEST_CASE(
    "a pair that measures its motions otherwise is not the assembled type of the same components") {
  const auto pair = assemble(*find_connection("CARTESIAN"), *find_connection("CARDAN"));
  REQUIRE(pair);
  CHECK(pair->info.name.empty());
  CHECK(pair->info.available == find_connection("BUSHING")->info.available);
}

TEST_CASE("two basic types make the assembled type, in either order") {
  const std::vector<std::array<std::string_view, 3>> pairs = {
      {"SLOT", "ALIGN", "TRANSLATOR"},
      {"SLOT", "REVOLUTE", "CYLINDRICAL"},
      {"JOIN", "REVOLUTE", "HINGE"},
      {"SLIDE-PLANE", "REVOLUTE", "PLANAR"},
      {"JOIN", "UNIVERSAL", "UJOINT"},
      {"PROJECTION CARTESIAN", "PROJECTION FLEXION-TORSION", "BUSHING"}};
  for (const auto& [a, b, whole] : pairs) {
    for (const auto& [first, second] : {std::pair{a, b}, std::pair{b, a}}) {
      const auto made = assemble(*find_connection(first), *find_connection(second));
      REQUIRE(made);
      CHECK(made->info.name == whole);
      REQUIRE(made->type);
      CHECK(made->type->index() == find_connection(whole)->type->index());
    }
  }
}

TEST_CASE("the assembly a type declares is the pair it is made of") {
  for_each_connection_type([]<class Type>(std::type_identity<Type>) {
    const std::string_view assembly = Type::kInfo.assembly;
    if (assembly == "basic" || assembly == "complex") return;
    const auto plus = assembly.find(" + ");
    REQUIRE(plus != std::string_view::npos);
    const auto made = assemble(*find_connection(assembly.substr(0, plus)),
                               *find_connection(assembly.substr(plus + 3)));
    REQUIRE(made);
    CHECK(made->info.name == Type::kInfo.name);
  });
}

TEST_CASE("a pair without a name of its own holds and frees what both do") {
  const auto ball = assemble(*find_connection("JOIN"), *find_connection("CARDAN"));
  REQUIRE(ball);
  CHECK_FALSE(ball->type);
  CHECK(ball->info.held == ComponentSet::of(1, 2, 3));
  CHECK(ball->info.available == ComponentSet::of(4, 5, 6));
}

TEST_CASE("a pair that is no assembled type has the predefined friction of its part that has one") {
  for (const char* rotation : {"REVOLUTE", "ALIGN", "UNIVERSAL", "CARDAN", "ROTATION"}) {
    for (const char* translation : {"SLOT", "SLIDE-PLANE", "JOIN", "CARTESIAN"}) {
      const auto alone = find_connection(translation);
      for (const auto& pair : {assemble(*alone, *find_connection(rotation)),
                               assemble(*find_connection(rotation), *alone)}) {
        REQUIRE(pair);
        if (!pair->info.name.empty()) continue;
        const bool has = alone->type->index() < 2;  // SLOT and SLIDE-PLANE
        CHECK(pair->type.has_value() == has);
        if (has) CHECK(pair->type->index() == alone->type->index());
      }
    }
  }
}

TEST_CASE("two types of one kind of motion, or an assembled one, make no pair") {
  CHECK_FALSE(assemble(*find_connection("SLOT"), *find_connection("JOIN")));
  CHECK_FALSE(assemble(*find_connection("CARDAN"), *find_connection("REVOLUTE")));
  for (const char* whole : {"HINGE", "TRANSLATOR"}) {
    for (const char* basic : {"SLOT", "REVOLUTE"}) {
      CHECK_FALSE(assemble(*find_connection(whole), *find_connection(basic)));
      CHECK_FALSE(assemble(*find_connection(basic), *find_connection(whole)));
    }
  }
  CHECK_FALSE(assemble(*find_connection("SLOT"), *find_connection("SLOT")));
}

// The numbers of the example are given to six digits: half of the last one.

TEST_CASE("the mean arm of a ring is that of a disc without a hole, to the last bit") {
  for (const double R : {0.3, 7.0, 1e-3, 12.3456789}) CHECK(Planar{R}.mean_arm() == 2.0 / 3.0 * R);
  CHECK(Planar{3.0, 0.0, 0.0, 1.0}.mean_arm() == Approx(2.0 / 3.0 * 26.0 / 8.0).epsilon(1e-15));
  CHECK(Planar{1.0, 0.0, 0.0, 1.0 - 1e-12}.mean_arm() == Approx(1.0 - 0.5e-12).epsilon(1e-15));
}

TEST_CASE("CYLINDRICAL gives the worked limit, with and without its overlap") {
  const Cylindrical joint{0.24, 0.55, 0.0};
  const ConnectorForce force{{0, 100, 50, 0, 10, 5}};
  CHECK(limit(joint, force, 1.0) == Approx(152.459).margin(5e-4));
  CHECK(limit(joint, force, 0.15) == Approx(22.8689).margin(5e-5));
  CHECK(limit(Cylindrical{0.24, 0.0, 0.0}, force, 1.0) ==
        Approx(std::hypot(100, 50)).epsilon(1e-15));
  const ConnectorForce shock{{0, 300, 400, 0, 55, 0}};
  CHECK(limit(joint, shock, 1.0) == Approx(700).epsilon(1e-14));
  CHECK(limit(joint, shock, 0.15) == Approx(105).epsilon(1e-14));
}

TEST_CASE("CYLINDRICAL with weights over position gives the worked limits") {
  PredefinedFriction friction = Cylindrical{0.24, 0.55, 0.0}.predefined().front();
  auto& g = std::get<DerivedComponent>(friction.contact_force);
  // The table of the worked example is given to seven digits.
  g[1].weight_table =
      make_function({{3.636364, 3.636364, 0.0}, {20, 20, 0.45}}, {over_position(1)}, 2);
  const ConnectorForce force{{0, 100, 50, 0, 10, 5}};
  Ambient ambient;
  for (const auto& [position, expected] :
       {std::pair{0.225, 36.5902}, std::pair{0.45, 50.3115}, std::pair{1.0, 50.3115}}) {
    ambient.position[0] = position;
    CHECK(0.15 * evaluate(g, force, ambient) == Approx(expected).margin(5e-5));
  }
}

TEST_CASE("CYLINDRICAL scales rotation by its radius in the potential") {
  const SlipSpace space = Cylindrical{0.24, 0.0, 0.0}.predefined().front().slip;
  REQUIRE(space.dimension == 2);
  CHECK(space.component[0] == 0);
  CHECK(space.component[1] == 3);
  CHECK(std::hypot(10.0 / space.scale[0], 3.0 / space.scale[1]) == Approx(16.0078).margin(5e-5));
}

TEST_CASE("HINGE gives the worked limits, with a number and with a worn internal moment") {
  const ConnectorForce force{{200, 300, 400, 0, 30, 40}};
  Hinge hinge{0.12, 0.14, 0.65, 0.0};
  CHECK(limit(hinge, force, 1.0) == Approx(106.462).margin(5e-4));
  hinge.internal_contact_moment = 100.0;
  CHECK(limit(hinge, force, 0.15) == Approx(30.9692).margin(5e-5));
  hinge.internal_contact_moment = make_function({{100, 0}, {90, 1000}}, {kOverAccumulatedSlip});
  CHECK(limit(hinge, force, 0.15, 0, 500.0) == Approx(30.2192).margin(5e-5));
  CHECK(limit(hinge, force, 0.15, 0, 2000.0) == Approx(29.4692).margin(5e-5));
}

TEST_CASE("PLANAR gives the worked limits of sliding and spinning") {
  const ConnectorForce force{{-100, 0, 0, 0, 6, 8}};
  const Planar planar{0.5, 20.0, 3.0};
  CHECK(planar.predefined()[0].suffix == "sliding");
  CHECK(planar.predefined()[1].suffix == "spinning");
  CHECK(limit(planar, force, 1.0, 0) == Approx(140).epsilon(1e-15));
  CHECK(limit(planar, force, 0.2, 0) == Approx(28).epsilon(1e-15));
  CHECK(limit(planar, force, 1.0, 1) == Approx(46.3333).margin(5e-5));
  CHECK(limit(planar, force, 0.2, 1) == Approx(9.26667).margin(5e-6));
}

TEST_CASE("TRANSLATOR gives the worked limits; absent lengths drop their terms") {
  const ConnectorForce force{{0, 3, 4, 2, 0.6, 0.8}};
  const Translator guide{0.1, 0.4, 5.0};
  CHECK(limit(guide, force, 1.0) == Approx(35).epsilon(1e-14));
  CHECK(limit(guide, force, 0.3) == Approx(10.5).epsilon(1e-14));
  const ConnectorForce shock{{0, 300, 400, 12, 55, 0}};
  CHECK(limit(Translator{0.24, 0.55, 0.0}, shock, 1.0) == Approx(750).epsilon(1e-14));
  CHECK(limit(Translator{0.0, 0.55, 0.0}, shock, 1.0) == Approx(700).epsilon(1e-14));
  CHECK(limit(Translator{0.24, 0.0, 0.0}, shock, 1.0) == Approx(550).epsilon(1e-14));
}

TEST_CASE("UJOINT gives the worked limits about both axes") {
  const ConnectorForce force{{100, 50, 20, 0, 8, 0}};
  UJoint joint;
  joint.R_p = 0.1;
  joint.R_a = 0.08;
  joint.L_s = 0.2;
  joint.L_a = 1.0;
  CHECK(limit(joint, force, 0.1, 0) == Approx(2.24812).margin(5e-6));
  CHECK(limit(joint, force, 0.1, 1) == Approx(1.67714).margin(5e-6));
  CHECK(joint.predefined()[0].suffix == "axis1");
  CHECK(joint.predefined()[1].suffix == "axis3");
  joint.internal_contact_moment_1 = 1.0;
  joint.internal_contact_moment_3 = 2.0;
  CHECK(limit(joint, force, 0.1, 0) == Approx(2.34812).margin(5e-6));
  CHECK(limit(joint, force, 0.1, 1) == Approx(1.87714).margin(5e-6));
}

TEST_CASE("UJOINT takes its factors from the user's table in place of the fit") {
  UJoint joint;
  joint.R_p = 0.1;
  joint.L_a = 1.0;
  joint.hinge_factors = make_table({{0.1, 0.4, 0.0, 0.25, 0}, {0.3, 0.2, 0.2, 0.45, 20}}, 4, 1);
  const HingeShares shares = joint.shares();
  CHECK(shares.k_ax == Approx(0.2).epsilon(1e-15));
  CHECK(shares.t_ax == Approx(0.3).epsilon(1e-15));
  CHECK(shares.k_tw == Approx(0.1).epsilon(1e-15));
  CHECK(shares.t_tw == Approx(0.35).epsilon(1e-15));
}

TEST_CASE("predefined limits do not depend on the unit of length") {
  // Powers of two change no digit; the lengths reach far below and above 1.
  for (const double unit : {0x1p-40, 0x1p40}) {
    const ConnectorForce f{{-7, 11, -13, 1.7, -1.9, 2.3}};
    ConnectorForce there = f;
    for (int c = 3; c < kComponents; ++c) there[c] *= unit;
    const auto same = [&](const auto& here, const auto& in_unit, double limit_unit,
                          std::size_t index = 0) {
      CHECK(limit(in_unit, there, 1.0, index) == limit_unit * limit(here, f, 1.0, index));
    };
    same(Cylindrical{0.2, 0.7, 5.0}, Cylindrical{0.2 * unit, 0.7 * unit, 5.0}, 1.0);
    same(Translator{0.3, 0.7, 5.0}, Translator{0.3 * unit, 0.7 * unit, 5.0}, 1.0);
    same(Hinge{0.3, 0.2, 0.7, 5.0}, Hinge{0.3 * unit, 0.2 * unit, 0.7 * unit, 5.0 * unit}, unit);
    const Planar planar{0.3, 5.0, 6.0, 0.1};
    const Planar small{0.3 * unit, 5.0, 6.0 * unit, 0.1 * unit};
    same(planar, small, 1.0, 0);
    same(planar, small, unit, 1);
    UJoint joint, other;
    joint.R_p = 0.1, joint.R_a = 0.08, joint.L_s = 0.2, joint.L_a = 0.35;
    other.R_p = 0.1 * unit, other.R_a = 0.08 * unit, other.L_s = 0.2 * unit,
    other.L_a = 0.35 * unit;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) same(joint, other, unit, axis);
  }
}

TEST_CASE("predefined contact forces match the reference formulas on signed forces") {
  const ConnectorForce f{{-7, 11, -13, 1.7, -1.9, 2.3}};
  // Sums of a few terms in another order: rounding.
  const double rounding = 1e-14;
  CHECK(limit(Slot{}, f, 1.0) == Approx(reference::slot(f[1], f[2], 0.0)).epsilon(rounding));
  CHECK(limit(SlidePlane{4.0}, f, 1.0) ==
        Approx(reference::slide_plane(f[0], 4.0)).epsilon(rounding));
  CHECK(limit(Cylindrical{0.2, 0.7, 5.0}, f, 1.0) ==
        Approx(reference::cylindrical({0.7, 5.0}, f[1], f[2], f[4], f[5])).epsilon(rounding));
  CHECK(limit(Translator{0.3, 0.7, 5.0}, f, 1.0) ==
        Approx(reference::translator({0.3, 0.7, 5.0}, f[1], f[2], f[3], f[4], f[5]))
            .epsilon(rounding));
  CHECK(limit(Hinge{0.3, 0.2, 0.7, 5.0}, f, 1.0) ==
        Approx(reference::hinge({0.3, 0.2, 0.7, 5.0}, f[0], f[1], f[2], f[4], f[5]))
            .epsilon(rounding));
  CHECK(limit(Planar{0.3, 5.0, 6.0, 0.1}, f, 1.0, 0) ==
        Approx(reference::planar_sliding(0.3, 5.0, f[0], f[4], f[5])).epsilon(rounding));
  CHECK(limit(Planar{0.3, 5.0, 6.0, 0.1}, f, 1.0, 1) ==
        Approx(reference::planar_spinning({0.3, 0.1}, 6.0, f[0], f[4], f[5])).epsilon(rounding));
}

}  // namespace
