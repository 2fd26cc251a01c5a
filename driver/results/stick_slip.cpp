// SPDX-License-Identifier: Apache-2.0
#include "driver/results/stick_slip.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::driver::results {
namespace {

/// Returns where a motion turns within an increment, as far as the cubic through its ends tells.
void add_turns(double begin, double begin_velocity, double end, double end_velocity,
               double duration, Extremes& places) {
  const double a = duration * begin_velocity;
  const double b = 3.0 * (end - begin) - 2.0 * a - duration * end_velocity;
  const double c = a + duration * end_velocity - 2.0 * (end - begin);
  // The slope a + 2 b x + 3 c x^2 vanishes at both of these.
  const double square = b * b - 3.0 * a * c;
  if (!(square >= 0.0)) return;
  const double q = -(b + std::copysign(std::sqrt(square), b));
  for (const double x : {q / (3.0 * c), a / q}) {
    if (x > 0.0 && x < 1.0) places.add(begin + x * (a + x * (b + x * c)));
  }
}

}  // namespace

StickSlipCounter::StickSlipCounter(const cases::Case& problem, std::size_t definition) {
  const law::SlipSpace& slip = problem.definitions[definition].law.slip;
  if (problem.dynamics && slip.dimension == 1 && slip.component[0] == problem.dynamics->component) {
    component_ = problem.dynamics->component;
  }
}

void StickSlipCounter::add(const Event& event, const bench::Row& row) {
  if (slips_) slip_time_ += event.time - slips_since_;
  slips_ = event.to == law::Regime::kSlip;
  slips_since_ = event.time;
  force_.add(event.force);
  if (component_ >= 0) place_.add(position_at(event, row, component_));
  if (event.reversal) loose_.reset();
  if (!slips_ || event.from != law::Regime::kStick) return;
  if (loose_ && !event.reversal) {
    const double period = event.time - *loose_;
    if (done_.cycles++ == 0) done_.first = *loose_;
    done_.last = event.time;
    done_.period.add(period);
    done_.time += period;
    done_.slip_time += slip_time_;
    done_.force.add(force_);
    if (component_ >= 0) done_.place.add(place_);
  }
  loose_ = event.time;
  slip_time_ = 0.0;
  force_ = {};
  place_ = {};
  force_.add(event.force);
  if (component_ >= 0) place_.add(position_at(event, row, component_));
}

void StickSlipCounter::add_place(const bench::Row& row) {
  const double end = row.quantities[static_cast<std::size_t>(cases::kFirstMotion + component_)];
  if (row.index > 0) {
    add_turns(row.begin[component_], velocity_, end, row.forces.velocity, row.duration, place_);
  }
  place_.add(end);
  velocity_ = row.forces.velocity;
}

}  // namespace slipbench::driver::results
