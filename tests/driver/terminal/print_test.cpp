// SPDX-License-Identifier: Apache-2.0
#include "driver/terminal/print.hpp"

#include <catch2/catch.hpp>
#include <chrono>

namespace slipbench::driver::terminal {
namespace {

TEST_CASE("A time has two digits of a millisecond up to a tenth of a second") {
  using std::chrono::microseconds;
  CHECK(elapsed_text(microseconds(1234)) == "1.2 ms");
  CHECK(elapsed_text(microseconds(99400)) == "99 ms");
  CHECK(elapsed_text(microseconds(99600)) == "0.10 s");
  CHECK(elapsed_text(microseconds(1500000)) == "1.50 s");
}

}  // namespace
}  // namespace slipbench::driver::terminal
