// SPDX-License-Identifier: Apache-2.0
// Exact integration at one tolerance against itself at another: where both numbers of the
// difference test go the same wrong way, their results still depend on the tolerance, or on
// nothing.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <span>

#include "law/exact/continuous_update.hpp"
#include "tests/difference/any_case.hpp"
#include "tests/difference/law_increment.hpp"
#include "tests/difference/one_step.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::test;

/// An increment of a seed that went wrong.
struct Found {
  std::uint64_t seed;
  int increment;
};

TEST_CASE("exact results do not depend on the tolerance beyond it") {
  // A coefficient on its floor at rest, or that comes to it, which was taken for a limit that is
  // gone.
  for (const Found& found : {Found{30270401003985, 2}, Found{30270401005265, 12}}) {
    CAPTURE(found.seed, found.increment);
    AnyCase any = any_case(found.seed, Way::kExact);
    PlainState<double> state;
    for (int i = 0; i + 1 < found.increment; ++i) {
      any.increments[static_cast<std::size_t>(i)].old = state;
      state =
          one_step<double>(Way::kExact, any.definition, any.increments[static_cast<std::size_t>(i)])
              .state;
    }
    const auto& from = any.increments[static_cast<std::size_t>(found.increment - 1)];
    std::span<const double> packed(any.definition);
    const auto definition = law::unpack(packed);
    REQUIRE(definition);
    law::PathSegment segment = law::path_segment(*definition, law_increment(from),
                                                 ambient(from.begin), {from.begin.force});
    segment.begin_blend.weight = from.begin_blend;
    segment.begin_stick = from.begin_stick;
    segment.begin_wrap_angle = from.begin_wrap_angle;
    const law::FrictionState old{state.elastic_slip, state.force, state.accumulated_slip,
                                 static_cast<law::Regime>(state.regime)};
    const auto fine = law::continuous_update(*definition, segment, old, 1e-11);
    CHECK(fine.converged);
    for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-10}) {
      const auto coarse = law::continuous_update(*definition, segment, old, tolerance);
      CHECK(coarse.converged);
      // Some dozens of pieces keep it each.
      CHECK(coarse.slip_increment ==
            Approx(fine.slip_increment).epsilon(std::max(30.0 * tolerance, 1e-8)));
    }
  }
}

}  // namespace
