// SPDX-License-Identifier: Apache-2.0
#include "reference/capstan_chain.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::capstan_chain;
using std::numbers::pi;

namespace {

constexpr double kAngles[] = {30.0 / 180.0 * pi, 0.5 * pi, 60.0 / 180.0 * pi};
const std::vector<std::vector<double>> kChain{{0.15, 0.15, 0.15},
                                              {kAngles[0], kAngles[1], kAngles[2]}};

}  // namespace

TEST_CASE("a chain of guides has the printed tensions") {
  const std::vector<Guide> guides{{0.15, kAngles[0]}, {0.15, kAngles[1]}, {0.15, kAngles[2]}};
  const auto falling = tensions(guides, 100.0, -1.0);
  CHECK_THAT(falling[0], printed("92.4465250376256"));
  CHECK_THAT(falling[1], printed("73.0402691048646"));
  CHECK_THAT(falling[2], printed("62.422843364857"));
  // Back up the chain: the same ratios.
  const auto rising = tensions(guides, falling[2], 1.0);
  CHECK(rising[2] == Approx(100.0).epsilon(1e-14));
}

TEST_CASE("a chain of guides is one guide of the summed angle") {
  const auto row = evaluate(kForm, kChain, {{100.0}}).back();
  CHECK_THAT(row[3], printed("62.422843364857"));
  CHECK(row[1] == Approx(62.422843364857 - 100.0).epsilon(1e-13));
  const auto one = evaluate(kForm, {{0.15}, {pi}}, {{100.0}}).back();
  for (std::size_t i = 0; i < row.size(); ++i) CHECK(row[i] == Approx(one[i]).epsilon(1e-14));
  CHECK(evaluate(kForm, kChain, {{-5.0}}).back()[2] == -5.0);
}

TEST_CASE("a chain needs a coefficient and an angle for every guide") {
  const auto broken = kForm.violation(std::vector<std::vector<double>>{{0.1, 0.2}, {1.0}});
  REQUIRE(broken.has_value());
  CHECK(broken->find("2 entries") != std::string::npos);
}
