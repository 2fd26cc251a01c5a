// SPDX-License-Identifier: Apache-2.0
// Fits of the closed forms to data that they made themselves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "driver/calibrate/fit/problem.hpp"
#include "reference/cattaneo_mindlin.hpp"
#include "reference/exponential_decay.hpp"
#include "reference/parallel_sliders.hpp"
#include "reference/wear.hpp"

namespace slipbench::driver::fit::test {

/// A curve with unknown parameters, its true ones, and the abscissae of the data.
struct Synthetic {
  std::string name;
  std::vector<double> truth;
  std::vector<double> abscissa;
  std::function<double(std::span<const double> parameters, double abscissa)> curve;
  double factor = 3.0;  ///< by which starts are off
};

inline std::vector<double> evenly(double first, double last, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

/// K1: mu_s, mu_k and d.
inline Synthetic decay() {
  return {"exponential decay",
          {0.3, 0.18, 0.4},
          evenly(0.0, 20.0, 200),
          [](std::span<const double> p, double rate) {
            return reference::exponential_decay::coefficient({p[0], p[1], p[2]}, rate);
          }};
}

/// W2: final and initial internal contact force, wear length and stick stiffness. mu is known: it
/// appears only in products with the forces.
inline Synthetic wear() {
  return {"exponential wear",
          {40.0, 100.0, 2.0, 500.0},
          evenly(0.0, 8.0, 400),
          [](std::span<const double> p, double motion) {
            return reference::wear::monotone(
                       reference::wear::ExponentialWear{0.2, p[3], p[0], p[1], p[2]}, motion)
                .force;
          }};
}

/// H1: the limit mu N and the compliance Lam; only Lam over the contact radius acts, which is 1.
inline Synthetic microslip() {
  return {"Cattaneo-Mindlin",
          {12.0, 4.0},
          evenly(0.0, 11.0, 200),
          [](std::span<const double> p, double motion) {
            return backbone(reference::cattaneo_mindlin::Contact{p[0], 1.0, p[1]}, motion);
          }};
}

/// M1: three sliders, stiffness and limit of each.
inline Synthetic sliders() {
  return {"parallel sliders",
          {100.0, 60.0, 30.0, 2.0, 4.0, 6.0},
          evenly(0.0, 0.4, 401),
          [](std::span<const double> p, double motion) {
            const std::array<reference::coulomb_slider::Slider, 3> list{
                {{p[0], p[3]}, {p[1], p[4]}, {p[2], p[5]}}};
            return reference::parallel_sliders::backbone(list, motion);
          },
          1.2};
}

/// Residuals against the curve of the true parameters plus `noise`, one number a point or none.
inline ResidualProblem problem_of(const Synthetic& synthetic, std::span<const double> start,
                                  std::span<const double> noise) {
  ResidualProblem problem;
  problem.rows = synthetic.abscissa.size();
  problem.data_rows = problem.rows;
  for (const double value : start) {
    problem.unknowns.push_back({.start = value, .lower = 0.0, .scale = Scale::kLog});
  }
  std::vector<double> measured(problem.rows);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i] = synthetic.curve(synthetic.truth, synthetic.abscissa[i]);
    if (!noise.empty()) measured[i] += noise[i];
  }
  problem.residuals = [synthetic, measured](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = synthetic.curve(x, synthetic.abscissa[i]) - measured[i];
    }
    return true;
  };
  return problem;
}

/// Normal noise of 1 % of the largest value of the curve; the same on every machine (Box-Muller).
inline std::vector<double> noise_of(const Synthetic& synthetic, std::uint64_t seed) {
  double largest = 0.0;
  for (const double at : synthetic.abscissa) {
    largest = std::max(largest, std::abs(synthetic.curve(synthetic.truth, at)));
  }
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  std::vector<double> noise(synthetic.abscissa.size());
  for (double& value : noise) {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    value = 0.01 * largest * radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  return noise;
}

}  // namespace slipbench::driver::fit::test
