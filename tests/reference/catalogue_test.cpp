// SPDX-License-Identifier: Apache-2.0
#include "reference/catalogue.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace slipbench::reference;

namespace {

/// Admissible values: the default, else a number inside the bounds; for a few closed forms with
/// rules between parameters, values that keep them.
std::vector<std::vector<double>> admissible_values(const ClosedForm& form) {
  static const std::map<std::string_view, std::vector<std::vector<double>>> kRules{
      {"linear_wear", {{0.2}, {1000.0}, {100.0}, {50.0}}},
      {"wear_table", {{0.0, 1.0}, {20.0, 120.0}, {4.0, 3.0, 2.0, 1.0}}},
      {"exponential_decay_test_data", {{0.3}, {0.23}, {20.0}, {0.2}}},
      {"static_kinetic_sawtooth", {{0.3}, {0.2}, {0.05}, {100.0}, {1000.0}}},
      {"planar_slider_circle", {{0.2}, {100.0}, {1000.0}, {0.05}}},
      {"planar_slider_circle_increments", {{0.2}, {100.0}, {1000.0}, {0.05}, {36.0}}},
      {"contact_force_varying_overlap", {{3.0}, {0.0, 2.0}, {0.7, 2.0}, {0.0}, {0.0}}},
      {"renard_coefficient", {{0.15}, {0.1}, {0.25}, {0.05}, {0.5}, {1.2}, {1.0}}}};
  if (const auto rule = kRules.find(form.name); rule != kRules.end()) return rule->second;
  std::vector<std::vector<double>> values;
  for (const Parameter& parameter : form.parameters) {
    const double inside =
        std::isfinite(parameter.lower) ? std::min(parameter.lower + 0.5, parameter.upper) : 0.5;
    const double value = parameter.default_value.value_or(inside);
    values.emplace_back(parameter.list ? 2 : 1, value);
  }
  return values;
}

}  // namespace

TEST_CASE("every closed form is found by its name, once") {
  std::set<std::string_view> names;
  for (const ClosedForm& form : catalogue()) {
    CHECK(names.insert(form.name).second);
    CHECK(find(form.name) == &form);
  }
  CHECK(names.size() == catalogue().size());
  CHECK(find("coulomb") == nullptr);
}

TEST_CASE("every closed form says what it is, where it comes from and when it holds") {
  const std::set<std::string_view> dimensions{
      "1",         "F",           "L",       "F/L",   "F L",         "1/L",     "T",      "L/T",
      "F L T^2",   "T/L",         "F T^2/L", "F T/L", "F/L^(2+chi)", "1/T",     "F/L^2",  "F L/T",
      "F T^2/L^2", "(F/L)^(1-n)", "L^2",     "L^2/F", "L T/F",       "L^4/F^2", "T^2/L^2"};
  for (const ClosedForm& form : catalogue()) {
    CAPTURE(std::string(form.name));
    CHECK_FALSE(form.title.empty());
    CHECK_FALSE(form.formula.empty());
    CHECK_FALSE(form.source.empty());
    CHECK_FALSE(form.range.empty());
    CHECK_FALSE(form.inputs.empty());
    CHECK_FALSE(form.outputs.empty());
    std::set<std::string_view> names;
    for (const Parameter& parameter : form.parameters) {
      CHECK(names.insert(parameter.name).second);
      CHECK(dimensions.count(parameter.dimension) == 1);
      CHECK_FALSE(parameter.text.empty());
      CHECK(parameter.lower < parameter.upper);
      if (parameter.default_value) CHECK(*parameter.default_value >= parameter.lower);
    }
    for (const auto signals : {form.inputs, form.outputs}) {
      for (const Signal& signal : signals) {
        CHECK(dimensions.count(signal.dimension) == 1);
        CHECK_FALSE(signal.text.empty());
      }
    }
  }
}

TEST_CASE("every closed form evaluates, repeats itself and keeps evaluators apart") {
  for (const ClosedForm& form : catalogue()) {
    CAPTURE(std::string(form.name));
    const auto values = admissible_values(form);
    REQUIRE_FALSE(form.violation(values).has_value());
    const auto first = form.make(values);
    const auto second = form.make(values);
    std::vector<std::vector<double>> results;
    for (const auto& evaluator : {first, second}) {
      std::vector<double> row(form.outputs.size());
      for (int i = 0; i < 5; ++i) {
        // Positive throughout, for a normal force may be among the inputs.
        std::vector<double> inputs(form.inputs.size(), 1.0 + 0.5 * std::sin(2.0 * i));
        for (std::size_t j = 0; j < inputs.size(); ++j) {
          const auto name = form.inputs[j].name;
          if (name == "time") inputs[j] = 0.7 * i;
        }
        row.assign(row.size(), std::numeric_limits<double>::quiet_NaN());
        evaluator(inputs, row);
        for (const double value : row) CHECK(std::isfinite(value));
      }
      results.push_back(row);
    }
    CHECK(results[0] == results[1]);
  }
}
