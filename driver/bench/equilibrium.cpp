// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/bracketed_root.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/case/quantity.hpp"
#include "law/update/connector_tangent.hpp"

namespace slipbench::driver::bench {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRelativeTolerance = 1e-12;  // of the forces of a component
constexpr double kSmallestPiece = 1.0 / 4096.0;

}  // namespace

Equilibrium::Equilibrium(const cases::Case& problem)
    : case_(&problem), old_(problem.definitions.size()), updates_(problem.definitions.size()) {
  component_.fill(0);
  pressing_slopes_.setZero();
  // A case whose definitions wait for each other is refused when it is read.
  order_ = order_of_evaluation(problem).value_or(std::vector<std::size_t>());
}

tl::expected<std::vector<std::size_t>, std::vector<std::size_t>> order_of_evaluation(
    const cases::Case& problem) {
  const std::size_t count = problem.definitions.size();
  const law::ComponentSet balanced = problem.kinetic.pressing & problem.force_driven;
  // The definition that has to come before `d` and is not in `order`; `count` if there is none.
  const auto awaited = [&](std::size_t d, const std::vector<std::size_t>& order) {
    const law::ComponentSet named =
        law::components_of(problem.definitions[d].law.contact_force) & balanced;
    for (std::size_t other = 0; other < count; ++other) {
      if (std::find(order.begin(), order.end(), other) != order.end()) continue;
      const law::SlipSpace& slip = problem.definitions[other].law.slip;
      for (int k = 0; k < slip.dimension; ++k) {
        if (named.contains(slip.component[static_cast<std::size_t>(k)])) return other;
      }
    }
    return count;
  };
  std::vector<std::size_t> order;
  while (order.size() < count) {
    std::size_t next = 0;
    while (next < count && (std::find(order.begin(), order.end(), next) != order.end() ||
                            awaited(next, order) < count)) {
      ++next;
    }
    if (next < count) {
      order.push_back(next);
      continue;
    }
    // All that are left wait: following what they wait for comes round.
    std::vector<std::size_t> chain;
    std::size_t at = 0;
    while (std::find(order.begin(), order.end(), at) != order.end()) ++at;
    while (std::find(chain.begin(), chain.end(), at) == chain.end()) {
      chain.push_back(at);
      at = awaited(at, order);
    }
    chain.erase(chain.begin(), std::find(chain.begin(), chain.end(), at));
    return tl::unexpected(std::move(chain));
  }
  return order;
}

/// Everything prescribed at the end of the piece from `from` to `to` of the increment.
void Equilibrium::prepare(double from, double to, const Quantities& begin, const Row& row) {
  if (to >= 1.0) {
    // The unknowns keep their values of before: the trial sets them.
    for (std::size_t i = 0; i < end_.size(); ++i) end_[i] = row.quantities[i];
  } else {
    for (std::size_t i = 0; i < end_.size(); ++i) {
      end_[i] = std::lerp(begin[i], row.quantities[i], to);
    }
  }
  increment_.duration = row.duration * (to - from);
  part_ = to;
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto c = static_cast<std::size_t>(component_[i]);
    load_[i] = end_[cases::kFirstForce + c];
    scale_[i] = std::abs(load_[i]);
    begin_friction_[i] = 0.0;
    for (std::size_t d = 0; d < old_.size(); ++d) {
      begin_friction_[i] += std::abs(law::friction_force(definitions_[d], old_[d])[component_[i]]);
    }
  }
  increment_.end = ambient_of(end_, case_->reference);
  std::copy_n(end_.begin() + cases::kFirstForce, kSize, increment_.force.values.begin());
}

void Equilibrium::press() {
  const law::KineticBehavior& kinetic = case_->kinetic;
  if (kinetic.pressing.empty()) return;
  law::set_kinetic_forces(kinetic, kinetic.pressing, &increment_);
  pressing_slopes_ = law::kinetic_slopes(kinetic, increment_);
  for (int k = 0; k < count_; ++k) {
    const int c = component_[static_cast<std::size_t>(k)];
    if (!kinetic.pressing.contains(c)) continue;
    increment_.force[c] = 0.0;
    pressing_slopes_.row(c).setZero();
  }
}

/// Forces at the trial positions, and how they change with each of them: by central differences,
/// which only Newton's method sees.
void Equilibrium::follow_positions(const Trial& trial) {
  const auto forces_at = [&](int k, double shift) {
    for (int l = 0; l < count_; ++l) {
      const auto j = static_cast<std::size_t>(l);
      end_[static_cast<std::size_t>(component_[j])] = trial.q[j] + (l == k ? shift : 0.0);
    }
    (*follow_)(part_, end_);
    Vector forces;
    std::copy_n(end_.begin() + cases::kFirstForce, kSize, forces.begin());
    return forces;
  };
  for (int k = 0; k < count_; ++k) {
    constexpr double kShift = 6e-6;  // the third root of the rounding
    const double shift = kShift * std::max(std::abs(trial.q[static_cast<std::size_t>(k)]), 1e-2);
    const Vector above = forces_at(k, shift);
    const Vector below = forces_at(k, -shift);
    for (int c = 0; c < kSize; ++c) {
      const auto i = static_cast<std::size_t>(c);
      following_slopes_(c, component_[static_cast<std::size_t>(k)]) =
          (above[i] - below[i]) / (2.0 * shift);
    }
  }
  const Vector forces = forces_at(-1, 0.0);
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    load_[i] = forces[static_cast<std::size_t>(component_[i])];
  }
  std::copy(forces.begin(), forces.end(), increment_.force.values.begin());
}

void Equilibrium::evaluate(Trial& trial) {
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const int c = component_[i];
    increment_.end.position[c] = trial.q[i];
    increment_.end.motion[c] = trial.q[i] - case_->reference[c];
  }
  if (follow_ != nullptr) follow_positions(trial);
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    trial.imbalance[i] = -load_[i];
    trial.tolerance[i] = std::abs(load_[i]);
    for (int l = 0; l < count_; ++l) {
      const auto j = static_cast<std::size_t>(l);
      trial.tangent[i][j] = -following_slopes_(component_[i], component_[j]);
    }
  }
  press();
  // What presses as a kinetic force is no load of its own.
  for (int c = 0; follow_ != nullptr && c < kSize; ++c) {
    if (!case_->kinetic.pressing.contains(c)) pressing_slopes_.row(c) = following_slopes_.row(c);
  }
  for (const std::size_t d : order_) {
    updates_[d] = (*integrate_)(d, increment_, old_[d]);
    const law::ConnectorForce force = law::friction_force(definitions_[d], updates_[d].state);
    law::ConnectorTangent tangent =
        law::connector_tangent(definitions_[d], increment_, updates_[d]);
    const law::ComponentSet pressing = case_->kinetic.pressing;
    if (!pressing.empty() || follow_ != nullptr)
      tangent.to_motion += tangent.to_force * pressing_slopes_;
    for (int k = 0; k < count_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double friction = force[component_[i]];
      trial.imbalance[i] += friction;
      trial.tolerance[i] += std::abs(friction);
      for (int l = 0; l < count_; ++l) {
        const auto j = static_cast<std::size_t>(l);
        trial.tangent[i][j] += tangent.to_motion(component_[i], component_[j]);
      }
      if (!pressing.contains(component_[i])) continue;
      increment_.force[component_[i]] -= friction;
      pressing_slopes_.row(component_[i]) -= tangent.to_motion.row(component_[i]);
    }
  }
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const int c = component_[i];
    const auto add = [&](double force) {
      trial.imbalance[i] += force;
      trial.tolerance[i] += std::abs(force);
    };
    const law::ElasticForce elastic = law::elastic_force(case_->kinetic, c, increment_.end);
    add(elastic.force);
    for (int l = 0; l < count_; ++l) {
      const auto j = static_cast<std::size_t>(l);
      trial.tangent[i][j] += elastic.slope[static_cast<std::size_t>(component_[j])];
    }
    if (increment_.duration > 0.0) {
      const auto viscous =
          law::viscous_force(case_->kinetic, c, law::mean_velocity(increment_, c), increment_.end);
      add(viscous.force);
      trial.tangent[i][i] += viscous.slope / increment_.duration;
    }
    scale_[i] = std::max(scale_[i], trial.tolerance[i]);
    // A position cannot be told apart from its neighbour: the slopes times that are noise. So is
    // the rounding of the friction at the begin, which a load that ends at 0 takes back.
    double noise = begin_friction_[i];
    for (int l = 0; l < count_; ++l) {
      const auto j = static_cast<std::size_t>(l);
      const double size =
          std::max(std::abs(trial.q[j]), std::abs(increment_.begin_position[component_[j]]));
      noise += size * std::abs(trial.tangent[i][j]);
    }
    trial.tolerance[i] = kRelativeTolerance * trial.tolerance[i] + 4.0 * kEpsilon * noise;
  }
}

/// Tells whether an unknown lies at a stop and is pushed against it.
bool Equilibrium::at_stop(const Trial& trial, int k) const {
  const auto i = static_cast<std::size_t>(k);
  return (trial.q[i] >= upper_[i] && trial.imbalance[i] < 0.0) ||
         (trial.q[i] <= lower_[i] && trial.imbalance[i] > 0.0);
}

bool Equilibrium::balanced(const Trial& trial, int k) const {
  const auto i = static_cast<std::size_t>(k);
  return std::abs(trial.imbalance[i]) <= trial.tolerance[i] || at_stop(trial, k);
}

double Equilibrium::merit(const Trial& trial) const {
  double sum = 0.0;
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (at_stop(trial, k) || !(scale_[i] > 0.0)) continue;
    const double part = trial.imbalance[i] / scale_[i];
    sum += part * part;
  }
  return sum;
}

bool Equilibrium::newton(Trial& trial) {
  constexpr int kMostIterations = 60;
  constexpr int kMostHalvings = 30;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kSize, kSize>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kSize, 1>;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    std::array<int, kSize> moving{};
    int n = 0;
    bool all = true;
    for (int k = 0; k < count_; ++k) {
      all = all && balanced(trial, k);
      if (!at_stop(trial, k)) moving[static_cast<std::size_t>(n++)] = k;
    }
    if (all) return true;
    Matrix tangent(n, n);
    Column imbalance(n);
    for (int a = 0; a < n; ++a) {
      const auto i = static_cast<std::size_t>(moving[static_cast<std::size_t>(a)]);
      imbalance[a] = trial.imbalance[i];
      for (int b = 0; b < n; ++b) {
        tangent(a, b) =
            trial.tangent[i][static_cast<std::size_t>(moving[static_cast<std::size_t>(b)])];
      }
    }
    const Eigen::FullPivLU<Matrix> lu(tangent);
    if (!lu.isInvertible()) return false;
    const Column step = lu.solve(imbalance);
    if (!step.allFinite()) return false;
    const double before = merit(trial);
    bool better = false;
    double part = 1.0;
    for (int halving = 0; halving < kMostHalvings && !better; ++halving, part *= 0.5) {
      Trial next = trial;
      for (int a = 0; a < n; ++a) {
        const auto i = static_cast<std::size_t>(moving[static_cast<std::size_t>(a)]);
        next.q[i] = std::clamp(trial.q[i] - part * step[a], lower_[i], upper_[i]);
      }
      evaluate(next);
      all = true;
      for (int k = 0; k < count_; ++k) all = all && balanced(next, k);
      better = all || merit(next) < (1.0 - 1e-4 * part) * before;
      if (better) trial = next;
    }
    if (!better) return false;
  }
  return false;
}

bool Equilibrium::holds(const Trial& trial) const {
  if (follow_ == nullptr) return true;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kSize, kSize> tangent(count_, count_);
  tangent.setIdentity();
  for (int k = 0; k < count_; ++k) {
    for (int l = 0; l < count_ && !at_stop(trial, k); ++l) {
      if (at_stop(trial, l)) continue;
      tangent(k, l) = trial.tangent[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
    }
  }
  return !(tangent.determinant() < 0.0);
}

/// Looks for a zero of one imbalance along its own component, away from where the load pushes to,
/// in steps that double; the other components stay. Where there is none before a stop, the stop
/// holds.
bool Equilibrium::search_along(int k, Trial& trial) {
  constexpr int kMostDoublings = 120;
  const auto i = static_cast<std::size_t>(k);
  if (balanced(trial, k)) return true;
  const double start = trial.q[i];
  const double sense = trial.imbalance[i] < 0.0 ? 1.0 : -1.0;
  const double end = sense > 0.0 ? upper_[i] : lower_[i];
  const double slope = trial.tangent[i][i];
  double step = slope > 0.0 ? std::abs(trial.imbalance[i]) / slope : 1e-6;
  step = std::max(step, 4.0 * kEpsilon * std::abs(start));
  const auto imbalance_at = [&](double q) {
    trial.q[i] = q;
    evaluate(trial);
    held_[i] = std::max(held_[i], sense * (trial.imbalance[i] + load_[i]));
    return trial.imbalance[i];
  };
  held_[i] = sense * (trial.imbalance[i] + load_[i]);
  double a = start, fa = trial.imbalance[i];
  for (int doubling = 0; doubling < kMostDoublings; ++doubling, step *= 2.0) {
    double b = start + sense * step;
    const bool stopped = sense * (end - b) <= 0.0;
    if (stopped) b = end;
    if (!std::isfinite(b)) break;
    const double fb = imbalance_at(b);
    if (!std::isfinite(fb)) break;
    if (balanced(trial, k)) return true;
    if ((fb < 0.0) != (fa < 0.0)) {
      const Bracket root = narrow({a, b}, fa, fb, 0.0, imbalance_at);
      // Of two neighbours the better one.
      const double beyond = std::abs(imbalance_at(root.b));
      if (balanced(trial, k)) return true;
      const double before = std::abs(imbalance_at(root.a));
      if (balanced(trial, k)) return true;
      if (beyond < before) imbalance_at(root.b);
      // Between neighbours the imbalance changes by the slope times their distance: more is a jump.
      jumped_ = true;
      return false;
    }
    if (stopped) return true;
    a = b;
    fa = fb;
  }
  return false;
}

bool Equilibrium::solve_piece(Trial& trial) {
  constexpr int kMostSweeps = 30;
  const Trial start = trial;
  jumped_ = false;
  if (newton(trial) && holds(trial)) return true;
  trial = start;
  evaluate(trial);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    for (int k = 0; k < count_; ++k) {
      if (!search_along(k, trial)) return false;
    }
    bool all = true;
    for (int k = 0; k < count_; ++k) all = all && balanced(trial, k);
    if (all) return true;
    const Trial swept = trial;
    if (newton(trial)) return true;
    trial = swept;
    evaluate(trial);
  }
  return false;
}

/// Makes the state at the last trial the begin of what follows; the row's sums grow by it. What an
/// update says of its increment counts from the first piece on; the piece runs `from`..`to` of it.
void Equilibrium::accept(double from, double to, Row& row) {
  const bool first = from == 0.0;
  for (std::size_t d = 0; d < updates_.size(); ++d) {
    DefinitionRow& here = row.definitions[d];
    const law::FrictionUpdate before = here.update;
    here.update = updates_[d];
    add_increment(updates_[d], here);
    old_[d] = updates_[d].state;
    here.update.onset = from + updates_[d].onset * (to - from);
    here.update.jump_onset = from + updates_[d].jump_onset * (to - from);
    if (first) continue;
    here.update.slip_increment += before.slip_increment;
    here.update.dissipation += before.dissipation;
    here.update.work += before.work;
    if (before.state.regime == law::Regime::kSlip) here.update.onset = before.onset;
    here.update.multiple_roots = here.update.multiple_roots || before.multiple_roots;
    here.update.snap_back = std::max(here.update.snap_back, before.snap_back);
    here.update.lost += before.lost;
    here.update.jumps += before.jumps;
    if (before.jumps > 0) here.update.jump_onset = before.jump_onset;
  }
  take_springs_and_dampers(*case_, increment_, row.forces);
  row.forces.pressing = increment_.force;
  increment_.begin_position = increment_.end.position;
}

std::string Equilibrium::explain(const Trial& trial) const {
  std::string text = "no static solution: ";
  if (count_ == 1) {
    const int c = component_[0];
    text += fmt::format("component {} is loaded with {} = {}{}", c + 1, cases::force_name(c),
                        base::format_number(load_[0]), follow_ != nullptr ? " " : ", ");
    if (follow_ != nullptr) {
      text += fmt::format("at {} = {}, and no position on its way holds it", cases::motion_name(c),
                          base::format_number(trial.q[0]));
    } else if (jumped_) {
      text += fmt::format("but its force jumps past that at {} = {}", cases::motion_name(c),
                          base::format_number(trial.q[0]));
    } else {
      text += fmt::format("but only {} can hold against it", base::format_number(held_[0]));
    }
  } else {
    text += "the loads";
    for (int k = 0; k < count_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      text += fmt::format("{} {} = {}", k == 0 ? "" : ",", cases::force_name(component_[i]),
                          base::format_number(load_[i]));
    }
    text += " cannot be held together";
  }
  std::string limits;
  for (std::size_t d = 0; d < updates_.size(); ++d) {
    const law::SlipSpace& slip = definitions_[d].slip;
    bool concerned = false;
    for (int k = 0; k < slip.dimension; ++k) {
      const auto end = component_.begin() + count_;
      concerned = concerned || std::find(component_.begin(), end,
                                         slip.component[static_cast<std::size_t>(k)]) != end;
    }
    if (!concerned) continue;
    limits += fmt::format("{}friction '{}' has the limit {}", limits.empty() ? "" : ", ",
                          case_->definitions[d].name, base::format_number(updates_[d].limit));
  }
  return limits.empty() ? text : text + " (" + limits + ")";
}

tl::expected<void, NoEquilibrium> Equilibrium::solve(
    law::ComponentSet unknown, const Quantities& begin,
    std::span<const law::FrictionDefinition> definitions, const IntegrateDefinition& integrate,
    const FollowPositions& follow, Row& row) {
  definitions_ = definitions;
  integrate_ = &integrate;
  follow_ = follow ? &follow : nullptr;
  following_slopes_.setZero();
  pressing_slopes_.setZero();
  count_ = 0;
  Trial trial;
  increment_.begin_position = row.begin;
  for (int c = 0; c < kSize; ++c) {
    if (!unknown.contains(c)) continue;
    const auto i = static_cast<std::size_t>(count_++);
    component_[i] = c;
    const law::Stop stop = case_->stop[static_cast<std::size_t>(c)].value_or(law::Stop{});
    lower_[i] = stop.lower;
    upper_[i] = stop.upper;
    trial.q[i] = std::clamp(row.begin[c], stop.lower, stop.upper);
  }
  for (std::size_t d = 0; d < updates_.size(); ++d) old_[d] = row.definitions[d].update.state;
  double done = 0.0;
  double size = 1.0;
  while (done < 1.0) {
    const double to = size >= 1.0 - done ? 1.0 : done + size;
    const Trial start = trial;
    prepare(done, to, begin, row);
    evaluate(trial);
    if (solve_piece(trial)) {
      // The updates are those of the last trial, which need not be the accepted one.
      evaluate(trial);
      accept(done, to, row);
      done = to;
      size = std::min(2.0 * size, 1.0);
      continue;
    }
    size = 0.5 * (to - done);
    if (size < kSmallestPiece) {
      if (follow_ != nullptr) {
        // The load where the search set out from, not where it ended.
        trial = start;
        evaluate(trial);
      }
      return tl::unexpected(NoEquilibrium{done, explain(trial)});
    }
    trial = start;
  }
  for (int k = 0; k < count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto c = static_cast<std::size_t>(component_[i]);
    row.quantities[c] = trial.q[i];
    row.forces.component[c].applied = load_[i];
    row.forces.component[c].reaction = at_stop(trial, k) ? -trial.imbalance[i] : 0.0;
  }
  if (follow_ != nullptr) follow(1.0, row.quantities);
  return {};
}

}  // namespace slipbench::driver::bench
