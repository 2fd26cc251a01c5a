// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/explain.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "driver/base/files/exit_code.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::analysis {
namespace {

constexpr const char* kShaft = R"(slipbench: 1
units: {length: m, force: N, time: s}
connector: {type: CYLINDRICAL}
friction:
  - {predefined: {R: 0.24, L: 0.55}, coefficient: 0.15, stick: {elastic_slip: 0.001}}
history:
  - {step: load, increments: 1, force: {f2: 300, f3: 400, m2: 55}}
  - {step: stroke, increments: 10, motion: {CP1: {to: 0.1}}}
  - {step: back, increments: 10, motion: {CP1: {to: 0.0}}}
)";

constexpr const char* kTables = R"(slipbench: 1
units: {length: mm, force: N, time: s, temperature: degC}
connector: {type: SLOT}
derived_components:
  normal:
    - {operator: norm, components: [2, 3]}
    - {operator: norm, components: [2], weights: {columns: [w2, CP1], rows: [[0.5, 0.0], [1.0, 10.0]]}}
friction:
  - component: 1
    contact_force: normal
    internal_contact_force: 10
    coefficient: {columns: [mu, slip_rate, temperature], rows: [[0.3, 0, 20], [0.2, 10, 20], [0.2, 0, 90], [0.1, 10, 90]]}
    force_limit: 100
    stick: {stiffness: 10000}
history:
  - {step: load, increments: 1, force: {f2: 30, f3: 40}, temperature: 55}
  - {step: slide, duration: 2, increments: 20, motion: {CP1: {to: 5}}}
  - {step: fast, duration: 0.1, increments: 10, motion: {CP1: {to: 10}}, temperature: 10}
  - {step: heavy, increments: 4, motion: {CP1: {to: 20}}, force: {f3: 4000}}
)";

constexpr const char* kWorn = R"(slipbench: 1
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - component: 1
    internal_contact_force: {columns: [force, accumulated_slip], rows: [[100, 0], [60, 1], [50, 4]]}
    coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.5}}
    stick: {elastic_slip: 0.01}
history:
  - {step: rub, duration: 5, increments: 10, motion: {CP1: {to: 10}}}
)";

cases::Case read(const char* text) {
  read::ReadCase result = read::read_case_text(base::SourceText("case.yaml", text), ".", {});
  INFO(base::render(result.diagnostics, result.sources));
  REQUIRE(result.value.has_value());
  return std::move(*result.value);
}

std::string text_of(const char* text, double time) {
  const cases::Case problem = read(text);
  const auto explained = explain(problem, time);
  REQUIRE(explained);
  return *explained;
}

/// The number behind the first `what`.
double number_after(const std::string& text, const std::string& what) {
  const auto at = text.find(what);
  INFO(what << " in " << text);
  REQUIRE(at != std::string::npos);
  return std::strtod(text.c_str() + at + what.size(), nullptr);
}

TEST_CASE("predefined friction is explained down to its terms") {
  CHECK(text_of(kShaft, 1.55) == R"(case: t = 1.6 s   increment 7, from t = 1.5 s, step 'stroke'
  the first increment that ends at or after t = 1.55 s
slip   CSF1 +105.0 N, CSM1 0.0 N m
  P 105.0 N = sqrt((CSF1)^2 + (CSM1/0.24)^2)
  Phi 0.0 N = P - limit
  limit 105.0 = mu 0.15 x F_N 700.0
  mu 0.15   a constant
  F_N 700.0 N = abs(contact 700.0 + internal 0.0)
     contact:  500.0 = sqrt((f2 300.0)^2 + (f3 400.0)^2)   forces across axis 1
     contact:  200.0 = sqrt((3.63636 x m2 55.0)^2 + (3.63636 x m3 0.0)^2)   bending moments across axis 1
     internal: 0.0   a constant
  slip direction (1.0, 0.0) in (CP1, 0.24 CPR1); slip rate 0.1
  slipping since t = 1.01 s
    before: t = 1.01 s stick -> slip (force 105.0 N, accumulated slip 0.0)
    next:   t = 2.02 s slip -> slip, reversed (force 105.0 N, accumulated slip 0.099)
)");
}

TEST_CASE("the force of a free component is explained by what acts along it") {
  constexpr const char* kPressed = R"(slipbench: 1
units: {length: mm, force: N, time: s}
connector: {type: CARTESIAN}
friction:
  - {component: 1, contact_force: 3, coefficient: 0.2, stick: {stiffness: 1000}}
elasticity: [{component: 3, stiffness: 500}]
damping: [{component: 3, coefficient: 50}]
history:
  - {step: press, increments: 5, motion: {CP1: {to: 1}, CP3: {to: 0.2}}}
)";
  const std::string text = text_of(kPressed, 1.0);
  INFO(text);
  CHECK(text.find("     contact:  110.0 = f3   component with its sign\n"
                  "               f3 110.0 = CEF3 100.0 + CVF3 10.0   component 3 is free\n") !=
        std::string::npos);
}

TEST_CASE("tables are explained with their cells, what lies outside is marked") {
  CHECK(text_of(kTables, 2.0) == R"(case: t = 2 s   increment 11, from t = 1.9 s, step 'slide'
slip   CSF1 +17.7188 N
  P 17.7188 N = abs(CSF1)
  Phi 0.0 N = P - limit
  limit 17.7188 = mu 0.225001 x F_N 78.75
  mu 0.225001   from its table: slip_rate 2.49992 in 0 .. 10 (25 %), temperature 55.0 in 20 .. 90 (50 %)
  F_N 78.75 N = abs(contact 68.75 + internal 10.0)
     contact:  50.0 = sqrt((f2 30.0)^2 + (f3 40.0)^2)   forces across axis 1
     contact:  18.75 = sqrt((0.625 x f2 30.0)^2)   force along axis 2; weights from their table, CP1 2.5 in 0 .. 10 (25 %)
     internal: 10.0   a constant
  slip direction (1.0) in (CP1); slip rate 2.49992
  slipping since t = 1.00068 s
    before: t = 1.00068 s stick -> slip (force 16.9722 N, accumulated slip 0.0)
    next:   none until the end of the history
)");
  const std::string fast = text_of(kTables, 3.1);
  CHECK(
      fast.find("slip_rate 49.9985 above 10: clamped to the end value, temperature 10.0 below 20: "
                "clamped to the end value") != std::string::npos);
  const std::string heavy = text_of(kTables, 4.1);
  CHECK(heavy.find("  limit 100.0 = force_limit   mu 0.2 x F_N ") != std::string::npos);
}

TEST_CASE("a worn fit is explained with its place in the wear table") {
  CHECK(text_of(kWorn, 1.2) == R"(case: t = 1.5 s   increment 3, from t = 1 s, step 'rub'
  the first increment that ends at or after t = 1.2 s
slip   CSF1 +12.6366 N
  P 12.6366 N = abs(CSF1)
  Phi 0.0 N = P - limit
  limit 12.6366 = mu 0.236788 x F_N 53.3667
  mu 0.236788 = kinetic 0.2 + (static 0.3 - kinetic 0.2) x exp(-0.5 x slip rate 2.0)
  F_N 53.3667 N = abs(contact 0.0 + internal 53.3667)
     contact:  none, only the internal contact force acts
     internal: 53.3667 from its table: accumulated_slip 2.99 in 1 .. 4 (66.33 %)
  slip direction (1.0) in (CP1); slip rate 2.0
  slipping since t = 0.005 s
    before: t = 0.005 s stick -> slip (force 14.3243 N, accumulated slip 0.0)
    next:   none until the end of the history
)");
  CHECK(text_of(kWorn, 5.0).find("accumulated_slip 9.99 above 4: clamped to the end value") !=
        std::string::npos);
}

TEST_CASE("the numbers of an explanation multiply out as printed") {
  for (const char* source : {kShaft, kTables, kWorn}) {
    for (const double time : {0.5, 1.0, 1.2, 1.55, 2.0}) {
      const std::string text = text_of(source, time);
      INFO(text);
      const double limit = number_after(text, "\n  limit ");
      const double mu = number_after(text, "= mu ");
      const double normal = number_after(text, "x F_N ");
      // Six digits are printed: three numbers, each off by 5e-6 at most.
      CHECK(mu * normal == Approx(limit).epsilon(1.5e-5));
      CHECK(number_after(text, "\n  mu ") == mu);
      CHECK(number_after(text, "\n  F_N ") == normal);
      const double contact = number_after(text, "abs(contact ");
      const double internal = number_after(text, "+ internal ");
      CHECK(contact + internal == Approx(normal).epsilon(1.5e-5));
      const double p = number_after(text, "\n  P ");
      CHECK(number_after(text, "Phi ") == Approx(p - limit).margin(1.5e-5 * limit));
      double terms = 0.0;
      for (auto at = text.find("contact:  "); at != std::string::npos;
           at = text.find("contact:  ", at + 1)) {
        terms += std::strtod(text.c_str() + at + 10, nullptr);
      }
      CHECK(terms == Approx(contact).epsilon(1.5e-5));
    }
  }
}

TEST_CASE("the start can be explained, the time outside the history cannot") {
  CHECK(text_of(kShaft, 0.0).find("case: t = 0 s   the start, step 'load'\nstick") == 0);
  const cases::Case problem = read(kShaft);
  for (const double time : {-1.0, 3.5}) {
    const auto explained = explain(problem, time);
    REQUIRE_FALSE(explained);
    CHECK(explained.error().code == base::kExitBadInput);
    CHECK(explained.error().message.find("case runs from t = 0 to t = 3\n") != std::string::npos);
  }
}

TEST_CASE("a friction that changes and a component with its sign are explained") {
  const std::string text = text_of(R"(slipbench: 1
connector: {type: SLOT}
friction:
  - {component: 1, contact_force: 2, internal_contact_force: 100, coefficient: 0.2, stick: {stiffness: 1000}}
history:
  - {step: slide, increments: 4, motion: {CP1: {to: 1}}, force: {f2: -80}}
  - step: change
    increments: 4
    motion: {CP1: {to: 2}}
    change_friction: {friction1: {coefficient: 0.4}}
)",
                                   1.5);
  CHECK(
      text.find("  limit 6.0 = mu 0.3 x F_N 20.0\n"
                "  mu 0.3 = 0.2 + 0.5 x (0.4 - 0.2)   the friction is changing; the new mu 0.4   a "
                "constant\n"
                "  F_N 20.0 = abs(contact -80.0 + internal 100.0)\n"
                "     contact:  -80.0 = f2   component with its sign\n") != std::string::npos);
}

TEST_CASE("every definition of a connector is explained, and every kind of criterion") {
  const std::string puck = text_of(R"(slipbench: 1
connector: {type: PLANAR}
friction:
  - {predefined: {R: 0.5, internal_contact_force: 20}, coefficient: 0.2, stick: {slip_tolerance: 1.0e-4, characteristic_length: 10}}
history:
  - {step: load, increments: 1, force: {f1: -100, m2: 6, m3: 8}, motion: {CP2: {to: 1}}}
)",
                                   1.0);
  CHECK(puck.find("\n'sliding' slip   CSF2 +28.0, CSF3 0.0\n") != std::string::npos);
  CHECK(puck.find("\n'spinning' stick   CSM1 0.0\n") != std::string::npos);
  const std::string belt = text_of(R"(slipbench: 1
connector: {type: SLIPRING, wrap_angle: = pi}
friction:
  - {predefined: {}, coefficient: 0.2, stick: {elastic_slip: 1.0e-3}}
history:
  - {step: pull, increments: 1, force: {f1: 100}}
  - {step: flow, increments: 2, motion: {CP2: {to: 1}}}
)",
                                   2.0);
  CHECK(belt.find("limit 87.4456 = T 100.0 x (exp(mu 0.2 x alpha 3.14159) - 1)") !=
        std::string::npos);
  CHECK(belt.find("behind the ring f_bc 187.446") != std::string::npos);
}

TEST_CASE("in the gap of a dead zone nothing is said to stick") {
  constexpr const char* kGap = R"(slipbench: 1
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - {component: 1, internal_contact_force: 100, coefficient: 0.2, stick: {stiffness: 1000}}
dead_zone:
  - {component: 1, width: 0.2}
history:
  - {step: in, increments: 10, motion: {CP1: {to: 0.5}}}
)";
  const std::string gap = text_of(kGap, 0.1);
  INFO(gap);
  CHECK(gap.find("\nin the gap of the dead zone   CSF1 0.0 N\n") != std::string::npos);
  CHECK(gap.find("play 0.05 mm of a dead zone of 0.2 mm, between its ends") != std::string::npos);
  CHECK(gap.find("  without slip since the start\n") != std::string::npos);
  CHECK(gap.find("% of the limit") == std::string::npos);
  const std::string slip = text_of(kGap, 0.9);
  CHECK(slip.find("\nslip   CSF1 +20.0 N\n") != std::string::npos);
  CHECK(slip.find("play 0.1 mm of a dead zone of 0.2 mm, at its upper end") != std::string::npos);
}

TEST_CASE("a ring behind a segment of known length slips in its own flow") {
  const std::string text = text_of(R"(slipbench: 1
units: {length: mm, force: N, time: s}
connector: {type: SLIPRING, wrap_angle: [1, 1], initial: {CP1: 100}, lengths: [50, 60]}
friction:
  - {predefined: {}, coefficient: 0.2, stick: {elastic_slip: 0.01}}
history:
  - {step: pull, increments: 2, motion: {CP2: {to: 1}}, force: {f1: 20}}
)",
                                   1.0);
  CHECK(text.find("slip direction (1.0) in (CP2); slip rate 1.0") != std::string::npos);
  CHECK(text.find("slip direction (1.0) in (CP2.ring2); slip rate 1.0") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::analysis
