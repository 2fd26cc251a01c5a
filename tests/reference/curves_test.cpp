// SPDX-License-Identifier: Apache-2.0
// The shipped curves against the closed forms they come from, number by number.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/cattaneo_mindlin.hpp"
#include "reference/coulomb_slider.hpp"
#include "reference/dahl.hpp"
#include "reference/elastic_belt.hpp"
#include "reference/planar_slider.hpp"
#include "reference/planar_slider_circle.hpp"
#include "reference/varying_normal_force.hpp"
#include "reference/wear.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"
#include "tests/support/project_paths.hpp"

using namespace slipbench::reference;
using std::numbers::pi;

namespace {

/// A file of reference/curves: its header and its numbers as they are printed.
class Curve {
 public:
  explicit Curve(const std::string& name) {
    std::ifstream file(slipbench::test::source_dir() + "/reference/curves/" + name + ".csv");
    std::string line;
    while (std::getline(file, line)) {
      if (line.starts_with("#")) continue;
      std::vector<std::string> fields;
      std::istringstream text(line);
      for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
      if (names_.empty()) {
        names_ = fields;
      } else {
        rows_.push_back(fields);
      }
    }
    INFO(name);
    REQUIRE(rows_.size() > 40);
    for (const auto& row : rows_) REQUIRE(row.size() == names_.size());
  }

  std::size_t size() const { return rows_.size(); }

  const std::string& text(std::size_t row, const std::string& column) const {
    const auto found = std::find(names_.begin(), names_.end(), column);
    REQUIRE(found != names_.end());
    return rows_[row][static_cast<std::size_t>(found - names_.begin())];
  }

  double number(std::size_t row, const std::string& column) const {
    return std::stod(text(row, column));
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

// Fifteen digits are printed; what is computed from printed motions has their rounding times the
// stiffness in it, a few units of the last digit.
Approx fifteen_digits(double value) { return Approx(value).epsilon(2e-14).margin(2e-13); }

/// The outputs of a closed form along columns of a curve.
std::vector<std::vector<double>> along(const Curve& curve, const std::vector<std::string>& columns,
                                       std::string_view form,
                                       const std::vector<std::vector<double>>& parameters) {
  std::vector<std::vector<double>> inputs;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    inputs.emplace_back();
    for (const std::string& column : columns) inputs.back().push_back(curve.number(i, column));
  }
  return evaluate(form, parameters, inputs);
}

constexpr planar_slider::Slider kPlanar{1000.0, 20.0};
constexpr double kRadius = 0.05;

/// One increment of backward Euler for the slider in a plane: trial, then back to the limit.
void radial_return(planar_slider::State& state, planar_slider::Vector motion, double limit) {
  const double k = kPlanar.stick_stiffness;
  planar_slider::Vector trial{state.force.x + k * (motion.x - state.motion.x),
                              state.force.y + k * (motion.y - state.motion.y)};
  const double size = std::hypot(trial.x, trial.y);
  if (size > limit) {
    state.accumulated_slip += (size - limit) / k;
    trial = {trial.x * limit / size, trial.y * limit / size};
  }
  state.force = trial;
  state.motion = motion;
}

/// A point run of CalculiX against the motion and normal force it was given and radial return.
void check_point_run(const std::string& name, planar_slider::Vector (*motion)(double),
                     double gradient) {
  const Curve curve(name);
  planar_slider::State state;
  REQUIRE(curve.size() == 201);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO(name << " row " << i);
    const double time = static_cast<double>(i) / 200.0;
    const planar_slider::Vector u = motion(time);
    const double normal_force = 100.0 + gradient * u.x;
    radial_return(state, u, 0.2 * normal_force);
    CHECK(curve.number(i, "time") == Approx(time).margin(1e-15));
    // Seven digits are printed, and beside a zero its rounding.
    const auto seven_digits = [](double value) {
      return Approx(value).epsilon(5.001e-7).margin(1e-13);
    };
    CHECK(curve.number(i, "ux_mm") == seven_digits(u.x));
    CHECK(curve.number(i, "uy_mm") == seven_digits(u.y));
    CHECK(curve.number(i, "N_N") == seven_digits(normal_force));
    CHECK(curve.number(i, "p_ccx_MPa") == seven_digits(normal_force));
    CHECK(curve.number(i, "fx_ccx_N") == seven_digits(state.force.x));
    CHECK(curve.number(i, "fy_ccx_N") == seven_digits(state.force.y));
    // Twelve digits are printed.
    const auto twelve_digits = [](double value) {
      return Approx(value).epsilon(5.1e-12).margin(1e-13);
    };
    CHECK(curve.number(i, "fx_return_N") == twelve_digits(state.force.x));
    CHECK(curve.number(i, "fy_return_N") == twelve_digits(state.force.y));
    CHECK(curve.number(i, "accslip_return_mm") == twelve_digits(state.accumulated_slip));
  }
}

planar_slider::Vector sine(double time) { return {0.1 * std::sin(2.5 * pi * time), 0.0}; }
planar_slider::Vector corner(double time) {
  return {0.1 * std::min(time, 0.5), 0.1 * std::max(time - 0.5, 0.0)};
}
planar_slider::Vector two_turns(double time) {
  const double p = 4.0 * pi * time;
  return {kRadius * (std::cos(p) - 1.0), kRadius * std::sin(p)};
}

}  // namespace

TEST_CASE("the curve of the slider on a triangle is its closed form") {
  const Curve curve("coulomb_triangle");
  const double none = std::numeric_limits<double>::infinity();
  const auto rows = along(curve, {"u_mm"}, "coulomb_slider", {{0.2}, {100.0}, {1000.0}, {none}});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    CHECK(curve.number(i, "N_N") == 100.0);
    CHECK(curve.number(i, "F_N") == fifteen_digits(rows[i][0]));
    CHECK(curve.number(i, "accslip_mm") == fifteen_digits(rows[i][1]));
    CHECK(curve.number(i, "dissipation_mJ") == fifteen_digits(rows[i][2]));
    if (i == 0) continue;
    const double step = std::abs(curve.number(i, "u_mm") - curve.number(i - 1, "u_mm"));
    CHECK(step == Approx(0.0025).epsilon(1e-10));
  }
}

TEST_CASE("the curve of the normal force in phase is its closed form") {
  const Curve curve("coulomb_in_phase_normal");
  const auto rows = along(curve, {"u_mm", "N_N"}, "varying_normal_force", {{0.2}, {1000.0}});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    CHECK(curve.number(i, "N_N") == Approx(100.0 + 500.0 * curve.number(i, "u_mm")).epsilon(1e-15));
    CHECK(curve.number(i, "F_N") == fifteen_digits(rows[i][0]));
  }
}

TEST_CASE("the curve of the normal force in quadrature is its closed form") {
  const Curve curve("coulomb_quadrature_normal");
  // The rounding of the phase, 5e-15, times the slope of the sticking force, k A = 100 N.
  const auto to_the_phase = [](double value) { return Approx(value).margin(1e-12); };
  const auto rows = along(curve, {"phase_rad"}, "quadrature_normal_force",
                          {{0.2}, {1000.0}, {0.1}, {100.0}, {0.5}, {2.0 * pi}, {0.0}});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    const double p = curve.number(i, "phase_rad");
    CHECK(p == Approx(static_cast<double>(i) * pi / 80.0).epsilon(1e-14));
    CHECK(curve.number(i, "u_mm") == Approx(0.1 * std::sin(p)).margin(2e-15));
    CHECK(curve.number(i, "N_N") == fifteen_digits(100.0 * (1.0 - 0.5 * std::cos(p))));
    CHECK(curve.number(i, "F_N") == to_the_phase(rows[i][0]));
  }
}

TEST_CASE("the curve around a corner is its closed form") {
  const Curve curve("coulomb_l_path");
  const auto rows = along(curve, {"ux_mm", "uy_mm"}, "planar_slider", {{0.2}, {100.0}, {1000.0}});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    CHECK(curve.number(i, "fx_N") == fifteen_digits(rows[i][0]));
    CHECK(curve.number(i, "fy_N") == fifteen_digits(rows[i][1]));
    const double leg = curve.number(i, "uy_mm");
    const double first = std::max(curve.number(i, "ux_mm") - 0.02, 0.0);
    CHECK(curve.number(i, "accslip_mm") ==
          fifteen_digits(first + (leg > 0.0 ? planar_slider::l_path(kPlanar, leg).slip : 0.0)));
  }
}

TEST_CASE("the curve of the circle is its closed form") {
  const Curve curve("coulomb_circle");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    const double p = curve.number(i, "phase_rad");
    CHECK(p == Approx(static_cast<double>(i) * pi / 60.0).epsilon(1e-14));
    const auto force = planar_slider::circle_transient(kPlanar, kRadius, p);
    CHECK(curve.number(i, "ux_mm") == Approx(kRadius * (std::cos(p) - 1.0)).margin(2e-15));
    CHECK(curve.number(i, "uy_mm") == Approx(kRadius * std::sin(p)).margin(2e-15));
    // The force turns with the phase, whose fifteen digits are off by up to 5e-14, times 20 N.
    CHECK(curve.number(i, "fx_N") == Approx(force.x).margin(1.2e-12));
    CHECK(curve.number(i, "fy_N") == Approx(force.y).margin(1.2e-12));
  }
}

TEST_CASE("the curve of the Dahl model is its closed form") {
  const Curve curve("dahl_loop");
  const dahl::Contact contact{20.0, 1000.0};
  dahl::State state{.force = dahl::loop_force(contact, 0.1)};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    const double x = curve.number(i, "x_mm");
    state = dahl::advance(contact, state, i > 0 ? x - curve.number(i - 1, "x_mm") : 0.0);
    CHECK(curve.number(i, "F_N") == fifteen_digits(state.force));
  }
}

TEST_CASE("the curve of two spheres is its closed form") {
  const Curve curve("cattaneo_mindlin_loop");
  const auto rows = along(curve, {"delta_mm"}, "cattaneo_mindlin",
                          {{10.0}, {10.0}, {210000.0}, {210000.0}, {0.3}, {0.3}, {100.0}, {0.2}});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    CHECK(curve.number(i, "T_N") == fifteen_digits(rows[i][0]));
  }
}

TEST_CASE("the curves of wear are their closed forms") {
  const Curve linear("wear_linear");
  const wear::LinearWear falls{0.2, 1000.0, 100.0, 50.0};
  for (std::size_t i = 0; i < linear.size(); ++i) {
    INFO("row " << i);
    const auto slip = wear::monotone(falls, linear.number(i, "u_mm"));
    CHECK(linear.number(i, "F_N") == fifteen_digits(slip.force));
    CHECK(linear.number(i, "accslip_mm") == fifteen_digits(slip.accumulated_slip));
    CHECK(linear.number(i, "Fint_N") ==
          fifteen_digits(wear::internal_contact_force(falls, slip.accumulated_slip)));
  }
  const Curve exponential("wear_exponential");
  const wear::ExponentialWear settles{0.2, 1000.0, 40.0, 100.0, 0.5};
  for (std::size_t i = 0; i < exponential.size(); ++i) {
    INFO("row " << i);
    const auto slip = wear::monotone(settles, exponential.number(i, "u_mm"));
    CHECK(exponential.number(i, "F_N") == fifteen_digits(slip.force));
    CHECK(exponential.number(i, "accslip_mm") == fifteen_digits(slip.accumulated_slip));
    CHECK(exponential.number(i, "Fint_N") ==
          fifteen_digits(wear::internal_contact_force(settles, slip.accumulated_slip)));
  }
}

TEST_CASE("the table of capstan ratios is exp(mu alpha)") {
  const Curve curve("capstan_ratio");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    const double exponent = curve.number(i, "mu") * curve.number(i, "wrap_deg") * pi / 180.0;
    CHECK_THAT(1.0 + capstan::band(exponent, 1.0).upper, printed(curve.text(i, "ratio")));
  }
}

TEST_CASE("the curve of an elastic belt's reversal is its closed form") {
  const Curve curve("elastic_belt_reversal");
  const elastic_belt::Belt belt{0.2, pi, 30.0, 50000.0, 100.0};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    INFO("row " << i);
    const double tension = curve.number(i, "Tin_N");
    // The square root of the travel is a difference of the tensions' square roots: the rounding of
    // the printed tension of 187 N, 5e-13 N, counts as sqrt(travel C/T) times that.
    const double rounding =
        2.0 *
        std::sqrt(curve.number(i, "travel_back_mm") * elastic_belt::compliance(belt) / tension) *
        1e-12;
    CHECK(curve.number(i, "travel_back_mm") == Approx(elastic_belt::reversal_travel(belt, tension))
                                                   .epsilon(1e-14)
                                                   .margin(rounding + 1e-20));
  }
}

TEST_CASE("the point runs of CalculiX agree with radial return to their digits") {
  check_point_run("calculix_sine", sine, 0.0);
  check_point_run("calculix_in_phase_normal", sine, 500.0);
  check_point_run("calculix_l_path", corner, 0.0);
  check_point_run("calculix_circle", two_turns, 0.0);
}

TEST_CASE("the belt that CalculiX ran reverses along the closed form of an elastic belt") {
  const Curve curve("calculix_belt");
  // Compliance and straight piece are not kept with the curve; both follow from its first reversal.
  constexpr double kArc = 2.36e-3;
  constexpr double kStraight = 1.0e-4;
  struct Reversal {
    double begin, end, rate;  // times of the pull, and how fast end B moves: as A in steady slip
    double from;              // tension
  };
  const double low = 100.0 * std::exp(-0.2 * pi);
  const double high = 100.0 * std::exp(0.2 * pi);
  for (const Reversal& r : {Reversal{1.0, 1.3501, 0.3, low}, Reversal{2.0, 2.2501, 0.42, high},
                            Reversal{3.0, 3.2501, 0.42, low}}) {
    double worst = 0.0;
    int compared = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double time = curve.number(i, "step_time");
      if (time <= r.begin || time > r.end) continue;
      const double tension = curve.number(i, "pull_B_N");
      const double root = std::sqrt(tension) - std::sqrt(r.from);
      const double travel = kArc * root * root + kStraight * std::abs(tension - r.from);
      worst = std::max(worst, std::abs(travel - r.rate * (time - r.begin)));
      ++compared;
    }
    CHECK(compared >= 15);
    // The motion of end B is not in the file; read off end A it is known to 1.1 % of its 0.11 mm. A
    // straight line would be off by a quarter of that.
    CHECK(worst < 1.1e-3);
  }
  // Both senses of steady slip as calculix_belt.md tells them: exp(+-mu alpha) to 0.22 %, with the
  // ripples of the mesh.
  struct Steady {
    double begin, end;
    double mean, lowest, highest;
  };
  for (const Steady& steady :
       {Steady{1.4, 2.0001, 187.2, 186.99, 187.36}, Steady{3.4, 4.0001, 187.3, 187.1, 187.53},
        Steady{2.4, 3.0001, 53.46, 53.19, 54.07}}) {
    INFO("from " << steady.begin);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double time = curve.number(i, "step_time");
      if (time < steady.begin || time > steady.end) continue;
      const double tension = curve.number(i, "pull_B_N");
      CHECK(tension > steady.lowest);
      CHECK(tension < steady.highest);
      sum += tension;
      count += 1.0;
    }
    // The mean is told with as many digits.
    CHECK(sum / count == Approx(steady.mean).margin(steady.mean < 100.0 ? 0.01 : 0.05));
    CHECK(sum / count == Approx(steady.mean < 100.0 ? low : high).epsilon(2.25e-3));
  }
}
