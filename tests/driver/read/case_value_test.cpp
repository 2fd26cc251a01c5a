// SPDX-License-Identifier: Apache-2.0
// What the keys of a case become: every key of the format reaches the case here.
#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "reference/catalogue.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::read {
namespace {

using law::IndependentKind;

const std::string kSlotForm =
    "    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n"
    "    contact_force: normal\n";

/// The sound case with its motion given by another profile.
history::Profile profile_of(const std::string& text, const std::string& folder = ".") {
  const cases::Case problem = sound(changed({{"{to: 0.45}", text}}), {}, folder);
  return problem.steps.at(0).drives.at(0).profile;
}

const law::FrictionDefinition& only_law(const cases::Case& problem) {
  REQUIRE(problem.definitions.size() == 1);
  return problem.definitions[0].law;
}

law::FrictionDefinition law_of(const std::vector<Change>& changes,
                               const std::string& folder = ".") {
  return only_law(sound(changed(changes), {}, folder));
}

TEST_CASE("Title, units, parameters and connection reach the case") {
  const cases::Case problem = sound(kSoundCase);
  CHECK(problem.file == "c.yaml");
  CHECK(problem.title == "base");
  CHECK(problem.units.length == "mm");
  CHECK(problem.units.force == "N");
  CHECK(problem.units.time == "s");
  CHECK(problem.units.temperature == "degC");
  CHECK(problem.parameters == base::NamedNumbers{{"r", 0.24}, {"li", 0.55}, {"mu", 0.15}});
  CHECK(problem.connection.info.name == "CYLINDRICAL");
  CHECK(problem.output_every == 1);
  CHECK(problem.output_columns.empty());
}

TEST_CASE("A case without a title is named after its file") {
  CHECK(sound(changed({{"title: base\n", ""}})).title == "c");
}

TEST_CASE("Parameters may use one another, and --set replaces them first") {
  const std::string text = changed({{"mu: 0.15", "mu: = nu/2, nu: 0.3"}});
  CHECK(std::get<law::ConstantCoefficient>(only_law(sound(text)).law).mu == 0.15);
  ReadOptions options;
  options.overrides = {{"nu", 0.5}};
  CHECK(std::get<law::ConstantCoefficient>(only_law(sound(text, options)).law).mu == 0.25);
  options.overrides = {{"mu", "2*nu"}};
  CHECK(sound(text, options).parameters.at("mu") == 0.6);
}

TEST_CASE("Expressions may be quoted and use functions") {
  const cases::Case problem = sound(changed({{"scale: = r", "scale: \"= sqrt(4)*r\""}}));
  CHECK(only_law(problem).slip.scale[1] == 0.48);
}

TEST_CASE("A pair of basic types is the assembled type") {
  CHECK(sound(changed({{"type: CYLINDRICAL", "type: [REVOLUTE, SLOT]"}})).connection.info.name ==
        "CYLINDRICAL");
}

TEST_CASE("A plane SLOT has one constraint force") {
  const cases::Case problem = sound(
      changed({{"type: CYLINDRICAL", "type: SLOT\n  dimension: 2"},
               {"components: [2, 3]}\n    - {operator: norm, components: [5, 6], weights: [= 2/li, "
                "= 2/li]}",
                "components: [2]}"},
               {", {component: 4, scale: = r}", ""},
               {"f2: 300, f3: 400, m2: {to: 55}", "f2: 300"}}));
  CHECK(problem.connection.info.held == law::ComponentSet::of(2));
}

TEST_CASE("Reference positions default to the initial ones") {
  const cases::Case plain =
      sound(changed({{"CYLINDRICAL\n", "CYLINDRICAL\n  initial: {CP1: = li}\n"}}));
  CHECK(plain.initial[0] == 0.55);
  CHECK(plain.reference[0] == 0.55);
  const cases::Case both = sound(changed(
      {{"CYLINDRICAL\n", "CYLINDRICAL\n  initial: {CP1: 2, CP2: 3}\n  reference: {CPR1: 0.5}\n"}}));
  CHECK(both.initial[0] == 2.0);
  CHECK(both.initial[1] == 3.0);
  CHECK(both.reference[0] == 2.0);
  CHECK(both.reference[3] == 0.5);
  CHECK(both.initial[3] == 0.0);
}

TEST_CASE("Derived components keep operators, signs, components and weights") {
  const law::FrictionDefinition d =
      law_of({{"- {operator: norm, components: [2, 3]}",
               "- {operator: macauley_sum, sign: -1, components: [3, 2], weights: [4, = 2*r]}"}});
  const auto& component = std::get<law::DerivedComponent>(d.contact_force);
  REQUIRE(component.size() == 2);
  CHECK(component[0].combine == law::TermOperator::kMacauleySum);
  CHECK(component[0].sign == -1.0);
  CHECK(component[0].count == 2);
  CHECK(component[0].component[0] == 2);
  CHECK(component[0].component[1] == 1);
  CHECK(component[0].weight[0] == 4.0);
  CHECK(component[0].weight[1] == 0.48);
  CHECK(component[1].combine == law::TermOperator::kNorm);
  CHECK(component[1].sign == 1.0);
  CHECK(component[1].weight[1] == 2.0 / 0.55);
  CHECK_FALSE(component[1].weight_table.has_value());
}

TEST_CASE("A derived component may be a sum, with weights from a table") {
  const law::FrictionDefinition d = law_of(
      {{"- {operator: norm, components: [2, 3]}", "- {operator: sum, components: [2]}"},
       {"{operator: norm, components: [5, 6], weights: [= 2/li, = 2/li]}",
        "{operator: sum, components: [5, 6], weights: {columns: [a, b, CP1, temperature], rows: "
        "[[1, 2, 0, 20], [3, 4, 1, 20], [5, 6, 0, 40]], extrapolate: constant}}"}});
  const auto& component = std::get<law::DerivedComponent>(d.contact_force);
  REQUIRE(component.size() == 2);
  CHECK(component[0].combine == law::TermOperator::kSum);
  CHECK(component[0].weight[0] == 1.0);
  REQUIRE(component[1].weight_table.has_value());
  const law::TableFunction& weights = *component[1].weight_table;
  CHECK(weights.table().dependents() == 2);
  REQUIRE(weights.independents().size() == 2);
  CHECK(weights.independents()[0] == law::Independent{IndependentKind::kPosition, 0});
  CHECK(weights.independents()[1].kind == IndependentKind::kTemperature);
  law::Ambient ambient;
  ambient.position[0] = 0.5;
  ambient.temperature = 20.0;
  CHECK(weights.value(ambient, {}, 1) == 3.0);
}

TEST_CASE("A potential gives the slip space, a component form one entry of it") {
  const cases::Case coupled = sound(kSoundCase);
  CHECK(coupled.definitions[0].coupled);
  CHECK(coupled.definitions[0].name == "sleeve");
  const law::SlipSpace& slip = only_law(coupled).slip;
  CHECK(slip.dimension == 2);
  CHECK(slip.component[0] == 0);
  CHECK(slip.component[1] == 3);
  CHECK(slip.scale[0] == 1.0);
  CHECK(slip.scale[1] == 0.24);
  const cases::Case explicit_form = sound(
      changed({{"    potential:\n", "    potential:\n      operator: sum\n      exponent: 2\n"}}));
  CHECK(only_law(explicit_form).slip.dimension == 2);
  const cases::Case single =
      sound(changed({{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n",
                      "    component: 4\n"}}));
  CHECK_FALSE(single.definitions[0].coupled);
  CHECK(only_law(single).slip.dimension == 1);
  CHECK(only_law(single).slip.component[0] == 3);
}

TEST_CASE("Definitions without names are numbered") {
  const cases::Case problem = sound(changed(
      {{"  - name: sleeve\n    potential:\n      terms: [{component: 1}, {component: 4, scale: = "
        "r}]\n",
        "  - component: 1\n"},
       {"history:",
        "  - {component: 4, contact_force: 2, coefficient: 0.1, stick: {stiffness: 2}}\nhistory:"},
       {"FLIM", "FLIM.friction1"},
       {"*FN", "*FN.friction1"}}));
  REQUIRE(problem.definitions.size() == 2);
  CHECK(problem.definitions[0].name == "friction1");
  CHECK(problem.definitions[1].name == "friction2");
}

TEST_CASE("A contact force may be a component's number, also as an expression") {
  for (const char* number : {"2", "= 1 + 1"}) {
    const law::FrictionDefinition d =
        law_of({{"contact_force: normal", std::string("contact_force: ") + number}});
    CHECK(std::get<law::ComponentContactForce>(d.contact_force).component == 1);
  }
}

TEST_CASE("An internal contact force is a number or a table, and may stand alone") {
  const law::FrictionDefinition number =
      law_of({{"contact_force: normal", "internal_contact_force: = 100*r"}});
  CHECK(std::get<double>(number.internal_contact_force) == 24.0);
  CHECK(std::holds_alternative<law::NoContactForce>(number.contact_force));
  const law::FrictionDefinition table = law_of(
      {{"contact_force: normal",
        "internal_contact_force:\n      columns: [force, accumulated_slip, temperature, field2, "
        "CPR1, CU1]\n      rows: [[100, 0, 20, 0, 0, 0], [90, 1000, 20, 0, 0, 0]]"}});
  const auto& function = std::get<law::TableFunction>(table.internal_contact_force);
  REQUIRE(function.independents().size() == 5);
  CHECK(function.independents()[0].kind == IndependentKind::kAccumulatedSlip);
  CHECK(function.independents()[1].kind == IndependentKind::kTemperature);
  CHECK(function.independents()[2] == law::Independent{IndependentKind::kField, 1});
  CHECK(function.independents()[3] == law::Independent{IndependentKind::kPosition, 3});
  CHECK(function.independents()[4] == law::Independent{IndependentKind::kConstitutiveMotion, 0});
  const std::array<double, 2> fields{};
  law::Ambient ambient;
  ambient.temperature = 20.0;
  ambient.fields = fields;
  CHECK(function.value(ambient, {.accumulated_slip = 500.0}) == 95.0);
}

TEST_CASE("The coefficient is a number, a table or a law by name") {
  CHECK(std::get<law::ConstantCoefficient>(law_of({}).law).mu == 0.15);
  const auto table = std::get<law::TabularCoefficient>(
      law_of({{"coefficient: = mu",
               "coefficient: {columns: [mu, slip_rate, contact_force, temperature, field1], rows: "
               "[[0.3, 0, 0, 0, 0], [0.1, 2, 0, 0, 0]], extrapolate: constant}"}})
          .law);
  REQUIRE(table.table.independents().size() == 4);
  CHECK(table.table.independents()[0].kind == IndependentKind::kSlipRate);
  CHECK(table.table.independents()[1].kind == IndependentKind::kContactForce);
  // Exact but for the rounding of (0.3 + 0.1)/2.
  const std::array<double, 1> fields{};
  law::Ambient ambient;
  ambient.fields = fields;
  CHECK(table.table.value(ambient, {.slip_rate = 1.0}) == Approx(0.2).epsilon(1e-15));
  const auto decay = std::get<law::ExponentialDecay>(
      law_of({{"coefficient: = mu",
               "coefficient: {exponential_decay: {static: 0.3, kinetic: = mu, decay: 0.5}}"}})
          .law);
  CHECK(decay.mu_static == 0.3);
  CHECK(decay.kinetic == 0.15);
  CHECK(decay.decay == 0.5);
}

TEST_CASE("A table may be extrapolated linearly, and may stand in a CSV file") {
  const TemporaryFolder folder;
  folder.write("mu.csv", "slip_rate,note,mu\n0,a,0.3\n1,b,0.2\n");
  const auto table = std::get<law::TabularCoefficient>(
      law_of({{"coefficient: = mu",
               "coefficient: {columns: [mu, slip_rate], csv: mu.csv, extrapolate: linear}"}},
             folder.path())
          .law);
  CHECK(table.table.table().extrapolation() == law::Extrapolation::kLinear);
  // Exact but for the rounding of 0.3 - 2 (0.3 - 0.2).
  CHECK(table.table.value({}, {.slip_rate = 2.0}) == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("A force limit of 0 is none") {
  const std::string key = "    coefficient: = mu\n";
  CHECK(law_of({}).force_limit == law::kNoForceLimit);
  CHECK(law_of({{key, key + "    force_limit: 0\n"}}).force_limit == law::kNoForceLimit);
  CHECK(law_of({{key, key + "    force_limit: 500\n"}}).force_limit == 500.0);
}

TEST_CASE("The stick stiffness has three forms and a default") {
  using Mode = law::StickStiffness::Mode;
  const auto stick = [](const std::string& text) {
    return law_of({{"{elastic_slip: 1.0e-4}", text}}).stick;
  };
  CHECK(stick("{elastic_slip: 0.01}").mode == Mode::kElasticSlip);
  CHECK(stick("{elastic_slip: 0.01}").value == 0.01);
  CHECK(stick("{stiffness: 1.0e4}").mode == Mode::kStiffness);
  CHECK(stick("{stiffness: 1.0e4}").value == 1.0e4);
  CHECK(stick("{slip_tolerance: 0.5, characteristic_length: 8}").mode == Mode::kElasticSlip);
  CHECK(stick("{slip_tolerance: 0.5, characteristic_length: 8}").value == 4.0);
  CHECK(stick("{characteristic_length: 8}").value == 8.0e-4);
  CHECK(stick("{slip_tolerance: 0.5}").value == 0.5);
  CHECK(stick("{}").value == 1.0e-4);
}

TEST_CASE("Predefined friction takes its geometry, also with a table inside") {
  const law::FrictionDefinition number =
      law_of({{kSlotForm, "    predefined: {R: 2, L: 4, internal_contact_force: 5}\n"}});
  CHECK(number.slip.dimension == 2);
  CHECK(number.slip.scale[1] == 2.0);
  CHECK(std::get<double>(number.internal_contact_force) == 5.0);
  const auto& contact = std::get<law::DerivedComponent>(number.contact_force);
  REQUIRE(contact.size() == 2);
  CHECK(contact[1].weight[0] == 0.5);
  const law::FrictionDefinition table = law_of(
      {{kSlotForm,
        "    predefined: {R: 2, internal_contact_force: {columns: [force, accumulated_slip], rows: "
        "[[100, 0], [90, 10]]}}\n"}});
  CHECK(law::depends_on_accumulated_slip(table.internal_contact_force));
}

TEST_CASE("Predefined friction with two checks gives two named definitions") {
  const cases::Case problem = sound(
      "slipbench: 1\nconnector: {type: PLANAR}\n"
      "friction:\n  - name: puck\n    predefined: {R: 0.5}\n    coefficient: 0.2\n"
      "    stick: {elastic_slip: 0.1}\n"
      "history: [{step: a, increments: 1}]\n");
  REQUIRE(problem.definitions.size() == 2);
  CHECK(problem.definitions[0].name != problem.definitions[1].name);
  CHECK(problem.definitions[0].name.starts_with("puck."));
  CHECK(problem.definitions[0].coupled);
  CHECK_FALSE(problem.definitions[1].coupled);
}

TEST_CASE("A universal joint's shares may come from a table") {
  const cases::Case problem = sound(
      "slipbench: 1\nconnector: {type: UJOINT}\n"
      "friction:\n  - predefined:\n      R_p: 0.1\n      L_a: 1\n      hinge_factors:\n"
      "        columns: [k_ax, t_ax, k_tw, t_tw, slenderness]\n"
      "        rows: [[0.4, 0.1, 0.1, 0.35, 0], [0.5, 0, 0.2, 0.45, 20]]\n"
      "    coefficient: 0.2\n    stick: {elastic_slip: 0.1}\n"
      "history: [{step: a, increments: 1}]\n");
  CHECK(problem.definitions.size() == 2);
}

TEST_CASE("Integration options reach every definition") {
  const law::FrictionDefinition plain = law_of({});
  CHECK(plain.accumulated_slip == law::AccumulatedSlipTiming::kEnd);
  CHECK(plain.slip_rate == law::SlipRateMeasure::kSlip);
  const law::FrictionDefinition other =
      law_of({{"history:",
               "integration: {method: backward_euler, accumulated_slip: start, slip_rate: "
               "relative_motion}\nhistory:"}});
  CHECK(other.accumulated_slip == law::AccumulatedSlipTiming::kStart);
  CHECK(other.slip_rate == law::SlipRateMeasure::kRelativeMotion);
}

TEST_CASE("A step has a name, a duration, increments, repetitions and drives") {
  const cases::Case problem = sound(
      changed({{"    increments: 10\n",
                "    increments: 10\n    duration: 2.5\n    repeat: 3\n    temperature: {to: 80}\n"
                "    fields: {field2: 7, field16: {smooth_to: 1}}\n"}}));
  REQUIRE(problem.steps.size() == 1);
  const cases::Step& step = problem.steps[0];
  CHECK(step.name == "press");
  CHECK(step.duration == 2.5);
  CHECK(step.increments == 10);
  CHECK(step.repeat == 3);
  REQUIRE(step.drives.size() == 7);
  const std::vector<int> wanted{cases::kFirstMotion,         cases::kFirstForce + 1,
                                cases::kFirstForce + 2,      cases::kFirstForce + 4,
                                cases::kTemperatureQuantity, cases::kFirstField + 1,
                                cases::kFirstField + 15};
  for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(step.drives[i].quantity == wanted[i]);
  CHECK(std::get<history::Constant>(step.drives[1].profile).value == 300.0);
  CHECK(std::get<history::LinearTo>(step.drives[4].profile).value == 80.0);
  CHECK(sound(kSoundCase).steps[0].duration == 1.0);
  CHECK(sound(kSoundCase).steps[0].repeat == 1);
}

TEST_CASE("Profiles of every kind are read") {
  CHECK(std::get<history::LinearTo>(profile_of("{to: = 2*li}")).value == 1.1);
  CHECK(std::get<history::SmoothTo>(profile_of("{smooth_to: 3}")).value == 3.0);
  const history::Profile expression = profile_of("\"= 0.1*sin(2*pi*t) + T\"");
  CHECK(std::get<history::ExpressionProfile>(expression).expression(std::array{0.0, 4.0}).value() ==
        4.0);
  const auto points = std::get<history::Tabular>(
      profile_of("{columns: [value, t], rows: [[0, 0], [3, 0.5], [1, 1]]}"));
  CHECK(points.times == std::vector<double>{0.0, 0.5, 1.0});
  CHECK(points.values == std::vector<double>{0.0, 3.0, 1.0});
}

TEST_CASE("Waves have a shape, an amplitude, a period or frequency, a mean and a phase") {
  const auto wave = std::get<history::Wave>(
      profile_of("{triangle: {amplitude: 2, frequency: 4, mean: 1, phase: = pi/2}}"));
  CHECK(wave.shape == history::WaveShape::kTriangle);
  CHECK(wave.amplitude == 2.0);
  CHECK(wave.period == 0.25);
  CHECK(wave.mean == 1.0);
  CHECK(wave.phase == Approx(1.5707963267948966).epsilon(1e-15));
  const auto shape = [](const std::string& name) {
    return std::get<history::Wave>(profile_of("{" + name + ": {amplitude: 1, period: 0.5}}"));
  };
  CHECK(shape("sine").shape == history::WaveShape::kSine);
  CHECK(shape("sine").period == 0.5);
  CHECK(shape("sawtooth").shape == history::WaveShape::kSawtooth);
  CHECK(shape("square").shape == history::WaveShape::kSquare);
}

TEST_CASE("A profile may be two columns of a CSV file in their own units") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "ms,disp\n0,0\n1000,1\n");
  const auto csv = std::get<history::CsvColumn>(
      profile_of("{csv: rig.csv, time: ms, time_unit: ms, value: disp, unit: in}", folder.path()));
  CHECK(csv.data.shown_name == "rig.csv");
  CHECK(csv.time_column == "ms");
  CHECK(csv.value_column == "disp");
  // One rounding in the data base's factors.
  CHECK(csv.value_conversion(2.0) == Approx(50.8).epsilon(1e-15));
  CHECK(csv.time_conversion(1000.0) == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("A column of temperatures keeps its origin") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,warm\n0,32\n1,212\n");
  const cases::Case problem =
      sound(changed({{"    increments: 10\n",
                      "    increments: 10\n    temperature: {csv: rig.csv, time: t, value: warm, "
                      "unit: degF}\n"}}),
            {}, folder.path());
  const auto& csv = std::get<history::CsvColumn>(problem.steps[0].drives.back().profile);
  // 32 degF is 0 degC up to the rounding of 32*5/9 - 160/9, about 1e-14.
  CHECK(csv.value_conversion(32.0) == Approx(0.0).margin(1e-12));
  CHECK(csv.value_conversion(212.0) == Approx(100.0).epsilon(1e-13));
}

TEST_CASE("A measured history drives a case, and starts it at its first row") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "ms,disp,load\n0,0.5,10\n1000,1,20\n");
  const std::string text =
      changed({{"- step: press\n    increments: 10\n    motion: {CP1: {to: 0.45}}\n    force: {f2: "
                "300, f3: 400, m2: {to: 55}}\n",
                "csv: rig.csv\n  time: ms\n  unit: ms\n  hold: true\n"
                "  columns: {CP1: disp, f2: {column: load, unit: lbf}}\n"}});
  const cases::Case problem = sound(text, {}, folder.path());
  CHECK(problem.steps.empty());
  REQUIRE(problem.measured.has_value());
  CHECK(problem.measured->data.shown_name == "rig.csv");
  CHECK(problem.measured->time_column == "ms");
  CHECK(problem.measured->time_conversion(1000.0) == Approx(1.0).epsilon(1e-15));
  CHECK(problem.measured->hold);
  REQUIRE(problem.measured->columns.size() == 2);
  CHECK(problem.measured->columns[0].quantity == std::size_t{cases::kFirstMotion});
  CHECK(problem.measured->columns[0].column == "disp");
  CHECK(problem.measured->columns[1].quantity == std::size_t{cases::kFirstForce + 1});
  // The pound-force in newtons as the data base has it, to its printed digits.
  CHECK(problem.measured->columns[1].conversion(1.0) == Approx(4.4482216152605).epsilon(1e-12));
  CHECK(problem.initial[0] == 0.5);
  CHECK(problem.reference[0] == 0.5);
  const cases::Case placed =
      sound(changed({{"CYLINDRICAL\n", "CYLINDRICAL\n  initial: {CP1: 0.25}\n"}}, text), {},
            folder.path());
  CHECK(placed.initial[0] == 0.25);
}

TEST_CASE("Output options reach the case") {
  const cases::Case problem =
      sound(changed({{"checks:", "output: {every: 5, columns: [CSF1, FLIM]}\nchecks:"}}));
  CHECK(problem.output_every == 5);
  CHECK(problem.output_columns == std::vector<std::string>{"CSF1", "FLIM"});
}

TEST_CASE("A check keeps what it compares, where and how closely") {
  const cases::Case problem =
      sound(changed({{"    tolerance: {relative: 1.0e-2, why: rounding}",
                      "    step: press\n    over: {from: 0.25, to: 0.75}\n    criterion: "
                      "pointwise\n    abscissa: "
                      "time\n    tolerance: {absolute: = mu, relative: 1.0e-2, why: rounding}"}}));
  REQUIRE(problem.checks.size() == 1);
  const cases::Check& check = problem.checks[0];
  CHECK(check.name == "limit");
  CHECK(check.quantity_text == "FLIM");
  CHECK(check.variables == std::vector<std::string>{"FLIM"});
  CHECK(check.quantity(std::array{7.0}).value() == 7.0);
  const auto& against = std::get<cases::ExpressionReference>(check.against);
  CHECK(against.variables == std::vector<std::string>{"FN"});
  CHECK(against.expression(std::array{100.0}).value() == 15.0);
  CHECK(check.step == "press");
  CHECK(check.from == 0.25);
  CHECK(check.to == 0.75);
  CHECK(check.tolerance.absolute == 0.15);
  CHECK(check.tolerance.relative == 0.01);
  CHECK(check.tolerance.why == "rounding");
  CHECK(check.where.line == 24);
}

const reference::ClosedForm& form(const std::string& name) {
  const reference::ClosedForm* found = reference::find(name);
  REQUIRE(found != nullptr);
  return *found;
}

cases::ClosedFormReference closed_form_of(const std::string& quantity, const std::string& against) {
  const cases::Case problem = sound(changed(
      {{"quantity: FLIM", "quantity: " + quantity}, {"{expression: \"= mu*FN\"}", against}}));
  return std::get<cases::ClosedFormReference>(problem.checks.at(0).against);
}

TEST_CASE("A closed form finds its inputs and its output by their meaning") {
  const std::string slider =
      "{closed_form: coulomb_slider, with: {mu: = mu, normal_force: 3, stick_stiffness: 100}}";
  const cases::ClosedFormReference force = closed_form_of("CSF1", slider);
  CHECK(force.name == "coulomb_slider");
  CHECK(force.inputs.at(0).variables == std::vector<std::string>{"CU1"});
  CHECK(force.inputs.at(0).expression(std::array{7.0}).value() == 7.0);
  const auto output = [](const cases::ClosedFormReference& reference) {
    return form(reference.name).outputs[static_cast<std::size_t>(reference.output)].name;
  };
  CHECK(output(force) == "force");
  CHECK(force.parameters.at(0) == std::vector<double>{0.15});
  CHECK(output(closed_form_of("CASUC", slider)) == "accumulated_slip");
  CHECK(output(closed_form_of("DISS", slider)) == "dissipation");
  CHECK(output(closed_form_of("STRAIN_E", slider)) == "stored_energy");
  CHECK(output(closed_form_of("WORK", slider)) == "work");
}

TEST_CASE("A closed form takes the inputs and the output it is told, and lists") {
  const cases::ClosedFormReference told = closed_form_of(
      "CSF1",
      "{closed_form: coulomb_slider, with: {mu: 1, normal_force: 3, stick_stiffness: 100}, inputs: "
      "{motion: CUR1}, output: work}");
  CHECK(told.inputs.at(0).variables == std::vector<std::string>{"CUR1"});
  CHECK(form(told.name).outputs[static_cast<std::size_t>(told.output)].name == "work");
  const cases::ClosedFormReference list = closed_form_of(
      "CSF1",
      "{closed_form: parallel_sliders, with: {stick_stiffnesses: [1, = 2*mu], limits: [3, 4]}}");
  CHECK(list.parameters.at(0) == std::vector<double>{1.0, 0.3});
}

TEST_CASE("An input of a closed form may be an expression over t, T, parameters and columns") {
  const cases::ClosedFormReference told = closed_form_of(
      "CSF1",
      "{closed_form: coulomb_slider, with: {mu: 1, normal_force: 3, stick_stiffness: 100}, inputs: "
      "{motion: = CU1 + r*CUR1 - li}}");
  const cases::ExpressionReference& motion = told.inputs.at(0);
  CHECK(motion.variables == std::vector<std::string>{"CU1", "CUR1"});
  CHECK(motion.expression(std::array{1.0, 10.0}).value() == Approx(1.0 + 0.24 * 10.0 - 0.55));
  const cases::ClosedFormReference both_times = closed_form_of(
      "CSF1",
      "{closed_form: coulomb_slider, with: {mu: 1, normal_force: 3, stick_stiffness: 100}, inputs: "
      "{motion: = T - t}}");
  CHECK(both_times.inputs.at(0).expression(std::array{5.0, 2.0}).value() == 3.0);
  CHECK(both_times.inputs.at(0).variables == std::vector<std::string>{"T", "t"});
}

TEST_CASE("A closed form without parameters needs no 'with', and its inputs may be constants") {
  const cases::ClosedFormReference band = closed_form_of(
      "CSF1",
      "{closed_form: capstan_band, inputs: {tension: FN, wrap_angle: = pi}, output: upper_limit}");
  CHECK(band.parameters.empty());
  REQUIRE(band.inputs.size() == 3);
  CHECK(band.inputs[0].variables == std::vector<std::string>{"FN"});
  CHECK(band.inputs[1].variables == std::vector<std::string>{"MU"});  // of the same meaning
  CHECK(band.inputs[2].variables.empty());
  CHECK(band.inputs[2].expression({}).value() == Approx(3.14159265358979324));
}

}  // namespace
}  // namespace slipbench::driver::read
