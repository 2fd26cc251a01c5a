// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/floors.hpp"

#include <catch2/catch.hpp>

namespace slipbench::architecture {
namespace {

std::string violations_of(const std::string& path, const std::string& include) {
  return to_string(floor_violations({path, "#pragma once\n#include " + include + "\n"}));
}

TEST_CASE("an include upwards is found, with its line") {
  CHECK(violations_of("driver/base/text/number.hpp", "\"driver/read/read_case.hpp\"") ==
        "driver/base/text/number.hpp:2: driver/read/read_case.hpp: stands above driver/base/text, "
        "which knows the rooms below it only\n");
  CHECK(violations_of("law/table/table.cpp", "\"law/update/connector.hpp\"") != "");
  CHECK(violations_of("driver/read/keys/a.hpp", "\"driver/read/a.hpp\"") != "");
  CHECK(violations_of("driver/calibrate/fit/search.cpp", "\"driver/case/case.hpp\"") != "");
}

TEST_CASE("a room knows itself and those below it") {
  CHECK(violations_of("driver/read/a.hpp", "\"driver/read/b.hpp\"") == "");
  CHECK(violations_of("driver/read/a.hpp", "\"driver/read/keys/b.hpp\"") == "");
  CHECK(violations_of("driver/bench/a.hpp", "\"law/update/connector.hpp\"") == "");
  CHECK(violations_of("driver/bench/a.hpp", "\"reference/catalogue.hpp\"") == "");
  CHECK(violations_of("driver/bench/a.hpp", "<vector>") == "");
  CHECK(violations_of("tests/support/a.hpp", "\"driver/cli/declare.hpp\"") == "");
}

TEST_CASE("a file in no room is found, and one that includes such a file") {
  CHECK(violations_of("driver/main.cpp", "<vector>") ==
        "driver/main.cpp:0: stands in no room of tests/architecture/floors.cpp\n");
  CHECK(violations_of("law/friction/new_folder/a.hpp", "<vector>") != "");
  CHECK(violations_of("driver/cli/main.cpp", "\"driver/a.hpp\"") != "");
}

TEST_CASE("a file opens the namespace of its room, or of one below it") {
  const auto violations = [](const std::string& path, const std::string& name) {
    return to_string(namespace_violations({path, "#pragma once\nnamespace " + name + " {\n}\n"}));
  };
  CHECK(violations("driver/check/a.hpp", "slipbench::driver::check") == "");
  CHECK(violations("driver/check/criteria/a.hpp", "slipbench::driver::check") == "");
  CHECK(violations("driver/check/a.hpp", "slipbench::driver::yaml") == "");
  CHECK(violations("driver/base/text/json.hpp", "slipbench::driver::base::json") == "");
  CHECK(violations("law/update/a.hpp", "slipbench::law") == "");
  CHECK(violations("driver/check/a.hpp", "slipbench::driver::report") ==
        "driver/check/a.hpp:2: namespace slipbench::driver::report is neither that of the room, "
        "slipbench::driver::check, nor of one below it\n");
  CHECK(violations("driver/check/a.hpp", "slipbench::driver") != "");
  CHECK(violations("driver/check/a.hpp", "slipbench::driver::checks") != "");
}

}  // namespace
}  // namespace slipbench::architecture
