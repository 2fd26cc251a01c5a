// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/dynamics.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/bench/bracketed_root.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/case/quantity.hpp"

namespace slipbench::driver::bench {
namespace {

// Of what is integrated, in units of its size: far below what is asked of a result.
constexpr double kOdeTolerance = 1e-13;
constexpr int kPieces = 64;           // of a stick whose forces are no straight lines
constexpr long kMostSteps = 150'000;  // of an increment, those that look for an instant among them

struct FreeStep {
  void operator()(gsl_odeiv2_step* step) const { gsl_odeiv2_step_free(step); }
};
struct FreeControl {
  void operator()(gsl_odeiv2_control* control) const { gsl_odeiv2_control_free(control); }
};
struct FreeEvolve {
  void operator()(gsl_odeiv2_evolve* evolve) const { gsl_odeiv2_evolve_free(evolve); }
};

double sign_of(double x) { return x < 0.0 ? -1.0 : 1.0; }

}  // namespace

struct Dynamics::Stepper {
  std::unique_ptr<gsl_odeiv2_step, FreeStep> step{
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, kEntries)};
  /// For steps that try out an instant: they leave the memory of the evolution alone.
  std::unique_ptr<gsl_odeiv2_step, FreeStep> probe{
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, kEntries)};
  std::unique_ptr<gsl_odeiv2_control, FreeControl> control{
      gsl_odeiv2_control_y_new(kOdeTolerance, kOdeTolerance)};
  std::unique_ptr<gsl_odeiv2_evolve, FreeEvolve> evolve{gsl_odeiv2_evolve_alloc(kEntries)};

  /// The right-hand side in units of the sizes.
  static int right_hand_side(double time, const double y[], double dydt[], void* parameters) {
    const Dynamics& mass = *static_cast<const Dynamics*>(parameters);
    State state;
    for (std::size_t i = 0; i < kEntries; ++i) state[i] = y[i] * mass.scale_[i];
    const State rates = mass.rates(time, state);
    for (std::size_t i = 0; i < kEntries; ++i) dydt[i] = rates[i] / mass.scale_[i];
    return std::isfinite(rates[kRelative]) ? GSL_SUCCESS : GSL_EBADFUNC;
  }
  static gsl_odeiv2_system system(Dynamics& mass) {
    return {right_hand_side, nullptr, kEntries, &mass};
  }
  void reset() const {
    gsl_odeiv2_step_reset(step.get());
    gsl_odeiv2_evolve_reset(evolve.get());
  }
};

Dynamics::Dynamics(const cases::Case& problem)
    : case_(&problem), data_(*problem.dynamics), stepper_(std::make_unique<Stepper>()) {
  // What goes wrong is told by return values; GSL's own handler would end the program.
  gsl_set_error_handler_off();
  mass_ = data_.reduced_mass();
  if (data_.driver) driver_share_ = data_.mass / (data_.mass + data_.driver->mass);
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    const law::SlipSpace& slip = problem.definitions[d].law.slip;
    if (slip.component[0] == data_.component) definition_ = static_cast<int>(d);
  }
  scale_.fill(1.0);
}
Dynamics::Dynamics(Dynamics&&) noexcept = default;
Dynamics::~Dynamics() = default;

law::ConnectorIncrement Dynamics::conditions(double time, double motion) const {
  if (varying_) {
    const double part = time / duration_;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      now_[i] = std::lerp((*begin_)[i], (*end_)[i], part);
    }
  }
  now_[static_cast<std::size_t>(data_.component)] = motion;
  if (follow_ != nullptr) (*follow_)(duration_ > 0.0 ? time / duration_ : 1.0, now_);
  law::ConnectorIncrement increment;
  increment.end = ambient_of(now_, case_->reference);
  std::copy_n(now_.begin() + cases::kFirstForce, law::kComponents, increment.force.values.begin());
  return increment;
}

Dynamics::Forces Dynamics::forces(double time, double motion, double velocity) const {
  const law::ConnectorIncrement here = conditions(time, motion);
  const law::KineticBehavior& kinetic = case_->kinetic;
  Forces forces;
  forces.load = forces.push = here.force[data_.component];
  if (data_.driver) {
    forces.driver = now_[cases::kDriverLoad];
    forces.push = (1.0 - driver_share_) * forces.load - driver_share_ * forces.driver;
  }
  forces.elastic = law::elastic_force(kinetic, data_.component, here.end).force;
  forces.viscous = law::viscous_force(kinetic, data_.component, velocity, here.end).force;
  return forces;
}

void Dynamics::press(double velocity, law::ConnectorIncrement& here) const {
  const law::KineticBehavior& kinetic = case_->kinetic;
  for (int c = 0; c < law::kComponents; ++c) {
    if (!kinetic.pressing.contains(c)) continue;
    if (c == data_.component) {
      here.force[c] = law::kinetic_force(kinetic, c, velocity, here.end) - here.force[c];
    } else {
      const auto i = static_cast<std::size_t>(c);
      const double motion = (*end_)[i] - (*begin_)[i];
      const double mean = duration_ > 0.0 ? motion / duration_ : 0.0;
      here.force[c] = law::kinetic_force(kinetic, c, mean, here.end);
    }
  }
}

law::Limit Dynamics::limit(double time, const State& state, double rate) const {
  if (friction_ == nullptr) return {};
  law::ConnectorIncrement here = conditions(time, state[kMotion]);
  if (!case_->kinetic.pressing.empty()) press(state[kRelative] + data_.belt_velocity, here);
  law::FrictionState old;
  old.accumulated_slip = state[kSlip];
  return law::LimitFunction(*friction_, here, old, 0.0).at(0.0, rate);
}

law::Limit Dynamics::static_limit(double time, const State& state) const {
  law::Limit limit = this->limit(time, state, 0.0);
  if (friction_ == nullptr || !data_.static_coefficient) return limit;
  limit.mu = std::max(limit.mu, *data_.static_coefficient);
  limit.force = std::min(limit.mu * limit.normal_force, friction_->force_limit);
  return limit;
}

Dynamics::State Dynamics::rates(double time, const State& state) const {
  const double w = state[kRelative];
  const double velocity = w + data_.belt_velocity;  // of the connector: w on a driver
  const double surface = surface_velocity(state);
  const Forces f = forces(time, state[kMotion], velocity);
  const double limit = this->limit(time, state, std::abs(w)).force;
  const double friction = sense_ * limit;
  State rates;
  rates[kMotion] = velocity;
  rates[kRelative] = (f.drive() - friction) / mass_;
  rates[kSlip] = limit > 0.0 ? sense_ * w : 0.0;
  rates[kHeat] = friction * w;
  rates[kLoadWork] = f.load * (w + surface) + f.driver * surface;
  rates[kBeltWork] = -friction * data_.belt_velocity;
  rates[kViscous] = f.viscous * velocity;
  rates[kCommon] = data_.driver ? (f.load + f.driver) / (data_.mass + data_.driver->mass) : 0.0;
  return rates;
}

double Dynamics::surface_velocity(const State& state) const {
  return data_.driver ? state[kCommon] - driver_share_ * state[kRelative] : data_.belt_velocity;
}

double Dynamics::relative_acceleration(double time, const State& state) const {
  return sense_ * rates(time, state)[kRelative];
}

Dynamics::State Dynamics::step_from(double time, const State& state, double size) {
  if (!(size > 0.0)) return state;
  ++steps_;
  State y, error;
  for (std::size_t i = 0; i < kEntries; ++i) y[i] = state[i] / scale_[i];
  const gsl_odeiv2_system system = Stepper::system(*this);
  gsl_odeiv2_step_reset(stepper_->probe.get());
  if (gsl_odeiv2_step_apply(stepper_->probe.get(), time, size, y.data(), error.data(), nullptr,
                            nullptr, &system) != GSL_SUCCESS) {
    fault_ = "the motion of the mass is not finite";
  }
  for (std::size_t i = 0; i < kEntries; ++i) y[i] *= scale_[i];
  return y;
}

/// Sizes of what is integrated, from the forces at hand and the time in which they move the mass.
void Dynamics::choose_scales(double time) {
  const double x = state_[kMotion];
  const Forces f = forces(time, x, state_[kRelative] + data_.belt_velocity);
  double period = duration_;
  const double k = law::elastic_force(case_->kinetic, data_.component, conditions(time, x).end)
                       .slope[static_cast<std::size_t>(data_.component)];
  if (k > 0.0) period = std::sqrt(mass_ / k);
  // A load that sets out from 0 has its size at the end of the increment.
  const double load = std::max(std::abs(f.push), std::abs(forces(duration_, x, 0.0).push));
  const double limit =
      std::max(static_limit(time, state_).force, static_limit(duration_, state_).force);
  const double push = (load + std::abs(f.elastic) + std::abs(f.viscous) + limit) / mass_;
  const double speed =
      std::max({std::abs(state_[kRelative]), std::abs(data_.belt_velocity), push * period});
  const double length = std::max(std::abs(x), speed * period);
  constexpr double kNothing = 1e-200;
  const auto sound = [](double size) {
    return size > kNothing && std::isfinite(size) ? size : 1.0;
  };
  scale_.fill(sound(mass_ * speed * speed));
  if (data_.driver) {
    const double common = std::max(speed, std::abs(state_[kCommon]));
    scale_[kCommon] = sound(common);
    scale_[kLoadWork] = sound((data_.mass + data_.driver->mass) * common * common);
  }
  scale_[kMotion] = scale_[kSlip] = sound(length);
  scale_[kRelative] = sound(speed);
  constexpr double kFirstPart = 0.05;
  step_ = kFirstPart * (period > 0.0 ? period : 1.0);
}

double Dynamics::slip(double time) {
  constexpr double kRounding = 1e-13;  // of the size of w
  const auto w_of = [&](const State& state) { return sense_ * state[kRelative]; };
  const gsl_odeiv2_system system = Stepper::system(*this);
  stepper_->reset();
  while (time < duration_) {
    const State before = state_;
    const double begin = time;
    State y;
    for (std::size_t i = 0; i < kEntries; ++i) y[i] = state_[i] / scale_[i];
    const int status =
        gsl_odeiv2_evolve_apply(stepper_->evolve.get(), stepper_->control.get(),
                                stepper_->step.get(), &system, &time, duration_, &step_, y.data());
    if (status != GSL_SUCCESS || !std::isfinite(y[kMotion]) || ++steps_ > kMostSteps) {
      fault_ = steps_ > kMostSteps ? "the motion of the mass needs too many time steps; take more "
                                     "increments, or less stiffness or damping"
                                   : "the motion of the mass is not finite";
      return begin;
    }
    for (std::size_t i = 0; i < kEntries; ++i) state_[i] = y[i] * scale_[i];

    // Does the mass keep up with its belt within this step? At its end, or at a minimum of w.
    const double size = time - begin;
    const auto acceleration = [&](double h) {
      return relative_acceleration(begin + h, step_from(begin, before, h));
    };
    const double turn_before = relative_acceleration(begin, before);
    const double turn_after = relative_acceleration(time, state_);
    Bracket bracket{0.0, size};
    double at_a = w_of(before);
    double at_b = w_of(state_);
    if (at_b > 0.0) {
      if (!(turn_before < 0.0 && turn_after > 0.0)) continue;
      bracket.b = narrow({0.0, size}, turn_before, turn_after, 0.0, acceleration).b;
      at_b = w_of(step_from(begin, before, bracket.b));
      if (at_b > -kRounding * scale_[kRelative]) continue;
    }
    double event = 0.0;
    if (!(at_a > 0.0) && turn_before > 0.0 && turn_after < 0.0) {
      // Slip has just begun: w rises from 0 and comes back behind its maximum.
      bracket.a = narrow({0.0, bracket.b}, turn_before, turn_after, 0.0, acceleration).a;
      at_a = w_of(step_from(begin, before, bracket.a));
    }
    if (at_a > 0.0) {
      event = narrow(bracket, at_a, at_b, 0.0, [&](double h) {
                return w_of(step_from(begin, before, h));
              }).b;
    }
    state_ = step_from(begin, before, event);
    state_[kRelative] = 0.0;
    if (fault_ != nullptr) return begin;
    return begin + event;
  }
  return duration_;
}

double Dynamics::stick(double time) {
  constexpr int kLooks = 16;  // for excursions of force and limit that are no straight lines
  const double velocity = data_.belt_velocity;
  const State before = state_;
  const auto moved = [&](double t) {
    State state = before;
    state[kMotion] += velocity * (t - time);
    return state;
  };
  // Above 0 the mass breaks loose.
  const auto excess = [&](double t) {
    const State state = moved(t);
    const double g =
        std::abs(forces(t, state[kMotion], velocity).drive()) - static_limit(t, state).force;
    return g != 0.0 ? g : -std::numeric_limits<double>::min();
  };
  double end = duration_;
  if (varying_ || velocity != 0.0) {
    double a = time;
    double at_a = std::min(excess(time), -std::numeric_limits<double>::min());
    for (int i = 1; i <= kLooks; ++i) {
      const double b = i == kLooks ? duration_ : time + (duration_ - time) * i / kLooks;
      const double at_b = excess(b);
      if (at_b > 0.0) {
        end = narrow({a, b}, at_a, at_b, 0.0, excess).b;
        break;
      }
      a = b;
      at_a = at_b;
    }
  }
  // Load and coupled springs are linear in time, so that Simpson's rule is exact; the damper's
  // force changes at most with temperature and fields. The work of a spring of its own is the
  // energy it takes up; where that depends on temperature or fields too, many pieces have to do.
  const auto& own = case_->kinetic.elasticity[static_cast<std::size_t>(data_.component)];
  const bool by_more = own && own->table() != nullptr && own->table()->independents().size() > 1;
  const bool by_energy = own && !by_more;
  const auto powers = [&](double t) {
    const Forces f = forces(t, before[kMotion] + velocity * (t - time), velocity);
    const double spring = by_energy ? 0.0 : f.elastic;
    return std::array<double, 3>{f.load * velocity, (spring + f.viscous - f.load) * velocity,
                                 f.viscous * velocity};
  };
  const auto spring_energy = [&](double t) {
    if (!by_energy) return 0.0;
    return law::elastic_energy(case_->kinetic, data_.component, conditions(t, state_[kMotion]).end);
  };
  const double energy_before = spring_energy(time);
  state_ = moved(end);
  if (data_.driver) move_together(time, end);
  if (velocity != 0.0) {
    state_[kBeltWork] += spring_energy(end) - energy_before;
    const int pieces = by_more || follow_ != nullptr ? kPieces : 1;
    const double h = (end - time) / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double t = time + h * i;
      const auto first = powers(t), middle = powers(t + 0.5 * h), last = powers(t + h);
      const auto mean = [&](std::size_t k) { return (first[k] + 4.0 * middle[k] + last[k]) / 6.0; };
      state_[kLoadWork] += h * mean(0);
      state_[kBeltWork] += h * mean(1);
      state_[kViscous] += h * mean(2);
    }
  }
  return end;
}

/// Two masses that stick move as one under their loads: these are linear in time, so that Simpson's
/// rule is exact for impulse and work, unless they follow the positions.
void Dynamics::move_together(double time, double end) {
  const double mass = data_.mass + data_.driver->mass;
  const int pieces = follow_ == nullptr ? 1 : kPieces;
  const double h = (end - time) / pieces;
  const auto load = [&](double t) {
    const Forces f = forces(t, state_[kMotion], 0.0);
    return f.load + f.driver;
  };
  for (int i = 0; i < pieces; ++i) {
    const double t = time + h * i;
    const double first = load(t), middle = load(t + 0.5 * h), last = load(t + h);
    const double v = state_[kCommon];
    const double half = v + h / 24.0 * (5.0 * first + 8.0 * middle - last) / mass;
    state_[kCommon] = v + h / 6.0 * (first + 4.0 * middle + last) / mass;
    state_[kLoadWork] += h / 6.0 * (first * v + 4.0 * middle * half + last * state_[kCommon]);
  }
}

void Dynamics::decide(double time) {
  const double drive = forces(time, state_[kMotion], data_.belt_velocity).drive();
  sense_ = 0;
  if (std::abs(drive) > static_limit(time, state_).force) sense_ = drive < 0.0 ? -1 : 1;
}

double Dynamics::friction_force(double time) const {
  if (sense_ != 0) return sense_ * limit(time, state_, std::abs(state_[kRelative])).force;
  return forces(time, state_[kMotion], data_.belt_velocity).drive();
}

/// Tells whether stick or slip began, or slip turned against friction: without a limit nothing
/// does.
bool Dynamics::changes_since(int old, double time) const {
  if ((old == 0) != (sense_ == 0)) return true;
  return old != sense_ && static_limit(time, state_).force > 0.0;
}

void Dynamics::note_change(double time, Row& row) const {
  if (definition_ < 0) return;
  law::RegimeChanges& changes = row.definitions[static_cast<std::size_t>(definition_)].changes;
  const auto i = static_cast<std::size_t>(changes.count);
  if (i >= changes.at.size()) {
    changes.overflow = true;
    return;
  }
  // Where slip begins, the force is still the one that broke loose; beyond a jump of the load it is
  // the limit.
  const double limit = static_limit(time, state_).force;
  changes.at[i] = {.fraction = duration_ > 0.0 ? time / duration_ : 0.0,
                   .to = sense_ == 0 ? law::Regime::kStick : law::Regime::kSlip,
                   .force = std::clamp(forces(time, state_[kMotion], data_.belt_velocity).drive(),
                                       -limit, limit),
                   .limit = limit,
                   .accumulated_slip = state_[kSlip]};
  ++changes.count;
}

void Dynamics::report(double time, Row& row) {
  const auto c = static_cast<std::size_t>(data_.component);
  const double velocity = state_[kRelative] + data_.belt_velocity;
  row.quantities[c] = state_[kMotion];
  const Forces f = forces(time, state_[kMotion], velocity);
  row.forces.component[c] = {f.elastic, f.viscous, 0.0, f.load};
  row.forces.velocity = velocity;
  const double surface = surface_velocity(state_);
  const double own = state_[kRelative] + surface;
  row.forces.kinetic_energy = 0.5 * data_.mass * own * own;
  if (data_.driver) {
    row.forces.driver_velocity = surface;
    row.forces.kinetic_energy += 0.5 * data_.driver->mass * surface * surface;
  }
  row.forces.external_work = state_[kLoadWork] + state_[kBeltWork];
  row.forces.viscous_dissipation += state_[kViscous] - reported_viscous_;
  reported_viscous_ = state_[kViscous];
  if (definition_ < 0) return;
  DefinitionRow& here = row.definitions[static_cast<std::size_t>(definition_)];
  const double slip_before = here.update.state.accumulated_slip;
  const law::Limit limit = sense_ == 0 ? static_limit(time, state_)
                                       : this->limit(time, state_, std::abs(state_[kRelative]));
  law::FrictionUpdate update;
  update.state.force[0] = friction_force(time);
  update.state.accumulated_slip = state_[kSlip];
  update.state.regime = sense_ == 0 ? law::Regime::kStick : law::Regime::kSlip;
  if (!(limit.force > 0.0)) update.state.regime = law::Regime::kOpen;
  update.direction[0] = update.state.force[0] != 0.0 ? sign_of(update.state.force[0]) : 0.0;
  update.contact_force = limit.contact_force;
  update.normal_force = limit.normal_force;
  update.mu = limit.mu;
  update.limit = limit.force;
  update.phi = std::abs(update.state.force[0]) - limit.force;
  update.slip_rate = std::abs(state_[kRelative]);
  update.slip_increment = state_[kSlip] - slip_before;
  update.dissipation = state_[kHeat] - here.dissipation;
  update.work = update.dissipation;
  here.update = update;
  here.dissipation = here.work = state_[kHeat];
}

void Dynamics::start(const law::FrictionDefinition* friction, Row& row) {
  friction_ = friction;
  begin_ = end_ = &row.quantities;
  duration_ = 0.0;
  varying_ = false;
  now_ = row.quantities;
  state_ = {};
  state_[kMotion] = row.quantities[static_cast<std::size_t>(data_.component)];
  state_[kRelative] =
      data_.initial_velocity - (data_.driver ? data_.driver->velocity : data_.belt_velocity);
  if (data_.driver) {
    state_[kCommon] = data_.driver->velocity + driver_share_ * state_[kRelative];
  }
  if (state_[kRelative] == 0.0) {
    decide(0.0);
  } else {
    sense_ = state_[kRelative] < 0.0 ? -1 : 1;
  }
  report(0.0, row);
}

tl::expected<void, DynamicsFailure> Dynamics::advance(const Quantities& begin,
                                                      const law::FrictionDefinition* friction,
                                                      const FollowPositions& follow, Row& row) {
  constexpr int kMostEvents = 100'000;
  friction_ = friction;
  begin_ = &begin;
  const Quantities end = row.quantities;  // the row's own position changes on the way
  end_ = &end;
  duration_ = row.duration;
  steps_ = 0;
  now_ = end;
  follow_ = follow ? &follow : nullptr;
  varying_ = follow_ != nullptr;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const bool mass = i == static_cast<std::size_t>(data_.component);
    varying_ = varying_ || (!mass && begin[i] != end[i]);
  }
  fault_ = nullptr;
  if (definition_ >= 0) {
    law::RegimeChanges& changes = row.definitions[static_cast<std::size_t>(definition_)].changes;
    changes.count = 0;
    changes.overflow = false;
  }
  double time = 0.0;
  // A load that jumps may break a stuck mass loose, or hold it, at once.
  const int before = sense_;
  if (state_[kRelative] == 0.0) decide(time);
  if (changes_since(before, time)) note_change(time, row);
  for (int events = 0; time < duration_; ++events) {
    if (sense_ != 0) choose_scales(time);
    time = sense_ != 0 ? slip(time) : stick(time);
    if (events > kMostEvents) fault_ = "the mass changes between stick and slip without end";
    if (fault_ != nullptr) {
      return tl::unexpected(DynamicsFailure{duration_ > 0.0 ? time / duration_ : 0.0, fault_});
    }
    if (time >= duration_ && state_[kRelative] != 0.0) break;
    const int old = sense_;
    decide(time);
    if (changes_since(old, time)) note_change(time, row);
  }
  report(duration_, row);
  if (follow_ != nullptr) follow(1.0, row.quantities);
  begin_ = end_ = nullptr;
  follow_ = nullptr;
  return {};
}

}  // namespace slipbench::driver::bench
