// SPDX-License-Identifier: Apache-2.0
// A small picture of curves in plain ASCII, which any terminal, pipe and locale can show.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace slipbench::driver::base {

/// A curve y(x) that is drawn with one character.
struct DrawnCurve {
  char pen = '*';
  std::string name;  ///< for the legend; empty: no line there
  std::function<double(double)> value;
};

/// A point of a curve with a name.
struct DrawnPoint {
  std::string name;
  double x = 0.0;
  double y = 0.0;
};

/// Curves to draw: x from 0 to `x_end` > 0, y from 0 to a round number above all curves. Values
/// that are no numbers, or negative, are left out.
struct CurveDrawing {
  double x_end = 1.0;
  std::string x_name;
  std::string y_name;
  std::vector<DrawnCurve> curves;  ///< the first is drawn on top
  std::vector<DrawnPoint> points;
};

/// The drawing as lines, each with a line feed: axes with numbers, curves, names of points, and a
/// legend if a curve has a name.
std::string draw(const CurveDrawing& drawing, int width = 60, int height = 12);

}  // namespace slipbench::driver::base
