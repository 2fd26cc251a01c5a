// SPDX-License-Identifier: Apache-2.0
// Defaults of a coefficient law, which it need not say: all of them follow from its coefficient().
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "law/base/capstan.hpp"
#include "law/base/dual.hpp"
#include "law/base/field.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/radioss_coefficient.hpp"
#include "law/friction/slip_line.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Tells whether a law tells its coefficient of the slip rate V alone, of V and F_N, or of V, F_N
/// and the Ambient (temperature, fields): its argument list says what it depends on.
template <class Law, class Number>
concept OfRate = requires(const Law& law, Number x) {
  law.coefficient(x);
};
template <class Law, class Number>
concept OfRateAndForce = requires(const Law& law, Number x) {
  law.coefficient(x, x);
};
template <class Law, class Number>
concept OfRateForceAndAmbient = requires(const Law& law, Number x, const Ambient& ambient) {
  law.coefficient(x, x, ambient);
};

template <class Law, class Number>
Number coefficient_of(const Law& law, const Ambient& ambient, const Number& rate,
                      const Number& force) {
  if constexpr (OfRate<Law, Number>) {
    return law.coefficient(rate);
  } else if constexpr (OfRateAndForce<Law, Number>) {
    return law.coefficient(rate, force);
  } else {
    return law.coefficient(rate, force, ambient);
  }
}

template <class Law>
inline constexpr bool kSeesForce = !OfRate<Law, double>;

/// Returns true if the coefficient is kept above kCoefficientFloor: unless the law says kHasFloor =
/// false.
template <class Law>
constexpr bool keeps_floor() {
  if constexpr (requires { Law::kHasFloor; }) return Law::kHasFloor;
  return true;
}

/// Returns the same law over another number type, its numbers as constants.
template <class To, template <class> class Law, class From>
Law<To> over(const Law<From>& law) {
  Law<To> result;
  const auto copy = [](auto& to, const auto& from) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, std::optional<From>>) {
      if (from) to = To(*from);
    } else {
      to = from;
    }
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (copy(result.*(std::get<I>(Law<To>::fields()).member),
          law.*(std::get<I>(Law<From>::fields()).member)),
     ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(Law<From>::fields())>>());
  return result;
}

/// Returns the coefficient before the floor with its slopes to slip rate and contact force.
template <class Law>
CoefficientPoint raw_point(const Law& law, const Ambient& ambient,
                           const SlipArguments& slip) noexcept {
  constexpr std::size_t kSlopes = kSeesForce<Law> ? 2 : 1;
  using Number = Dual<double, kSlopes>;
  const Number mu =
      coefficient_of(over<Number>(law), ambient, Number::variable(slip.slip_rate, 0),
                     kSeesForce<Law> ? Number::variable(slip.contact_force, kSlopes - 1) : 0.0);
  return {mu.value, mu.slope[0], kSeesForce<Law> ? mu.slope[kSlopes - 1] : 0.0};
}

template <class Law>
CoefficientPoint default_point(const Law& law, const Ambient& ambient,
                               const SlipArguments& slip) noexcept {
  const CoefficientPoint raw = raw_point(law, ambient, slip);
  return keeps_floor<Law>() ? clamped(raw) : raw;
}

/// Returns dmu/d(number) in the order of fields(); 0 on the floor, and for what is no number or not
/// given.
template <class Law>
auto default_to_numbers(const Law& law, const Ambient& ambient,
                        const SlipArguments& slip) noexcept {
  constexpr std::size_t kNumbers = std::tuple_size_v<decltype(Law::fields())>;
  using Number = Dual<double, kNumbers>;
  auto varied = over<Number>(law);
  using Varied = decltype(varied);
  std::size_t i = 0;
  const auto vary = [&](auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, Number>) member.slope[i] = 1.0;
    if constexpr (std::is_same_v<Member, std::optional<Number>>) {
      if (member) member->slope[i] = 1.0;
    }
    ++i;
  };
  std::apply([&](const auto&... field) { (vary(varied.*(field.member)), ...); }, Varied::fields());
  const Number mu =
      coefficient_of(varied, ambient, Number(slip.slip_rate), Number(slip.contact_force));
  if (keeps_floor<Law>() && !(mu.value >= kCoefficientFloor)) return std::array<double, kNumbers>{};
  return mu.slope;
}

/// A limit along a SlipLine with its derivatives by the slip.
struct LinePoint {
  double x = 0.0;
  double value = 0.0;
  double slope = 0.0;
  double curvature = 0.0;
};

/// Returns the next slip at which a limit changes its curvature or has a kink against it, found by
/// the signs of its curvature at kBendSamples places, denser near the beginning, and of the rise of
/// its slope between them; then by bisection. Two bends between neighbouring places may be passed
/// over. \param at LinePoint of a slip
template <class At>
double next_sampled_bend(const SlipLine& line, const At& at) noexcept {
  constexpr int kBendSamples = 64;
  // Below these parts of its size a curvature, and a rise of the slope, is rounding.
  constexpr double kFlat = 1e-14;
  constexpr double kEqual = 1e-13;
  const double span = line.end - line.slip;
  if (!(span > 0.0)) return kNoBend;
  const auto sign = [](double x, double rounding) {
    return std::abs(x) > rounding ? (x > 0.0 ? 1 : -1) : 0;
  };
  const auto bending = [&](const LinePoint& p) {
    return sign(p.curvature * span * span, kFlat * std::abs(p.value));
  };
  const auto rise = [&](const LinePoint& a, const LinePoint& b) {
    const double equal = kEqual * (std::abs(a.slope) + std::abs(b.slope));
    return sign(b.slope - a.slope, std::max(equal, kFlat * std::abs(b.value) / span));
  };
  // A search that stands on a bend looks from just behind it.
  LinePoint low = at(line.slip + 1e-9 * span);
  int side = bending(low);
  for (int i = 1; i <= kBendSamples; ++i) {
    const double part = static_cast<double>(i) / kBendSamples;
    const LinePoint high = at(line.slip + part * part * part * span);
    for (const int sign_here : {rise(low, high), bending(high)}) {
      if (sign_here == 0 || sign_here == side) continue;
      if (side == 0) {
        side = sign_here;
        continue;
      }
      LinePoint before = low;
      LinePoint behind = high;
      while (behind.x - before.x > 1e-14 * behind.x + 1e-13 * span) {
        const LinePoint middle = at(before.x + 0.5 * (behind.x - before.x));
        const bool turned = rise(before, middle) == -side || bending(middle) == -side;
        (turned ? behind : before) = middle;
      }
      if (is_ahead(line, behind.x)) return behind.x;
      side = -side;
    }
    low = high;
  }
  return kNoBend;
}

/// Returns the next bend of limit(mu, F_N) along a line; `limit` is a template over the number
/// type.
template <class Law, class Limit>
double default_bend(const Law& law, const SlipLine& line, const Limit& limit) noexcept {
  using First = Dual<double, 1>;
  using Second = Dual<First, 1>;
  const auto second = over<Second>(law);
  const Ambient ambient = line.ambient == nullptr ? Ambient{} : *line.ambient;
  return next_sampled_bend(line, [&](double slip) {
    const Second x = Second::variable(First::variable(slip, 0), 0);
    const Second force = line.force + (x - line.slip) * line.force_per_slip;
    Second mu = coefficient_of(second, ambient, line.rate_at_zero + x * line.rate_per_slip, force);
    if (keeps_floor<Law>() && !(mu >= Second(kCoefficientFloor))) mu = kCoefficientFloor;
    const Second y = limit(mu, force);
    return LinePoint{slip, y.value.value, y.slope[0].value, y.slope[0].slope[0]};
  });
}

template <class Law>
double default_next_bend(const Law& law, const SlipLine& line) noexcept {
  return default_bend(law, line, [](const auto& mu, const auto& force) { return mu * force; });
}
template <class Law>
double default_next_belt_bend(const Law& law, const SlipLine& line, double wrap_angle,
                              FlowSense sense) noexcept {
  const double sign = sense == FlowSense::kForward ? 1.0 : -1.0;
  return default_bend(
      law, line, [&](const auto& mu, const auto&) { return sign * exp(sign * wrap_angle * mu); });
}

/// Returns a range up to a few times the largest speed, and the largest force, of a law's numbers.
template <class Law>
LawRange default_range(const Law& law) {
  constexpr Dimension kSpeed{0, 1, -1};
  LawRange result;
  const auto look = [&](const auto& number, const Dimension& of) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(number)>, double>) {
      const double end = kDecays * std::abs(number);
      if (of == kSpeed) result.slip_rate = std::max(result.slip_rate, end);
      if (of == dimension::kForce) result.contact_force = std::max(result.contact_force, end);
    }
  };
  std::apply([&](const auto&... field) { (look(law.*(field.member), field.dimension), ...); },
             Law::fields());
  return result;
}

/// Returns the largest value of f over some ascending places and between them: at the best of them,
/// then by golden section between its neighbours. \param place where it lies, if wanted
template <class F>
double scanned_maximum(std::span<const double> places, const F& f, double* place = nullptr) {
  std::size_t best = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (const double here = f(places[i]); here > largest) largest = here, best = i;
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = places[best == 0 ? 0 : best - 1];
  double high = places[std::min(best + 1, places.size() - 1)];
  double at = places[best];
  for (int i = 0; i < 60; ++i) {
    const double left = high - kGolden * (high - low);
    const double right = low + kGolden * (high - low);
    const double f_left = f(left);
    const double f_right = f(right);
    for (const auto& [x, value] : {std::pair{left, f_left}, std::pair{right, f_right}}) {
      if (value > largest) largest = value, at = x;
    }
    (f_left > f_right ? high : low) = f_left > f_right ? right : left;
  }
  if (place != nullptr) *place = at;
  return largest;
}

/// Returns the range that a law gives itself, or the one of its numbers.
template <class Law>
LawRange own_range(const Law& law) {
  if constexpr (requires { law.range(); }) {
    return law.range();
  } else {
    return default_range(law);
  }
}

/// Returns 0 and the powers of a number between 1e-9 and 1e12 units; without a unit, of 1.
inline std::vector<double> scales(int per_decade, double unit) {
  std::vector<double> places{0.0};
  for (int i = -9 * per_decade; i <= 12 * per_decade; ++i) {
    places.push_back((unit > 0.0 ? unit : 1.0) *
                     std::pow(10.0, static_cast<double>(i) / per_decade));
  }
  return places;
}

/// Returns the largest f(CoefficientPoint, F_N) of a law over all rates and forces, by a scan of
/// their scales around the law's own, so that no unit counts; infinity where it still grows at the
/// end of it, and for a law that sees the temperature or a field. Allocates: not for the update.
template <class Law, class F>
double scanned_bound(const Law& law, const F& f) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  if constexpr (OfRateForceAndAmbient<Law, double>) return kUnknown;
  const LawRange own = own_range(law);
  const std::vector<double> rates = scales(8, own.slip_rate);
  const auto at = [&](double rate, double force) {
    return f(default_point(law, Ambient{}, {.slip_rate = rate, .contact_force = force}), force);
  };
  const auto over_rates = [&](double force) {
    return scanned_maximum(rates, [&](double rate) { return at(rate, force); });
  };
  const auto grows = [](double last, double before) {
    return last - before > 1e-6 * std::abs(last);
  };
  const double fastest = rates.back();
  const auto unbounded_at = [&](double force, double largest) {
    return grows(at(fastest, force), at(0.1 * fastest, force)) && at(fastest, force) >= largest;
  };
  if constexpr (!kSeesForce<Law>) {
    const double largest = over_rates(0.0);
    return unbounded_at(0.0, largest) ? kUnknown : largest;
  } else {
    const std::vector<double> forces = scales(2, own.contact_force);
    const double strongest = forces.back();
    double force = 0.0;
    const double largest = scanned_maximum(forces, over_rates, &force);
    const bool unbounded = unbounded_at(force, largest) ||
                           (grows(over_rates(strongest), over_rates(0.1 * strongest)) &&
                            over_rates(strongest) >= largest);
    return unbounded ? kUnknown : largest;
  }
}

template <class Law>
double default_largest(const Law& law) {
  return scanned_bound(law, [](const CoefficientPoint& p, double) { return p.mu; });
}
template <class Law>
double default_largest_growth(const Law& law) {
  return scanned_bound(law, [](const CoefficientPoint& p, double force) {
    return p.mu + force * p.to_contact_force;
  });
}
template <class Law>
double default_steepest_weakening(const Law& law) {
  return std::max(
      scanned_bound(law, [](const CoefficientPoint& p, double) { return -p.to_slip_rate; }), 0.0);
}

}  // namespace slipbench::law
