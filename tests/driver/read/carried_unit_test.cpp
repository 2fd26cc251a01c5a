// SPDX-License-Identifier: Apache-2.0
// Numbers that carry their unit: converted wherever a number has a dimension, refused elsewhere.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "driver/base/text/one_line.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

using std::numbers::pi;

/// A case in kN, cm and ms: no unit is what it is in SI, and few are in mm, N, s.
const std::string kSlider =
    "slipbench: 1\n"
    "units: {length: cm, force: kN, time: ms, temperature: K}\n"
    "parameters: {k: 1, phi: 1}\n"
    "connector: {type: SLOT}\n"
    "friction:\n"
    "  - component: 1\n"
    "    contact_force: 2\n"
    "    coefficient: 0.2\n"
    "    stick: {elastic_slip: 1.0e-4}\n"
    "history:\n"
    "  - step: go\n"
    "    duration: 1\n"
    "    increments: 10\n"
    "    motion: {CP1: {to: 1}}\n"
    "    force: {f2: 1}\n"
    "checks:\n"
    "  - name: limit\n"
    "    quantity: FLIM\n"
    "    against: {expression: \"= 0.2\"}\n"
    "    tolerance: {absolute: 1.0e-9}\n";

/// A rotation in mm, N, s.
const std::string kHinge =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s, temperature: degC}\n"
    "connector: {type: HINGE}\n"
    "friction:\n"
    "  - component: 4\n"
    "    internal_contact_force: 10\n"
    "    coefficient: 0.2\n"
    "    stick: {elastic_slip: 1.0e-4}\n"
    "history:\n"
    "  - step: go\n"
    "    increments: 10\n"
    "    motion: {CPR1: {to: 1}}\n";

const law::FrictionDefinition& first(const cases::Case& problem) {
  return problem.definitions[0].law;
}

TEST_CASE("A length, a force, a time and a stiffness are converted to the case's system") {
  const cases::Case problem =
      read::sound(read::changed({{"elastic_slip: 1.0e-4", "elastic_slip: 2 um"},
                                 {"contact_force: 2",
                                  "contact_force: 2\n"
                                  "    internal_contact_force: 250 N\n"
                                  "    force_limit: 3 MN"},
                                 {"duration: 1", "duration: 0.5 s"},
                                 {"{to: 1}", "{to: 12 mm}"},
                                 {"f2: 1", "f2: 300 N"},
                                 {"absolute: 1.0e-9", "absolute: 5 N"}},
                                kSlider));
  CHECK(first(problem).stick.value == Approx(2.0e-4));
  CHECK(std::get<double>(first(problem).internal_contact_force) == Approx(0.25));
  CHECK(first(problem).force_limit == Approx(3000.0));
  CHECK(problem.steps[0].duration == Approx(500.0));
  CHECK(std::get<history::LinearTo>(problem.steps[0].drives[0].profile).value == Approx(1.2));
  CHECK(std::get<history::Constant>(problem.steps[0].drives[1].profile).value == Approx(0.3));
  CHECK(problem.checks[0].tolerance.absolute == Approx(0.005));
}

TEST_CASE("A mass follows from force, length and time") {
  // 1 kN ms^2/cm = 1e3 N 1e-6 s^2 / 1e-2 m = 0.1 kg.
  const cases::Case problem = read::sound(
      read::changed({{"    motion: {CP1: {to: 1}}\n", ""},
                     {"history:",
                      "dynamics: {mass: 0.3 kg, belt_velocity: 2 m/s, initial_velocity: 36 km/h}\n"
                      "elasticity: [{component: 1, stiffness: 4 kN/mm}]\n"
                      "damping: [{component: 1, coefficient: 7 N*s/m}]\n"
                      "history:"}},
                    kSlider));
  REQUIRE(problem.dynamics.has_value());
  CHECK(problem.dynamics->mass == Approx(3.0));
  CHECK(problem.dynamics->belt_velocity == Approx(0.2));
  CHECK(problem.dynamics->initial_velocity == Approx(1.0));
  CHECK(problem.kinetic.elasticity[0]->value(1.0, {}).force == Approx(40.0));
  CHECK(problem.kinetic.damping[0]->value(1.0, {}).force == Approx(0.07));
}

TEST_CASE("A wave carries units in each of its numbers, and the quantity decides of what") {
  const auto wave = [](const std::string& text) {
    const cases::Case problem = read::sound(read::changed({{"{to: 1}", text}}, kHinge));
    return std::get<history::Wave>(problem.steps[0].drives[0].profile);
  };
  const history::Wave found =
      wave("{sine: {amplitude: 90 deg, frequency: 1.2 kHz, phase: 45 deg, mean: 0.5 rad}}");
  CHECK(found.amplitude == Approx(pi / 2));
  CHECK(found.period == Approx(1.0 / 1200.0));
  CHECK(found.phase == Approx(pi / 4));
  CHECK(found.mean == Approx(0.5));
  CHECK(wave("{square: {amplitude: 1, period: 250 ms}}").period == Approx(0.25));
}

TEST_CASE("A rotation takes moments and angles where a translation takes forces and lengths") {
  const cases::Case problem = read::sound(read::changed(
      {{"internal_contact_force: 10", "internal_contact_force: 2 Nm"},
       {"elastic_slip: 1.0e-4", "stiffness: 5 kN.m/rad"},
       {"coefficient: 0.2",
        "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.5 s/rad}}"},
       {"history:",
        "elasticity: [{component: 4, stiffness: 4 N m}]\n"
        "stops: [{component: 4, upper: 130 deg}]\nhistory:"},
       {"{to: 1}", "{to: 20 deg}"}},
      kHinge));
  CHECK(std::get<double>(first(problem).internal_contact_force) == Approx(2000.0));
  CHECK(first(problem).stick.value == Approx(5.0e6));
  CHECK(problem.kinetic.elasticity[3]->value(1.0, {}).force == Approx(4000.0));
  CHECK(problem.stop[3]->upper == Approx(130.0 * pi / 180.0));
}

TEST_CASE("The numbers of a law are converted by their dimensions") {
  const cases::Case problem = read::sound(read::changed(
      {{"coefficient: 0.2",
        "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.5 s/m}}"}},
      kSlider));
  CHECK(std::get<law::ExponentialDecay>(first(problem).law).decay == Approx(5.0));  // ms/cm
}

TEST_CASE("Temperatures are converted with their offset, and their amplitudes without") {
  const auto profile = [](const std::string& text) {
    const cases::Case problem = read::sound(
        read::changed({{"    force:", "    temperature: " + text + "\n    force:"}}, kSlider));
    return problem.steps[0].drives.back().profile;
  };
  CHECK(std::get<history::Constant>(profile("80 degC")).value == Approx(353.15));
  CHECK(std::get<history::LinearTo>(profile("{to: 212 degF}")).value == Approx(373.15));
  const auto wave =
      std::get<history::Wave>(profile("{sine: {amplitude: 18 degF, period: 1, mean: 20 degC}}"));
  CHECK(wave.amplitude == Approx(10.0));
  CHECK(wave.mean == Approx(293.15));
}

TEST_CASE("A parameter's dimension is its unit's, on the command line too") {
  const std::string text = read::changed(
      {{"parameters: {k: 1, phi: 1}", "parameters: {k: 5 N/mm, phi: 130 deg, T0: 20 degC}"}},
      kSlider);
  CHECK(read::sound(text).parameters.at("k") == Approx(0.05));
  CHECK(read::sound(text).parameters.at("phi") == Approx(130.0 * pi / 180.0));
  CHECK(read::sound(text).parameters.at("T0") == Approx(293.15));
  // A difference of 20 degC would be 20 K.
  const auto notes = [](const read::ReadCase& read) {
    return base::lines_of(read.diagnostics, base::Severity::kNote);
  };
  CHECK_THAT(
      notes(read::read_text(text)),
      Catch::VectorContains(std::string("parameters.T0: '20 degC' is taken as the temperature "
                                        "293.15 K; a difference is written in K")));
  read::ReadOptions options;
  options.overrides = {{"k", std::string("5kN/mm")}, {"phi", std::string("90 deg")}};
  CHECK(read::sound(text, options).parameters.at("k") == Approx(50.0));
  CHECK(read::sound(text, options).parameters.at("phi") == Approx(pi / 2));
  options.overrides = {{"k", std::string("5 kN/mmm")}};
  CHECK(read::complaint(text, options).find("--set k: '5 kN/mmm': unknown unit 'kN/mmm'") !=
        std::string::npos);
}

TEST_CASE("Positions and wrap angles carry units") {
  const cases::Case problem = read::sound(read::changed({{"type: SLOT",
                                                          "type: SLOT, initial: {CP1: 3 mm}, "
                                                          "reference: {CP1: 1 in}"}},
                                                        kSlider));
  CHECK(problem.initial[0] == Approx(0.3));
  CHECK(problem.reference[0] == Approx(2.54));
  const std::string belt =
      "slipbench: 1\nconnector: {type: SLIPRING, wrap_angle: [130 deg, 0.5 rad, 1]}\n"
      "friction: [{predefined: {}, coefficient: 0.2, stick: {elastic_slip: 1.0e-4}}]\n"
      "history: [{step: go, increments: 1, force: {f1: 1}, motion: {CP2: {to: 1}}}]\n";
  const cases::Case around = read::sound(belt);
  const auto& ring = std::get<law::SlipRing>(*around.connection.type);
  REQUIRE(ring.wrap_angles.size() == 3);
  CHECK(ring.wrap_angles[0] == Approx(130.0 * pi / 180.0));
  CHECK(ring.wrap_angles[1] == 0.5);
  CHECK(ring.wrap_angles[2] == 1.0);
}

TEST_CASE("A quoted number with its unit is one too, as JSON has to write it") {
  const cases::Case problem = read::sound(read::changed({{"{to: 1}", "{to: \"12 mm\"}"}}, kSlider));
  CHECK(std::get<history::LinearTo>(problem.steps[0].drives[0].profile).value == Approx(1.2));
}

TEST_CASE("A unit that does not fit is refused with one that would") {
  const auto only = [](const std::vector<read::Change>& changes, const std::string& text,
                       const std::string& wanted) {
    const std::vector<std::string> found = read::messages(read::changed(changes, text));
    CAPTURE(found);
    REQUIRE(found.size() == 1);
    CHECK(found[0].ends_with(wanted));
  };
  only({{"{to: 1}", "{to: 5 N}"}}, kSlider,
       "history[0].motion.CP1.to: '5 N' is a force: a length is wanted, such as cm");
  only({{"{to: 1}", "{to: 5 mm}"}}, kHinge,
       "history[0].motion.CPR1.to: '5 mm' is a length: an angle is wanted, such as rad");
  only({{"duration: 1", "duration: 12 mm"}}, kSlider,
       "history[0].duration: '12 mm' is a length: a time is wanted, such as ms");
  only({{"{to: 1}", "{to: 12 mmm}"}}, kSlider,
       "history[0].motion.CP1.to: '12 mmm': unknown unit 'mmm'; did you mean 'mm'?");
  only({{"{to: 1}", "{to: 130 degs}"}}, kHinge,
       "history[0].motion.CPR1.to: '130 degs': unknown unit 'degs'; did you mean 'deg'?");
  only({{"coefficient: 0.2", "coefficient: 0.2 N"}}, kSlider,
       "friction[0].coefficient: '0.2 N': a number without a unit is wanted here");
  only({{"increments: 10", "increments: 10 s"}}, kSlider,
       "history[0].increments: '10 s': a number without a unit is wanted here");
  only({{"coefficient: 0.2", "coefficient: 20 %"}}, kSlider,
       "friction[0].coefficient: wanted a number: '20 %': write the fraction 0.2");
  only({{"{to: 1}", "{sine: {amplitude: 1, frequency: 6 rad/s}}"}}, kSlider,
       "history[0].motion.CP1.sine.frequency: '6 rad/s' is an angular speed (angle per time): a "
       "frequency (cycles per time) is wanted, such as 1/ms");
  only({{"elastic_slip: 1.0e-4", "elastic_slip: 1 um"}}, kHinge,
       "friction[0].stick.elastic_slip: '1 um' is a length: an angle is wanted, such as rad");
  only({{"stick: {elastic_slip: 1.0e-4}", "stick: {stiffness: 3 N}"}}, kSlider,
       "friction[0].stick.stiffness: '3 N' is a force: a stiffness (force per length) is wanted, "
       "such as kN/cm");
  only({{"    stick: {elastic_slip: 1.0e-4}\n", ""},
        {"history:", "dynamics: {mass: 3 N}\nhistory:"},
        {"    motion: {CP1: {to: 1}}\n", ""}},
       kSlider, "dynamics.mass: '3 N' is a force: a mass is wanted, such as kg");
  only({{"{to: 1}", "{to: = 2*k mm}"}}, kSlider,
       "an expression has no unit: its result is in the case's units, angles in radians");
  only({{"{to: 1}", "{to: 2 pi}"}}, kHinge, "history[0].motion.CPR1.to: '2 pi': 'pi' is no unit");
  only({{"{to: 1}", "{to: 2 A}"}}, kSlider,
       "history[0].motion.CP1.to: '2 A': unit 'A' measures nothing that a case has");
  only({{"duration: 1", "duration: 1,5 s"}}, kSlider,
       "history[0].duration: wanted a number: '1,5': the decimal mark is '.'; write 1.5");
}

TEST_CASE("Rows are numbers of the case's system, and the message converts for them") {
  const std::vector<std::string> found = read::messages(read::changed(
      {{"coefficient: 0.2", "coefficient: {columns: [mu, slip_rate], rows: [[0.2, 5 m/s]]}"}},
      kSlider));
  REQUIRE(found.size() == 1);
  CHECK(
      found[0].ends_with("rows[0][1]: '5 m/s': a number without a unit is wanted here; in the "
                         "case's units it is 0.5"));
}

TEST_CASE("Without a system of units angles alone have one") {
  const std::string text =
      read::changed({{"units: {length: mm, force: N, time: s, temperature: degC}\n", ""},
                     {"{to: 1}", "{to: 90 deg}"}},
                    kHinge);
  CHECK(std::get<history::LinearTo>(read::sound(text).steps[0].drives[0].profile).value ==
        Approx(pi / 2));
  const std::vector<std::string> found = read::messages(
      read::changed({{"internal_contact_force: 10", "internal_contact_force: 1 Nm"}}, text));
  REQUIRE(found.size() == 1);
  CHECK(found[0].ends_with(
      "friction[0].internal_contact_force: '1 Nm': unit 'Nm' cannot be converted: the case does "
      "not state its unit of force (units: {force: ...})"));
}

TEST_CASE("A unit where it is not known what is measured is refused") {
  const std::vector<std::string> found = read::messages(
      read::changed({{"quantity: FLIM", "quantity: \"= 2*FLIM\""}, {"1.0e-9", "1 N"}}, kSlider));
  REQUIRE(found.size() == 1);
  CHECK(
      found[0].ends_with("checks[0].tolerance.absolute: '1 N': a number in the case's units is "
                         "wanted here, without a unit"));
}

}  // namespace
}  // namespace slipbench::driver::read
