// SPDX-License-Identifier: Apache-2.0
// Exact derivatives of random histories of random definitions to every number they have, against
// central differences of the whole histories.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "law/sensitivity/sensitivity.hpp"
#include "tests/support/definition_numbers.hpp"
#include "tests/support/random_definition.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

struct Count {
  long compared = 0;
  long at_kinks = 0;  ///< left out: the histories beside it are not smooth there
};

/// The state's numbers that have derivatives: the forces, then the accumulated slip.
double number(const FrictionUpdate& update, int k, int dimension) {
  return k < dimension ? update.state.force[static_cast<std::size_t>(k)]
                       : double{update.state.accumulated_slip};
}

/// Compares all increments of one history for one number of the definition.
void compare(const FrictionDefinition& definition, const std::vector<HistoryRow>& rows,
             const DefinitionNumber& varied, Count* count) {
  const double h = 1e-6 * std::max(std::abs(varied.value), 1e-3);
  const FrictionDefinition below = varied.at(definition, varied.value - h);
  const FrictionDefinition above = varied.at(definition, varied.value + h);
  DefinitionSlopes slopes;
  slopes.unknowns = 2;  // one that nothing depends on, so that columns are not mixed up
  REQUIRE(add_slopes(below, above, 2.0 * h, 1, &slopes));

  const auto low = run_history(below, rows);
  const auto high = run_history(above, rows);
  const int dimension = definition.slip.dimension;
  StateSlopes state_slopes(definition, slopes);
  FrictionState old;
  bool smooth = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ConnectorIncrement increment = rows[i].increment();
    const FrictionUpdate now = update(definition, increment, old);
    state_slopes.advance(increment, old, now);
    // A change of regime within the width is a kink in all that follows.
    smooth = smooth && low[i].state.regime == now.state.regime &&
             high[i].state.regime == now.state.regime;
    for (int k = 0; k <= dimension && smooth; ++k) {
      const double middle = number(now, k, dimension);
      const double ahead = (number(high[i], k, dimension) - middle) / h;
      const double back = (middle - number(low[i], k, dimension)) / h;
      const double central = 0.5 * (ahead + back);
      // Rounding of the state over the width, with what a long history makes of it.
      const double rounding = 1e-12 * (std::abs(middle) + (k < dimension ? now.limit : 1.0)) / h;
      const double bend = std::abs(ahead - back);
      // A knot of a table, a clamp, another root.
      if (bend > 1e-3 * std::abs(central) + 4.0 * rounding) {
        smooth = false;
        break;
      }
      const double exact =
          k < dimension ? state_slopes.force(k)[1] : state_slopes.accumulated_slip()[1];
      INFO(varied.name << ", increment " << i << ", entry " << k << " of " << dimension);
      CHECK(std::abs(exact - central) <= 1e-5 * std::abs(central) + 0.1 * bend + rounding);
      CHECK((k < dimension ? state_slopes.force(k)[0] : state_slopes.accumulated_slip()[0]) == 0.0);
    }
    ++(smooth ? count->compared : count->at_kinks);
    old = now.state;
  }
}

TEST_CASE("exact derivatives agree with differences of whole histories") {
  Count all;
  for (std::uint32_t seed = 1; seed <= 400; ++seed) {
    Dice dice(seed);
    DefinitionDescription description =
        random_definition(&dice, dice.pick(kPotentialKind), {.table_motions = {1, 2, 3, 4, 5, 6}});
    description.blend = {};
    const FrictionDefinition definition = description.build();
    const std::vector<HistoryRow> rows = random_history(&dice, 25);
    for (const DefinitionNumber& varied : numbers_of(definition)) {
      INFO("seed " << seed << ", " << description.name);
      compare(definition, rows, varied, &all);
    }
  }
  INFO("compared " << all.compared << ", left out at kinks " << all.at_kinks);
  CHECK(all.compared > 50000);
  CHECK(all.at_kinks < all.compared / 10);
}

}  // namespace
