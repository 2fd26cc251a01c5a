// SPDX-License-Identifier: Apache-2.0
#include "driver/terminal/progress.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::terminal {
namespace {

TEST_CASE("the line of progress tells how far, what failed and how long it will take") {
  CHECK(progress_text({0, 100, 0}, "cases", 1.0) == "[>                   ] 0 of 100 cases");
  CHECK(progress_text({50, 100, 2}, "cases", 3.0) ==
        "[==========>         ] 50 of 100 cases, 2 failed, 3 s left");
  CHECK(progress_text({100, 100, 0}, "cases", 3.0) == "[====================] 100 of 100 cases");
  CHECK(progress_text({1, 101, 0}, "cases", 6.0) ==
        "[>                   ] 1 of 101 cases, 10 min left");
  CHECK(progress_text({1, 10001, 0}, "cases", 1.0) ==
        "[>                   ] 1 of 10001 cases, 2.8 h left");
  CHECK(progress_text({0, 0, 0}, "cases", 1.0) == "[>                   ] 0 of 0 cases");
}

TEST_CASE("the line is cut to what the terminal can take back, by letters") {
  CHECK(fitting("[==>] 3 of 9 cases", 80) == "[==>] 3 of 9 cases");
  CHECK(fitting("[==>] 3 of 9 cases", 10) == "[==>] 3 o");
  CHECK(fitting("größe", 4) == "grö");
  CHECK(fitting("any length", 0) == "any length");
  CHECK(fitting("\x1B[2Jcase", 80) == "\xEF\xBF\xBD[2Jcase");
}

}  // namespace
}  // namespace slipbench::driver::terminal
