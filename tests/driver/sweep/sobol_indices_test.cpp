// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sobol_indices.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/samples.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

/// A slot that slips in the end: its force is the product of coefficient and load.
struct Product {
  TemporaryFolder folder;

  Product() {
    folder.write(
        "slot.yaml",
        "slipbench: 1\nunits: {length: mm, force: N, time: s}\n"
        "parameters: {mu: 0.2, load: 100, idle: 1}\nconnector: {type: SLOT}\n"
        "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: 1e5}}]\n"
        "history: [{step: go, increments: 2, motion: {CP1: {to: 0.1}}, force: {f2: = load}}]\n");
  }

  std::string keys(int rows, const std::string& sampler, int seed) const {
    return "slipbench: 1\nsweep:\n  case: slot.yaml\n  sobol_indices: true\n"
           "  vary: {mu: {uniform: [0.1, 0.3]}, load: {uniform: [50, 150]}, idle: {uniform: [0, "
           "1]}}\n"
           "  sampler: " +
           sampler + "\n  seed: " + std::to_string(seed) + "\n  samples: " + std::to_string(rows) +
           "\n  collect: {force: {last: CSF1}, rises: {first_passage: {of: CSF1, above: 12}},\n"
           "            same: {last: CP1}}\n";
  }
  ReadSweep read(int rows, const std::string& sampler = "sobol", int seed = 1) const {
    return read_sweep(folder.write("s.yaml", keys(rows, sampler, seed)).string());
  }
};

SobolEstimate estimate(const Sweep& sweep) {
  SobolEstimate found(sweep);
  run_sweep(sweep, {}, [&](const SampleOutcome& one) { found.add(one); });
  return found;
}

// Of a product of independent factors with means m and variances v.
constexpr double kVarianceOfMu = 0.2 * 0.2 / 12.0;
constexpr double kVarianceOfLoad = 100.0 * 100.0 / 12.0;
constexpr double kVariance =
    kVarianceOfMu * kVarianceOfLoad + kVarianceOfMu * 100.0 * 100.0 + kVarianceOfLoad * 0.2 * 0.2;
constexpr std::array kFirst{kVarianceOfMu * 100.0 * 100.0 / kVariance,
                            kVarianceOfLoad * 0.2 * 0.2 / kVariance, 0.0};
constexpr std::array kTotal{1.0 - kFirst[1], 1.0 - kFirst[0], 0.0};

TEST_CASE("Sobol' indices of a product are those of the closed form") {
  const Product product;
  const ReadSweep read = product.read(4096);
  REQUIRE(read.value.has_value());
  REQUIRE(read.value->samples == 20480);
  const SobolEstimate found = estimate(*read.value);
  for (std::size_t p = 0; p < 3; ++p) {
    INFO("parameter " << p);
    const SobolIndices indices = found.indices(0, p);
    // The sequence's error with so many rows; random rows would be some 0.02 off.
    CHECK(indices.first.value == Approx(kFirst[p]).margin(0.005));
    CHECK(indices.total.value == Approx(kTotal[p]).margin(0.005));
    CHECK(indices.first.low <= kFirst[p]);
    CHECK(indices.first.high >= kFirst[p]);
    CHECK(indices.total.low <= kTotal[p]);
    CHECK(indices.total.high >= kTotal[p]);
  }
  CHECK(found.indices(0, 2).total.high < 1e-12);
  CHECK_FALSE(found.varies(2));
  CHECK(found.dropped(0) == 0);
  // Where mu load stays below 12 N: the integral of the two densities, 0.0296.
  CHECK(found.dropped(1) > 0);
  CHECK_THAT(found.text(), Catch::Contains("left out") && Catch::Contains("mu 0.5") &&
                               Catch::Contains("idle 0.00 (0.00 .. 0.00), alone 0.00"));
}

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
    for (std::size_t p = 0; p < 2; ++p) {
      const SobolIndices indices = found.indices(0, p);
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
  const VariancePart one = narrow.indices(0, 0).first;
  CHECK(one.high - one.low == Approx(width / (2.0 * kSeeds) / 4.0).epsilon(0.35));
}

TEST_CASE("A row of samples is A, A with one coordinate of B, and B") {
  const Product product;
  for (const std::string sampler : {"sobol", "halton", "lhs", "random"}) {
    INFO(sampler);
    const ReadSweep read = product.read(50, sampler);
    REQUIRE(read.value.has_value());
    std::vector<double> values(750);
    REQUIRE(Samples(*read.value).take(values) == 250);
    const auto at = [&](std::size_t sample, std::size_t p) { return values[sample * 3 + p]; };
    for (std::size_t row = 0; row < 250; row += 5) {
      for (std::size_t p = 0; p < 3; ++p) {
        CHECK(at(row, p) != at(row + 4, p));
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(at(row + 1 + i, p) == at(i == p ? row + 4 : row, p));
        }
      }
    }
    Samples later(*read.value);
    later.skip(17);
    std::vector<double> some(60);
    later.take(some);
    CHECK(std::equal(some.begin(), some.end(), values.begin() + 51));
  }
}

TEST_CASE("Sobol' indices are refused where the samples cannot be laid out") {
  const Product product;
  const auto errors = [&](const std::string& text) {
    const ReadSweep read = read_sweep(product.folder.write("s.yaml", text).string());
    std::string all;
    for (const base::Diagnostic& one : read.diagnostics.sorted()) all += one.message + "\n";
    return all;
  };
  CHECK_THAT(errors(product.keys(10, "grid", 1)), Catch::Contains("not a grid"));
  CHECK_THAT(errors(product.keys(1'000'000'000, "sobol", 1)), Catch::Contains("5 runs a sample"));
}

}  // namespace
}  // namespace slipbench::driver::sweep
