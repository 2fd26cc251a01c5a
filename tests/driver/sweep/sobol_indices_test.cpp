// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sobol_indices.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/sweep/samples.hpp"
#include "tests/driver/sweep/sobol_product.hpp"

namespace slipbench::driver::sweep {
namespace {

TEST_CASE("Sobol' indices of a product are those of the closed form") {
  const Product product;
  const ReadSweep read = product.read(4096);
  REQUIRE(read.value.has_value());
  REQUIRE(read.value->samples == 20480);
  const SobolEstimate found = estimate(*read.value);
  const std::vector<SobolIndices> all = found.indices(0);
  REQUIRE(all.size() == 3);
  for (std::size_t p = 0; p < 3; ++p) {
    INFO("parameter " << p);
    const SobolIndices& indices = all[p];
    // The sequence's error with so many rows; random rows would be some 0.02 off.
    CHECK(indices.first.value == Approx(kFirst[p]).margin(0.005));
    CHECK(indices.total.value == Approx(kTotal[p]).margin(0.005));
    CHECK(indices.first.low <= kFirst[p]);
    CHECK(indices.first.high >= kFirst[p]);
    CHECK(indices.total.low <= kTotal[p]);
    CHECK(indices.total.high >= kTotal[p]);
  }
  CHECK(all[2].total.high < 1e-12);
  CHECK_FALSE(found.varies(2));
  CHECK(found.dropped(0) == 0);
  // Where mu load stays below 12 N: the integral of the two densities, 0.0296.
  CHECK(found.dropped(1) > 0);
  CHECK_THAT(found.text(), Catch::Contains("left out") && Catch::Contains("mu 0.5") &&
                               Catch::Contains("idle 0.00 (0.00 .. 0.00), alone 0.00"));
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

TEST_CASE("Sobol' indices of many parameters take the sums of each once") {
  // Those of all parameters again for each of them would be some 60 million sums.
  constexpr std::size_t kParameters = 400;
  const Product product;
  ReadSweep read = product.read(128);
  REQUIRE(read.value.has_value());
  Sweep& sweep = *read.value;
  sweep.varied.resize(kParameters, sweep.varied.front());
  sweep.collected.resize(1);
  SobolEstimate found(sweep);
  std::size_t id = 0;
  for (std::size_t row = 0; row < 128; ++row) {
    const double a = row % 2 == 0 ? 1.0 : -1.0;
    const double b = row / 2 % 2 == 0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < kParameters + 2; ++i) {
      // The first parameter is all that counts.
      const double number = i == 1 || i == kParameters + 1 ? b : a;
      found.add({.id = id++, .values = {}, .numbers = {&number, 1}, .failure = {}});
    }
  }
  REQUIRE(found.varies(0));
  const std::vector<SobolIndices> indices = found.indices(0);
  REQUIRE(indices.size() == kParameters);
  CHECK(indices[0].first.value == 1.0);
  CHECK(indices[0].total.value == 1.0);
  for (std::size_t p = 1; p < kParameters; ++p) {
    CHECK(indices[p].first.value == 0.0);
    CHECK(indices[p].total.high == 0.0);
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
  // 64 groups of sums of 900 numbers.
  std::string many = product.keys(2, "random", 1);
  std::string more;
  for (int i = 0; i < 900; ++i) more += ", n" + std::to_string(i) + ": {last: CSF1}";
  many.insert(many.rfind('}'), more);
  CHECK(errors(many) ==
        "3 varied parameters and 903 collected numbers take 358 MB of sums for Sobol' indices, "
        "more than 220; vary or collect fewer, or leave out 'sobol_indices'\n");
}

}  // namespace
}  // namespace slipbench::driver::sweep
