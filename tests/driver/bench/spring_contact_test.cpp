// SPDX-License-Identifier: Apache-2.0
// Contact forces over free components: what springs, dampers, loads and stops press with, in every
// kind of run, and what is said of it when a case is read.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/results/plausibility.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/support/dice.hpp"

namespace slipbench::driver::bench {
namespace {

/// A CARTESIAN connector whose friction along component 1 is pressed in component 3.
std::string spring_case(const std::string& history, const std::string& rest,
                        const std::string& friction =
                            "  - {component: 1, contact_force: 3, coefficient: 0.2, stick: "
                            "{stiffness: 1000}}\n") {
  return "slipbench: 1\ntitle: t\nunits: {length: mm, force: N, time: s}\n"
         "connector: {type: CARTESIAN}\nfriction:\n" +
         friction + rest + "history:\n" + history;
}

cases::Case sound(const std::string& text) {
  const read::ReadCase read = read::read_text(text);
  INFO(base::render(read.diagnostics));
  REQUIRE(read.value);
  return *read.value;
}

/// "severity|path|message|hint" of all that was said but what is said of the units' gaps.
std::vector<std::string> said(const std::string& text) {
  std::vector<std::string> all;
  for (const base::Diagnostic& one : read::read_text(text).diagnostics.sorted()) {
    all.push_back(std::string(one.severity == base::Severity::kError     ? "error"
                              : one.severity == base::Severity::kWarning ? "warning"
                                                                         : "note") +
                  "|" + one.path + "|" + one.message + "|" + one.hint);
  }
  return all;
}

double normal_force(const Row& row, std::size_t d = 0) {
  return row.definitions[d].update.normal_force;
}
double friction(const Row& row, std::size_t d = 0) {
  return row.definitions[d].update.state.force[0];
}

TEST_CASE("a spring presses with its force in a prescribed motion, with its sign") {
  const std::vector<Row> rows = rows_of(
      sound(spring_case("  - {step: a, increments: 4, motion: {CP1: {to: 1}, CP3: {to: -0.2}}}\n",
                        "elasticity: [{component: 3, stiffness: 500}]\n")));
  CHECK(rows.back().definitions[0].update.contact_force == Approx(-100.0).epsilon(1e-15));
  CHECK(friction(rows.back()) == Approx(20.0).epsilon(1e-13));
}

const std::string kMembrane =
    "elasticity: [{components: [1, 3], stiffness: [[250, 500], [500, 1000]]}]\n";

TEST_CASE("a load is balanced together with the friction that its own motion presses") {
  // P = t N + mu N with t = 0.5, N = k t u.
  const std::string history = "  - {step: in, increments: 7, force: {f1: {to: 70}}}\n";
  for (const std::string stick : {"{stiffness: 1.0e+5}", "{elastic_slip: 1.0e-6}"}) {
    const std::string friction_text =
        "  - {component: 1, contact_force: 3, coefficient: 0.2, stick: " + stick + "}\n";
    for (const Row& row : rows_of(sound(spring_case(history, kMembrane, friction_text)))) {
      INFO(stick << " T = " << row.time);
      CHECK(normal_force(row) == Approx(10 * row.time / 0.7 * 7).margin(1e-9));
      const double load = row.forces.component[0].applied;
      CHECK(row.forces.component[0].elastic + friction(row) == Approx(load).margin(1e-9));
    }
  }
}

TEST_CASE("the books of a run under load close: work of the load, springs, damper, friction") {
  test::Dice dice(5);
  int slipping = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const double k11 = dice.between(100, 500);
    const double k33 = dice.between(100, 800);
    const double k13 = dice.between(-0.6, 0.6) * std::sqrt(k11 * k33);
    const auto n = [](double x) { return std::to_string(x); };
    std::string history;
    for (int s = 0; s < 3; ++s) {
      history += "  - {step: s" + std::to_string(s) +
                 ", increments: 2000, force: {f1: {to: " + n(dice.between(-80, 80)) +
                 "}}, motion: {CP3: {to: " + n(dice.between(-0.4, 0.4)) + "}}}\n";
    }
    const std::vector<Row> rows = rows_of(sound(spring_case(
        history, "elasticity: [{components: [1, 3], stiffness: [[" + n(k11) + ", " + n(k13) +
                     "], [" + n(k13) + ", " + n(k33) +
                     "]]}]\ndamping: [{component: 1, coefficient: " + n(dice.between(0.1, 3)) +
                     "}]\n")));
    double supplied = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const auto power = [&](const Row& row) {
        return std::pair{row.forces.component[0].applied, row.forces.component[2].elastic};
      };
      const auto [load_a, hold_a] = power(rows[i - 1]);
      const auto [load_b, hold_b] = power(rows[i]);
      const double u1 = rows[i].quantities[0] - rows[i - 1].quantities[0];
      const double u3 = rows[i].quantities[2] - rows[i - 1].quantities[2];
      supplied += 0.5 * (load_a + load_b) * u1 + 0.5 * (hold_a + hold_b) * u3;
      slipping += rows[i].definitions[0].update.state.regime == law::Regime::kSlip ? 1 : 0;
    }
    const Row& end = rows.back();
    INFO("trial " << trial);
    CHECK(end.forces.elastic_energy + end.forces.viscous_dissipation + end.definitions[0].work ==
          Approx(supplied).margin(2e-3 * (1.0 + std::abs(supplied))));
  }
  CHECK(slipping > 10000);
}

TEST_CASE("heat of a damper beyond the range of a double is infinite, and stays so") {
  const std::vector<Row> rows = rows_of(
      sound(spring_case("  - {step: a, increments: 9, motion: {CP1: {to: 120}, CP3: {to: -0.2}}}\n",
                        "damping: [{component: 1, coefficient: 1.0e+305}]\n"
                        "elasticity: [{component: 3, stiffness: 500}]\n")));
  CHECK(std::isinf(double{rows.back().forces.viscous_dissipation}));
}

const std::string kFrictionIn3 =
    "  - {name: brake, component: 3, internal_contact_force: 100, coefficient: 0.3, stick: "
    "{stiffness: 1.0e+4}}\n";
const std::string kFrictionIn1 =
    "  - {name: slide, component: 1, contact_force: 3, coefficient: 0.5, stick: {stiffness: "
    "1000}}\n";
const std::string kLoadOn3 =
    "  - {step: a, increments: 9, force: {f3: {to: 90}}, motion: {CP1: {to: 2}}}\n";

TEST_CASE("of a loaded component its friction is left to press, whatever stands first") {
  // 90 N on a spring of 300 N/mm and a brake of 30 N: the spring carries what the brake does not.
  const std::string spring = "elasticity: [{component: 3, stiffness: 300}]\n";
  const std::vector<Row> first =
      rows_of(sound(spring_case(kLoadOn3, spring, kFrictionIn3 + kFrictionIn1)));
  const std::vector<Row> second =
      rows_of(sound(spring_case(kLoadOn3, spring, kFrictionIn1 + kFrictionIn3)));
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(normal_force(first[i], 1) == std::abs(friction(first[i], 0)));
    CHECK(friction(first[i], 1) == friction(second[i], 0));
    CHECK(first[i].quantities[2] == second[i].quantities[2]);
  }
  CHECK(friction(first.back(), 1) == Approx(0.5 * 30).epsilon(1e-12));
  CHECK(first.back().quantities[2] == Approx(60.0 / 300).epsilon(1e-12));
}

TEST_CASE("a stop that takes up the load leaves the friction of the component to press as well") {
  const std::vector<Row> rows = rows_of(sound(spring_case(
      kLoadOn3, "stops: [{component: 3, upper: 0.01}]\n", kFrictionIn1 + kFrictionIn3)));
  const Row& end = rows.back();
  CHECK(end.forces.component[2].reaction == Approx(60.0).epsilon(1e-12));
  CHECK(normal_force(end, 0) == Approx(30.0).epsilon(1e-12));
}

TEST_CASE("a component that changes hands presses with its spring while its motion is prescribed") {
  const std::vector<Row> rows = rows_of(sound(spring_case(
      "  - {step: moved, increments: 2, motion: {CP1: {to: 1}, CP3: {to: 0.1}}}\n"
      "  - {step: loaded, increments: 2, motion: {CP1: {to: 2}}, force: {f3: {to: 80}}}\n"
      "  - {step: held, increments: 2, motion: {CP1: {to: 3}, CP3: {to: 0.2}}}\n",
      "elasticity: [{component: 3, stiffness: 500}]\n")));
  CHECK(normal_force(rows[2]) == Approx(50.0).epsilon(1e-14));
  CHECK(normal_force(rows[4]) == 0.0);
  CHECK(rows[4].definitions[0].update.state.regime == law::Regime::kOpen);
  CHECK(normal_force(rows[6]) == Approx(100.0).epsilon(1e-13));
}

TEST_CASE("a mass rubs under a spring that presses as under the same internal force") {
  const std::string history = "  - {step: vibrate, increments: 200, duration: 4}\n";
  const std::string rest =
      "dynamics: {component: 1, mass: 2, initial_velocity: 3}\nelasticity:\n"
      "  - {component: 1, stiffness: 40}\n";
  const cases::Case pressed = sound(read::changed(
      {{"{type: CARTESIAN}", "{type: CARTESIAN, initial: {CP3: 0.2}, reference: {CP3: 0}}"}},
      spring_case(history, rest + "  - {component: 3, stiffness: 50}\n",
                  "  - {component: 1, contact_force: 3, coefficient: 0.2}\n")));
  const cases::Case given = sound(spring_case(
      history, rest, "  - {component: 1, internal_contact_force: 10, coefficient: 0.2}\n"));
  const std::vector<Row> a = rows_of(pressed);
  const std::vector<Row> b = rows_of(given);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(normal_force(a[i]) == 10.0);
    CHECK(a[i].quantities[0] == b[i].quantities[0]);
    CHECK(a[i].definitions[0].dissipation == b[i].definitions[0].dissipation);
  }
}

TEST_CASE("a mass under coupled springs feels and gives the other component's force") {
  const cases::Case problem = sound(spring_case(
      "  - {step: vibrate, increments: 300, duration: 3, motion: {CP3: = 0.1*sin(t)}}\n",
      kMembrane + "dynamics: {component: 1, mass: 1, initial_velocity: 2}\n",
      "  - {component: 1, contact_force: 3, coefficient: 0.1}\n"));
  const std::vector<Row> rows = rows_of(problem);
  double held = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const double hold = 500 * row.quantities[0] + 1000 * row.quantities[2];
    CHECK(row.forces.component[2].elastic == Approx(hold).margin(1e-12));
    CHECK(normal_force(row) == Approx(std::abs(hold)).margin(1e-12));
    if (i == 0) continue;
    held += 0.5 * (hold + rows[i - 1].forces.component[2].elastic) *
            (row.quantities[2] - rows[i - 1].quantities[2]);
  }
  const Row& end = rows.back();
  CHECK(end.forces.elastic_energy + end.forces.kinetic_energy + end.definitions[0].dissipation ==
        Approx(0.5 * 4 + held).margin(1e-3));
}

TEST_CASE("the force of a mass in its own direction presses with what accelerates it") {
  // Without friction along 1, the mass of component 3 swings; what presses is -m a.
  const cases::Case problem = sound(spring_case(
      "  - {step: swing, increments: 50, duration: 2, motion: {CP1: {to: 5}}, force: {f3: 3}}\n",
      "elasticity: [{component: 3, stiffness: 30}]\ndynamics: {component: 3, mass: 2}\n"));
  for (const Row& row : rows_of(problem)) {
    const double x = 3.0 / 30 * (1 - std::cos(std::sqrt(15.0) * row.time));
    if (row.index > 0) CHECK(normal_force(row) == Approx(std::abs(30 * x - 3)).margin(1e-9));
  }
}

TEST_CASE("exact integration under springs and dampers does not depend on the increments") {
  const auto end = [](int increments, const std::string& extra) {
    return rows_of(
               sound(spring_case(
                   "  - {step: a, increments: " + std::to_string(increments) +
                       ", motion: {CP1: {to: 1}, CP3: {to: 0.3}}}\n",
                   "integration: {method: exact}\ndamping: [{component: 3, coefficient: 20}]\n" +
                       extra)))
        .back();
  };
  for (const std::string spring :
       {"elasticity: [{component: 3, stiffness: 400}]\n",
        "elasticity: [{component: 3, columns: [force, displacement], rows: [[0, 0], [90, 0.1], "
        "[150, 0.4]]}]\n",
        "elasticity: [{components: [1, 3], stiffness: [[90, 30], [30, 400]]}]\n"}) {
    INFO(spring);
    const Row one = end(1, spring);
    for (const int increments : {3, 7, 50}) {
      const Row many = end(increments, spring);
      CHECK(friction(many) == Approx(friction(one)).epsilon(1e-9));
      CHECK(many.definitions[0].dissipation ==
            Approx(one.definitions[0].dissipation).epsilon(1e-9));
      CHECK(many.definitions[0].update.state.accumulated_slip ==
            Approx(one.definitions[0].update.state.accumulated_slip).epsilon(1e-9));
    }
  }
}

// ---- What is said when a case is read.

const std::string kRamp =
    "  - {step: push, increments: 2, motion: {CP1: {to: 1}}, force: {f3: {to: 50}}}\n";
const std::string kSpring3 = "elasticity: [{component: 3, stiffness: 500}]\n";

TEST_CASE("a load against a spring that should press is warned of, and the remedies press") {
  CHECK(said(spring_case(kRamp, kSpring3)) ==
        std::vector<std::string>{
            "warning|friction[0].contact_force|step 'push' drives component 3 by force: in "
            "equilibrium its load and the spring or stop that takes it up cancel, and nothing is "
            "left to press|prescribe CP3 under 'motion' instead: its spring then presses; or "
            "prescribe f3 in a connection that holds component 3: SLOT, CYLINDRICAL "
            "or TRANSLATOR"});
  CHECK(normal_force(rows_of(sound(spring_case(kRamp, kSpring3))).back()) == 0.0);
  // The spring by its position, and a connection that holds the component.
  CHECK(normal_force(
            rows_of(sound(spring_case(
                        "  - {step: a, increments: 4, motion: {CP1: {to: 1}, CP3: {to: 0.1}}}\n",
                        kSpring3)))
                .back()) == Approx(50.0));
  std::string slot = read::changed({{"CARTESIAN", "SLOT"}}, spring_case(kRamp, ""));
  CHECK(said(slot).empty());
  CHECK(normal_force(rows_of(sound(slot)).back()) == Approx(50.0));
}

TEST_CASE("the run does not blame the load's size for a pressure that is balanced") {
  const cases::Case problem = sound(spring_case(kRamp, kSpring3));
  results::Plausibility plausibility(problem);
  for (const Row& row : rows_of(problem)) plausibility.add(row);
  CHECK(plausibility.findings().empty());
}

TEST_CASE("a spring that is never compressed is told by its motion") {
  const auto finding = [](const std::string& motion) {
    const cases::Case problem = sound(spring_case(
        "  - {step: a, increments: 4, motion: {CP1: {to: 1}" + motion + "}}\n", kSpring3));
    results::Plausibility plausibility(problem);
    for (const Row& row : rows_of(problem)) plausibility.add(row);
    REQUIRE(plausibility.findings().size() == 1);
    return plausibility.findings()[0];
  };
  const std::string never =
      "friction 'friction1': nothing ever presses: its contact force is 0 all along, and so is its "
      "friction; look at the size and the sign of CP3";
  CHECK(finding("") == never + " (nothing moves it) in the history");
  CHECK(finding(", CP3: {to: 0}") == never + " in the history");
}

TEST_CASE("a load that only friction takes up is told what presses") {
  const std::vector<std::string> all =
      said(spring_case(kRamp, kSpring3, kFrictionIn1 + kFrictionIn3));
  REQUIRE(all.size() == 1);
  CHECK(all[0].find("cancel, and only the friction 'brake' of component 3 is left to press") !=
        std::string::npos);
}

TEST_CASE("frictions that would press themselves or each other are refused with the reason") {
  CHECK(said(spring_case("  - {step: a, increments: 4, force: {f1: {to: 9}}}\n",
                         "elasticity: [{component: 1, stiffness: 5}]\n",
                         "  - {component: 1, contact_force: 1, coefficient: 0.2, stick: "
                         "{stiffness: 10}}\n")) ==
        std::vector<std::string>{
            "error|friction[0].contact_force|friction 'friction1' would press itself: its contact "
            "force names a component that it slips in and that is driven by force, and in "
            "equilibrium that force is minus this friction|prescribe the position of such a "
            "component under 'motion', or let the contact force name another"});
  CHECK(said(spring_case("  - {step: a, increments: 4, force: {f1: {to: 9}, f3: {to: 9}}}\n",
                         "elasticity: [{component: 1, stiffness: 5}]\n",
                         "  - {name: a, component: 1, contact_force: 3, coefficient: 0.2, stick: "
                         "{stiffness: 10}}\n"
                         "  - {name: b, component: 3, contact_force: 1, coefficient: 0.2, stick: "
                         "{stiffness: 10}}\n")) ==
        std::vector<std::string>{
            "error|friction[0].contact_force|frictions 'a', 'b' would press each other: the "
            "contact force of each names a component that the next slips in and that is driven by "
            "force, and in equilibrium that force is minus its friction|prescribe the position of "
            "such a component under 'motion', or let the contact force name another"});
}

const std::string kNever =
    "nothing drives f3: the contact force is 0 over the whole run|component 3 is free: a spring "
    "under 'elasticity' presses once the history moves CP3";

TEST_CASE("a contact force that nothing drives is said when the case is read") {
  const std::string slides =
      "  - {step: a, increments: 4, motion: {CP1: {to: 6}}, force: {f2: 100}}\n";
  const std::string slot = read::changed({{"CARTESIAN", "SLOT"}}, spring_case(slides, ""));
  CHECK(said(slot) ==
        std::vector<std::string>{"warning|friction[0].contact_force|nothing drives f3: the contact "
                                 "force is 0 over the whole run|a step drives it, for example "
                                 "'force: {f3: 100}'"});
  CHECK(said(read::changed({{"f2: 100", "f3: 100"}}, slot)).empty());
  CHECK(said(read::changed({{"contact_force: 3", "contact_force: 3, internal_contact_force: 5"}},
                           slot))
            .front()
            .find("note|") == 0);
  const std::string moves = "  - {step: a, increments: 4, motion: {CP1: {to: 6}, CP3: {to: 1}}}\n";
  CHECK(said(spring_case(moves, "")) ==
        std::vector<std::string>{"warning|friction[0].contact_force|" + kNever});
  CHECK(said(spring_case(moves, kSpring3)).empty());
  CHECK(said(spring_case(moves, "damping: [{component: 3, coefficient: 1}]\n")).empty());
}

TEST_CASE("of a derived component one driven entry is enough, and zeros are none") {
  const auto both = [](const std::string& forces) {
    return read::changed(
        {{"CARTESIAN", "SLOT"}, {"contact_force: 3", "contact_force: n"}},
        spring_case(
            "  - {step: a, increments: 4, motion: {CP1: {to: 6}}, force: {" + forces + "}}\n",
            "derived_components: {n: [{components: [2, 3]}]}\n"));
  };
  CHECK(said(both("f2: 100")).empty());
  CHECK(
      said(both("f2: 0")) ==
      std::vector<std::string>{"note|friction[0].contact_force|nothing drives f3, and the history "
                               "keeps f2 at 0: the contact force is 0 over the whole run|a step "
                               "drives it, for example 'force: {f3: 100}'"});
}

TEST_CASE("a stiffness matrix is told what is wrong with it") {
  const auto with = [](const std::string& elasticity) {
    return said(spring_case("  - {step: a, increments: 4, motion: {CP1: {to: 1}, CP3: {to: 1}}}\n",
                            "elasticity: [" + elasticity + "]\n"));
  };
  CHECK(with("{components: [1, 3], stiffness: [[4, -2], [-2, 1]]}").empty());
  CHECK(with("{components: [1, 3], stiffness: [[4, 2], [-2, 1]]}") ==
        std::vector<std::string>{"error|elasticity[0].stiffness[1][0]|a stiffness matrix is "
                                 "symmetric: -2 here and 2 across the diagonal|"});
  CHECK(with("{components: [1, 3], stiffness: [[4, 3], [3, 1]]}") ==
        std::vector<std::string>{
            "error|elasticity[0].stiffness|a stiffness matrix is positive semidefinite: along some "
            "displacement these springs would give away energy that nothing has put in|for two "
            "components, stiffness[0][1]^2 must not be above stiffness[0][0] times "
            "stiffness[1][1]"});
  CHECK(with("{components: [1, 3], stiffness: [[4, 3]]}").front() ==
        "error|elasticity[0].stiffness|wanted a matrix of 2 rows of 2 numbers, one for each of the "
        "'components'|");
  CHECK(with("{components: [1, 3], stiffness: 4}").front() ==
        "error|elasticity[0].stiffness|wanted a matrix of 2 rows of 2 numbers, one for each of the "
        "'components'|");
  CHECK(with("{component: 3, stiffness: [[4, 3], [3, 1]]}").front() ==
        "error|elasticity[0].stiffness|a matrix is the stiffness of several components|name them "
        "with 'components: [..]', or write one number");
  CHECK(with("{components: [3], stiffness: [[4]]}").front() ==
        "error|elasticity[0].components|joins two or more components|a spring along one component "
        "is '{component: .., stiffness: ..}'");
  CHECK(with("{stiffness: 4}").front() ==
        "error|elasticity[0]|needs 'component', or 'components' and their matrix|");
  CHECK(with("{components: [1, 3], stiffness: [[4, 1], [1, 1]]}, {component: 3, stiffness: 2}")
            .front() == "error|elasticity[1].component|component 3 already has an elasticity|");
  CHECK(with("{components: [1, 3], component: 1, stiffness: [[4, 1], [1, 1]]}").front() ==
        "error|elasticity[0].component|several components take a 'stiffness' matrix, and nothing "
        "beside it|leave out 'components', or this");
}

}  // namespace
}  // namespace slipbench::driver::bench
