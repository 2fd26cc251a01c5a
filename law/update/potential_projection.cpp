// SPDX-License-Identifier: Apache-2.0
#include "law/update/potential_projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::law {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Adds `factor` times the direction in which leaf `leaf` grows at `y` (coordinate v, |v| > 0).
void add_direction(const PotentialLeaf& leaf, const SlipVector& y, double v, double factor,
                   SlipVector* out) {
  const bool norm = leaf.kind == PotentialLeaf::Kind::kNorm;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (leaf.direction[k] == 0.0) continue;
    (*out)[k] +=
        factor * (norm ? y[k] / v : std::copysign(leaf.direction[k], v * leaf.direction[k]));
  }
}

}  // namespace

Projection::Projection(const Potential& potential, const SlipVector& trial) noexcept
    : potential_(potential), trial_(trial) {
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential.leaves); ++g) {
    lengths_[g] = length(potential.leaf[g], trial);
  }
}

/// sum c <t - c pull> - offset of a part, and what it falls by with the pull.
Projection::Level Projection::level(int part, double pull) const noexcept {
  Level result;
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
    const PotentialLeaf& leaf = potential_.leaf[g];
    const double rest = lengths_[g] - leaf.factor * pull;
    if (leaf.part != part || !(rest > 0.0)) continue;
    result.value += leaf.factor * rest;
    result.stiffness += leaf.factor * leaf.factor;
  }
  result.value -= potential_.offset[static_cast<std::size_t>(part)];
  return result;
}

/// The pull that brings a part down to `target`; 0 if it is not above. The level is convex and made
/// of at most six straight pieces: Newton's method from 0 climbs to the root without passing it.
double Projection::pull_to(int part, double target) const noexcept {
  double pull = 0.0;
  for (int i = 0; i <= kComponents; ++i) {
    const Level here = level(part, pull);
    if (!(here.value > target) || !(here.stiffness > 0.0)) break;
    const double next = pull + (here.value - target) / here.stiffness;
    if (!(next > pull)) break;
    pull = next;
  }
  return pull;
}

PartReturn Projection::sum_part(int part, double x, double limit) const noexcept {
  PartReturn result;
  const Level start = level(part, 0.0);
  result.stiffness = start.stiffness;
  if (!(start.value > 0.0)) return result;  // inside its dead zone: nothing pulls
  const double offset = potential_.offset[static_cast<std::size_t>(part)];
  const double power = potential_.exponent - 1.0;

  if (power == 0.0) {
    Level end = level(part, x);
    result.share = 1.0;
    result.pull = x;
    if (end.value < 0.0 && offset > 0.0) {
      // Down to its dead zone and no further: the share is what is needed for that.
      result.pull = pull_to(part, 0.0);
      result.share = result.pull / x;
      end = level(part, result.pull);
      end.value = 0.0;
    }
    result.magnitude = std::max(end.value, 0.0);
    result.stiffness = end.stiffness;
    return result;
  }

  // Root of X - level(x mu), mu = (X/T)^(b-1), growing in X. For b < 2 the unknown is mu, with
  // X = T mu^(1/(b-1)): so the power is at least 1, the function convex on each straight piece, and
  // Newton's method descends from the upper end.
  const bool by_share = power < 1.0;
  double furthest = 0.0;  // beyond this share all leaves are at 0
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
    if (potential_.leaf[g].part == part) {
      furthest = std::max(furthest, lengths_[g] / (x * potential_.leaf[g].factor));
    }
  }
  double low = 0.0;
  double high = by_share ? std::pow(start.value / limit, power) : start.value;
  if (offset >= 0.0) {
    high = std::min(high, by_share ? furthest : limit * std::pow(furthest, 1.0 / power));
  }
  double u = high;
  double checked = high;
  for (int i = 0; i < 200; ++i) {
    const double magnitude = by_share ? limit * std::pow(u, 1.0 / power) : u;
    const double share = by_share ? u : std::pow(u / limit, power);
    const Level here = level(part, x * share);
    result.magnitude = magnitude;
    result.share = share;
    result.stiffness = here.stiffness;
    // Not cut off at 0: where X is too small for a double, only the level tells on which side of
    // its dead zone the part is.
    const double residual = magnitude - here.value;
    (residual > 0.0 ? high : low) = u;
    if (residual == 0.0 || high - low <= kEpsilon * high) break;
    const double slope = by_share ? magnitude / (power * u) + x * here.stiffness
                                  : 1.0 + x * here.stiffness * power * share / u;
    double next = u - residual / slope;
    const bool stalled = i % 4 == 3 && high - low > 0.5 * checked;
    if (i % 4 == 3) checked = high - low;
    if (!(next > low && next < high) || stalled) next = low + 0.5 * (high - low);
    if (std::abs(next - u) <= 0.5 * kEpsilon * u) break;
    u = next;
  }
  result.pull = x * result.share;
  // A share has the rounding of X times b-1: with a large exponent the pull is known better from X.
  if (power * result.pull * result.stiffness > start.value && result.magnitude > 0.0) {
    result.pull = pull_to(part, result.magnitude);
    result.share = result.pull / x;
  }
  return result;
}

std::array<PartReturn, kComponents> Projection::sum_parts(double x, double limit) const noexcept {
  std::array<PartReturn, kComponents> parts{};
  for (int i = 0; i < potential_.parts; ++i) {
    parts[static_cast<std::size_t>(i)] = sum_part(i, x, limit);
  }
  return parts;
}

std::array<PartReturn, kComponents> Projection::max_parts(double limit) const noexcept {
  std::array<PartReturn, kComponents> parts{};
  double x = 0.0;
  for (int i = 0; i < potential_.parts; ++i) {
    PartReturn& part = parts[static_cast<std::size_t>(i)];
    part.pull = pull_to(i, limit);
    const Level end = level(i, part.pull);
    part.magnitude = part.pull > 0.0 ? limit : std::max(end.value, 0.0);
    part.stiffness = end.stiffness;
    x += part.pull;
  }
  for (PartReturn& part : parts) part.share = x > 0.0 ? part.pull / x : 0.0;
  return parts;
}

std::array<PartReturn, kComponents> Projection::parts_on_limit(double x,
                                                               double limit) const noexcept {
  if (potential_.combine == PotentialOperator::kMax) return max_parts(limit);
  auto parts = sum_parts(x, limit);
  if (potential_.exponent != 1.0) return parts;
  // X = level(x) is, after many elastic slips, what two large numbers leave. The parts add up to
  // the limit: the one that the longest pull is needed for has what the others leave of it.
  double rest = limit, longest = 0.0;
  PartReturn* last = nullptr;
  for (int i = 0; i < potential_.parts; ++i) {
    const auto n = static_cast<std::size_t>(i);
    rest -= parts[n].magnitude;
    const double pull = pull_to(i, std::max(-potential_.offset[n], 0.0));
    if (pull > longest) {
      longest = pull;
      last = &parts[n];
    }
  }
  if (last != nullptr) last->magnitude = std::max(last->magnitude + rest, 0.0);
  return parts;
}

/// From X and the differences of the lengths: t - c q alone is, after many elastic slips, what two
/// large numbers leave. Over the leaves h of a part that are not at 0
///   r_g = (c_g (X + offset) + sum c_h (c_h t_g - c_g t_h)) / sum c_h^2.
std::array<double, kComponents> Projection::lengths_left(
    const std::array<PartReturn, kComponents>& parts) const noexcept {
  const auto leaves = static_cast<std::size_t>(potential_.leaves);
  std::array<double, kComponents> longest{};  // t/c of a part
  for (std::size_t g = 0; g < leaves; ++g) {
    double& most = longest[static_cast<std::size_t>(potential_.leaf[g].part)];
    most = std::max(most, lengths_[g] / potential_.leaf[g].factor);
  }
  // Tells whether anything is left of a part; then it is at least its longest leaf.
  const auto remains = [&](std::size_t i) {
    const double offset = potential_.offset[i];
    return parts[i].magnitude + offset > 8.0 * kEpsilon * std::abs(offset);
  };
  const auto is_left = [&](std::size_t h) {
    const PotentialLeaf& leaf = potential_.leaf[h];
    const auto i = static_cast<std::size_t>(leaf.part);
    return lengths_[h] > leaf.factor * parts[i].pull ||
           (remains(i) && lengths_[h] / leaf.factor == longest[i]);
  };
  std::array<double, kComponents> left = lengths_;
  for (std::size_t g = 0; g < leaves; ++g) {
    const PotentialLeaf& leaf = potential_.leaf[g];
    const auto i = static_cast<std::size_t>(leaf.part);
    if (!(lengths_[g] > 0.0) || !(parts[i].pull > 0.0)) continue;
    left[g] = 0.0;
    if (!is_left(g)) continue;
    double sum = leaf.factor * (parts[i].magnitude + potential_.offset[i]);
    double stiffness = 0.0;
    for (std::size_t h = 0; h < leaves; ++h) {
      const PotentialLeaf& other = potential_.leaf[h];
      if (other.part != leaf.part || !is_left(h)) continue;
      sum += other.factor * (other.factor * lengths_[g] - leaf.factor * lengths_[h]);
      stiffness += other.factor * other.factor;
    }
    left[g] = std::max(sum / stiffness, 0.0);
  }
  return left;
}

SlipVector Projection::returned(const std::array<PartReturn, kComponents>& parts) const noexcept {
  const std::array<double, kComponents> left = lengths_left(parts);
  SlipVector y = trial_;
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
    const PotentialLeaf& leaf = potential_.leaf[g];
    if (!(lengths_[g] > 0.0) || !(parts[static_cast<std::size_t>(leaf.part)].pull > 0.0)) continue;
    const double v = coordinate(leaf, trial_);
    const bool norm = leaf.kind == PotentialLeaf::Kind::kNorm;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double d = leaf.direction[k];
      if (d == 0.0) continue;
      y[k] = norm ? left[g] / lengths_[g] * trial_[k]
                  : (trial_[k] - d * v) + d * std::copysign(left[g], v);
    }
  }
  return y;
}

SlipVector Projection::normal(const std::array<PartReturn, kComponents>& parts,
                              double x) const noexcept {
  SlipVector m{};
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
    const PotentialLeaf& leaf = potential_.leaf[g];
    const PartReturn& part = parts[static_cast<std::size_t>(leaf.part)];
    if (!(lengths_[g] > 0.0) || !(part.share > 0.0)) continue;
    const bool at_zero = leaf.factor * part.pull >= lengths_[g];
    const double slope = at_zero && x > 0.0 ? lengths_[g] / x : leaf.factor * part.share;
    add_direction(leaf, trial_, coordinate(leaf, trial_), slope, &m);
  }
  return m;
}

double Projection::longest() const noexcept {
  std::array<double, kComponents> pull{};
  for (std::size_t g = 0; g < static_cast<std::size_t>(potential_.leaves); ++g) {
    double& here = pull[static_cast<std::size_t>(potential_.leaf[g].part)];
    here = std::max(here, lengths_[g] / potential_.leaf[g].factor);
  }
  double sum = 0.0;
  for (const double p : pull) sum += p;
  return sum;
}

}  // namespace slipbench::law
