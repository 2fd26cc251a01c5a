// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.hpp"

#include <catch2/catch.hpp>

namespace slipbench::architecture {
namespace {

std::vector<Violation> violations_of(const std::string& path, const std::string& include) {
  return include_violations({path, "#pragma once\n#include " + include + "\n"});
}

bool allowed(const std::string& path, const std::string& include) {
  return violations_of(path, include).empty();
}

TEST_CASE("a law that includes a closed form is found, with its line") {
  const auto found = violations_of("law/table/table.hpp", "\"reference/masing.hpp\"");
  REQUIRE(found.size() == 1);
  CHECK(found[0].path == "law/table/table.hpp");
  CHECK(found[0].line == 2);
  CHECK(
      to_string(found[0]) ==
      "law/table/table.hpp:2: reference/masing.hpp: this room knows the standard library, law/ and "
      "Eigen only");
}

TEST_CASE("the law knows itself, Eigen and the standard library") {
  CHECK(allowed("law/table/table.cpp", "\"law/table/table.hpp\""));
  CHECK(allowed("law/table/table.cpp", "<Eigen/Core>"));
  CHECK(allowed("law/table/table.cpp", "<cmath>"));
  CHECK_FALSE(allowed("law/table/table.cpp", "\"driver/bench/simulation.hpp\""));
  CHECK_FALSE(allowed("law/table/table.cpp", "<fmt/format.h>"));
  CHECK_FALSE(allowed("law/table/table.cpp", "<gsl/gsl_math.h>"));
  CHECK_FALSE(allowed("law/table/table.cpp", "<yaml-cpp/yaml.h>"));
  CHECK_FALSE(allowed("law/table/table.cpp", "<math.h>"));
}

TEST_CASE("a closed form knows itself and the standard library") {
  CHECK(allowed("reference/masing.hpp", "\"reference/wear.hpp\""));
  CHECK(allowed("reference/masing.hpp", "<vector>"));
  CHECK_FALSE(allowed("reference/masing.hpp", "\"law/table/table.hpp\""));
  CHECK_FALSE(allowed("reference/masing.hpp", "<Eigen/Core>"));
}

TEST_CASE("the driver knows both rooms and its third parties, each at its place") {
  CHECK(allowed("driver/bench/simulation.cpp", "\"law/table/table.hpp\""));
  CHECK(allowed("driver/bench/simulation.cpp", "\"reference/catalogue.hpp\""));
  CHECK(allowed("driver/bench/simulation.hpp", "<tl/expected.hpp>"));
  CHECK(allowed("driver/bench/simulation.hpp", "<fmt/format.h>"));
  CHECK(allowed("driver/bench/simulation.cpp", "<gsl/gsl_math.h>"));
  CHECK_FALSE(allowed("driver/bench/simulation.hpp", "<gsl/gsl_math.h>"));
  CHECK(allowed("driver/bench/equilibrium.cpp", "<Eigen/LU>"));
  CHECK_FALSE(allowed("driver/bench/simulation.cpp", "<boost/asio.hpp>"));
  CHECK_FALSE(allowed("driver/bench/simulation.cpp", "\"tests/support/files.hpp\""));

  CHECK(allowed("driver/yaml/parse.cpp", "<yaml-cpp/eventhandler.h>"));
  CHECK_FALSE(allowed("driver/yaml/node.hpp", "<yaml-cpp/yaml.h>"));
  CHECK_FALSE(allowed("driver/read/read_case.cpp", "<yaml-cpp/yaml.h>"));

  CHECK(allowed("driver/cli/main.cpp", "<CLI/CLI.hpp>"));
  CHECK(allowed("driver/cli/run.cpp", "<CLI/CLI.hpp>"));
  CHECK_FALSE(allowed("driver/cli/declare.hpp", "<CLI/CLI.hpp>"));
  CHECK_FALSE(allowed("driver/commands/run.cpp", "<CLI/CLI.hpp>"));

  CHECK(allowed("driver/base/units/expression.cpp", "<muParser.h>"));
  CHECK_FALSE(allowed("driver/base/units/expression.hpp", "<muParser.h>"));
  CHECK_FALSE(allowed("driver/history/profile.cpp", "<muParser.h>"));

  CHECK(allowed("driver/base/units/units.cpp", "<udunits2.h>"));
  CHECK_FALSE(allowed("driver/base/units/units.hpp", "<udunits2.h>"));
}

TEST_CASE("tests see the rooms of what they test") {
  CHECK(allowed("tests/law/table/table_test.cpp", "\"reference/masing.hpp\""));
  CHECK_FALSE(allowed("tests/law/table/table_test.cpp", "\"driver/bench/simulation.hpp\""));
  CHECK(allowed("tests/reference/masing_test.cpp", "<catch2/catch.hpp>"));
  CHECK_FALSE(allowed("tests/reference/masing_test.cpp", "\"law/table/table.hpp\""));
  CHECK(allowed("tests/property/twin_test.cpp", "<rapidcheck.h>"));
  CHECK_FALSE(allowed("tests/driver/yaml/parse_test.cpp", "<yaml-cpp/yaml.h>"));
  CHECK(allowed("bench/yaml.cpp", "<yaml-cpp/yaml.h>"));
}

TEST_CASE("project headers are written from the root and in quotes") {
  CHECK_FALSE(allowed("law/table/table.cpp", "\"table.hpp\""));
  CHECK_FALSE(allowed("law/table/table.cpp", "<law/table/table.hpp>"));
  CHECK_FALSE(allowed("driver/bench/simulation.cpp", "\"fmt/format.h\""));
}

TEST_CASE("an include in a comment counts for nothing, one with odd blanks counts") {
  CHECK(include_violations({"law/a.hpp", "// #include <fmt/format.h>\n"}).empty());
  CHECK(include_violations({"law/a.hpp", "/*\n#include <fmt/format.h>\n*/\n"}).empty());
  CHECK(include_violations({"law/a.hpp", "  #  include\t<fmt/format.h>\n"}).size() == 1);
  CHECK(include_violations({"docs/a.md", "#include <fmt/format.h>\n"}).empty());
}

}  // namespace
}  // namespace slipbench::architecture
