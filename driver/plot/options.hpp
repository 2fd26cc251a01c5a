// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/plot/look.hpp"

namespace slipbench::driver {

struct PlotOptions {
  std::string input;   ///< a case, or a result if it ends in .csv
  std::string output;  ///< .svg, .png or .pdf; empty: <stem of the input>.svg, .law.svg, .KIND.svg
  std::vector<std::string> settings;  ///< --set, as typed; for a case only
  bool allow_outside = false;
  bool law = false;  ///< draw the coefficients of a case, not its forces
  std::string kind;  ///< one of plot_kinds(); empty: force over time and over motion
  PictureLook look;
};

}  // namespace slipbench::driver
