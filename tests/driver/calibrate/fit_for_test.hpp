// SPDX-License-Identifier: Apache-2.0
// Fits that tests make from texts: cases and data in a folder of their own.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/calibrate/calibrate.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::calibrate {

/// Reads fit.yaml of a folder; it has to be sound.
inline Fit sound_fit(const TemporaryFolder& folder, std::string_view text) {
  const ReadFit read = read_fit(folder.write("fit.yaml", text).string());
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value);
  return *read.value;
}

inline Calibration calibrated(const Fit& fit, unsigned threads = 0) {
  auto found = calibrate(fit, {}, {.threads = threads});
  if (!found) FAIL(found.error().message);
  return std::move(*found);
}

inline Calibration calibrated(const TemporaryFolder& folder, std::string_view fit) {
  return calibrated(sound_fit(folder, fit));
}

/// The unknown of a name.
inline double estimate(const Calibration& calibration, std::string_view name) {
  for (const FittedUnknown& unknown : calibration.unknowns) {
    if (unknown.name == name) return unknown.value;
  }
  FAIL("no unknown " << name);
  return 0.0;
}

/// A triangle of amplitude 1 and period 4: 0, 1, 0, -1, 0 at 0, 1, 2, 3, 4.
inline double triangle(double time) {
  const double phase = std::fmod(time, 4.0);
  if (phase <= 1.0) return phase;
  return phase <= 3.0 ? 2.0 - phase : phase - 4.0;
}

/// A Jenkins element led along `position`, at rest at 0: exact over rows between which the motion
/// does not turn.
inline std::vector<double> slider_forces(const std::vector<double>& position, double stiffness,
                                         double limit) {
  std::vector<double> forces;
  double force = 0.0;
  double before = 0.0;
  for (const double u : position) {
    force = std::clamp(force + stiffness * (u - before), -limit, limit);
    before = u;
    forces.push_back(force);
  }
  return forces;
}

/// A slider with 100 N and a triangle of amplitude 1 mm: cases and data of its tests.
struct SliderRig {
  double mu = 0.3;
  double stiffness = 120.0;
  double normal_force = 100.0;
  double amplitude = 1.0;
  double noise = 0.0;  ///< standard deviation
  unsigned seed = 1;
  int rows = 160;     ///< over two periods of 4 s
  double unit = 1.0;  ///< what forces are divided by

  static std::string case_text() {
    return "slipbench: 1\n"
           "units: {length: mm, force: N, time: s}\n"
           "parameters: {mu: 0.1, k: 360, N: 100, amplitude: 1}\n"
           "connector: {type: SLOT}\n"
           "friction:\n"
           "  - name: sleeve\n"
           "    predefined: {}\n"
           "    coefficient: = mu\n"
           "    stick: {stiffness: = k}\n"
           "history:\n"
           "  - {step: go, duration: 1, increments: 20, force: {f2: = N},\n"
           "     motion: {CP1: {to: = amplitude}}}\n"
           "  - {step: back, duration: 2, increments: 40, motion: {CP1: {to: = -amplitude}}}\n"
           "  - {step: forth, duration: 2, increments: 40, motion: {CP1: {to: = amplitude}}}\n"
           "  - {step: again, duration: 2, increments: 40, motion: {CP1: {to: = -amplitude}}}\n"
           "  - {step: end, duration: 1, increments: 20, motion: {CP1: {to: 0}}}\n";
  }

  /// t, u, F at the ends of the rows.
  std::string data() const {
    std::vector<double> position;
    for (int i = 1; i <= rows; ++i) position.push_back(amplitude * triangle(8.0 * i / rows));
    const std::vector<double> forces = slider_forces(position, stiffness, mu * normal_force);
    std::mt19937_64 bits(seed);
    std::string text = "t,u,F\n";
    for (int i = 1; i <= rows; ++i) {
      // Box and Muller, so that every standard library gives the same noise.
      const double a = (static_cast<double>(bits() >> 11U) + 0.5) * 0x1p-53;
      const double b = (static_cast<double>(bits() >> 11U) + 0.5) * 0x1p-53;
      const double normal = std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * M_PI * b);
      const auto row = static_cast<std::size_t>(i - 1);
      text += fmt::format("{:.17g},{:.17g},{:.17g}\n", 8.0 * i / rows, position[row],
                          (forces[row] + noise * normal) / unit);
    }
    return text;
  }
};

inline const std::string kSliderFit =
    "slipbench: 1\n"
    "calibrate:\n"
    "  experiments:\n"
    "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: F}}\n"
    "  vary: {mu: {bounds: [0, 2]}, k: {bounds: [1, 1.0e+5], scale: log}}\n";

}  // namespace slipbench::driver::calibrate
