// SPDX-License-Identifier: Apache-2.0
#include "reference/contact_force_ujoint.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::contact_force_ujoint;

namespace {
constexpr Ujoint kJoint{0.1, 0.08, 0.2, 1.0, 0.0, 0.0};
}

TEST_CASE("UJOINT's slenderness factors have the printed values and keep their sums") {
  const auto factors = slenderness_factors(10.0);
  CHECK_THAT(factors.axial, printed("0.456731"));
  CHECK_THAT(factors.shear, printed("0.0432692"));
  CHECK_THAT(factors.twist_bending, printed("0.101563"));
  CHECK_THAT(factors.twist_shear, printed("0.351563"));
  for (const double slenderness : {0.01, 1.0, 2.0, 4.0, 6.0, 30.0}) {
    const auto f = slenderness_factors(slenderness);
    CHECK(f.axial + f.shear == Approx(0.5).epsilon(1e-15));
    CHECK(f.twist_shear - f.twist_bending == Approx(0.25).epsilon(1e-15));
  }
}

TEST_CASE("UJOINT's slenderness factors are continuous and start at their known values") {
  for (const double knot : {2.0, 6.0}) {
    const auto below = slenderness_factors(std::nextafter(knot, 0.0));
    const auto above = slenderness_factors(knot);
    // Neighbouring doubles: only rounding may separate the two formulas.
    CHECK(below.axial == Approx(above.axial).epsilon(1e-14));
    CHECK(below.twist_bending == Approx(above.twist_bending).epsilon(1e-14));
  }
  const auto squat = slenderness_factors(1e-12);
  CHECK(squat.axial == Approx(0.25).epsilon(1e-11));
  CHECK(std::abs(squat.twist_bending) < 1e-12);
}

TEST_CASE("UJOINT has the printed limits") {
  const std::vector<std::vector<double>> parameters{{0.1}, {0.08}, {0.2}, {1.0}, {0.0}, {0.0}};
  const std::vector<double> straight{100, 50, 20, 8, 0, 0};
  CHECK_THAT(0.1 * evaluate("contact_force_ujoint_1", parameters, {straight})[0][0],
             printed("2.24812"));
  CHECK_THAT(0.1 * evaluate("contact_force_ujoint_3", parameters, {straight})[0][0],
             printed("1.67714"));

  const std::vector<std::vector<double>> fitted{{0.1}, {0.08}, {0.2}, {1.0}, {1.0}, {2.0}};
  const std::vector<double> bent{100, 50, 20, 8, 0.5, 0};
  CHECK_THAT(0.1 * evaluate("contact_force_ujoint_1", fitted, {bent})[0][0], printed("2.45055"));
  CHECK_THAT(0.1 * evaluate("contact_force_ujoint_3", fitted, {bent})[0][0], printed("1.88002"));
}

TEST_CASE("UJOINT's trigonometric shares are the projections on the cross's axes") {
  using Vector = std::array<double, 3>;
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const SlendernessFactors factors{0.4, 0.1, 0.11, 0.36};
  for (const double alpha : {-3.0, -0.7, 0.0, 0.5, 2.0}) {
    for (const double beta : {-1.2, -0.3, 0.0, 0.9}) {
      const Vector f{70.0, -40.0, 25.0};
      const Vector e3b{std::sin(beta), -std::sin(alpha) * std::cos(beta),
                       std::cos(alpha) * std::cos(beta)};
      Vector cross{0.0, -e3b[2], e3b[1]};
      const double norm = std::sqrt(dot(cross, cross));
      for (double& c : cross) c /= norm;
      const double a1 = std::abs(f[0]);
      const double a3 = std::abs(dot(f, e3b));
      const double b = std::abs(dot(f, cross));
      const double h = 0.11 * 6.0;
      const double v = 0.36 * 6.0 / 1.0;
      const double w = 2.0 / 0.2 * std::sqrt(b * b / 64.0 + h * h);
      const auto expected = [&](double own, double other) {
        return 2.0 * (0.4 * own * 0.08 +
                      0.1 * (std::sqrt(b * b / 16.0 + v * v + 0.01 * other * other) + w));
      };
      const auto moments = normal_moments(kJoint, factors, {f[0], f[1], f[2], -6.0, alpha, beta});
      CHECK(moments.axis_1 == Approx(expected(a1, a3)).epsilon(1e-13));
      CHECK(moments.axis_3 == Approx(expected(a3, a1)).epsilon(1e-13));
    }
  }
}
