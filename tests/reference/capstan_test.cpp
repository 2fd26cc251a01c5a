// SPDX-License-Identifier: Apache-2.0
#include "reference/capstan.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::capstan;
using std::numbers::pi;

namespace {

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

const std::vector<std::vector<double>> kRing{{0.2}, {pi}, {1000.0}};

}  // namespace

TEST_CASE("the capstan has the printed ratios of tension") {
  const double degrees[] = {30, 90, 180, 360, 720, 1080};
  const double coefficients[] = {0.1, 0.2, 0.3};
  const char* ratios[3][6] = {{"1.05375489702567", "1.17008878749642", "1.36910777062485",
                               "1.87445608758534", "3.51358562428573", "6.58606196269472"},
                              {"1.11039938300559", "1.36910777062485", "1.87445608758534",
                               "3.51358562428573", "12.3452839391874", "43.3762121764543"},
                              {"1.17008878749642", "1.60197765128236", "2.56633239520814",
                               "6.58606196269472", "43.3762121764543", "285.678421101121"}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const double angle = degrees[j] / 180.0 * pi;
      const auto row = evaluate(kBandForm, {}, {{1.0, coefficients[i], angle}}).back();
      CHECK_THAT(row[2], printed(ratios[i][j]));
      CHECK(row[3] == exact(1.0 / row[2]));
      CHECK(1.0 / tension_before(coefficients[i] * angle, 1.0, 1.0) == exact(row[2]));
    }
  }
}

TEST_CASE("the capstan keeps the digits of a tiny wrap") {
  // T mu alpha (1 + mu alpha/2): the second term is far below the rounding.
  CHECK(band(1e-12, 100.0).upper == Approx(1e-10).epsilon(1e-11));
  CHECK(band(1e-12, 100.0).lower == Approx(-1e-10).epsilon(1e-11));
  CHECK(mobilised_exponent(100.0, 100.0 + 1e-8) == Approx(1e-10).epsilon(1e-5));
  CHECK(mobilised_exponent(1.0, 1.0 + 0x1p-40) == Approx(0x1p-40).epsilon(1e-11));
}

TEST_CASE("the capstan has the printed tensions and forces in both directions of flow") {
  const double exponent = 0.2 * pi;
  const double forward = tension_before(exponent, 100.0, 1.0);
  const double backward = tension_before(exponent, 100.0, -1.0);
  CHECK_THAT(forward, printed("53.3488091091103"));
  CHECK_THAT(100.0 - forward, printed("46.6511908908897"));
  CHECK_THAT(backward, printed("187.445608758534"));
  CHECK_THAT(100.0 - backward, printed("-87.4456087585338"));
  CHECK(band(exponent, forward).upper == exact(46.6511908908897));
  CHECK(band(exponent, backward).lower == exact(-87.4456087585338));
  CHECK(tension_before(exponent, 0.0, 1.0) == 0.0);
}

TEST_CASE("the capstan's band is not symmetric") {
  const auto limits = band(0.1 * pi / 2.0, 5.0);
  CHECK_THAT(limits.lower, printed("-0.726820"));
  CHECK_THAT(limits.upper, printed("0.850444"));
  const auto row = evaluate(kBandForm, {}, {{5.0, 0.1, pi / 2.0}, {5.0, 0.1, 1.718132}});
  CHECK_THAT(row[0][2] / 5.0, printed("1.17009"));
  CHECK_THAT(row[0][3] / 5.0, printed("0.854636"));
  CHECK_THAT(row[1][2] / 5.0, printed("1.18746"));
}

TEST_CASE("tensions stick strictly inside the capstan's band") {
  const double exponent = 0.2 * pi;
  CHECK(sticks(exponent, 53.35, 100.0));
  CHECK(sticks(exponent, 100.0, 100.0));
  CHECK(sticks(exponent, 187.44, 100.0));
  CHECK_FALSE(sticks(exponent, 53.34, 100.0));
  CHECK_FALSE(sticks(exponent, 187.45, 100.0));
  CHECK_FALSE(sticks(exponent, 0.0, 100.0));
  CHECK_FALSE(sticks(exponent, 100.0, -1.0));
  CHECK_FALSE(sticks(0.0, 100.0, 100.0));
  const auto rows = evaluate(kStatusForm, {{0.2}, {pi}}, {{53.34, 100.0}, {150.0, 100.0}, {0, 9}});
  CHECK(rows[0][0] == 0.0);
  CHECK(rows[0][1] == exact(std::log(100.0 / 53.34)));
  CHECK(rows[1][0] == 1.0);
  CHECK(rows[1][1] == exact(-std::log(1.5)));
  CHECK(rows[2] == std::vector<double>{0.0, 0.0});
}

TEST_CASE("the wrap angle is the angle by which the belt turns") {
  CHECK(wrap_angle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}) == 0.0);
  CHECK(wrap_angle({0, 0, 0}, {1, 0, 0}, {1, 3, 0}) == exact(pi / 2.0));
  CHECK(wrap_angle({0, 0, 0}, {1, 0, 0}, {0, 0, 0}) == exact(pi));
  CHECK(wrap_angle({0, 0, 0}, {1, 0, 0}, {1.0 + std::cos(1e-9), std::sin(1e-9), 0}) ==
        Approx(1e-9).epsilon(1e-12));
  const auto row =
      evaluate(kWrapAngleForm, {}, {{1, 2, 3, 1, 2, 8, 1.0, 2.0 + std::sqrt(3.0), 9}}).back();
  CHECK(row[0] == exact(pi / 3.0));
}

TEST_CASE("a slip ring sticks elastically in the flow and slips at either end of its band") {
  const auto rows = evaluate(
      kForm, kRing,
      {{0.3, 100.0}, {0.33, 100.0}, {0.5, 100.0}, {0.4, 100.0}, {0.1, 100.0}, {0.1, 100.0}});
  const double upper = 100.0 * std::expm1(0.2 * pi);
  const double lower = 100.0 * std::expm1(-0.2 * pi);
  CHECK(rows[0][0] == 0.0);
  CHECK(rows[1][0] == exact(30.0));
  CHECK(rows[1][1] == exact(130.0));
  CHECK(rows[1][4] == 0.0);
  CHECK(rows[2][0] == exact(upper));
  CHECK(rows[2][2] == exact(upper));
  CHECK(rows[2][3] == exact(lower));
  CHECK(rows[2][1] == exact(187.445608758534));
  CHECK(rows[2][4] == exact(0.2 - upper / 1000.0));
  CHECK(rows[3][0] == exact(upper - 100.0));
  CHECK(rows[4][0] == exact(lower));
  CHECK(rows[4][1] == exact(53.3488091091103));
  CHECK(rows[4][4] == exact(0.2 - upper / 1000.0 + 0.4 - (upper - lower) / 1000.0));
  CHECK(rows[5] == rows[4]);
  for (const auto& row : rows) CHECK(row[7] == exact(row[5] + row[6]));
}

TEST_CASE("a slip ring's work is its dissipation and stored energy under any tension") {
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::vector<double>> path{{0.0, 50.0}};
  for (int i = 0; i < 300; ++i) {
    // Sometimes slack.
    path.push_back({path.back()[0] + 0.4 * (uniform(dice) - 0.5), 200.0 * uniform(dice) - 30.0});
  }
  const auto rows = evaluate(kForm, kRing, path);
  double slips = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    CHECK(row[0] <= row[2] * (1.0 + 1e-14));
    CHECK(row[0] >= row[3] * (1.0 + 1e-14));
    CHECK(row[4] >= rows[i - 1][4]);
    CHECK(row[5] >= rows[i - 1][5]);
    // Three hundred increments' roundings add up.
    CHECK(row[7] == Approx(row[5] + row[6]).epsilon(1e-11));
    if (row[4] > rows[i - 1][4]) ++slips;
  }
  CHECK(slips > 100);
}

TEST_CASE("increments of a straight piece change nothing for a slip ring, slack or taut") {
  const std::vector<std::vector<double>> corners{{0.0, 100.0}, {0.2, 40.0},  {0.25, 160.0},
                                                 {0.0, -60.0}, {0.1, -20.0}, {0.3, 90.0},
                                                 {-0.2, 30.0}};
  std::vector<std::vector<double>> fine{corners[0]};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (int j = 1; j <= 9; ++j) {
      std::vector<double> point(2);
      for (std::size_t c = 0; c < 2; ++c) {
        point[c] = corners[i - 1][c] + j / 9.0 * (corners[i][c] - corners[i - 1][c]);
      }
      fine.push_back(point);
    }
  }
  const auto coarse_rows = evaluate(kForm, kRing, corners);
  const auto fine_rows = evaluate(kForm, kRing, fine);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t c = 0; c < coarse_rows[i].size(); ++c) {
      CHECK(fine_rows[9 * i][c] == Approx(coarse_rows[i][c]).epsilon(1e-11).margin(1e-12));
    }
  }
  CHECK(coarse_rows[3][0] == 0.0);
  CHECK(coarse_rows[3][1] == -60.0);
  CHECK(coarse_rows[4][0] == 0.0);
  CHECK(coarse_rows[5][0] > 0.0);
}

TEST_CASE("a slip ring without friction or without wrap passes the tension on") {
  const std::vector<std::vector<double>> path{{0.0, 80.0}, {5.0, 90.0}, {-3.0, 20.0}};
  for (const auto& parameters :
       {std::vector<std::vector<double>>{{0.0}, {pi}, {1000.0}}, {{0.2}, {0.0}, {1000.0}}}) {
    for (const auto& row : evaluate(kForm, parameters, path)) {
      CHECK(row[0] == 0.0);
      CHECK(row[4] == 0.0);
    }
    CHECK(evaluate(kForm, parameters, path).back()[1] == 20.0);
  }
}

TEST_CASE("a continuum belt on a drum by finite elements bears the capstan out") {
  struct Peer {
    double mu;
    double degrees;
    double rising;  // far tension 100, mean of the plateau
    double falling;
  };
  // CalculiX, a belt of solid elements with finite thickness, which shifts its plateau by 0.2 %.
  const Peer peers[] = {{0.1, 90, 117.13, 85.40},
                        {0.2, 90, 136.93, 73.06},
                        {0.3, 90, 160.06, 62.54},
                        {0.2, 180, 187.23, 53.38}};
  const char* rising[] = {"117.009", "136.911", "160.198", "187.446"};
  const char* falling[] = {"85.464", "73.040", "62.423", "53.349"};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& peer = peers[i];
    const auto row = evaluate(kBandForm, {}, {{100.0, peer.mu, peer.degrees / 180.0 * pi}}).back();
    CHECK_THAT(row[2], printed(rising[i]));
    CHECK_THAT(row[3], printed(falling[i]));
    CHECK(row[2] == Approx(peer.rising).epsilon(0.002));
    CHECK(row[3] == Approx(peer.falling).epsilon(0.002));
  }
}
