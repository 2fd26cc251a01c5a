// SPDX-License-Identifier: Apache-2.0
// Fits made by hand, for what is told of them: nothing here has been fitted.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

struct MadeFit {
  Fit fit;
  Calibration calibration;
};

/// The force of an elastic slider at the positions of a history, from rest.
std::vector<double> slider_force(const std::vector<double>& positions, double limit,
                                 double stiffness);

/// Two loops of a slider with noise, a third one held out; resampled, with profiles and searches.
MadeFit made_slider_fit();
/// A table of slip rate x temperature, 5 x 4, of which the data saw a part.
MadeFit made_table_fit();
/// A table over the position, of which the first and the last cell were not seen.
MadeFit made_curve_fit();
/// Makes one that did not converge: a trend is left, no errors are known, some bounds are open.
MadeFit made_unconverged_fit();
/// Twenty unknowns with long names, compared over the position, very many points.
MadeFit made_large_fit();
/// Names that look like HTML everywhere.
MadeFit made_hostile_fit();

struct NamedFit {
  std::string name;
  std::function<MadeFit()> make;
};
std::vector<NamedFit> made_fits();

}  // namespace slipbench::driver::calibrate
