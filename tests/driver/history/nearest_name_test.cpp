// SPDX-License-Identifier: Apache-2.0
#include "driver/history/nearest_name.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace slipbench::driver {
namespace {

TEST_CASE("the nearest name is the one with the fewest changes") {
  const std::vector<std::string> names = {"time", "disp", "force", "displacement"};
  CHECK(nearest_name("dips", names) == "disp");
  CHECK(nearest_name("Force", names) == "force");
  CHECK(nearest_name("tme", names) == "time");
  CHECK(nearest_name("displacment", names) == "displacement");
}

TEST_CASE("a name far from all others has no nearest one") {
  const std::vector<std::string> names = {"time", "disp"};
  CHECK(nearest_name("temperature", names).empty());
  CHECK(nearest_name("", names).empty());
  CHECK(nearest_name(std::string(100000, 'x'), names).empty());
  CHECK(nearest_name("a", std::vector<std::string>{"b"}).empty());
  CHECK(nearest_name("a", {}).empty());
}

}  // namespace
}  // namespace slipbench::driver
