// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/experiment_model.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/calibrate/varied_case.hpp"
#include "tests/driver/calibrate/fit_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

const std::string kCase =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "parameters: {static: 0.3, ratio: 0.6, speed: 2, k: 500, press: 100, both: = ratio*static}\n"
    "connector: {type: SLOT}\n"
    "friction:\n"
    "  - name: pad\n"
    "    predefined: {internal_contact_force: {columns: [F, accumulated_slip], rows: [[20, 0], "
    "[10, 5]]}}\n"
    "    coefficient: {exponential_decay: {static: = static, kinetic: = both, decay: = 1/speed}}\n"
    "    stick: {stiffness: = 2*k}\n"
    "history:\n"
    "  - {step: a, duration: 1, increments: 60, force: {f2: = press},\n"
    "     motion: {CP1: {sine: {amplitude: 1.5, period: 0.5}}}}\n";

Fit fit_of(const TemporaryFolder& folder, const std::string& compare) {
  folder.write("pad.yaml", kCase);
  std::string data = "t,F\n";
  for (int i = 1; i < 40; ++i) data += fmt::format("{},{}\n", 0.0251 * i, 10 * std::sin(i));
  folder.write("pad.csv", data);
  return sound_fit(folder,
                   "slipbench: 1\n"
                   "calibrate:\n"
                   "  experiments: [{case: pad.yaml, data: pad.csv, time: t, compare: {" +
                       compare +
                       ": F}}]\n"
                       "  vary: {static: {bounds: [0, 1]}, ratio: {bounds: [0, 1]}, speed: "
                       "{bounds: [0.1, 50]}, k: {bounds: [1, 1.0e+5]}}\n"
                       "  tables: {pad.internal_contact_force: {free: F}}\n");
}

ModelOptions options_of(const Fit& fit) {
  ModelOptions options;
  options.ordinates = varied_ordinates(fit);
  for (const VariedParameter& parameter : fit.vary) options.unknowns.push_back(parameter.range);
  options.unknowns.push_back({.start = 20.0, .lower = 0.0});
  options.unknowns.push_back({.start = 10.0, .lower = 0.0});
  return options;
}

ExperimentModel model_of(const Fit& fit, const ModelOptions& options) {
  auto model = ExperimentModel::make(fit, fit.experiments.at(0), options);
  if (!model) FAIL(model.error().message);
  return std::move(*model);
}

/// The largest difference between the derivatives and central differences of the values, as a part
/// of the largest derivative to the same unknown.
double worst_derivative(const ExperimentModel& model, const std::vector<double>& x) {
  const std::size_t n = x.size();
  std::vector<double> values(model.points()), plain(model.points()), below(model.points()),
      above(model.points());
  std::vector<double> jacobian(model.points() * n);
  REQUIRE(model.derivatives(x, values, jacobian));
  REQUIRE(model.values(x, plain));
  CHECK(values == plain);
  double worst = 0.0;
  for (std::size_t u = 0; u < n; ++u) {
    std::vector<double> moved = x;
    const double h = 1e-6 * x[u];
    moved[u] = x[u] - h;
    REQUIRE(model.values(moved, below));
    moved[u] = x[u] + h;
    REQUIRE(model.values(moved, above));
    double largest = 0.0;
    double deviation = 0.0;
    for (std::size_t row = 0; row < model.points(); ++row) {
      const double slope = jacobian[row * n + u];
      largest = std::max(largest, std::abs(slope));
      deviation = std::max(deviation, std::abs(slope - (above[row] - below[row]) / (2.0 * h)));
    }
    CHECK(largest > 0.0);
    worst = std::max(worst, deviation / largest);
  }
  return worst;
}

const std::vector<double> kElsewhere{0.25, 0.7, 3.0, 350.0, 23.0, 9.0};

}  // namespace

TEST_CASE("a varied case is the case with these values, by the friction alone and as a whole") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "CSF1");
  const auto varied = VariedCase::open(fit, fit.experiments[0], varied_ordinates(fit));
  REQUIRE(varied);
  CHECK(varied->unknowns().size() == 6);
  CHECK(varied->parameters() == 4);
  const auto definitions = varied->definitions_at(kElsewhere);
  const auto whole = varied->case_at(kElsewhere);
  REQUIRE(definitions);
  REQUIRE(whole);
  REQUIRE(definitions->size() == 1);
  for (const law::FrictionDefinition* definition :
       {&definitions->front(), &std::as_const(whole->definitions[0].law)}) {
    const auto& decay = std::get<law::ExponentialDecay>(definition->law);
    CHECK(decay.mu_static == 0.25);
    CHECK(decay.kinetic == 0.7 * 0.25);
    CHECK(decay.decay == 1.0 / 3.0);
    CHECK(definition->stick.value == 700.0);
    const auto& table = std::get<law::TableFunction>(definition->internal_contact_force).table();
    CHECK(table.ordinate(0, 0) == 23.0);
    CHECK(table.ordinate(1, 0) == 9.0);
  }
  CHECK(varied->numbers_at(kElsewhere)->at("both") == 0.7 * 0.25);
}

TEST_CASE("values that the reader refuses are no values of a varied case") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "CSF1");
  const auto varied = VariedCase::open(fit, fit.experiments[0], varied_ordinates(fit));
  REQUIRE(varied);
  std::vector<double> x = kElsewhere;
  x[0] = -0.1;
  CHECK_FALSE(varied->definitions_at(x));
  CHECK_FALSE(varied->case_at(x));
}

TEST_CASE("exact derivatives are those of the values, of nonlinear expressions and tables, too") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "CSF1");
  const ExperimentModel model = model_of(fit, options_of(fit));
  CHECK(model.exact().size() == 6);
  CHECK(model.by_differences().empty());
  // Differences of the values are good to 1e-9; no point changes its regime within them.
  CHECK(worst_derivative(model, kElsewhere) < 1e-7);
}

TEST_CASE("a quantity that is linear in its force has exact derivatives") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "\"= 3 - k/100*CSF1 + speed\"");
  const ExperimentModel model = model_of(fit, options_of(fit));
  CHECK(model.exact().size() == 6);
  CHECK(worst_derivative(model, kElsewhere) < 1e-7);
}

TEST_CASE("a quantity that is not has those of whole runs, with the same values") {
  const TemporaryFolder folder;
  const Fit plain = fit_of(folder, "CSF1");
  const Fit squared = fit_of(folder, "= CSF1*CSF1");
  const ExperimentModel one = model_of(plain, options_of(plain));
  const ExperimentModel other = model_of(squared, options_of(squared));
  CHECK(other.exact().empty());
  CHECK(other.by_differences().size() == 6);
  CHECK_FALSE(other.whole_runs_because().empty());
  CHECK(worst_derivative(other, kElsewhere) < 1e-6);
  ModelOptions whole = options_of(plain);
  whole.whole_runs = true;
  const ExperimentModel run = model_of(plain, whole);
  std::vector<double> replayed(one.points()), from_run(run.points());
  REQUIRE(one.values(kElsewhere, replayed));
  REQUIRE(run.values(kElsewhere, from_run));
  CHECK(replayed == from_run);
}

TEST_CASE("a model says where it has no value") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "CSF1");
  const ExperimentModel model = model_of(fit, options_of(fit));
  std::vector<double> x = kElsewhere;
  x[0] = -1.0;
  std::vector<double> values(model.points()), jacobian(model.points() * x.size());
  CHECK_FALSE(model.values(x, values));
  CHECK_FALSE(model.derivatives(x, values, jacobian));
}

TEST_CASE("at a bound derivatives look inwards") {
  const TemporaryFolder folder;
  const Fit fit = fit_of(folder, "CSF1");
  const ExperimentModel model = model_of(fit, options_of(fit));
  std::vector<double> x = kElsewhere;
  x[1] = 0.0;  // below it, the reader refuses the coefficient
  std::vector<double> values(model.points()), jacobian(model.points() * x.size());
  REQUIRE(model.derivatives(x, values, jacobian));
  double largest = 0.0;
  for (std::size_t row = 0; row < model.points(); ++row) {
    largest = std::max(largest, std::abs(jacobian[row * x.size() + 1]));
  }
  CHECK(largest > 0.0);
}

}  // namespace slipbench::driver::calibrate
