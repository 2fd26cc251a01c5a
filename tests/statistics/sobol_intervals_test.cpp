// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "tests/driver/sweep/sobol_product.hpp"

namespace slipbench::driver::sweep {
namespace {

TEST_CASE("Intervals of Sobol' indices hold the true ones as often as they say") {
  const Product product;
  int held = 0;
  int all = 0;
  double width = 0.0;
  constexpr int kSeeds = 20;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const ReadSweep read = product.read(256, "random", seed);
    REQUIRE(read.value.has_value());
    const SobolEstimate found = estimate(*read.value);
    const std::vector<SobolIndices> both = found.indices(0);
    for (std::size_t p = 0; p < 2; ++p) {
      const SobolIndices& indices = both[p];
      held += indices.first.low <= kFirst[p] && kFirst[p] <= indices.first.high ? 1 : 0;
      held += indices.total.low <= kTotal[p] && kTotal[p] <= indices.total.high ? 1 : 0;
      width += indices.first.high - indices.first.low;
      all += 2;
    }
  }
  // 95 % of 80, of which some are of the same sweep; far from always, which would be too wide.
  CHECK(held >= 0.88 * all);
  CHECK(held < all);
  const ReadSweep more = product.read(4096, "random");
  const SobolEstimate narrow = estimate(more.value.value());
  const VariancePart one = narrow.indices(0)[0].first;
  CHECK(one.high - one.low == Approx(width / (2.0 * kSeeds) / 4.0).epsilon(0.35));
}

}  // namespace
}  // namespace slipbench::driver::sweep
