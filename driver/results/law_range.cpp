// SPDX-License-Identifier: Apache-2.0
#include "driver/results/law_range.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <type_traits>

namespace slipbench::driver::results {
namespace {

/// After so many times the reciprocal of its rate an exponential has nothing left to show.
constexpr double kDecays = 4.0;
/// The size of a change of mu that is worth seeing, where the law has none itself.
constexpr double kTypicalCoefficient = 0.1;
constexpr law::Dimension kSpeed{0, 1, -1};

/// Returns where constant + linear x + square x^2 has turned (twice the vertex), or else has
/// changed by its own size; 0 if it never does.
double polynomial_scale(double constant, double linear, double square) {
  if (linear * square < 0.0) return -linear / square;
  const double size = std::max(std::abs(constant), kTypicalCoefficient);
  if (linear != 0.0) return size / std::abs(linear);
  return square != 0.0 ? std::sqrt(size / std::abs(square)) : 0.0;
}

/// Returns where exp(rate x) has died away, or grown e times.
double exponential_scale(double rate) {
  if (rate == 0.0) return 0.0;
  return rate < 0.0 ? -kDecays / rate : 1.0 / rate;
}

LawRange range(const law::ExponentialDecay& law) {
  LawRange result;
  if (!law.depends_on_slip_rate()) return result;
  result.slip_rate = exponential_scale(-law.decay);
  result.landmarks = {{"static", 0.0}};
  return result;
}
LawRange range(const law::ExponentialTestData& law) {
  LawRange result = range(law.fit());
  result.slip_rate = std::max(result.slip_rate, 1.5 * law.rate2);
  result.landmarks = {{"mu1", 0.0}, {"mu2", law.rate2}};
  return result;
}
LawRange range(const law::GeneralizedViscous& law) {
  const double area = law.area.value_or(1.0);
  return {polynomial_scale(law.fric, law.c2, law.c5),
          area * polynomial_scale(law.fric, law.c1, law.c4),
          {}};
}
LawRange range(const law::ModifiedDarmstad& law) {
  const double area = law.area.value_or(1.0);
  LawRange result;
  // Twice as far as the fastest of them: the others are seen well enough.
  for (const auto& [factor, rate] :
       {std::pair{law.c1, law.c2}, {law.c3, law.c4}, {law.c5, law.c6}}) {
    const double scale = factor == 0.0 ? 0.0 : 2.0 * exponential_scale(rate);
    if (scale > 0.0 && (result.slip_rate == 0.0 || scale < result.slip_rate)) {
      result.slip_rate = scale;
    }
  }
  result.contact_force = area * polynomial_scale(law.fric + law.c5, law.c3, law.c1);
  return result;
}
LawRange range(const law::Renard& law) {
  // All of the way back to C2 where that is not far beyond the joints.
  const double recovery = law.c2 > law.c4 ? 3.0 / std::sqrt(law.c2 - law.c4) : 0.0;
  const double end = std::max(1.5 * law.c6, std::min(law.c6 + recovery, 3.0 * law.c6));
  const double unit = 1.0 / law.speed_factor;
  return {unit * end, 0.0, {{"C1", 0.0}, {"C3", unit * law.c5}, {"C4", unit * law.c6}}};
}
LawRange range(const law::TabularCoefficient& law) {
  const auto last = [&](law::IndependentKind kind) {
    const int column = law.table.column_of(kind);
    return column < 0 ? 0.0 : 1.1 * law.table.table().knots(column).back();
  };
  return {last(law::IndependentKind::kSlipRate), last(law::IndependentKind::kContactForce), {}};
}
/// A law that says nothing of itself here is drawn up to a few times the largest of its speeds and
/// of its forces; one without such numbers over what is asked for.
template <class Law>
LawRange range(const Law& law) {
  LawRange result;
  const auto look = [&](const auto& number, const law::Dimension& dimension) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(number)>, double>) {
      const double end = kDecays * std::abs(number);
      if (dimension == kSpeed) result.slip_rate = std::max(result.slip_rate, end);
      if (dimension == law::dimension::kForce) {
        result.contact_force = std::max(result.contact_force, end);
      }
    }
  };
  std::apply([&](const auto&... field) { (look(law.*(field.member), field.dimension), ...); },
             Law::fields());
  return result;
}

}  // namespace

LawRange law_range(const law::FrictionLaw& law) {
  return std::visit([](const auto& one) { return range(one); }, law);
}

double area_of(const law::FrictionLaw& law) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.area; }) return one.area.value_or(0.0);
        return 0.0;
      },
      law);
}

}  // namespace slipbench::driver::results
