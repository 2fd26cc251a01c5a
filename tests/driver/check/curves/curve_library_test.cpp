// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/curve_library.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "driver/base/csv/csv_reader.hpp"

namespace slipbench::driver::check {
namespace {

TEST_CASE("every shipped curve can be read and says in a sentence what it is") {
  const auto curves = shipped_curves();
  REQUIRE(curves.size() >= 10);
  CHECK(std::is_sorted(curves.begin(), curves.end(),
                       [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const ShippedCurve& curve : curves) {
    INFO(curve.name);
    CHECK(is_curve_name(curve.name));
    CHECK(find_shipped_curve(curve.name) == curve.file);
    CHECK(base::CsvReader::open(curve.file, {}));
    CHECK_FALSE(curve.text.empty());
    CHECK(curve.text.front() != '#');
    CHECK(curve_description(curve.name).find(curve.text) != std::string::npos);
  }
}

TEST_CASE("a file is no name, and a name that no curve has finds none") {
  CHECK_FALSE(is_curve_name("a.csv"));
  CHECK_FALSE(is_curve_name("golden/a"));
  CHECK_FALSE(is_curve_name(""));
  CHECK_FALSE(find_shipped_curve("no_such_curve"));
  CHECK_FALSE(find_shipped_curve("../curves/dahl_loop"));
  CHECK(curve_description("no_such_curve").empty());
}

}  // namespace
}  // namespace slipbench::driver::check
