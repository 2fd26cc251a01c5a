// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slipbench::driver::plot {

/// The amplitudes of a signal over frequency. A sine of amplitude A has a peak of height A at its
/// frequency.
struct Amplitudes {
  double step = 0.0;           ///< of the frequencies, which begin with 0 [1/T]
  std::vector<double> values;  ///< in the unit of the signal
  double peak_frequency = 0.0;
  double peak = 0.0;  ///< the highest amplitude, between its frequencies where it lies there
};

/// The spectrum of a signal at times that increase but need not be equally far apart: it is
/// interpolated linearly at as many equal steps as the shortest power of two not below the number
/// of times, less its mean, times a Hann window whose mean is made good, with zeros to four times
/// its length. What lies below one and a half periods of the whole time is no peak: it is the
/// window's own width. Fewer than 8 times, or none that increase, give no amplitudes.
Amplitudes amplitudes_of(std::span<const double> times, std::span<const double> signal);

}  // namespace slipbench::driver::plot
