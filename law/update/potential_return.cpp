// SPDX-License-Identifier: Apache-2.0
#include "law/update/potential_return.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/update/first_root.hpp"
#include "law/update/potential_projection.hpp"
#include "law/update/potential_search.hpp"
#include "law/update/six_steps.hpp"
#include "law/update/snap_back.hpp"

namespace slipbench::law {
namespace {

using Parts = std::array<PartReturn, kComponents>;
using Search = Start<LimitFunction>;

/// Tells whether the force is beyond the limit again at a knot behind the root.
bool beyond_again(const Search& start, double slip, double end) noexcept {
  for (double x = start.limit.next_knot(slip, end); x < end; x = start.limit.next_knot(x, end)) {
    if (distance(start, x).value > 0.0) return true;
  }
  return false;
}

/// The fraction of the way from y0 to `trial` at which P reaches the limit, the last time if y0
/// is beyond it; 0 if it stays beyond. P is convex along it: Newton's method comes down from the
/// far end. Of a way of many elastic slips the fraction is small, and a step to it has the rounding
/// of its length: a step back from below takes that away.
double meets_limit(const Potential& potential, const SlipVector& y0, const SlipVector& rise,
                   double limit) noexcept {
  const bool beyond = !within(potential, y0, limit);
  double lambda = 1.0;
  // P(lambda rise) <= P(y0 + lambda rise) + P(-y0): from there no step is long beside the fraction.
  if (const double far = value(potential, rise); potential.homogeneous && far > 0.0) {
    lambda = std::min((limit + value(potential, scaled(y0, -1.0))) / far, 1.0);
  }
  for (int i = 0; i < 100; ++i) {
    const SlipVector y = sum_of(y0, lambda, rise);
    const double excess = value(potential, y) - limit;
    const double slope = dot(gradient(potential, y), rise);
    if (beyond && excess > 0.0 && !(slope > 0.0)) {
      // A step to a limit of 0 may end beyond it, by rounding.
      return excess <= 32.0 * std::numeric_limits<double>::epsilon() * norm(rise) ? lambda : 0.0;
    }
    if (!(slope > 0.0)) break;
    const double next = lambda - excess / slope;
    if (!(excess > 0.0)) return std::min(next, 1.0);
    if (!(next < lambda)) break;
    lambda = next;
    if (lambda <= 0.0) return 0.0;
  }
  return lambda;
}

/// Work over ds as in theory (13.2), with the limit surface of the potential.
/// \param[out] onset the fraction of the increment before it is met
double split_work(const Potential& potential, const SlipVector& y0, const SlipVector& trial,
                  const SlipVector& y1, const SlipVector& ds, double limit,
                  double* onset) noexcept {
  const SlipVector rise = sum_of(trial, -1.0, y0);
  const double lambda = meets_limit(potential, y0, rise, limit);
  *onset = lambda;
  const SlipVector split = sum_of(y0, lambda, rise);
  return 0.5 * (lambda * (dot(y0, ds) + dot(split, ds)) +
                (1.0 - lambda) * (dot(split, ds) + dot(y1, ds)));
}

/// The return to a potential.
struct PotentialReturn : ReturnSteps<SlipVector, LimitFunction> {
  using ReturnSteps::ReturnSteps;

  /// With shifts a coefficient that vanishes at rest does not grip: the force would have to jump to
  /// where it is held.
  bool grips() const noexcept {
    return potential.homogeneous ? ReturnSteps::grips() : rest.force > start.least;
  }

  End end(FrictionUpdate* result) noexcept {
    const bool fixed = begin.fixed;
    Scale scale = scale_at(start, rest.force);
    const bool slips = !within(potential, scale.trial, scale.limit);
    End end{.limit = rest, .force = scale.trial};
    const Limit& l = end.limit;
    SlipVector& y = end.force;
    m = gradient(potential, y);
    if (fixed) {
      result->multiple_roots = -limit.slope(rest) > begin.stick * dot(m, m) && dot(m, m) > 0.0;
    }
    if (slips) {
      result->converged = first_slip(start, &end.slip);
      end.limit = limit(end.slip);
      const bool goes_on =
          l.force > start.least || (start.closed && slips_without_force(fixed, limit, l, end.slip));
      end.regime = goes_on ? Regime::kSlip : Regime::kOpen;
    }
    const bool opens = end.regime == Regime::kOpen;
    if (end.regime == Regime::kSlip) {
      scale = scale_at(start, l.force);
      const Projection projection(potential, scale.trial);
      const double x = scale.kappa * end.slip;
      const Parts parts = projection.parts_on_limit(x, scale.limit);
      y = projection.returned(parts);
      m = projection.normal(parts, x);
      // Far above rounding: what is left is the failure of the search.
      const double missed = std::abs(value(potential, y) - scale.limit);
      result->converged =
          result->converged && missed <= 1e-9 * scale.limit + 1e-13 * norm(scale.trial);
      y = put_on_limit(potential, y, scale.limit);
    }
    if (fixed && limit.depends_on_slip() && !opens) {
      const double longest = Projection(potential, begin.trial).longest() / begin.stick;
      result->multiple_roots = result->multiple_roots || beyond_again(start, end.slip, longest);
    }
    // From the slips to the forces where the return was done on slips.
    kappa = fixed ? begin.stick : l.force / begin.stick;
    end.elastic_slip = start.closed ? y : fixed || slips ? scaled(y, 1.0 / kappa) : begin.trial;
    if (start.closed) y = scaled(end.elastic_slip, kappa);
    trial_force = start.closed ? scaled(begin.trial, kappa) : scale.trial;
    if (opens) {
      if (potential.homogeneous) end.slip = first_zero(limit, end.slip);
      y = end.elastic_slip = SlipVector{};
      trial_force = fixed ? begin.trial : SlipVector{};
    }
    const double square = slips || dot(y, y) > 0.0 ? dot(m, m) : 0.0;
    if (square > 0.0) end.direction = scaled(m, 1.0 / square);
    return end;
  }

  void take_energies(const End& end, FrictionUpdate* result) const noexcept {
    const bool opens = end.regime == Regime::kOpen;
    const SlipVector& y = end.force;
    const SlipVector& ds = begin.ds;
    // With shifts y . m is not P: the slip's own work counts.
    result->dissipation = opens                   ? 0.0
                          : potential.homogeneous ? end.limit.force * end.slip
                                                  : std::max(end.slip * dot(y, m), 0.0);
    result->stored_energy = 0.5 * dot(y, end.elastic_slip);
    result->phi = value(potential, y) - end.limit.force;
    if (end.regime == Regime::kStick) {
      result->work = 0.5 * (dot(begin.force, ds) + dot(y, ds));
      return;
    }
    result->work =
        split_work(potential, begin.force, trial_force, y, ds, end.limit.force, &result->onset);
    if (opens || !(end.limit.force > 0.0)) {
      result->onset = begin.fixed
                          ? meets_limit(potential, begin.force, scaled(ds, begin.stick), rest.force)
                          : meets_limit(potential, begin.old.elastic_slip, ds, begin.stick);
    }
    // Along the normal of the end the spring has the stiffness |m|^2 kappa.
    const double along = begin.stick * dot(m, m);
    if (!(along > 0.0) || !may_snap_back(begin.definition)) return;
    result->snap_back = largest_snap_back(limit, along, end.slip);
    if (result->snap_back >= 1.0) take_jumps(end, along, result);
  }

  void take_jumps(const End& end, double along, FrictionUpdate* result) const noexcept {
    const bool opens = end.regime == Regime::kOpen;
    // P along the normal: of a force from the other side it is negative.
    const SlipVector& here = opens ? begin.trial : end.force;
    const auto along_normal = [&](const SlipVector& v) {
      return value(potential, here) + dot(m, sum_of(v, -1.0, here));
    };
    const double start_force = along_normal(begin.force);
    SnapBackPath path = snap_back_path(limit, along, end.slip, start_force, opens);
    // With shifts y . m is not P.
    if (!opens) {
      path.friction_work -=
          std::min((end.limit.force - dot(end.force, m)) * end.slip, path.friction_work);
    }
    const double stored = 0.5 * dot(begin.force, begin.old.elastic_slip);
    const double work = result->work;
    book_jumps(path, start_force, along_normal(begin.trial), stored, result);
    const auto turns = [&](const SlipVector& v) {
      const SlipVector beside = sum_of(v, -dot(v, m) / dot(m, m), m);
      return dot(beside, beside) > 1e-20 * dot(v, v);
    };
    if (result->jumps > 0 && (turns(begin.trial) || turns(begin.force))) {
      // The force leaves the line of the path: what is lost is what the spring gives and friction
      // does not take, with the work of the increment to first order.
      result->lost =
          std::max(work + stored - result->stored_energy - result->dissipation - path.fallen, 0.0);
      result->work =
          result->dissipation + result->lost + path.fallen + result->stored_energy - stored;
    }
  }

  /// The numbers that `potential_tangent` is made of.
  SlipTangent tangent(const End& end) const noexcept {
    return {.transverse = kappa,
            .radial = limit.slope(end.limit),
            .rate = end.limit.to_rate * limit.motion_in_rate(),
            .contact = end.limit.to_contact};
  }

  const Potential& potential = *std::get_if<Potential>(&begin.definition.criterion);
  const Search start{potential,
                     limit,
                     begin.trial,
                     begin.stick,
                     value(potential, SlipVector{}),
                     begin.fixed,
                     !begin.fixed && potential.homogeneous};
  SlipVector m{};            ///< dP/dy at the end
  SlipVector trial_force{};  ///< y_trial at the limit of the end
  double kappa = 0.0;        ///< at the limit of the end [F/L]
};

}  // namespace

FrictionUpdate update_potential(const FrictionDefinition& definition,
                                const ConnectorIncrement& increment,
                                const FrictionState& old) noexcept {
  return in_six_steps<PotentialReturn>(definition, increment, old);
}

namespace {

/// The projection of theory 11.7 differentiated at fixed x(T): what dy_tr and dT do to y and x.
class Linearised {
 public:
  Linearised(const Potential& potential, const SlipVector& trial, const SlipVector& force, double x,
             double limit) noexcept
      : potential_(potential),
        trial_(trial),
        force_(force),
        projection_(potential, trial),
        x_(x),
        limit_(limit) {
    maximum_ = potential.combine == PotentialOperator::kMax;
    parts_ = projection_.parts_on_limit(x, limit);
    for (PartReturn& part : parts_) {
      if (part.pull > 0.0) part.stiffness = 0.0;
    }
    for (std::size_t g = 0; g < static_cast<std::size_t>(potential.leaves); ++g) {
      const PotentialLeaf& leaf = potential.leaf[g];
      PartReturn& part = parts_[static_cast<std::size_t>(leaf.part)];
      if (part.pull > 0.0 && rest(g) > 0.0) part.stiffness += leaf.factor * leaf.factor;
    }
    const double power = potential.exponent - 1.0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const PartReturn& part = parts_[i];
      if (maximum_ || !(part.pull > 0.0)) continue;
      if (part.magnitude > 0.0) {
        hardening_[i] = part.stiffness * x * power * part.share / part.magnitude;
        given_[i] = 1.0 / (1.0 + hardening_[i]);
      }
      normal_ += part.share * part.share * given_[i] * part.stiffness;
    }
  }

  /// \return dx
  double change(const SlipVector& by_trial, double by_limit, SlipVector* y) const noexcept {
    std::array<double, kComponents> rise{};  // of a part's magnitude, as the trial gives it
    std::array<double, kComponents> along{};
    for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
      const PotentialLeaf& leaf = potential_.leaf[g];
      along[g] = along_leaf(leaf, by_trial);
      if (rest(g) > 0.0) rise[static_cast<std::size_t>(leaf.part)] += leaf.factor * along[g];
    }
    std::array<double, kComponents> magnitude{};  // change of X_i where the part is pulled
    double x = 0.0;
    if (maximum_) {
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        magnitude[i] = by_limit;
        if (parts_[i].pull > 0.0 && parts_[i].stiffness > 0.0) {
          x += (rise[i] - by_limit) / parts_[i].stiffness;
        }
      }
    } else {
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        const PartReturn& part = parts_[i];
        x += part.share * given_[i] * (rise[i] - part.magnitude / limit_ * by_limit);
      }
      x = normal_ > 0.0 ? x / normal_ : 0.0;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        const PartReturn& part = parts_[i];
        magnitude[i] = given_[i] * (rise[i] - part.stiffness * part.share * x +
                                    hardening_[i] * part.magnitude * by_limit / limit_);
      }
    }
    *y = by_trial;
    for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
      const PotentialLeaf& leaf = potential_.leaf[g];
      const auto i = static_cast<std::size_t>(leaf.part);
      if (!(parts_[i].pull > 0.0) || !(projection_.lengths()[g] > 0.0)) {
        if (!(projection_.lengths()[g] > 0.0)) at_apex(leaf, by_trial, y);
        continue;
      }
      const double r = rest(g);
      const double dr =
          r > 0.0 ? along[g] - leaf.factor * (rise[i] - magnitude[i]) / parts_[i].stiffness : 0.0;
      const double t = projection_.lengths()[g];
      const double v = coordinate(leaf, trial_);
      for (std::size_t k = 0; k < y->size(); ++k) {
        const double d = leaf.direction[k];
        if (d == 0.0) continue;
        if (leaf.kind == PotentialLeaf::Kind::kNorm) {
          const double n = trial_[k] / t;
          (*y)[k] = n * dr + r / t * (by_trial[k] - n * along[g]);
        } else {
          (*y)[k] += std::copysign(d, v * d) * (dr - along[g]);
        }
      }
    }
    return x;
  }

 private:
  /// Change of the length of a leaf.
  double along_leaf(const PotentialLeaf& leaf, const SlipVector& by_trial) const noexcept {
    const double v = coordinate(leaf, trial_);
    if (leaf.kind == PotentialLeaf::Kind::kNorm) {
      double sum = 0.0;
      for (std::size_t k = 0; k < trial_.size(); ++k) {
        if (leaf.direction[k] != 0.0) sum += trial_[k] * by_trial[k];
      }
      return v > 0.0 ? sum / v : 0.0;
    }
    if (leaf.kind == PotentialLeaf::Kind::kHalfLine && !(v > 0.0)) return 0.0;
    return std::copysign(1.0, v) * dot(leaf.direction, by_trial);
  }

  /// Returns what is left of the length of leaf g.
  double rest(std::size_t g) const noexcept { return length(potential_.leaf[g], force_); }

  /// A leaf that is not loaded while others slip. Where its part is pulled it stays at 0; otherwise
  /// its share (r/T)^(b-1) begins with the slope 0, 1/T or without bound. A half line gives way to
  /// the other side, and nothing is said of it.
  void at_apex(const PotentialLeaf& leaf, const SlipVector& by_trial,
               SlipVector* y) const noexcept {
    if (leaf.kind == PotentialLeaf::Kind::kHalfLine) return;
    const auto part = static_cast<std::size_t>(leaf.part);
    const double power = potential_.exponent - 1.0;
    const bool pulled = parts_[part].pull > 0.0;
    if (!pulled && (maximum_ || power > 1.0 || potential_.offset[part] > 0.0)) return;
    const double kept =
        power == 1.0 && !pulled ? 1.0 / (1.0 + leaf.factor * leaf.factor * x_ / limit_) : 0.0;
    const double along = dot(leaf.direction, by_trial);
    for (std::size_t k = 0; k < y->size(); ++k) {
      if (leaf.direction[k] == 0.0) continue;
      (*y)[k] = leaf.kind == PotentialLeaf::Kind::kNorm
                    ? kept * by_trial[k]
                    : by_trial[k] + (kept - 1.0) * leaf.direction[k] * along;
    }
  }

  const Potential& potential_;
  const SlipVector& trial_;
  const SlipVector& force_;  ///< the return of `trial_`
  Projection projection_;
  double x_;
  double limit_;
  bool maximum_ = false;
  std::array<PartReturn, kComponents> parts_{};
  std::array<double, kComponents> hardening_{};
  std::array<double, kComponents> given_{};  ///< 1 / (1 + hardening); 0 where X_i stays at 0
  double normal_ = 0.0;
};

}  // namespace

PotentialTangent potential_tangent(const FrictionDefinition& definition,
                                   const FrictionUpdate& update) noexcept {
  using Vector = Eigen::Matrix<double, kComponents, 1>;
  PotentialTangent result;
  result.to_slip.setZero();
  result.to_contact.setZero();
  if (update.state.regime == Regime::kOpen) return result;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  const double kappa = update.tangent.transverse;
  const double limit = update.limit;
  const Eigen::Map<const Vector> motion(update.motion_direction.data());

  if (update.state.regime == Regime::kStick) {
    result.to_slip.diagonal().setConstant(kappa);
    if (!fixed && limit > 0.0) {
      // y = (F_lim / g_c) s_el follows the limit, in proportion.
      const Vector share = Eigen::Map<const Vector>(update.state.force.data()) / limit;
      result.to_slip += update.tangent.rate * share * motion.transpose();
      result.to_contact = update.tangent.contact * share;
    }
    return result;
  }

  // Slip without force follows nothing.
  if (!(limit > 0.0)) return result;
  const Potential& potential = *std::get_if<Potential>(&definition.criterion);
  const double x = kappa * update.slip_increment;
  const SlipVector m = scaled(update.direction, 1.0 / dot(update.direction, update.direction));
  const SlipVector trial = sum_of(update.state.force, x, m);
  const Linearised linear(potential, trial, update.state.force, x, limit);

  Eigen::Matrix<double, kComponents, kComponents> y_by_trial;
  Vector x_by_trial, y_by_limit;
  SlipVector column;
  for (int k = 0; k < kComponents; ++k) {
    SlipVector unit{};
    unit[static_cast<std::size_t>(k)] = 1.0;
    x_by_trial[k] = linear.change(unit, 0.0, &column);
    y_by_trial.col(k) = Eigen::Map<const Vector>(column.data());
  }
  double x_by_limit = linear.change(SlipVector{}, 1.0, &column);
  y_by_limit = Eigen::Map<const Vector>(column.data());
  if (!fixed) {
    // The trial force (F_lim / g_c) s_tr and kappa dL follow the limit.
    const Vector along = Eigen::Map<const Vector>(trial.data()) / limit;
    x_by_limit += x_by_trial.dot(along) - x / limit;
    y_by_limit += y_by_trial * along;
  }
  // kappa ddL = kappa A.ds + G dF and dF = F' ddL + dF_ext, eliminated for dF.
  const double slope = update.tangent.radial;
  const double sum = kappa - x_by_limit * slope;
  const double follow = sum != 0.0 ? kappa / sum : 0.0;
  const Vector limit_by_slip = follow * (slope * x_by_trial + update.tangent.rate * motion);
  result.to_slip = kappa * y_by_trial + y_by_limit * limit_by_slip.transpose();
  result.to_contact = follow * update.tangent.contact * y_by_limit;
  return result;
}

}  // namespace slipbench::law
