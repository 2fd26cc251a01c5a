// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/plot/look.hpp"

namespace slipbench::driver::plot {

struct PlotOptions {
  std::string input;   ///< a case, or a result if it ends in .csv
  std::string output;  ///< .svg, .png or .pdf; empty: STEM.svg, STEM.law.svg, STEM.KIND.svg
  std::vector<std::string> settings;  ///< --set, as typed; for a case only
  bool allow_outside = false;
  bool force = false;             ///< --force: replace a file that is no picture of the input
  bool law = false;               ///< draw the coefficients of a case, not its forces
  std::string kind;               ///< one of plot_kinds(); empty: force over time and over motion
  std::vector<std::string> more;  ///< further inputs, drawn into the same picture
  std::string x;                  ///< a result column; empty: the one that goes with y
  std::vector<std::string> y;     ///< result columns of one unit; empty: the friction force
  PictureLook look;
};

}  // namespace slipbench::driver::plot
