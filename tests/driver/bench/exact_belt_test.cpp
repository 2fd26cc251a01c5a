// SPDX-License-Identifier: Apache-2.0
// Elastic belts by exact integration: what they end with does not depend on the increments.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/bench/exact_integration.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::bench {
namespace {

const std::string kLinear = "stiffness: 5000";
/// Pushes where it is slack, and turns at two knots while it is tight.
const std::string kTable =
    "columns: [force, displacement], rows: [[-5, -0.02], [0, 0], [20, 0.005], [200, 0.04]]";

/// Tightened, let go until it is slack, tightened again while it flows on, and pulled back.
cases::Case belt(const std::string& elasticity, const std::string& stick,
                 const std::string& coefficient, const std::string& method, int increments) {
  const std::string n = "increments: " + std::to_string(increments) + ", ";
  return read::sound(
      "slipbench: 1\n"
      "connector: {type: SLIPRING, wrap_angle: 1.5, initial: {CP1: 100}, initial_strain: 0.002}\n"
      "friction:\n  - {predefined: {}, coefficient: " +
      coefficient + ", stick: {" + stick + "}}\nelasticity: [{component: 1, " + elasticity +
      "}]\nintegration: {method: " + method + "}\nhistory:\n" + "  - {step: pull, " + n +
      "motion: {CP1: {to: 101}, CP2: {to: 1}, CP3: {to: 0.5}}}\n" + "  - {step: slacken, " + n +
      "motion: {CP1: {to: 98}, CP2: {to: 1.2}}}\n" + "  - {step: tighten, " + n +
      "motion: {CP1: {to: 101}, CP2: {to: 2}}}\n" + "  - {step: back, " + n +
      "motion: {CP1: {to: 102}, CP2: {to: 1.6}}}\n");
}

/// Returns what every step ends with: forces, slip, energies.
std::vector<std::array<double, 6>> ends(const cases::Case& problem) {
  std::vector<std::array<double, 6>> ends;
  const std::vector<Row> rows = rows_of(problem);
  const std::size_t n = (rows.size() - 1) / 4;
  for (std::size_t i = n; i < rows.size(); i += n) {
    const DefinitionRow& row = rows[i].definitions[0];
    ends.push_back({rows[i].quantities[cases::kFirstForce], row.update.state.force[0],
                    row.update.state.accumulated_slip, row.dissipation, row.work,
                    row.update.stored_energy});
  }
  return ends;
}

/// The largest difference of two runs as a part of the largest value.
double difference(const std::vector<std::array<double, 6>>& a,
                  const std::vector<std::array<double, 6>>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    double size = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      size = std::max(size, std::abs(b[i][j]));
      most = std::max(most, std::abs(a[i][j] - b[i][j]));
    }
    worst = std::max(worst, most / size);
  }
  return worst;
}

TEST_CASE("an elastic belt ends alike in one increment a step and in fifty, slack in between") {
  for (const std::string& elasticity : {kLinear, kTable}) {
    for (const std::string stick : {"elastic_slip: 0.01", "stiffness: 1000"}) {
      for (const std::string coefficient :
           {"0.2",
            "{columns: [coefficient, contact_force], rows: [[0.1, 0], [0.3, 20], [0.2, 80]]}",
            "{columns: [coefficient, slip_rate], rows: [[0.1, 0], [0.3, 2]]}"}) {
        CAPTURE(elasticity, stick, coefficient);
        const auto run = [&](const std::string& method, int n) {
          return ends(belt(elasticity, stick, coefficient, method, n));
        };
        const auto one = run("exact", 1);
        CHECK(one[1][0] < 0.0);
        CHECK(one[1][1] == 0.0);
        for (const int n : {3, 7, 50}) {
          CAPTURE(n);
          CHECK(difference(run("exact", n), one) < 1e-11);
        }
        const double coarse = difference(run("backward_euler", 2000), one);
        const double fine = difference(run("backward_euler", 4000), one);
        CHECK(coarse < 2e-3);
        CHECK(fine < 0.6 * coarse);
      }
    }
  }
}

TEST_CASE("the slip of an elastic belt ends where the strain does") {
  const double force = std::expm1(0.3);
  for (const int n : {1, 7}) {
    const auto with_elastic_slip = ends(belt(kLinear, "elastic_slip: 0.01", "0.2", "exact", n));
    const auto with_stiffness = ends(belt(kLinear, "stiffness: 1000", "0.2", "exact", n));
    const double length = 100.0 / 1.002 - 0.5;
    // 101 - 3 tau = length - 0.2 tau.
    const double slack = (101.0 - length) / 2.8;
    CHECK(with_elastic_slip[1][2] == Approx(0.99 + 0.2 * slack).epsilon(1e-12));
    // All that is slip is not stretch of the stick; it is gone where the belt is slack.
    CHECK(with_stiffness[1][2] == Approx(1.0 + 0.2 * slack).epsilon(1e-12));
    const double tight = (length - 0.2 - 98.0) / 3.8;
    CHECK(with_elastic_slip[2][2] - with_elastic_slip[1][2] ==
          Approx(0.8 * (1.0 - tight) - 0.01).epsilon(1e-12));
    CHECK(with_elastic_slip[2][1] == Approx(force * with_elastic_slip[2][0]).epsilon(1e-12));
  }
}

}  // namespace
}  // namespace slipbench::driver::bench
