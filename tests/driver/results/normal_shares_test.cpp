// SPDX-License-Identifier: Apache-2.0
#include "driver/results/normal_shares.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/bench/connector_increment.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::results {
namespace {

struct Seen {
  std::vector<NormalShare> shares;
  double normal_force = 0.0;
};

/// The shares of the definitions of a case at its last row; each row is checked on the way.
std::vector<Seen> shares_at_end(const std::string& text) {
  const TemporaryFolder folder;
  const auto read = read::read_case(folder.write("c.yaml", "slipbench: 1\n" + text).string(), {});
  REQUIRE(read.value);
  REQUIRE_FALSE(read.diagnostics.has_errors());
  const cases::Case& problem = *read.value;
  std::vector<Seen> end(problem.definitions.size());
  const auto ended = bench::follow_case(problem, [&](const bench::Simulation& simulation) {
    const law::ConnectorIncrement increment = bench::connector_increment(problem, simulation.row());
    for (std::size_t d = 0; d < end.size(); ++d) {
      const law::FrictionUpdate& update = simulation.row().definitions[d].update;
      Seen now{normal_shares(simulation.definition(d), update, increment), update.normal_force};
      if (!end[d].shares.empty()) {
        REQUIRE(now.shares.size() == end[d].shares.size());
        for (std::size_t k = 0; k < now.shares.size(); ++k) {
          REQUIRE(now.shares[k].name == end[d].shares[k].name);
        }
      }
      double sum = 0.0;
      for (const NormalShare& share : now.shares) sum += share.value;
      // The same terms are added in another order.
      CHECK(std::abs(sum) == Approx(now.normal_force).epsilon(1e-14).margin(1e-12));
      end[d] = now;
    }
  });
  REQUIRE(ended);
  return end;
}

TEST_CASE("a derived component's shares are its terms, and their sum is the normal force") {
  const auto seen = shares_at_end(R"(units: {length: mm, force: N, time: s}
connector: {type: CYLINDRICAL}
friction:
  - predefined: {R: 0.24, L: 0.55, internal_contact_force: 20}
    coefficient: 0.15
    stick: {elastic_slip: 0.01}
history:
  - {step: press, increments: 4, motion: {CP1: {to: 0.1}}, force: {f2: {to: 300}, f3: {to: 400}, m2: {to: 55}}}
)");
  REQUIRE(seen.size() == 1);
  REQUIRE(seen[0].shares.size() == 3);
  CHECK(seen[0].shares[0].name == "forces across axis 1 (f2 f3)");
  CHECK(seen[0].shares[0].value == Approx(500.0).epsilon(1e-14));
  CHECK(seen[0].shares[1].name == "bending moments across axis 1 (m2 m3)");
  CHECK(seen[0].shares[1].value == Approx(200.0).epsilon(1e-14));
  CHECK(seen[0].shares[2].name == "internal contact force");
  CHECK(seen[0].shares[2].value == 20.0);
}

TEST_CASE("a component keeps its sign, so that it may lift off") {
  const auto seen = shares_at_end(R"(units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - component: 1
    contact_force: 2
    internal_contact_force: 100
    coefficient: 0.2
    stick: {elastic_slip: 0.01}
history:
  - {step: pull, increments: 4, motion: {CP1: {to: 0.1}}, force: {f2: {to: -80}}}
)");
  REQUIRE(seen[0].shares.size() == 2);
  CHECK(seen[0].shares[0].name == "f2");
  CHECK(seen[0].shares[0].value == -80.0);
  CHECK(seen[0].shares[1].value == 100.0);
  CHECK(seen[0].normal_force == 20.0);
}

TEST_CASE("the hinges of a universal joint share its load; a belt has its tension") {
  const auto joint = shares_at_end(R"(units: {length: m, force: N, time: s}
connector: {type: UJOINT}
friction:
  - predefined: {R_p: 0.02, R_a: 0.03, L_s: 0.04, L_a: 0.1, internal_contact_moment_1: 0.5}
    coefficient: 0.1
    stick: {elastic_slip: 0.001}
history:
  - {step: load, increments: 4, motion: {CPR1: {to: 0.1}, CPR3: {to: 0.2}}, force: {f1: {to: 300}, f2: {to: 200}, m2: {to: 4}}}
)");
  REQUIRE(joint.size() == 2);
  for (const Seen& axis : joint) {
    REQUIRE(axis.shares.size() == 4);
    CHECK(axis.shares[0].name == "faces of the hinges");
    CHECK(axis.shares[3].name == "internal contact moment");
  }
  CHECK(joint[0].shares[3].value == 0.5);
  CHECK(joint[1].shares[3].value == 0.0);

  const auto belt = shares_at_end(R"(units: {length: mm, force: N, time: s}
connector: {type: SLIPRING, wrap_angle: 1.5}
friction:
  - {predefined: {}, coefficient: 0.2, stick: {elastic_slip: 0.01}}
history:
  - {step: haul, increments: 4, force: {f1: 60}, motion: {CP2: {to: 1.0}}}
)");
  REQUIRE(belt[0].shares.size() == 1);
  CHECK(belt[0].shares[0].name == "tension before the ring");
  CHECK(belt[0].shares[0].value == 60.0);
}

TEST_CASE("terms of the same components are told apart") {
  const auto seen = shares_at_end(R"(units: {length: mm, force: N, time: s}
connector: {type: SLOT}
derived_components:
  normal:
    - {operator: norm, components: [2, 3], weights: [1, 1]}
    - {operator: norm, components: [2, 3], weights: [0.5, 0]}
friction:
  - {component: 1, contact_force: normal, coefficient: 0.2, stick: {elastic_slip: 0.01}}
history:
  - {step: press, increments: 4, motion: {CP1: {to: 0.1}}, force: {f2: {to: 30}, f3: {to: 40}}}
)");
  REQUIRE(seen[0].shares.size() == 3);
  CHECK(seen[0].shares[0].name == "forces across axis 1 (f2 f3)");
  CHECK(seen[0].shares[0].value == Approx(50.0).epsilon(1e-14));
  CHECK(seen[0].shares[1].name == "forces across axis 1 (f2 f3), 2");
  CHECK(seen[0].shares[1].value == 15.0);
}

}  // namespace
}  // namespace slipbench::driver::results
