// SPDX-License-Identifier: Apache-2.0
#include "reference/elastic_belt.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::elastic_belt;
using std::numbers::pi;

namespace {

constexpr Belt kBelt{0.2, pi, 30.0, 50000.0, 100.0};
const std::vector<std::vector<double>> kBeltParameters{{0.2}, {pi}, {30.0}, {50000.0}, {100.0}};

// Exact formulas over some branches: their roundings, of the size of the stretch, add up.
Approx exact(double value) { return Approx(value).epsilon(1e-12).margin(1e-12); }

/// The virgin travel at which all of the belt is pulled out.
double travel_to_full_slip() {
  const double a = kBelt.mu * kBelt.wrap_angle;
  return compliance(kBelt) * kBelt.far_tension * (std::expm1(a) - a);
}

/// The same belt as many small pieces, each of uniform tension, with rigid-plastic friction between
/// them: given the tension of the pulled end, every piece takes the tension nearest to its own that
/// friction with its neighbour allows; the stretch is summed.
class Pieces {
 public:
  explicit Pieces(int n) : tensions_(static_cast<std::size_t>(n), kBelt.far_tension) {}

  double stretch_after(double tension) {
    const double ratio = std::exp(kBelt.mu * kBelt.wrap_angle / static_cast<double>(size()));
    double neighbour = tension;
    double stretch = 0.0;
    for (double& t : tensions_) {
      const double step = &t == tensions_.data() ? std::sqrt(ratio) : ratio;
      t = std::clamp(t, neighbour / step, neighbour * step);
      neighbour = t;
      stretch += (t - kBelt.far_tension) * kBelt.radius * kBelt.wrap_angle /
                 (static_cast<double>(size()) * kBelt.axial_stiffness);
    }
    return stretch;
  }

 private:
  [[nodiscard]] std::size_t size() const { return tensions_.size(); }
  std::vector<double> tensions_;
};

}  // namespace

TEST_CASE("an elastic belt's reversal has the printed travels, front and energy") {
  const double tensions[] = {180, 150, 120, 100, 80, 60};
  const char* travels[] = {"0.000226330565076457", "0.00625219400250953", "0.0224673747234",
                           "0.0408721639006934",   "0.0675964958019181",  "0.1060330349004"};
  for (std::size_t i = 0; i < 6; ++i) {
    // The fall of the tension from full slip is a difference: two digits go.
    CHECK(reversal_travel(kBelt, tensions[i]) == Approx(std::stod(travels[i])).epsilon(2e-12));
  }
  CHECK_THAT(full_reversal_travel(kBelt), printed("0.122383253602932"));
  CHECK(reversal_travel(kBelt, lowest_tension(kBelt)) == exact(0.122383253602932));
  CHECK_THAT(reversal_loop_energy(kBelt), printed("5.47040087961234"));
  CHECK(reversal_front(kBelt, 100.0) == exact(pi / 2.0));
  CHECK(reversal_front(kBelt, highest_tension(kBelt)) == exact(pi));
  CHECK(reversal_front(kBelt, lowest_tension(kBelt)) == exact(0.0));
}

TEST_CASE("the energy of an elastic belt's loop is the area between its branches") {
  const double full = full_reversal_travel(kBelt);
  const int n = 20000;
  double area = 0.0;
  for (int i = 0; i < n; ++i) {
    // The midpoint rule in the root of the travel, over which the tension is smooth.
    const double r = (i + 0.5) / n;
    const double step = std::sqrt(full / compliance(kBelt)) * r;
    const double down = std::sqrt(highest_tension(kBelt)) - step;
    const double up = std::sqrt(lowest_tension(kBelt)) + step;
    area += (up * up - down * down) * 2.0 * r * full / n;
  }
  // The rule's second-order error dominates.
  CHECK(area == Approx(5.47040087961234).epsilon(1e-8));
}

TEST_CASE("a straight stick line misses an elastic belt's tension by a third of its span") {
  const double full = full_reversal_travel(kBelt);
  const double high = highest_tension(kBelt);
  const double span = high - lowest_tension(kBelt);
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = full * i / 1000.0;
    const double root = std::sqrt(high) - std::sqrt(x / compliance(kBelt));
    worst = std::max(worst, high - span * x / full - root * root);
  }
  CHECK(worst == Approx(straight_line_error(kBelt)).epsilon(1e-12));
  CHECK(straight_line_error(kBelt) / span == Approx(0.326).margin(5e-4));
}

TEST_CASE("an elastic belt pulled from rest to full slip and back passes the printed points") {
  const double start = 0.7;
  const double turn = start + travel_to_full_slip() + 0.05;
  std::vector<std::vector<double>> path{{start}, {turn}};
  const double tensions[] = {180, 150, 120, 100, 80, 60};
  for (const double t : tensions) path.push_back({turn - reversal_travel(kBelt, t)});
  path.push_back({turn - full_reversal_travel(kBelt)});
  path.push_back({turn - full_reversal_travel(kBelt) - 0.02});
  const auto rows = evaluate(kForm, kBeltParameters, path);
  CHECK(rows[0] == std::vector<double>{100.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  CHECK(rows[1][0] == exact(187.445608758534));
  CHECK(rows[1][2] == exact(pi));
  CHECK(rows[1][3] == exact(0.05));
  for (std::size_t i = 0; i < 6; ++i) {
    // The travel's rounding, 1e-16 of 0.9, over the steep beginning of the branch.
    CHECK(rows[i + 2][0] == Approx(tensions[i]).epsilon(1e-11));
    CHECK(pi - rows[i + 2][2] == Approx(reversal_front(kBelt, tensions[i])).epsilon(1e-11));
    CHECK(rows[i + 2][3] == rows[1][3]);
  }
  CHECK(rows[8][0] == Approx(53.3488091091103).epsilon(1e-11));
  CHECK(rows[9][0] == exact(53.3488091091103));
  CHECK(rows[9][1] == exact(53.3488091091103 - 100.0));
  CHECK(rows[9][3] == exact(0.05 - 0.02));
}

TEST_CASE("an elastic belt's closed loop costs its area") {
  const double turn = travel_to_full_slip();
  const double back = turn - full_reversal_travel(kBelt);
  const auto rows = evaluate(kForm, kBeltParameters, {{0.0}, {turn}, {back}, {turn}});
  CHECK(rows[3][0] == Approx(rows[1][0]).epsilon(1e-9));
  // Full slip is met to the rounding of the travel.
  CHECK(rows[3][4] - rows[1][4] == Approx(5.47040087961234).epsilon(1e-10));
  CHECK(rows[3][6] - rows[1][6] == Approx(5.47040087961234).epsilon(1e-10));
  CHECK(rows[3][5] == Approx(rows[1][5]).epsilon(1e-9));

  // Sliding on: the tension of each end works against the same travel.
  const auto slid = evaluate(kForm, kBeltParameters, {{0.0}, {turn}, {turn + 0.5}});
  CHECK(slid[2][6] - slid[1][6] == Approx(0.5 * 87.445608758534).epsilon(1e-12));
}

TEST_CASE("an elastic belt remembers where it turned and closes its loops") {
  const auto rows = evaluate(
      kForm, kBeltParameters,
      {{0.0}, {0.03}, {0.01}, {0.02}, {0.01}, {0.03}, {0.035}, {-0.01}, {0.0}, {-0.01}, {-0.02}});
  CHECK(rows[4][0] == exact(rows[2][0]));
  CHECK(rows[5][0] == exact(rows[1][0]));
  const auto direct = evaluate(kForm, kBeltParameters, {{0.0}, {0.035}, {-0.01}, {-0.02}});
  CHECK(rows[6][0] == exact(direct[1][0]));
  CHECK(rows[7][0] == exact(direct[2][0]));
  CHECK(rows[9][0] == exact(direct[2][0]));
  CHECK(rows[10][0] == exact(direct[3][0]));
}

TEST_CASE("a row without motion changes nothing for an elastic belt") {
  const auto rows =
      evaluate(kForm, kBeltParameters, {{0.0}, {0.0}, {0.03}, {0.03}, {0.01}, {0.01}, {0.04}});
  CHECK(rows[1] == rows[0]);
  CHECK(rows[3] == rows[2]);
  CHECK(rows[5] == rows[4]);
  const auto direct = evaluate(kForm, kBeltParameters, {{0.0}, {0.03}, {0.01}, {0.04}});
  CHECK(rows[6] == direct[3]);
}

TEST_CASE("an elastic belt's first branch meets the virgin curve on the other side") {
  // Beyond the mirror point nothing is left of the first pull.
  const auto rows = evaluate(kForm, kBeltParameters, {{0.0}, {0.01}, {-0.03}});
  const auto virgin = evaluate(kForm, kBeltParameters, {{0.0}, {-0.03}});
  CHECK(rows.back()[0] == exact(virgin.back()[0]));
  CHECK(rows.back()[5] == exact(virgin.back()[5]));
  CHECK(rows.back()[2] == exact(virgin.back()[2]));
}

TEST_CASE("many small pieces of belt follow the elastic belt on any path") {
  Pieces pieces(4000);
  // Short of full slip, where the pieces would no longer tell the travel from the tension.
  const double tensions[] = {150, 90, 130, 110, 160, 75, 95, 80, 120, 60, 180, 105};
  std::vector<std::vector<double>> path{{0.0}};
  for (const double t : tensions) path.push_back({pieces.stretch_after(t)});
  const auto rows = evaluate(kForm, kBeltParameters, path);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    // Pieces of 1/4000 of the angle carry tensions off by up to 1.6e-4 of themselves.
    CHECK(rows[i + 1][0] == Approx(tensions[i]).epsilon(2e-4));
  }
}

TEST_CASE("an elastic belt's dissipation never falls and increments change nothing") {
  std::mt19937 dice(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<std::vector<double>> coarse{{0.0}};
  std::vector<std::vector<double>> fine{{0.0}};
  for (int i = 0; i < 60; ++i) {
    const double from = coarse.back()[0];
    coarse.push_back({0.1 * uniform(dice)});
    for (int j = 1; j <= 5; ++j) fine.push_back({from + 0.2 * j * (coarse.back()[0] - from)});
  }
  const auto coarse_rows = evaluate(kForm, kBeltParameters, coarse);
  const auto fine_rows = evaluate(kForm, kBeltParameters, fine);
  double fully = 0.0;
  for (std::size_t i = 1; i < coarse.size(); ++i) {
    CHECK(coarse_rows[i][6] >= coarse_rows[i - 1][6]);
    if (coarse_rows[i][3] != coarse_rows[i - 1][3]) ++fully;
    // Roundings of the travel are magnified where a branch begins.
    for (const std::size_t c : {0U, 3U, 4U, 5U, 6U}) {
      CHECK(fine_rows[5 * i][c] == Approx(coarse_rows[i][c]).epsilon(1e-9).margin(1e-9));
    }
  }
  for (std::size_t i = 1; i < fine.size(); ++i) {
    CHECK(fine_rows[i][6] >= fine_rows[i - 1][6] - 1e-12);
  }
  CHECK(fully > 0);
}

TEST_CASE("the inverse of e^y - 1 - y is found on both sides and at all sizes") {
  for (const double y : {1e-9, 1e-3, 0.2, 0.5, 1.2, 1.4, 3.0, 30.0}) {
    for (const double x : {y, -y}) {
      const double c = exponential_remainder(x);
      // Its slope vanishes at 0: the last digit of c is worth half of it in y, relatively.
      CHECK(inverse_exponential_remainder(c, x > 0.0) == Approx(x).epsilon(1e-14));
    }
  }
  CHECK(inverse_exponential_remainder(0.0, true) == 0.0);
}
