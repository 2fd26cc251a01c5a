// SPDX-License-Identifier: Apache-2.0
#include "law/update/snap_back.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "law/base/bisection.hpp"

namespace slipbench::law {
namespace {

/// Calls visit(low, high) for the pieces of [0, slip] in which F_lim is smooth.
template <class Visit>
void for_each_piece(const LimitFunction& limit, double slip, Visit visit) noexcept {
  for (double low = 0.0; low < slip;) {
    const double high = std::min(limit.next_knot(low, slip), slip);
    visit(low, high);
    low = high;
  }
}

double inside(const LimitFunction& limit, double low, double high, double at) noexcept {
  const double margin = margin_inside(low, high, limit.begin_slip());
  return std::clamp(at, low + margin, high - margin);
}

/// Integral of F_lim over [low, high]: Gauss's rule of three points in eight equal parts.
double integral(const LimitFunction& limit, double low, double high) noexcept {
  constexpr int kParts = 8;
  constexpr double kNode = 0.774596669241483377;
  const double half = 0.5 * (high - low) / kParts;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double middle = low + (2 * i + 1) * half;
    sum += 8.0 * limit(middle).force +
           5.0 * (limit(middle - kNode * half).force + limit(middle + kNode * half).force);
  }
  return sum * half / 9.0;
}

}  // namespace

double largest_snap_back(const LimitFunction& limit, double kappa, double slip) noexcept {
  double largest = 0.0;
  for_each_piece(limit, slip, [&](double low, double high) {
    const double steepest = largest_inside(low, high, limit.begin_slip(), [&](double at) {
      const Limit here = limit(at);
      const double hardening = std::max(limit.slope(here) - here.to_slip, 0.0);
      return -here.to_slip / (kappa + hardening);
    });
    largest = std::max(largest, steepest);
  });
  return largest;
}

SnapBackPath snap_back_path(const LimitFunction& limit, double kappa, double slip, double start,
                            bool opens) noexcept {
  SnapBackPath path;
  const double at_rest = path.at_rest = limit(0.0).force;
  const auto sum_at = [&](double x) { return kappa * x + limit(x).force; };
  const auto rises = [&](double x) { return kappa + limit.slope(limit(x)) > 0.0; };
  // Q stands still at `level` while the sum is below it; of a force beyond the limit from the start
  // that is no jump of this increment's.
  double level = std::max(start, at_rest);
  bool below = start > at_rest;
  bool jumping = false;
  const auto fall = [&](double low, double high, double work) {
    const double area = level * (high - low) - 0.5 * kappa * (high - low) * (high + low) - work;
    (jumping ? path.lost : path.fallen) += std::max(area, 0.0);
  };
  const auto take = [&](double low, double high, bool rising) {
    const double end = sum_at(high);
    if (!below && !rising) {
      below = jumping = true;
      level = sum_at(low);
      if (path.jumps++ == 0) path.first_level = level;
    }
    if (below && end > level) {
      const double lands = turn(low, high, [&](double x) { return sum_at(x) < level; }).high;
      const double work = integral(limit, low, lands);
      path.friction_work += work;
      fall(low, lands, work);
      low = lands;
      below = jumping = false;
    }
    const double work = integral(limit, low, high);
    path.friction_work += work;
    if (below) fall(low, high, work);
    if (!below) level = std::max(level, end);
  };
  for_each_piece(limit, slip, [&](double low, double high) {
    const bool first = rises(inside(limit, low, high, low));
    const bool last = rises(inside(limit, low, high, high));
    if (first == last) {
      take(low, high, first);
      return;
    }
    const double bend = turn(low, high, [&](double x) { return rises(x) == first; }).high;
    take(low, bend, first);
    take(bend, high, last);
  });
  if (opens && jumping) {
    const double held = std::max(level - kappa * slip, 0.0);
    path.lost += 0.5 * held * held / kappa;
  }
  return path;
}

void book_jumps(const SnapBackPath& path, double start, double trial, double stored,
                FrictionUpdate* update) noexcept {
  if (path.jumps == 0) return;
  update->jumps = path.jumps;
  if (trial > start) {
    const auto fraction = [&](double level) {
      return std::clamp((level - start) / (trial - start), 0.0, 1.0);
    };
    update->onset = fraction(path.at_rest);
    update->jump_onset = fraction(path.first_level);
  }
  update->lost = path.lost;
  update->dissipation = path.friction_work;
  // Exact in one dimension: the motion gives what friction takes, what is lost and what is kept.
  update->work = path.friction_work + path.lost + path.fallen + update->stored_energy - stored;
}

}  // namespace slipbench::law
