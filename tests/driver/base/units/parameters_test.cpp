// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/parameters.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

namespace slipbench::driver::base {
namespace {

using Parameters = std::vector<ParameterText>;

std::vector<ParameterError> errors_of(const Parameters& parameters,
                                      const Parameters& overrides = {}) {
  return resolve_parameters(parameters, overrides).errors;
}

TEST_CASE("parameters may use each other in any order") {
  const ResolvedParameters resolved = resolve_parameters(
      Parameters{{"c", "= a + b"}, {"a", 2.0}, {"b", "= 3*a"}, {"angle", "= pi/2"}});
  REQUIRE(resolved.errors.empty());
  CHECK(resolved.values.at("c") == 8.0);
  CHECK(resolved.values.at("b") == 6.0);
  CHECK(resolved.values.at("angle") == 1.5707963267948966);
  CHECK(resolved.values.size() == 4);
}

TEST_CASE("an override replaces a parameter and everything that follows from it") {
  const Parameters parameters = {{"mu", "= 1/0"}, {"limit", "= 100*mu"}};
  const ResolvedParameters resolved = resolve_parameters(parameters, Parameters{{"mu", 0.5}});
  REQUIRE(resolved.errors.empty());
  CHECK(resolved.values.at("limit") == 50.0);
  const ResolvedParameters twice =
      resolve_parameters(parameters, Parameters{{"mu", 0.5}, {"mu", "= 2*0.1"}});
  REQUIRE(twice.errors.empty());
  CHECK(twice.values.at("limit") == 20.0);
}

TEST_CASE("an override of an unknown parameter is an error") {
  const auto errors = errors_of({{"mu", 0.1}}, {{"mu", 0.2}, {"nu", 0.3}});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].in_override);
  CHECK(errors[0].index == 1);
  CHECK(errors[0].concerns_name);
  CHECK(errors[0].error.unknown_name == "nu");
}

TEST_CASE("parameters that define each other are reported once, with the circle") {
  const auto errors = errors_of({{"x", "= a"}, {"a", "= b + 1"}, {"b", "= c"}, {"c", "= 2*a"}});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].index == 1);
  CHECK(errors[0].error.message == "parameters define each other: a -> b -> c -> a");
  const auto itself = errors_of({{"a", "= a"}});
  REQUIRE(itself.size() == 1);
  CHECK(itself[0].error.message == "parameters define each other: a -> a");
}

TEST_CASE("every faulty parameter is reported, its users are not") {
  const auto errors = errors_of({{"a", "= 1 + unknown"},
                                 {"b", "= a"},
                                 {"c", "= 2 +"},
                                 {"d", "= 1/zero"},
                                 {"zero", 0.0},
                                 {"e", "= d + b + c"}});
  REQUIRE(errors.size() == 3);
  CHECK(errors[0].index == 0);
  CHECK(errors[0].error.unknown_name == "unknown");
  CHECK(errors[0].error.offset == 6);
  CHECK_FALSE(errors[0].concerns_name);
  CHECK(errors[1].index == 2);
  CHECK(errors[2].index == 3);
  CHECK(errors[2].error.message == "1/zero divides by zero at zero = 0");
}

TEST_CASE("parameters have their values beside faulty ones that they do not use") {
  const ResolvedParameters resolved = resolve_parameters(Parameters{{"a", "= 1 + unknown"},
                                                                    {"b", "= c"},
                                                                    {"c", "= a"},
                                                                    {"d", "= 2*e"},
                                                                    {"e", 3.0},
                                                                    {"no name", 1.0},
                                                                    {"x", "= y"},
                                                                    {"y", "= x"},
                                                                    {"z", "= y + e"},
                                                                    {"twice", 1.0},
                                                                    {"twice", 2.0},
                                                                    {"w", "= twice"}});
  CHECK(resolved.errors.size() == 4);
  CHECK(resolved.values == NamedNumbers{{"d", 6.0}, {"e", 3.0}});
}

TEST_CASE("a parameter's name must be free and an identifier") {
  for (const char* name : {"pi", "t", "T", "sin", "2a", "a b", "", "a.b"}) {
    const auto errors = errors_of({{name, 1.0}, {"user", "= 2"}});
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].concerns_name);
    CHECK(errors[0].index == 0);
  }
  const auto twice = errors_of({{"a", 1.0}, {"a", 2.0}});
  REQUIRE(twice.size() == 1);
  CHECK(twice[0].index == 1);
  CHECK(twice[0].error.message == "parameter 'a' is defined twice");
}

TEST_CASE("a parameter cannot use the time") {
  const auto errors = errors_of({{"a", "= 2*t"}});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].error.unknown_name == "t");
}

TEST_CASE("a parameter that is not finite is an error") {
  const auto errors = errors_of({{"a", std::numeric_limits<double>::infinity()}});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].index == 0);
}

TEST_CASE("a long chain of parameters is resolved") {
  constexpr int kLength = 300;
  Parameters parameters;
  for (int i = 0; i < kLength; ++i) {
    parameters.push_back({"p" + std::to_string(i), "= 1 + p" + std::to_string(i + 1)});
  }
  parameters.push_back({"p" + std::to_string(kLength), 0.0});
  const ResolvedParameters resolved = resolve_parameters(parameters);
  REQUIRE(resolved.errors.empty());
  CHECK(resolved.values.at("p0") == 300.0);
}

}  // namespace
}  // namespace slipbench::driver::base
