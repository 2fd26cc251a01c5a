// SPDX-License-Identifier: Apache-2.0
#include "driver/report/json_text.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <limits>

namespace slipbench::driver::report {
namespace {

TEST_CASE("brackets, members and items are separated as JSON wants it") {
  JsonText json;
  json.begin_object();
  json.member("a", true);
  json.key("b");
  json.begin_array();
  json.begin_object();
  json.end_object();
  json.value("x");
  json.null();
  json.end_array();
  json.member_if("left out", "");
  json.member("c", std::int64_t{12345678901});
  json.end_object();
  CHECK(json.take() == R"({"a":true,"b":[{},"x",null],"c":12345678901})");
}

TEST_CASE("numbers have ten digits, a series as many as it needs, what is not finite is null") {
  JsonText json;
  json.begin_array();
  json.value(0.1 + 0.2);
  json.value(1000.0000123456);
  json.value(-123456.789, 6);
  json.series(std::array{0.1 + 0.2, -123456.789, 1e-30, 2.0, -0.0,
                         std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()});
  json.series(std::array{1000.0, 1000.00123, 1000.00246});
  json.end_array();
  CHECK(json.take() ==
        "[0.3,1000.000012,-123457,[0.3,-123457,1e-30,2,-0,null,null],"
        "[1000,1000.00123,1000.00246]]");
}

TEST_CASE("no text ends a script element, breaks a line of JavaScript or is no UTF-8") {
  JsonText json;
  json.begin_array();
  json.value("</script><!-- \"a\\b\"");
  json.value("\xE2\x80\xA8 and \xE2\x80\xA9 but \xE2\x82\xAC");
  json.value("\xFF");
  json.value(std::string_view("\0\x1F", 2));
  json.end_array();
  CHECK(json.take() ==
        "[\"\\u003c/script>\\u003c!-- \\\"a\\\\b\\\"\",\"\\u2028 and \\u2029 but \xE2\x82\xAC\","
        "\"\xEF\xBF\xBD\",\"\\u0000\\u001f\"]");
}

}  // namespace
}  // namespace slipbench::driver::report
