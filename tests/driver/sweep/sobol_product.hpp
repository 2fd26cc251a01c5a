// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/sobol_indices.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {

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

inline SobolEstimate estimate(const Sweep& sweep) {
  SobolEstimate found(sweep);
  run_sweep(sweep, {}, [&](const SampleOutcome& one) { found.add(one); });
  return found;
}

// Of a product of independent factors with means m and variances v.
inline constexpr double kVarianceOfMu = 0.2 * 0.2 / 12.0;
inline constexpr double kVarianceOfLoad = 100.0 * 100.0 / 12.0;
inline constexpr double kVariance =
    kVarianceOfMu * kVarianceOfLoad + kVarianceOfMu * 100.0 * 100.0 + kVarianceOfLoad * 0.2 * 0.2;
inline constexpr std::array kFirst{kVarianceOfMu * 100.0 * 100.0 / kVariance,
                                   kVarianceOfLoad * 0.2 * 0.2 / kVariance, 0.0};
inline constexpr std::array kTotal{1.0 - kFirst[1], 1.0 - kFirst[0], 0.0};

}  // namespace slipbench::driver::sweep
