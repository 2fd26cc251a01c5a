// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/json.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace slipbench::driver::base::json {
namespace {

TEST_CASE("members keep their order and numbers are the shortest that read back") {
  Value value;
  value["b"] = 0.1;
  value["a"] = 3;
  value["c"] = true;
  value["d"] = nullptr;
  value["b"] = 1e300;
  CHECK(value.dump() == R"({"b": 1e+300, "a": 3, "c": true, "d": null})");
}

TEST_CASE("nested values are indented, empty ones stay together") {
  Value value;
  value["list"] = Array{1, "two", Object{}};
  value["none"] = Array{};
  CHECK(value.dump(2) == "{\n  \"list\": [\n    1,\n    \"two\",\n    {}\n  ],\n  \"none\": []\n}");
}

TEST_CASE("strings are escaped, and bytes that are no UTF-8 are replaced") {
  CHECK(Value("a\"\\\n\t\x01 \xC2\xB5").dump() == "\"a\\\"\\\\\\n\\t\\u0001 \xC2\xB5\"");
  CHECK(Value("\xFF").dump() == "\"\xEF\xBF\xBD\"");
}

TEST_CASE("what JSON has no number for is null") {
  CHECK(Value(std::numeric_limits<double>::infinity()).dump() == "null");
  CHECK(Value(std::numeric_limits<double>::quiet_NaN()).dump() == "null");
}

}  // namespace
}  // namespace slipbench::driver::base::json
