// SPDX-License-Identifier: Apache-2.0
#include "reference/catalogue.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace slipbench::reference;

namespace {

/// Admissible values: the default, else a number inside the bounds.
std::vector<std::vector<double>> admissible_values(const ClosedForm& form) {
  std::vector<std::vector<double>> values;
  for (const Parameter& parameter : form.parameters) {
    const double value = parameter.default_value.value_or(parameter.lower + 0.5);
    values.push_back(std::vector<double>(parameter.list ? 2 : 1, value));
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
  CHECK(names.size() == 13);
  CHECK(find("coulomb") == nullptr);
}

TEST_CASE("every closed form says what it is, where it comes from and when it holds") {
  const std::set<std::string_view> dimensions{"1", "F", "L", "F/L", "F L"};
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
        row.assign(row.size(), std::numeric_limits<double>::quiet_NaN());
        evaluator(inputs, row);
        for (const double value : row) CHECK(std::isfinite(value));
      }
      results.push_back(row);
    }
    CHECK(results[0] == results[1]);
  }
}
