// SPDX-License-Identifier: Apache-2.0
// The play of a dead zone against what a play is, in long double, at any magnitude.
#include "driver/bench/dead_zone.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/dice.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::driver;
using Long = long double;

/// Places of a play, counted from where its outer part began the increment. The inner part rests
/// where the spring behind it is relaxed, but stays within the gap: an edge that comes to it takes
/// it along.
struct Play {
  Long outer, inner;

  static Play begin(double play) { return {0.0L, -Long{play}}; }
  Play after(double motion, Long relaxed, Long half) const {
    return {outer + motion, std::clamp(relaxed, outer + motion - half, outer + motion + half)};
  }
};

TEST_CASE("the play is that of an inner part that stays within the gap and moves with its edges") {
  constexpr std::int64_t kIncrements = 1000000;
  // Rounding of double dominates, half an epsilon of the numbers that are added each time: two sums
  // make the extension, two differences the motion that is left of it.
  constexpr Long kRounding = 2.0L * std::numeric_limits<double>::epsilon();
  std::int64_t done = 0, within = 0, across = 0, held = 0;
  for (std::uint64_t seed = 0; done < kIncrements; ++seed) {
    test::Dice dice(20261126 + seed);
    const auto any_size = [&] { return std::pow(10.0, dice.between(-12.0, 12.0)); };
    const double size = any_size();
    // Half of the gaps and springs are of the size of the motion.
    const auto length = [&] {
      return dice.chance(0.5) ? size * dice.between(0.1, 2.0) : any_size();
    };
    const double width = dice.chance(0.05) ? 0.0 : length();
    const double most = dice.chance(0.2) ? 0.0 : length();  // elastic slip at which it slips
    double play = width * dice.between(-0.5, 0.5);
    double elastic = 0.0;
    for (int number = 1; number <= 50; ++number, ++done) {
      const double motion = size * dice.between(-2.0, 2.0);
      const bench::PlayStep step = bench::move_play({.width = width}, play, elastic, motion);
      const Play before = Play::begin(play);
      const Play after = before.after(motion, before.inner - elastic, 0.5L * width);
      const auto close = [&](double found, Long exact) {
        return std::abs(found - exact) <=
               kRounding * (std::abs(Long{elastic}) + std::abs(Long{play}) + std::abs(motion));
      };
      // These hold to the last bit: the play stays within the gap, leaves the motion as it is where
      // it does not travel, and the spring relaxed where it comes to rest between the edges.
      const bool between = std::abs(step.play) < 0.5 * width;
      const bool exact =
          std::abs(step.play) <= 0.5 * width &&
          (step.travel == 0.0 ? step.motion == motion : !between || elastic + step.motion == 0.0);
      if (!exact || !close(step.play, after.outer - after.inner) ||
          !close(step.travel, after.outer - after.inner - play) ||
          !close(step.motion, after.inner - before.inner)) {
        FAIL("seed " << seed << ", increment " << number << ": play " << step.play << ", travel "
                     << step.travel << ", motion " << step.motion << ", exactly "
                     << after.outer - after.inner << " and " << after.inner - before.inner);
      }
      within += between ? 1 : 0;
      across += width > 0.0 && std::abs(step.travel) == width ? 1 : 0;
      held += step.travel == 0.0 ? 1 : 0;
      play = step.play;
      elastic = std::clamp(elastic + step.motion, -most, most);
    }
  }
  // All of it was drawn: rests between the edges, ways from edge to edge, and along with an edge.
  CHECK(std::min({within, across, held}) > kIncrements / 20);
}

}  // namespace
