// SPDX-License-Identifier: Apache-2.0
#include "driver/read/resolve/resolve_formulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "law/base/component.hpp"
#include "law/update/penalty_predictor.hpp"

namespace slipbench::driver::read {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Reports a key that is of no use where it stands.
template <class T>
bool refuse(yaml::Binder& binder, const yaml::At<T>& at, std::string message,
            std::string hint = {}) {
  if (!at.given()) return false;
  binder.error(*at.node, at.path, std::move(message), std::move(hint));
  return true;
}

std::optional<law::NormalStiffness> normal_stiffness(yaml::Binder& binder,
                                                     const yaml::At<NumberOrTable>& at) {
  if (!at.sound) return std::nullopt;
  if (const double* number = std::get_if<double>(&at.value)) return *number;
  auto function = table_function(binder, std::get<TableText>(at.value), *at.node, at.path,
                                 kNormalStiffnessTable);
  if (!function) return std::nullopt;
  return std::move(*function);
}

/// VISF, K and m, or C: exactly one of the two ways.
std::optional<law::ViscousPenalty> viscous(yaml::Binder& binder,
                                           const yaml::At<FormulationText>& at) {
  const FormulationText& text = at.value;
  bool good = !refuse(binder, text.tangential_stiffness,
                      "K_t belongs to 'penalty: stiffness'; the viscous penalty has no stick",
                      "the slope of its force over the speed is C, or VISF sqrt(2 K m)");
  law::ViscousPenalty penalty;
  const bool sqrt_given = text.normal_stiffness.given() || text.mass.given();
  if (text.viscous_coefficient.given()) {
    if (sqrt_given || text.visf.given()) {
      binder.error(*text.viscous_coefficient.node, text.viscous_coefficient.path,
                   "stands in place of VISF sqrt(2 K m): give 'C' alone, or 'K' and 'm' with or "
                   "without 'VISF'");
      good = false;
    }
    if (!text.viscous_coefficient.sound) return std::nullopt;
    penalty.coefficient = text.viscous_coefficient.value;
    return good ? std::optional(penalty) : std::nullopt;
  }
  if (!text.normal_stiffness.given() || !text.mass.given()) {
    if (!yaml::has_unknown_key<FormulationText>(*at.node)) {
      const std::string lacks = sqrt_given ? (text.mass.given() ? "'K'" : "'m'") : "'K' and 'm'";
      binder.error(*at.node, at.path,
                   "a viscous penalty needs " + lacks +
                       (sqrt_given ? ": C = VISF sqrt(2 K m)" : ", or 'C': C = VISF sqrt(2 K m)"));
    }
    good = false;
  }
  auto stiffness = normal_stiffness(binder, text.normal_stiffness);
  if (!stiffness || !text.mass.sound || text.visf.faulty() || !good) return std::nullopt;
  penalty.stiffness = std::move(*stiffness);
  penalty.mass = text.mass.value;
  if (text.visf.given() && text.visf.value == 0.0) {
    binder.note(*text.visf.node, text.visf.path, "VISF 0 means 1, as in the solver");
  } else if (text.visf.given()) {
    penalty.visf = text.visf.value;
  }
  const double* number = std::get_if<double>(&penalty.stiffness);
  if (number != nullptr && !std::isfinite(penalty.visf * std::sqrt(2.0 * *number * penalty.mass))) {
    binder.error(*text.normal_stiffness.node, text.normal_stiffness.path,
                 fmt::format("C = VISF sqrt(2 K m) is not finite for VISF {}, K {} and m {}",
                             base::format_number(penalty.visf), base::format_number(*number),
                             base::format_number(penalty.mass)));
    return std::nullopt;
  }
  if (penalty.mass == 0.0 || (number != nullptr && *number == 0.0)) {
    const yaml::At<double>& mass = text.mass;
    binder.warning(mass.value == 0.0 ? *mass.node : *text.normal_stiffness.node,
                   mass.value == 0.0 ? mass.path : text.normal_stiffness.path,
                   "C = VISF sqrt(2 K m) = 0: there is no friction force");
  }
  return penalty;
}

std::optional<law::StiffnessPenalty> stiffness(yaml::Binder& binder,
                                               const yaml::At<FormulationText>& at) {
  const FormulationText& text = at.value;
  const std::string of_viscous = " belongs to 'penalty: viscous'; a stiffness penalty has 'K_t'";
  bool good = !refuse(binder, text.normal_stiffness, "K" + of_viscous);
  good = !refuse(binder, text.mass, "m" + of_viscous) && good;
  good = !refuse(binder, text.viscous_coefficient, "C" + of_viscous) && good;
  if (text.visf.sound) {
    binder.warning(*text.visf.node, text.visf.path,
                   "VISF has no effect on a stiffness penalty: it is a factor of the viscous C");
  }
  if (!text.tangential_stiffness.given() && !yaml::has_unknown_key<FormulationText>(*at.node)) {
    binder.error(*at.node, at.path, "a stiffness penalty needs 'K_t'");
  }
  if (!good || !text.tangential_stiffness.sound) return std::nullopt;
  return law::StiffnessPenalty{text.tangential_stiffness.value};
}

/// alpha of an Xfreq of Ifiltr 2, in one of its two spellings.
std::optional<double> xfreq_coefficient(yaml::Binder& binder, const FilterText& text) {
  const yaml::At<double>& xfreq = text.xfreq;
  if (!text.xfreq_convention.given()) {
    binder.error(*xfreq.node, xfreq.path,
                 "needs 'xfreq_convention': steps (Xfreq = T/dt) or ratio (Xfreq = dt/T)",
                 "decks that ran in OpenRadioss mean steps; 'period: T' says it without either");
    return std::nullopt;
  }
  if (!text.xfreq_convention.sound || !xfreq.sound) return std::nullopt;
  const bool steps = text.xfreq_convention.value == XfreqConvention::kSteps;
  const double alpha = steps ? kTwoPi / xfreq.value : kTwoPi * xfreq.value;
  if (alpha <= 1.0) return alpha;
  binder.error(*xfreq.node, xfreq.path,
               steps
                   ? fmt::format("alpha = 2 pi/Xfreq = {:.7g} is above 1: an Xfreq in steps is at "
                                 "least 2 pi = 6.2831853... (found {})",
                                 alpha, base::format_number(xfreq.value))
                   : fmt::format("alpha = 2 pi Xfreq = {:.7g} is above 1: an Xfreq as a ratio is "
                                 "at most 1/(2 pi) = 0.1591549... (found {})",
                                 alpha, base::format_number(xfreq.value)));
  return std::nullopt;
}

/// Tells whether a filter of this formulation smooths the force, as law::smooths has it of a sound
/// one.
bool would_smooth(const FormulationText& text) {
  law::Formulation formulation;
  formulation.filter.kind = law::Filter::Kind::kSimple;
  formulation.convention = text.convention;
  if (!text.penalty.sound || text.penalty.value == PenaltyKind::kStiffness) {
    formulation.penalty = law::StiffnessPenalty{};
  }
  return law::smooths(formulation);
}

/// The filter of a definition; nothing after an error.
std::optional<law::Filter> filter(yaml::Binder& binder, const yaml::At<FilterText>& at,
                                  const FormulationText& formulation) {
  const FilterText& text = at.value;
  using Kind = law::Filter::Kind;
  law::Filter result;
  result.clip = text.clip;
  int ways = 0;
  for (const yaml::At<double>* way : {&text.simple, &text.period, &text.frequency, &text.xfreq}) {
    ways += way->given() ? 1 : 0;
  }
  if (ways != 1) {
    if (ways > 1 || !yaml::has_unknown_key<FilterText>(*at.node)) {
      binder.error(*at.node, at.path,
                   std::string(ways == 0 ? "needs" : "takes only") +
                       " one of 'simple', 'period', 'frequency' and 'Xfreq'");
    }
    return std::nullopt;
  }
  if (text.xfreq_convention.given() && !text.xfreq.given()) {
    binder.error(*text.xfreq_convention.node, text.xfreq_convention.path,
                 "says how 'Xfreq' is meant, which is not given");
    return std::nullopt;
  }
  if (at.faulty()) return std::nullopt;
  for (const yaml::At<double>* way : {&text.simple, &text.frequency, &text.xfreq}) {
    if (!way->given() || way->value != 0.0) continue;
    binder.warning(*way->node, way->path, "0 is no filter: the force is not smoothed");
    return result;
  }
  if (text.simple.given()) {
    result.kind = Kind::kSimple;
    result.value = text.simple.value;
  } else if (text.period.given()) {
    result.kind = Kind::kPeriod;
    result.value = text.period.value;
  } else if (text.frequency.given()) {
    result.kind = Kind::kFrequency;
    result.value = text.frequency.value;
    if (formulation.convention == law::Convention::kAsCoded) {
      binder.warning(*text.frequency.node, text.frequency.path,
                     would_smooth(formulation)
                         ? "as coded alpha is max(1, 2 pi f dt): this filter never smooths, above "
                           "1 it overshoots and from 2 on it diverges"
                         : "as coded alpha is max(1, 2 pi f dt), a factor of K_t: this filter "
                           "never smooths, above 1 it makes the spring stiffer");
    }
  } else {
    const auto alpha = xfreq_coefficient(binder, text);
    if (!alpha) return std::nullopt;
    result.kind = Kind::kSimple;
    result.value = *alpha;
  }
  return result;
}

std::optional<law::Orthotropy> orthotropy(yaml::Binder& binder, const OrthotropicText& text,
                                          const LawSurroundings& surroundings) {
  law::Orthotropy result;
  result.speed = text.speed;
  bool good = true;
  if (auto second = coefficient_law(binder, coefficient_of(text.direction2), surroundings)) {
    result.second = std::move(*second);
  } else {
    good = false;
  }
  if (text.axis.faulty()) return std::nullopt;
  if (text.axis.given()) {
    const std::vector<double>& axis = text.axis.value;
    const double length = axis.size() == 2 ? std::hypot(axis[0], axis[1]) : 0.0;
    if (!(length > 0.0) || !std::isfinite(length)) {
      binder.error(*text.axis.node, text.axis.path,
                   axis.size() == 2
                       ? "an axis of length 0 has no direction"
                       : fmt::format("wanted the 2 entries of direction 1 in the two components "
                                     "that slip, found {}",
                                     axis.size()));
      return std::nullopt;
    }
    result.first = {axis[0] / length, axis[1] / length};
  }
  return good ? std::optional(std::move(result)) : std::nullopt;
}

/// The penalty of `formulation:`, or of the stick stiffness beside an orthotropic coefficient.
std::optional<law::Formulation> penalty(yaml::Binder& binder,
                                        const yaml::At<FrictionText>& friction) {
  const FrictionText& text = friction.value;
  law::Formulation result;
  if (!text.formulation.given()) {
    if (text.stick.value.stiffness.sound) {
      result.penalty = law::StiffnessPenalty{text.stick.value.stiffness.value};
      return result;
    }
    if (!text.stick.faulty() && !yaml::has_unknown_key<FrictionText>(*friction.node)) {
      binder.error(*text.coefficient.node, text.coefficient.path,
                   "an orthotropic coefficient needs a 'formulation', or 'stick: {stiffness: k}', "
                   "which stands for the formulation {penalty: stiffness, K_t: k}");
    }
    return std::nullopt;
  }
  const FormulationText& formulation = text.formulation.value;
  result.convention = formulation.convention;
  const bool refused =
      refuse(binder, text.stick,
             "a formulation has a stiffness of its own in place of the connector's 'stick'",
             "leave out 'stick'; a stiffness penalty has 'K_t'");
  if (!formulation.penalty.sound) return std::nullopt;
  if (formulation.penalty.value == PenaltyKind::kViscous) {
    auto made = viscous(binder, text.formulation);
    if (!made || refused || text.formulation.faulty()) return std::nullopt;
    result.penalty = std::move(*made);
  } else {
    auto made = stiffness(binder, text.formulation);
    if (!made || refused || text.formulation.faulty()) return std::nullopt;
    result.penalty = *made;
  }
  return result;
}

/// The increments of a step against the period of a filter.
void check_period(yaml::Binder& binder, const yaml::At<FilterText>& at, bool smooths,
                  const cases::Case& problem) {
  const yaml::At<double>& period = at.value.period;
  if (!period.sound) return;
  for (const cases::Step& step : problem.steps) {
    const double dt = step.duration / step.increments;
    const double alpha = kTwoPi * dt / period.value;
    if (!(alpha > 1.0)) continue;
    constexpr double kMostIncrements = 1e9;
    const double wanted = std::ceil(kTwoPi * step.duration / period.value);
    binder.error(
        *period.node, period.path,
        fmt::format(
            "alpha = 2 pi dt/T = {:.6g} is above 1 in step '{}' with dt = {}: {}", alpha, step.name,
            base::format_number(dt),
            smooths ? "the filter would overshoot" : "the spring would be stiffer than K_t"),
        "give the step " +
            (wanted <= kMostIncrements ? fmt::format("at least {:.0f} increments, or ", wanted)
                                       : std::string()) +
            fmt::format("a period of at least {:.6g}", kTwoPi * dt));
    return;
  }
}

/// A formulation sees the motion's speed and the wear at the start, whatever `integration:` says.
void warn_of_timing(yaml::Binder& binder, const CaseText& text) {
  const std::vector<yaml::At<FrictionText>>& all = text.friction.value;
  if (std::none_of(all.begin(), all.end(), [](const yaml::At<FrictionText>& friction) {
        return has_formulation(friction.value);
      })) {
    return;
  }
  const IntegrationText& integration = text.integration;
  if (integration.slip_rate.given() && integration.slip_rate.value == law::SlipRateMeasure::kSlip) {
    binder.warning(*integration.slip_rate.node, integration.slip_rate.path,
                   "a formulation sees the speed of the relative motion, not that of the slip");
  }
  if (integration.accumulated_slip.given() &&
      integration.accumulated_slip.value == law::AccumulatedSlipTiming::kEnd) {
    binder.warning(*integration.accumulated_slip.node, integration.accumulated_slip.path,
                   "a formulation takes the internal contact force at the slip of the start of an "
                   "increment");
  }
}

}  // namespace

yaml::At<CoefficientText> coefficient_of(const yaml::At<DirectionText>& direction) {
  yaml::At<CoefficientText> coefficient;
  coefficient.value = direction.value.coefficient;
  coefficient.node = direction.node;
  coefficient.path = direction.path;
  coefficient.sound = direction.sound;
  return coefficient;
}

bool has_formulation(const FrictionText& text) {
  return text.formulation.given() || text.coefficient.value.orthotropic != nullptr;
}

std::optional<law::Formulation> formulation(yaml::Binder& binder,
                                            const yaml::At<FrictionText>& friction,
                                            const LawSurroundings& surroundings) {
  const FrictionText& text = friction.value;
  if (!has_formulation(text)) {
    if (text.filter.given() && !yaml::has_unknown_key<FrictionText>(*friction.node)) {
      refuse(binder, text.filter,
             "a filter smooths the force of a 'formulation', and this definition has none",
             "add 'formulation: {penalty: stiffness, K_t: ...}' or {penalty: viscous, ...}");
    }
    return std::nullopt;
  }
  auto result = penalty(binder, friction);
  bool good = result.has_value();
  if (text.filter.given() && text.filter.node->is_map()) {
    auto made = filter(binder, text.filter, text.formulation.value);
    good = good && made;
    if (good) result->filter = *made;
  } else {
    good = good && !text.filter.given();
  }
  if (text.coefficient.value.orthotropic) {
    auto made = orthotropy(binder, *text.coefficient.value.orthotropic, surroundings);
    const FormulationText& written = text.formulation.value;
    if (written.penalty.sound && written.penalty.value == PenaltyKind::kViscous &&
        written.convention == law::Convention::kAsCoded) {
      binder.error(*text.coefficient.node, text.coefficient.path,
                   "as coded, a viscous penalty with two coefficients gives a force that points "
                   "the wrong way: it is not offered",
                   "take 'convention: documented', or 'penalty: stiffness'");
      good = false;
    }
    good = good && made && text.coefficient.sound;
    if (good) result->orthotropy = std::move(*made);
  }
  return good ? result : std::nullopt;
}

void set_formulation(law::FrictionDefinition& definition, const law::Formulation& formulation) {
  definition.formulation = formulation;
  definition.slip_rate = law::SlipRateMeasure::kRelativeMotion;
  if (const auto* spring = std::get_if<law::StiffnessPenalty>(&formulation.penalty)) {
    definition.stick = {law::StickStiffness::Mode::kStiffness, spring->stiffness};
  }
}

bool slip_suits_formulation(yaml::Binder& binder, const yaml::At<FrictionText>& friction,
                            const law::FrictionDefinition& definition) {
  const FrictionText& text = friction.value;
  const auto error = [&](std::string message, std::string hint) {
    if (text.formulation.given()) {
      binder.error(*text.formulation.node, text.formulation.path, std::move(message),
                   std::move(hint));
    } else {
      binder.error(*text.coefficient.node, text.coefficient.path, std::move(message),
                   std::move(hint));
    }
    return false;
  };
  if (std::holds_alternative<law::Capstan>(definition.criterion)) {
    return error("a SLIPRING takes no formulation: its limit depends on the sense of its flow",
                 "give 'stick'");
  }
  if (std::holds_alternative<law::Potential>(definition.criterion)) {
    return error(
        "a formulation returns the force to a circle or an ellipse, not to this potential",
        "take 'operator: sum' with 'exponent: 2' and no shifts, or 'stick' in place of it");
  }
  if (!definition.formulation || !definition.formulation->orthotropy) return true;
  const law::SlipSpace& slip = definition.slip;
  const std::string wanted = "an orthotropic coefficient needs two components that slip together";
  if (slip.dimension != 2) {
    binder.error(*text.coefficient.node, text.coefficient.path,
                 wanted + (slip.dimension == 1 ? ", here one slips"
                                               : fmt::format(", here {} slip", slip.dimension)),
                 "predefined CONTACT, SLIDE-PLANE and CYLINDRICAL have two, and so has a "
                 "'potential' of two terms; the spinning of a PLANAR is 'component: 4' beside it");
    return false;
  }
  // With a radius a rotation is a length along the surface; without one it is an angle.
  const auto is_angle = [&](std::size_t i) {
    const int c = slip.component[i];
    const auto& terms = text.potential.value.terms.value;
    return law::is_rotation(c) && slip.scale[i] == 1.0 && !text.predefined.given() &&
           std::none_of(terms.begin(), terms.end(), [&](const yaml::At<PotentialTermText>& term) {
             return term.value.component.value == c + 1 && term.value.scale.given();
           });
  };
  if (is_angle(0) == is_angle(1)) return true;
  binder.error(*text.coefficient.node, text.coefficient.path,
               wanted + " in one unit: here one is an angle beside a length",
               "the 'scale' of the rotation is the radius it rubs at");
  return false;
}

void check_formulations(yaml::Binder& binder, const CaseText& text, const cases::Case& problem) {
  const std::vector<yaml::At<FrictionText>>& all = text.friction.value;
  if (all.empty()) return;
  warn_of_timing(binder, text);
  const bool predefined = all.front().value.predefined.given();
  if (!predefined && all.size() != problem.definitions.size()) return;
  const std::size_t count = predefined ? 1 : all.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FrictionText& friction = all[i].value;
    if (!has_formulation(friction)) continue;
    const bool written = friction.formulation.given();
    const yaml::Node& node = written ? *friction.formulation.node : *friction.coefficient.node;
    const yaml::Path& path = written ? friction.formulation.path : friction.coefficient.path;
    if (problem.dynamics) {
      binder.error(node, path, "a mass of 'dynamics:' sticks rigidly: it takes no formulation",
                   "leave out 'dynamics:', or give the definition no formulation");
    }
    if (friction.filter.given()) {
      const bool smooths = would_smooth(friction.formulation.value);
      check_period(binder, friction.filter, smooths, problem);
      law::ComponentSet slips;
      for (const cases::CaseDefinition& definition : problem.definitions) {
        if (!predefined && &definition != &problem.definitions[i]) continue;
        const law::SlipSpace& slip = definition.law.slip;
        for (int k = 0; k < slip.dimension; ++k) {
          slips.insert(slip.component[static_cast<std::size_t>(k)]);
        }
      }
      if (smooths && !(slips & problem.force_driven).empty()) {
        binder.error(*friction.filter.node, friction.filter.path,
                     "a filtered force lags behind the motion: " +
                         motion_names(slips & problem.force_driven) +
                         ", driven by force, would have no equilibrium to find",
                     "drive the motion, or leave out the filter");
      }
    }
  }
}

}  // namespace slipbench::driver::read
