// SPDX-License-Identifier: Apache-2.0
#include "reference/backlash_slider.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;
using backlash_slider::Slider;

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-12).margin(1e-13); }

}  // namespace

TEST_CASE("without a gap a backlash slider is the Coulomb slider") {
  const std::vector<std::vector<double>> path{{0.0},  {0.013}, {0.1}, {0.09},
                                              {-0.1}, {-0.02}, {0.3}};
  const auto one = evaluate("coulomb_slider", {{0.2}, {100.0}, {1000.0}, {kNone}}, path);
  const auto other = evaluate("backlash_slider", {{20.0}, {1000.0}, {0.0}, {kNone}, {0.0}}, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (std::size_t k = 0; k < 5; ++k) CHECK(other[i][k] == exact(one[i][k]));
  }
}

TEST_CASE("a backlash slider's loop has the corners, the slip and the energy of its formulas") {
  const Slider slider{1000.0, 30.0, 10.0, 0.06};
  const auto corners = backlash_slider::loop_vertices(slider, 0.1);
  std::vector<std::vector<double>> path{{0.0}};
  for (const auto& corner : corners) path.push_back({corner.motion});
  path.push_back({0.1});
  const auto rows = evaluate("backlash_slider", {{30.0}, {1000.0}, {0.06}, {10.0}, {0.0}}, path);
  for (std::size_t i = 0; i < corners.size(); ++i) CHECK(rows[i + 1][0] == exact(corners[i].force));
  CHECK(rows.back()[1] - rows[1][1] == exact(backlash_slider::loop_slip(slider, 0.1)));
  CHECK(rows.back()[2] - rows[1][2] == exact(backlash_slider::loop_energy(slider, 0.1)));
  CHECK(backlash_slider::loop_energy(slider, 0.1) == exact(40.0 * (0.2 - 0.06 - 0.04)));
  CHECK(rows[3][5] == exact(-0.03));  // the gap is crossed
  CHECK(rows[1][5] == exact(0.03));
}

TEST_CASE("a motion within the gap and the elastic slips costs nothing") {
  const Slider slider{1000.0, 30.0, 10.0, 0.06};
  CHECK(backlash_slider::loop_energy(slider, 0.04) == 0.0);
  const auto rows = evaluate("backlash_slider", {{30.0}, {1000.0}, {0.06}, {10.0}, {0.01}},
                             {{0.0}, {0.04}, {-0.04}, {0.04}});
  CHECK(rows[0][5] == 0.01);
  CHECK(rows[1][0] == exact(20.0));  // 0.05 from the middle of the gap, 0.02 beyond its end
  CHECK(rows[1][2] == 0.0);
  CHECK(rows[1][4] == exact(0.2));  // all of it in the spring
}

TEST_CASE("work is dissipation plus stored energy at every row of a backlash slider") {
  const auto rows = evaluate("backlash_slider", {{30.0}, {1000.0}, {0.06}, {10.0}, {-0.03}},
                             {{0.0}, {0.2}, {0.15}, {-0.3}, {-0.29}, {-0.1}, {0.4}});
  for (const auto& row : rows) CHECK(row[4] == exact(row[2] + row[3]));
}

TEST_CASE("a play outside its gap is no start") {
  const auto* form = find("backlash_slider");
  REQUIRE(form != nullptr);
  const std::vector<std::vector<double>> outside{{30.0}, {1000.0}, {0.06}, {kNone}, {0.04}};
  CHECK(form->violation(outside) == "start lies between -gap/2 and gap/2");
}
