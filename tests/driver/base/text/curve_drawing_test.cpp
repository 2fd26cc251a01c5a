// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/curve_drawing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "driver/base/text/tics.hpp"

namespace slipbench::driver::base {
namespace {

CurveDrawing rising() {
  CurveDrawing drawing;
  drawing.x_end = 10.0;
  drawing.x_name = "V";
  drawing.y_name = "mu";
  drawing.curves.push_back({'*', "", [](double x) { return 0.04 * x; }});
  return drawing;
}

TEST_CASE("A drawing has its numbers where the curve has them") {
  CHECK(draw(rising(), 11, 5) ==
        " mu |\n"
        "0.4 +         **\n"
        "0.3 +       **\n"
        "0.2 +    ***\n"
        "0.1 +  **\n"
        "  0 +**--------+> V\n"
        "     0        10\n");
}

TEST_CASE("Points are named, curves have a legend, and a steep curve has no gaps") {
  CurveDrawing drawing = rising();
  drawing.points.push_back({"C3", 10.0, 0.4});
  drawing.points.push_back({"C1", 5.0, 0.2});
  drawing.curves.push_back({'o', "steep", [](double x) { return x < 5.0 ? 0.0 : 0.4; }});
  const std::string text = draw(drawing);
  CHECK(text.find("C1") != std::string::npos);
  CHECK(text.find("o steep") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), 'o') > 35);
  CHECK(std::none_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= 0x80; }));
}

TEST_CASE("What is no number is left out") {
  CurveDrawing drawing = rising();
  drawing.curves[0].value = [](double x) {
    return x < 5.0 ? 0.1 : std::numeric_limits<double>::infinity();
  };
  const std::string text = draw(drawing);
  CHECK(std::count(text.begin(), text.end(), '*') == 30);
  drawing.curves[0].value = [](double) { return std::nan(""); };
  CHECK(draw(drawing).find('*') == std::string::npos);
}

TEST_CASE("Tics are 1, 2 or 5 times a power of ten") {
  CHECK(tic_step(10.0, 4.0) == Approx(2.0));
  CHECK(tic_step(0.25, 4.0) == Approx(0.05));
  CHECK(tic_step(4000.0, 4.0) == Approx(1000.0));
  CHECK(tic_step(0.0, 4.0) == 1.0);
}

}  // namespace
}  // namespace slipbench::driver::base
