// SPDX-License-Identifier: Apache-2.0
#include "law/friction/friction_law.hpp"

#include "law/friction/law_list.hpp"

namespace slipbench::law {

std::string_view name_of(const FrictionLaw& law) {
  return visit_law([]<class Law>(const Law&) { return Law::kName; }, law);
}
std::string_view title_of(const FrictionLaw& law) {
  return visit_law([]<class Law>(const Law&) { return Law::kTitle; }, law);
}

CoefficientPoint evaluate_boxed(const BoxedLaw& law, const Ambient& ambient,
                                const SlipArguments& slip) noexcept {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.evaluate(ambient, slip); }) {
          return l.evaluate(ambient, slip);
        } else {
          return default_point(l, ambient, slip);
        }
      },
      content(law));
}

bool any_depends_on_slip_rate(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.depends_on_slip_rate(); }) {
          return l.depends_on_slip_rate();
        } else {
          return true;
        }
      },
      law);
}

bool depends_on_contact_force(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.depends_on_contact_force(); }) {
          return l.depends_on_contact_force();
        } else {
          return kSeesForce<std::remove_cvref_t<decltype(l)>>;
        }
      },
      law);
}

double largest(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.largest(); }) {
          return l.largest();
        } else {
          return default_largest(l);
        }
      },
      law);
}

double largest_growth(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.largest_growth(); }) {
          return l.largest_growth();
        } else {
          return default_largest_growth(l);
        }
      },
      law);
}

double steepest_weakening(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.steepest_weakening(); }) {
          return l.steepest_weakening();
        } else {
          return default_steepest_weakening(l);
        }
      },
      law);
}

double any_next_bend(const FrictionLaw& law, const SlipLine& line) noexcept {
  return visit_law(
      [&](const auto& l) {
        if constexpr (requires { l.next_bend(line); }) {
          return l.next_bend(line);
        } else {
          return default_next_bend(l, line);
        }
      },
      law);
}

double next_belt_bend(const FrictionLaw& law, const SlipLine& line, double wrap_angle,
                      FlowSense sense) noexcept {
  return visit_law(
      [&](const auto& l) {
        if constexpr (requires { l.next_belt_bend(line, wrap_angle, sense); }) {
          return l.next_belt_bend(line, wrap_angle, sense);
        } else {
          return default_next_belt_bend(l, line, wrap_angle, sense);
        }
      },
      law);
}

bool has_floor(const FrictionLaw& law) {
  return visit_law([]<class Law>(const Law&) { return keeps_floor<Law>(); }, law);
}

double raw_coefficient(const FrictionLaw& law, const Ambient& ambient,
                       const SlipArguments& slip) noexcept {
  return visit_law(
      [&](const auto& l) {
        if constexpr (requires { l.raw(ambient, slip); }) {
          return l.raw(ambient, slip);
        } else if constexpr (requires { l.evaluate(ambient, slip); }) {
          return l.evaluate(ambient, slip).mu;
        } else {
          return coefficient_of(l, ambient, slip.slip_rate, slip.contact_force);
        }
      },
      law);
}

std::string_view overflow(const FrictionLaw& law, double slip_rate) {
  return visit_law(
      [&](const auto& l) {
        if constexpr (requires { l.overflow(slip_rate); }) return l.overflow(slip_rate);
        return std::string_view{};
      },
      law);
}

LawRange range(const FrictionLaw& law) {
  return visit_law([](const auto& l) { return own_range(l); }, law);
}

double area_of(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) -> double {
        if constexpr (requires { l.area; }) return l.area.value_or(0.0);
        return 0.0;
      },
      law);
}

bool needs_area(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        if constexpr (requires { l.needs_area(); }) return l.needs_area();
        return false;
      },
      law);
}

std::optional<ExponentialDecay> exponential_decay(const FrictionLaw& law) {
  if (const auto* decay = std::get_if<ExponentialDecay>(&law)) return *decay;
  if (const auto* data = get_law_if<ExponentialTestData>(law)) return data->fit();
  return std::nullopt;
}

}  // namespace slipbench::law
