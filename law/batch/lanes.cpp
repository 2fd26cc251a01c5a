// SPDX-License-Identifier: Apache-2.0
#include "law/batch/lanes.hpp"

#include <cmath>

#include "law/base/compensated_sum.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {
namespace {

constexpr double kOpen = static_cast<double>(Regime::kOpen);
constexpr double kStick = static_cast<double>(Regime::kStick);
constexpr double kSlip = static_cast<double>(Regime::kSlip);

/// Does the arithmetic of RadialReturn for a limit that does not change with the slip of the
/// increment, operation by operation; docs/theory, section 11.11. Everything is computed for every
/// lane, and chosen from: so the loop becomes instructions over several lanes.
template <int D, bool kFixed, bool kWears>
[[gnu::always_inline]] inline bool step(Lanes& l, const LaneMotion& motion) noexcept {
  std::int64_t passed = 0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    // The limit.
    double internal = l.segment_low[i];
    if constexpr (kWears) {
      internal +=
          (l.accumulated_slip[i] - l.segment_begin[i]) / l.segment_width[i] * l.segment_rise[i];
      internal = internal < 0.0 ? 0.0 : internal;
    }
    const double held = l.mu[i] * std::abs(l.contact[i] + internal);
    const double limit = held >= l.force_limit[i] ? l.force_limit[i] : held;

    // The predictor.
    const double stick = l.stick[i];
    const double ds0 = l.scale[0][i] * motion[0];
    const double trial0 = kFixed ? l.force[0][i] + stick * ds0 : l.elastic_slip[0][i] + ds0;
    double trial1 = 0.0;
    if constexpr (D == 2) {
      const double ds1 = l.scale[1][i] * motion[1];
      trial1 = kFixed ? l.force[1][i] + stick * ds1 : l.elastic_slip[1][i] + ds1;
    }
    const double reach = D == 1 ? std::abs(trial0) : std::sqrt(trial0 * trial0 + trial1 * trial1);

    // Admissibility and return.
    const bool grips = limit > 0.0;
    const bool outside = reach > (kFixed ? limit : stick) * kLimitSlack;
    const double returned = kFixed ? (reach - limit) / stick : reach - stick;
    const double slip = grips ? (outside ? returned : 0.0) : 0.0;
    const double hold = kFixed ? 1.0 : limit / stick;
    const auto finish = [&](double trial, double* force, double* elastic_slip) {
      // In one dimension the quotient is exact, and no division is needed.
      const double direction = D == 1 ? (trial < 0.0 ? -1.0 : 1.0) : trial / reach;
      const double stuck = kFixed ? trial : hold * trial;
      const double y = grips ? (outside ? limit * direction : stuck) : 0.0;
      *force = y;
      if constexpr (!kFixed) {
        *elastic_slip = grips ? (outside ? stick * direction : trial) : 0.0;
      }
      return y;
    };
    const double y0 = finish(trial0, &l.force[0][i], &l.elastic_slip[0][i]);
    double size = std::abs(y0);
    if constexpr (D == 2) {
      const double y1 = finish(trial1, &l.force[1][i], &l.elastic_slip[1][i]);
      size = y0 * y0 + y1 * y1;
    }
    add_compensated(slip, &l.accumulated_slip[i], &l.slip_left_out[i]);
    l.regime[i] = grips ? (outside ? kSlip : kStick) : kOpen;
    if constexpr (kWears) passed |= l.accumulated_slip[i] >= l.segment_end[i] ? 1 : 0;

    // Summary.
    l.limit[i] = limit;
    l.peak[i] = size > l.peak[i] ? size : l.peak[i];
    add_compensated(limit * slip, &l.dissipation[i], &l.energy_left_out[i]);
    l.slipping[i] += grips ? (outside ? 1.0 : 0.0) : 0.0;
    l.open[i] += grips ? 0.0 : 1.0;
  }
  return passed != 0;
}

template <int D, bool kFixed, bool kWears>
bool portable_step(Lanes* lanes, LaneMotion motion) noexcept {
  return step<D, kFixed, kWears>(*lanes, motion);
}
#if defined(__x86_64__)
template <int D, bool kFixed, bool kWears>
[[gnu::target("avx2")]] bool avx2_step(Lanes* lanes, LaneMotion motion) noexcept {
  return step<D, kFixed, kWears>(*lanes, motion);
}
template <int D, bool kFixed, bool kWears>
[[gnu::target("avx512f,avx512dq,avx512vl")]] bool avx512_step(Lanes* lanes,
                                                              LaneMotion motion) noexcept {
  return step<D, kFixed, kWears>(*lanes, motion);
}
#endif

/// As a scalar run does it: a value that is not beyond the one before leaves that with its bits.
template <LaneKept kKept>
[[gnu::always_inline]] inline void keep(const double* column, const double* scale,
                                        double* so_far) noexcept {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double signed_value = scale[i] * column[i];
    const double value = kKept == LaneKept::kMagnitude ? std::abs(signed_value) : signed_value;
    const bool beyond = kKept == LaneKept::kMinimum ? value < so_far[i] : value > so_far[i];
    so_far[i] = beyond ? value : so_far[i];
  }
}

[[gnu::always_inline]] inline void count_changes(const double* regime, double from, double to,
                                                 double* before, double* count) noexcept {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const bool was = before[i] == from;
    const bool is = regime[i] == to;
    count[i] += was ? (is ? 1.0 : 0.0) : 0.0;
    before[i] = regime[i];
  }
}

[[gnu::always_inline]] inline void mix(const LaneCorners& corner,
                                       const std::array<double, 3>& fraction, double* mu) noexcept {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double low = corner[0][i] + fraction[0] * (corner[1][i] - corner[0][i]);
    const double high = corner[2][i] + fraction[1] * (corner[3][i] - corner[2][i]);
    const double value = low + fraction[2] * (high - low);
    mu[i] = value < 0.0 ? 0.0 : value;
  }
}

void portable_mix(const LaneCorners& corner, const std::array<double, 3>& fraction,
                  LaneColumn* mu) noexcept {
  mix(corner, fraction, mu->data());
}
template <LaneKept kKept>
void portable_keep(const LaneColumn& column, const LaneColumn& scale, LaneColumn* so_far) noexcept {
  keep<kKept>(column.data(), scale.data(), so_far->data());
}
void portable_count(const LaneColumn& regime, double from, double to, LaneColumn* before,
                    LaneColumn* count) noexcept {
  count_changes(regime.data(), from, to, before->data(), count->data());
}
#if defined(__x86_64__)
template <LaneKept kKept>
[[gnu::target("avx2")]] void avx2_keep(const LaneColumn& column, const LaneColumn& scale,
                                       LaneColumn* so_far) noexcept {
  keep<kKept>(column.data(), scale.data(), so_far->data());
}
template <LaneKept kKept>
[[gnu::target("avx512f,avx512dq,avx512vl")]] void avx512_keep(const LaneColumn& column,
                                                              const LaneColumn& scale,
                                                              LaneColumn* so_far) noexcept {
  keep<kKept>(column.data(), scale.data(), so_far->data());
}
[[gnu::target("avx2")]] void avx2_mix(const LaneCorners& corner,
                                      const std::array<double, 3>& fraction,
                                      LaneColumn* mu) noexcept {
  mix(corner, fraction, mu->data());
}
[[gnu::target("avx512f,avx512dq,avx512vl")]] void avx512_mix(const LaneCorners& corner,
                                                             const std::array<double, 3>& fraction,
                                                             LaneColumn* mu) noexcept {
  mix(corner, fraction, mu->data());
}
[[gnu::target("avx2")]] void avx2_count(const LaneColumn& regime, double from, double to,
                                        LaneColumn* before, LaneColumn* count) noexcept {
  count_changes(regime.data(), from, to, before->data(), count->data());
}
[[gnu::target("avx512f,avx512dq,avx512vl")]] void avx512_count(const LaneColumn& regime,
                                                               double from, double to,
                                                               LaneColumn* before,
                                                               LaneColumn* count) noexcept {
  count_changes(regime.data(), from, to, before->data(), count->data());
}
#endif

template <LaneKept kKept>
LaneKeep keep_for(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return avx512_keep<kKept>;
  if (set == InstructionSet::kAvx2) return avx2_keep<kKept>;
#endif
  static_cast<void>(set);
  return portable_keep<kKept>;
}

template <int D, bool kFixed, bool kWears>
LaneStep step_for(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return avx512_step<D, kFixed, kWears>;
  if (set == InstructionSet::kAvx2) return avx2_step<D, kFixed, kWears>;
#endif
  static_cast<void>(set);
  return portable_step<D, kFixed, kWears>;
}

template <int D, bool kFixed>
LaneStep step_for(bool wears, InstructionSet set) noexcept {
  return wears ? step_for<D, kFixed, true>(set) : step_for<D, kFixed, false>(set);
}

template <int D>
LaneStep step_for(bool fixed, bool wears, InstructionSet set) noexcept {
  return fixed ? step_for<D, true>(wears, set) : step_for<D, false>(wears, set);
}

}  // namespace

bool is_available(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::kPortable:
      return true;
#if defined(__x86_64__)
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::kAvx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
#endif
    default:
      return false;
  }
}

InstructionSet widest_instructions() noexcept {
  static const InstructionSet widest =
      is_available(InstructionSet::kAvx512) ? InstructionSet::kAvx512
      : is_available(InstructionSet::kAvx2) ? InstructionSet::kAvx2
                                            : InstructionSet::kPortable;
  return widest;
}

LaneStep lane_step(int dimension, bool fixed, bool wears, InstructionSet set) noexcept {
  return dimension == 1 ? step_for<1>(fixed, wears, set) : step_for<2>(fixed, wears, set);
}

LaneKeep lane_keep(LaneKept kept, InstructionSet set) noexcept {
  switch (kept) {
    case LaneKept::kMaximum:
      return keep_for<LaneKept::kMaximum>(set);
    case LaneKept::kMinimum:
      return keep_for<LaneKept::kMinimum>(set);
    case LaneKept::kMagnitude:
      break;
  }
  return keep_for<LaneKept::kMagnitude>(set);
}

LaneMix lane_mix(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return avx512_mix;
  if (set == InstructionSet::kAvx2) return avx2_mix;
#endif
  static_cast<void>(set);
  return portable_mix;
}

LaneCount lane_count(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return avx512_count;
  if (set == InstructionSet::kAvx2) return avx2_count;
#endif
  static_cast<void>(set);
  return portable_count;
}

}  // namespace slipbench::law
