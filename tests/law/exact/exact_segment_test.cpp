// SPDX-License-Identifier: Apache-2.0
#include "law/exact/exact_segment.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using namespace slipbench::law;
using std::numbers::pi;

TEST_CASE("the half angle is accurate at both ends") {
  // tan(psi/2) = across / (length + along): 5e-13 and, mirrored, its reciprocal.
  const HalfAngle ahead = half_angle({1.0, 1e-12});
  CHECK(ahead.sine / ahead.cosine == Approx(5e-13).epsilon(1e-14));
  const HalfAngle behind = half_angle({-1.0, 1e-12});
  CHECK(behind.cosine / behind.sine == Approx(5e-13).epsilon(1e-14));
  CHECK(half_angle({-3.0, 0.0}).sine == 1.0);
  CHECK(half_angle({-3.0, 0.0}).cosine == 0.0);
  CHECK(half_angle({0.0, 0.0}).cosine == 1.0);
  const PlaneSlip back = on_radius(half_angle({-0.6, 0.8}), 2.0);
  CHECK(back.along == Approx(-1.2).epsilon(1e-15));
  CHECK(back.across == Approx(1.6).epsilon(1e-15));
}

TEST_CASE("straight on and straight back do not turn, however far") {
  CHECK(turned({1.0, 0.0}, 1e300).sine == 0.0);
  CHECK(turned({0.0, 1.0}, 1e300).cosine == 0.0);
  const HalfAngle far = turned(half_angle({0.0, 1.0}), 1e4);
  CHECK(far.cosine == 1.0);
  CHECK(far.sine == 0.0);
}

TEST_CASE("what a turn leaves beside the motion vanishes in all units alike") {
  const double r = 0x1p-10;
  for (const double turn : {1.0, 100.0, 225.0, 235.0, 700.0, 735.0}) {
    CAPTURE(turn);
    const HalfAngle angle = turned(half_angle({0.0, 1.0}), turn);
    CHECK((angle.sine == 0.0) == (turn > 230.3));  // exp(-turn) < 1e-100
    for (const double unit : {0x1p-40, 0x1p30}) {
      CHECK(on_radius(angle, unit * r).across == unit * on_radius(angle, r).across);
    }
  }
}

TEST_CASE("the stick length is the positive root, without cancellation") {
  CHECK(stick_length({0.0, 0.0}, 0.02) == 0.02);
  CHECK(stick_length({-0.02, 0.0}, 0.02) == Approx(0.04).epsilon(1e-15));
  CHECK(stick_length({0.02, 0.0}, 0.02) == 0.0);
  // |(a + w, b)| = R with b = R: w = -2 a only for a < 0.
  CHECK(stick_length({-0.006, 0.016}, 0.02) ==
        Approx(0.006 + std::sqrt(0.02 * 0.02 - 0.016 * 0.016)).epsilon(1e-14));
  // Almost on the radius and ahead: reserve/(2 along), here 1e-12 R^2 / (2 R).
  const double r = 1.0;
  const double a = 1.0 - 1e-12;
  CHECK(stick_length({a, 0.0}, r) == Approx(1.0 - a).epsilon(1e-12));
  // 3, 4 and 5 eighths, with 2^-40 more of radius: 2^-40 R/along.
  CHECK(stick_length({0.375, 0.5}, 0.625 + 0x1p-40) ==
        Approx(0x1p-40 * 0.625 / 0.375).epsilon(1e-11));
}

TEST_CASE("after a right angle the force is sech and tanh, the slip ln cosh") {
  // Reference case D1 in elastic slip: R = lim/k = 0.02 mm.
  const double r = 0.02;
  for (const double w : {1e-9, 0.005, 0.01, 0.05, 1.0}) {
    const SegmentEnd end = exact_segment({0.0, r}, w, r);
    CHECK(std::abs(end.elastic_slip.across - r / std::cosh(w / r)) <= 4e-16 * r);
    CHECK(std::abs(end.elastic_slip.along - r * std::tanh(w / r)) <= 4e-16 * r);
    // ln cosh of a small number is its square's half: the sum of two lengths cannot be better than
    // the rounding of the travel.
    const double x = w / r;
    const double slip = r * (x + std::log1p(std::exp(-2.0 * x)) - std::numbers::ln2);
    CHECK(std::abs(end.slip - slip) <= 4e-16 * (w + r));
    CHECK(end.stick == 0.0);
  }
}

TEST_CASE("motion sticks up to the radius and slips from there") {
  const SegmentEnd inside = exact_segment({0.005, 0.0}, 0.01, 0.02);
  CHECK(inside.stick == 0.01);
  CHECK(inside.elastic_slip.along == 0.015);
  CHECK(inside.slip == 0.0);
  const SegmentEnd beyond = exact_segment({0.005, 0.0}, 0.05, 0.02);
  CHECK(beyond.stick == Approx(0.015).epsilon(1e-15));
  CHECK(beyond.elastic_slip.along == 0.02);
  CHECK(beyond.slip == Approx(0.035).epsilon(1e-15));
}

TEST_CASE("nothing moves without motion") {
  const SegmentEnd end = exact_segment({0.012, 0.016}, 0.0, 0.02);
  CHECK(end.elastic_slip.along == 0.012);
  CHECK(end.elastic_slip.across == 0.016);
  CHECK(end.slip == 0.0);
}

TEST_CASE("a segment and its halves have the same end") {
  const double r = 0.02;
  for (const double psi : {0.0, 1e-8, 0.3, 1.5, 2.0, 3.1, pi - 1e-9}) {
    const PlaneSlip begin{r * std::cos(psi), r * std::sin(psi)};
    const SegmentEnd whole = exact_segment(begin, 0.07, r);
    const SegmentEnd half = exact_segment(begin, 0.035, r);
    const SegmentEnd rest = exact_segment(half.elastic_slip, 0.035, r);
    CHECK(std::abs(rest.elastic_slip.along - whole.elastic_slip.along) <= 1e-14 * r);
    CHECK(std::abs(rest.elastic_slip.across - whole.elastic_slip.across) <= 1e-14 * r);
    CHECK(std::abs(half.slip + rest.slip - whole.slip) <= 1e-14 * r);
  }
}

}  // namespace
