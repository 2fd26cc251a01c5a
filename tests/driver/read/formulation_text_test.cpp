// SPDX-License-Identifier: Apache-2.0
// formulation, filter, orthotropic and CONTACT as they are written: what they mean, and what they
// must not say.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "law/connection/connection_type.hpp"
#include "law/friction/law_list.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

/// A contact point; \p friction stands beside `predefined`, line 5 from column 5 on.
std::string contact(const std::string& friction, const std::string& more = {},
                    const std::string& step = "force: {f1: 100}, motion: {CP2: {to: 1}}") {
  return "slipbench: 1\n"
         "units: {length: mm, force: N, time: s}\n"
         "connector: {type: CONTACT}\n"
         "friction:\n"
         "  - {predefined: {}, " +
         friction + "}\n" + more + "history:\n  - {step: go, increments: 100, " + step + "}\n";
}

const std::string kStiff = "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1000}";

const law::Formulation& formulation_of(const cases::Case& problem) {
  REQUIRE(problem.definitions.size() == 1);
  REQUIRE(problem.definitions[0].law.formulation.has_value());
  return *problem.definitions[0].law.formulation;
}

law::Filter filter_of(const std::string& filter) {
  return formulation_of(sound(contact(kStiff + ", filter: " + filter))).filter;
}

/// The one error of a case, without the file's name.
std::string only_message(const std::string& text) {
  const auto all = messages(text);
  REQUIRE(all.size() == 1);
  return all[0];
}
void check_error(const std::string& text, const std::string& words) {
  const std::string message = only_message(text);
  INFO(message);
  CHECK(message.find("error: ") != std::string::npos);
  CHECK(message.find(words) != std::string::npos);
}

TEST_CASE("what presses on a contact point is one-sided for every definition") {
  const cases::Case problem = sound(
      "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: CONTACT}\n"
      "friction:\n  - {component: 2, contact_force: 1, coefficient: 0.3, stick: {stiffness: 1}}\n"
      "history:\n  - {step: go, increments: 1, force: {f1: 1}, motion: {CP2: {to: 1}}}\n");
  law::ConnectorForce force;
  const auto normal = [&](double f1) {
    force[0] = f1;
    return law::evaluate(problem.definitions.at(0).law.contact_force, force, law::Ambient{});
  };
  CHECK(normal(20.0) == 20.0);
  CHECK(normal(-20.0) == 0.0);
}

TEST_CASE("timings that a formulation does not follow are told") {
  const std::string asked =
      contact(kStiff, "integration: {slip_rate: slip, accumulated_slip: end}\n");
  const auto all = messages(asked);
  REQUIRE(all.size() == 2);
  CHECK(all[0].find("warning: integration.slip_rate: a formulation sees") != std::string::npos);
  CHECK(all[1].find("warning: integration.accumulated_slip: a formulation takes") !=
        std::string::npos);
  const std::string fitting =
      contact(kStiff, "integration: {slip_rate: relative_motion, accumulated_slip: start}\n");
  CHECK(messages(fitting).empty());
}

TEST_CASE("a contact point presses on one side and slips in two tangents, or in one") {
  const cases::Case space = sound(contact("coefficient: 0.3, stick: {stiffness: 1000}"));
  const law::FrictionDefinition& d = space.definitions.at(0).law;
  CHECK(d.slip.dimension == 2);
  CHECK(d.slip.component[0] == 1);
  CHECK(d.slip.component[1] == 2);
  const law::Ambient ambient;
  law::ConnectorForce force;
  force[0] = 70.0;
  CHECK(law::evaluate(d.contact_force, force, ambient) == 70.0);
  force[0] = -70.0;
  CHECK(law::evaluate(d.contact_force, force, ambient) == 0.0);
  const cases::Case plane = sound(changed({{"type: CONTACT", "type: CONTACT, dimension: 2"}},
                                          contact("coefficient: 0.3, stick: {stiffness: 1000}")));
  CHECK(plane.definitions.at(0).law.slip.dimension == 1);
  CHECK_FALSE(plane.connection.info.available.contains(2));
}

TEST_CASE("a viscous penalty has VISF, K and m, or C") {
  const auto penalty = [](const std::string& keys) {
    return std::get<law::ViscousPenalty>(
        formulation_of(
            sound(contact("coefficient: 0.3, formulation: {penalty: viscous, " + keys + "}")))
            .penalty);
  };
  CHECK(penalty("K: 5100, m: 1.0e-3").visf == 1.0);
  CHECK(penalty("VISF: 0, K: 5100, m: 1.0e-3").visf == 1.0);
  CHECK(penalty("VISF: 4, K: 5100, m: 1.0e-3").visf == 4.0);
  CHECK(std::get<double>(penalty("K: 5100, m: 1.0e-3").stiffness) == 5100.0);
  CHECK(penalty("K: 5100, m: 1.0e-3").mass == 1e-3);
  CHECK(penalty("C: 3").coefficient == 3.0);
  CHECK(std::holds_alternative<law::TableFunction>(
      penalty("K: {columns: [K, contact_force], rows: [[1, 0], [2, 9]]}, m: 1").stiffness));
  // At x = contact_force the table is asked at F_N; slip cannot enter.
  check_error(contact("coefficient: 0.3, formulation: {penalty: viscous, m: 1, K: {columns: [K, "
                      "slip_rate], rows: [[1, 0]]}}"),
              "a normal stiffness cannot depend on 'slip_rate'");
}

TEST_CASE("a stiffness penalty takes the place of the stick stiffness") {
  const cases::Case problem = sound(contact(kStiff));
  const law::Formulation& f = formulation_of(problem);
  CHECK(std::get<law::StiffnessPenalty>(f.penalty).stiffness == 1000.0);
  CHECK(f.convention == law::Convention::kDocumented);
  CHECK(f.filter.kind == law::Filter::Kind::kNone);
  CHECK(problem.definitions[0].law.slip_rate == law::SlipRateMeasure::kRelativeMotion);
  // No note on a characteristic length that plays no part.
  CHECK(messages(contact(kStiff)).empty());
  CHECK(formulation_of(sound(changed({{"1000", "1000, convention: as_coded"}}, contact(kStiff))))
            .convention == law::Convention::kAsCoded);
}

TEST_CASE("the keys of the other penalty are errors, VISF only a warning") {
  const auto with = [](const std::string& keys) {
    return contact("coefficient: 0.3, formulation: {" + keys + "}");
  };
  check_error(with("penalty: viscous, K_t: 3, C: 1"), "K_t belongs to 'penalty: stiffness'");
  check_error(with("penalty: stiffness, K_t: 3, K: 1"), "K belongs to 'penalty: viscous'");
  check_error(with("penalty: stiffness, K_t: 3, m: 1"), "m belongs to 'penalty: viscous'");
  check_error(with("penalty: stiffness, K_t: 3, C: 1"), "C belongs to 'penalty: viscous'");
  check_error(with("penalty: stiffness"), "a stiffness penalty needs 'K_t'");
  check_error(with("penalty: viscous"), "a viscous penalty needs 'K' and 'm', or 'C'");
  check_error(with("penalty: viscous, K: 3"), "a viscous penalty needs 'm'");
  check_error(with("penalty: viscous, m: 3"), "a viscous penalty needs 'K'");
  check_error(with("penalty: viscous, C: 3, K: 1, m: 1"), "stands in place of VISF sqrt(2 K m)");
  check_error(with("penalty: viscous, C: 3, VISF: 2"), "stands in place of VISF sqrt(2 K m)");
  check_error(with("penalty: viscous, C: 0"), "must be greater than 0");
  check_error(with("penalty: viscous, VISF: -1, K: 1, m: 1"), "must be at least 0");
  check_error(with("penalty: stiffness, K_t: 0"), "must be greater than 0");
  check_error(with("K_t: 3"), "missing key 'penalty'");
  check_error(with("penalty: elastic, K_t: 3"), "wanted viscous or stiffness");
  const std::string text = with("penalty: stiffness, K_t: 3, VISF: 2");
  CHECK(only_message(text).find("warning: ") != std::string::npos);
  CHECK(only_message(text).find("VISF has no effect on a stiffness penalty") != std::string::npos);
}

TEST_CASE("stick beside a formulation is an error") {
  check_error(contact(kStiff + ", stick: {stiffness: 5}"),
              "a formulation has a stiffness of its own");
}

TEST_CASE("each spelling of a filter gives its coefficient") {
  using Kind = law::Filter::Kind;
  CHECK(filter_of("{simple: 0.1}").kind == Kind::kSimple);
  CHECK(filter_of("{simple: 0.1}").value == 0.1);
  CHECK(filter_of("{period: 2}").kind == Kind::kPeriod);
  CHECK(filter_of("{frequency: 1.0e6}").kind == Kind::kFrequency);
  CHECK_FALSE(filter_of("{frequency: 1.0e6}").clip);
  CHECK(filter_of("{simple: 0.1, clip: true}").clip);
  // Xfreq says T/dt or dt/T, so the coefficient is known at once.
  const law::Filter steps = filter_of("{Xfreq: 60, xfreq_convention: steps}");
  CHECK(steps.kind == Kind::kSimple);
  CHECK(steps.value == Approx(std::numbers::pi / 30.0).epsilon(1e-15));  // one rounding
  const law::Filter ratio = filter_of("{Xfreq: 0.05, xfreq_convention: ratio}");
  CHECK(ratio.value == Approx(0.1 * std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("a filter coefficient is above 0 and at most 1") {
  const auto with = [](const std::string& filter) {
    return contact(kStiff + ", filter: " + filter);
  };
  CHECK(filter_of("{simple: 1}").value == 1.0);
  check_error(with("{simple: 1.0001}"), "must be between 0 and 1");
  check_error(with("{simple: -0.1}"), "must be between 0 and 1");
  CHECK(filter_of("{Xfreq: 6.2832, xfreq_convention: steps}").value <= 1.0);
  check_error(with("{Xfreq: 6.2831, xfreq_convention: steps}"), "is at least 2 pi");
  CHECK(filter_of("{Xfreq: 0.1591, xfreq_convention: ratio}").value <= 1.0);
  check_error(with("{Xfreq: 0.1592, xfreq_convention: ratio}"), "is at most 1/(2 pi)");
  check_error(with("{frequency: -0.1}"), "must be at least 0");
  check_error(with("{period: 0}"), "must be greater than 0");
}

TEST_CASE("0 turns a filter off with a warning, as in the solver") {
  for (const char* filter :
       {"{simple: 0}", "{frequency: 0}", "{Xfreq: 0, xfreq_convention: steps}"}) {
    const std::string text = contact(kStiff + ", filter: " + filter);
    CHECK(formulation_of(sound(text)).filter.kind == law::Filter::Kind::kNone);
    CHECK(only_message(text).find("warning: ") != std::string::npos);
    CHECK(only_message(text).find("0 is no filter") != std::string::npos);
  }
}

TEST_CASE("a period is held against the increments of every step") {
  // dt = 0.01: 2 pi 0.01 = 0.0628.
  CHECK(filter_of("{period: 0.063}").value == 0.063);
  check_error(contact(kStiff + ", filter: {period: 0.062}"), "is above 1 in step 'go' with dt");
}

TEST_CASE("a filter needs one way of saying it, and a formulation") {
  const auto with = [](const std::string& filter) {
    return contact(kStiff + ", filter: " + filter);
  };
  check_error(with("{clip: true}"), "needs one of 'simple'");
  check_error(with("{simple: 0.1, period: 3}"), "takes only one of 'simple'");
  check_error(with("{Xfreq: 60}"), "needs 'xfreq_convention'");
  check_error(with("{simple: 0.1, xfreq_convention: steps}"), "says how 'Xfreq' is meant");
  check_error(contact("coefficient: 0.3, stick: {stiffness: 5}, filter: {simple: 0.1}"),
              "a filter smooths the force of a 'formulation'");
}

TEST_CASE("a frequency as coded is told to be no filter") {
  const std::string text = changed({{"1000}", "1000, convention: as_coded}"}},
                                   contact(kStiff + ", filter: {frequency: 5}"));
  const std::string message = only_message(text);
  CHECK(message.find("this filter never smooths, above 1 it makes the spring stiffer") !=
        std::string::npos);
  CHECK(message.find("diverges") == std::string::npos);
  const std::string viscous = only_message(
      contact("coefficient: 0.3, formulation: {penalty: viscous, C: 1, convention: as_coded}, "
              "filter: {frequency: 5}"));
  CHECK(viscous.find("above 1 it overshoots and from 2 on it diverges") != std::string::npos);
}

const std::string kTwo = "coefficient: {orthotropic: {direction1: 0.3, direction2: 0.1}}";

TEST_CASE("an orthotropic coefficient has two laws, an axis and a speed") {
  const std::string form = ", formulation: {penalty: stiffness, K_t: 1000}";
  const cases::Case problem = sound(contact(kTwo + form));
  const law::Orthotropy& two = formulation_of(problem).orthotropy.value();
  CHECK(std::get<law::ConstantCoefficient>(problem.definitions[0].law.law).mu == 0.3);
  CHECK(std::get<law::ConstantCoefficient>(two.second).mu == 0.1);
  CHECK(two.first == std::array{1.0, 0.0});
  CHECK(two.speed == law::Orthotropy::Speed::kComponent);
  const cases::Case turned = sound(contact(
      "coefficient: {orthotropic: {direction1: {exponential_decay: {static: 0.3, kinetic: 0.2, "
      "decay: 1}}, direction2: {columns: [mu, slip_rate], rows: [[0.2, 0], [0.1, 9]]}, speed: "
      "total, axis: [3, 4]}}" +
      form));
  const law::Orthotropy& axes = formulation_of(turned).orthotropy.value();
  CHECK(std::holds_alternative<law::ExponentialDecay>(turned.definitions[0].law.law));
  CHECK(std::holds_alternative<law::TabularCoefficient>(axes.second));
  CHECK(axes.speed == law::Orthotropy::Speed::kTotal);
  CHECK(axes.first[0] == Approx(0.6).epsilon(1e-15));  // one rounding
  CHECK(axes.first[1] == Approx(0.8).epsilon(1e-15));
}

TEST_CASE("orthotropic beside a stick stiffness means a stiffness penalty") {
  const law::Formulation f = formulation_of(sound(contact(kTwo + ", stick: {stiffness: 500}")));
  CHECK(std::get<law::StiffnessPenalty>(f.penalty).stiffness == 500.0);
  CHECK(f.orthotropy.has_value());
  check_error(contact(kTwo), "an orthotropic coefficient needs a 'formulation'");
  check_error(contact(kTwo + ", stick: {elastic_slip: 0.01}"),
              "an orthotropic coefficient needs a 'formulation'");
}

TEST_CASE("orthotropic friction is refused where it has no meaning") {
  const std::string form = ", formulation: {penalty: stiffness, K_t: 1000}";
  const auto one = [&](const std::string& coefficient) {
    return contact("coefficient: {orthotropic: " + coefficient + "}" + form);
  };
  check_error(one("{direction1: 0.3}"), "missing key 'direction2'");
  check_error(one("{direction1: 0.3, direction2: -0.1}"), "must be at least 0");
  check_error(one("{direction1: 0.3, direction2: 0.1, axis: [0, 0]}"),
              "an axis of length 0 has no direction");
  check_error(one("{direction1: 0.3, direction2: 0.1, axis: [1, 0, 0]}"), "found 3");
  check_error(one("{direction1: 0.3, direction2: {orthotropic: {direction1: 1, direction2: 1}}}"),
              "cannot be orthotropic itself");
  check_error(changed({{"type: CONTACT", "type: CONTACT, dimension: 2"}}, contact(kTwo + form)),
              "needs two components that slip together, here one slips");
  check_error(contact(kTwo + ", formulation: {penalty: viscous, C: 3, convention: as_coded}"),
              "points the wrong way");
  // Two units, and two definitions with one coefficient.
  const std::string shaft =
      "slipbench: 1\n"
      "connector: {type: CYLINDRICAL}\n"
      "friction:\n"
      "  - {potential: {terms: [{component: 1}, {component: 4, scale: 1}]}, "
      "internal_contact_force: 5, " +
      kTwo + form +
      "}\n"
      "history: [{step: go, increments: 1, motion: {CP1: {to: 1}}}]\n";
  CHECK(messages(shaft).empty());
  const auto complains = [](const std::string& text, const std::string& words) {
    const std::string all = complaint(text);
    INFO(all);
    CHECK(all.find(words) != std::string::npos);
  };
  complains(changed({{", scale: 1", ""}}, shaft),
            "error: friction[0].coefficient: an orthotropic coefficient needs two components that "
            "slip together in one unit: here one is an angle beside a length; the 'scale' of the "
            "rotation is the radius it rubs at");
  complains(changed({{"CONTACT", "PLANAR"}}, contact(kTwo + form)),
            "needs two components that slip together, here one slips; predefined CONTACT, "
            "SLIDE-PLANE and CYLINDRICAL have two, and so has a 'potential' of two terms; the "
            "spinning of a PLANAR is 'component: 4' beside it");
  complains(changed({{"CYLINDRICAL", "CARTESIAN"},
                     {"[{component: 1}, {component: 4, scale: 1}]",
                      "[{component: 1}, {component: 2}, {component: 3}]"}},
                    shaft),
            "slip together, here 3 slip");
}

TEST_CASE("a formulation is refused where it cannot hold") {
  check_error(contact(kStiff, "integration: {method: exact}\n"),
              "a formulation is a rule for increments");
  check_error(contact(kStiff + ", filter: {simple: 0.1}", "", "force: {f1: 100, f2: {to: 5}}"),
              "a filtered force lags behind the motion");
  CHECK(messages(changed({{"1000}", "1000, convention: as_coded}"}},
                         contact(kStiff + ", filter: {simple: 0.1}", "",
                                 "force: {f1: 100, f2: {to: 5}}")))
            .empty());
  CHECK(messages(contact(kStiff, "", "force: {f1: 100, f2: {to: 5}}")).empty());
  check_error(
      "slipbench: 1\n"
      "connector: {type: SLIPRING, wrap_angle: 1}\n"
      "friction: [{predefined: {}, coefficient: 0.3, formulation: {penalty: viscous, C: "
      "1}}]\n"
      "history: [{step: go, increments: 1, force: {f1: 5}, motion: {CP2: {to: 1}}}]\n",
      "a SLIPRING takes no formulation");
  check_error(
      "slipbench: 1\n"
      "connector: {type: SLIDE-PLANE}\n"
      "friction: [{potential: {operator: max, terms: [{component: 2}, {component: 3}]}, "
      "contact_force: 1, coefficient: 0.3, formulation: {penalty: viscous, C: 1}}]\n"
      "history: [{step: go, increments: 1, force: {f1: 5}, motion: {CP2: {to: 1}}}]\n",
      "not to this potential");
  check_error(
      "slipbench: 1\n"
      "connector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: 0.3, formulation: {penalty: viscous, C: "
      "1}}]\n"
      "dynamics: {mass: 1}\n"
      "history: [{step: go, increments: 1, force: {f2: 5}}]\n",
      "takes no formulation");
}

TEST_CASE("a change of friction leaves a formulation alone") {
  const auto second = [](const std::string& friction, const std::string& change) {
    return changed({{"slipbench: 1\n", "slipbench: 1\n"}}, contact(friction)) +
           "  - {step: on, increments: 5, change_friction: {friction1: {" + change + "}}}\n";
  };
  CHECK(messages(second(kStiff, "coefficient: 0.1, force_limit: 4")).empty());
  check_error(second(kStiff, "coefficient: 0.1, stick: {stiffness: 5}"),
              "only its coefficient and its force limit can change");
  check_error(second(kStiff, kTwo), "not to two directions");
  check_error(second(kTwo + ", stick: {stiffness: 5}", "coefficient: 0.1"),
              "the coefficients of an orthotropic definition cannot change");
}

TEST_CASE("a period too short for any number of increments asks for a longer one") {
  check_error(contact(kStiff + ", filter: {period: 1.0e-300}"),
              "give the step a period of at least 0.0628319");
  check_error(contact(kStiff + ", filter: {period: 0.05}"),
              "give the step at least 126 increments, or a period of at least 0.0628319");
  check_error(changed({{"1000}", "1000, convention: as_coded}"}},
                      contact(kStiff + ", filter: {period: 0.05}")),
              "the spring would be stiffer than K_t");
}

TEST_CASE("a viscous coefficient beyond all numbers is refused where it is written") {
  check_error(contact("coefficient: 0.3, formulation: {penalty: viscous, K: 1.0e308, m: 1.0e308}"),
              "C = VISF sqrt(2 K m) is not finite");
}

TEST_CASE("options of a Radioss block lead to the keys that say them") {
  check_error(contact(kStiff + ", Ifiltr: 1"), "Ifiltr 1 is {simple: alpha}");
  check_error(contact(kStiff + ", Iform: 2"), "2 {penalty: stiffness, K_t: ..}");
  check_error(contact(kStiff + ", Ifric: 3"), "3 renard");
  check_error(contact("coefficient: {orthotropic: {direction1: 0.3, direction2: 0.1, Idir: 1}}, "
                      "stick: {stiffness: 10}"),
              "Idir 1 is {orthotropic: {direction1: ..");
  check_error(contact("coefficient: {renard: {Fric: 0.1, C1: 0.15, C2: 0.10, C3: 0.25, C4: 0.05, "
                      "C5: 10, C6: 100}}, stick: {stiffness: 10}"),
              "Renard's law has no Fric");
}

TEST_CASE("a column that a formulation brings is told to be one") {
  const auto check = [](const std::string& quantity) {
    return contact("coefficient: 0.3, stick: {stiffness: 10}",
                   "checks:\n  - {name: a, quantity: " + quantity +
                       ", against: {expression: \"= 1\"}, tolerance: {absolute: 1, why: test}}\n");
  };
  check_error(check("CSF2_RAW"), "'CSF2_RAW' is a column of a definition with a 'formulation'");
  check_error(check("\"= 2*CSF3_TRIAL\""), "'CSF3_TRIAL' is a column of a definition with a 'form");
  check_error(check("ALPHA"), "with a 'filter' behind its 'formulation'");
  check_error(contact("coefficient: 0.3, stick: {stiffness: 10}", "output: {columns: [MU1]}\n"),
              "'MU1' is a column of a definition with an 'orthotropic' coefficient");
}

}  // namespace
}  // namespace slipbench::driver::read
