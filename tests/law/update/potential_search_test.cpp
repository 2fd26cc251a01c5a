// SPDX-License-Identifier: Apache-2.0
#include "law/update/potential_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace slipbench::law;

/// A limit that grows by e over 1/rate, counting how often it is asked for.
struct SteepLimit {
  double rate;
  int* calls;
  Limit operator()(double slip) const noexcept {
    ++*calls;
    const double force = std::exp(rate * (slip - 0.97));
    return {.force = force, .to_slip = rate * force};
  }
  double slope(const Limit& limit) const noexcept { return limit.to_slip; }
};

TEST_CASE("the search halves its bracket where Newton's method would creep") {
  Potential line;
  line.parts = line.leaves = 1;
  line.leaf[0].direction[0] = 1.0;
  int calls = 0;
  const SteepLimit limit{2e4, &calls};
  const Start<SteepLimit> start{line, limit, {10.0}, 1.0, 0.0, true, false};
  const double slip = bracketed(start, 0.96, 1.0, 0.9999);
  // exp(rate (x - 0.97)) + x = 10, where Newton's method alone goes a part of 1/rate a step.
  CHECK(limit(slip).force + slip == Approx(10.0).epsilon(1e-10));
  CHECK(calls < 100);
}

}  // namespace
