// SPDX-License-Identifier: Apache-2.0
#include "tests/difference/one_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "law/contact/internal_contact_force.hpp"
#include "law/definition/capstan_limit.hpp"
#include "law/definition/limit_function.hpp"
#include "law/definition/motion.hpp"
#include "law/definition/packed_definition.hpp"
#include "law/exact/continuous_update.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/difference/law_increment.hpp"

namespace slipbench::test {
namespace {

template <class Vector>
double length(const Vector& v) {
  double square = 0.0;
  for (const double x : v) square += x * x;
  return std::sqrt(square);
}

/// Returns the slope of the limit to the slip of an increment, at its end [F/L].
double slope_of_limit(const law::FrictionDefinition& definition,
                      const law::ConnectorIncrement& increment, const law::FrictionState& old,
                      double motion, const law::FrictionUpdate& u) {
  const auto slope = [&](const auto& limit) { return limit.slope(limit(u.slip_increment)); };
  if (!std::holds_alternative<law::Capstan>(definition.criterion)) {
    return slope(law::LimitFunction(definition, increment, old, motion));
  }
  const double force = u.state.force[static_cast<std::size_t>(definition.slip.component[0])];
  return slope(
      law::CapstanLimit(definition, increment, motion,
                        force < 0.0 ? law::FlowSense::kBackward : law::FlowSense::kForward));
}

/// Returns the length of the shortest piece between two knots of a limit that wears, on the slip of
/// an increment [L].
double narrowest_piece(const law::FrictionDefinition& definition,
                       const law::ConnectorIncrement& increment, const law::FrictionState& old,
                       double motion, const law::FrictionUpdate& u) {
  const law::LimitFunction limit(definition, increment, old, motion);
  double narrowest = u.slip_increment;
  for (double low = 0.0; low < u.slip_increment;) {
    const double high = std::min(limit.next_knot(low, u.slip_increment), u.slip_increment);
    narrowest = std::min(narrowest, high - low);
    low = high;
  }
  return narrowest;
}

/// \param largest limit on the way [F]
/// \param from accumulated slip that the slip is a difference to [L]
PlainStep<double> plain(Way way_of, const law::FrictionDefinition& definition,
                        const law::ConnectorIncrement& increment, const law::FrictionState& old,
                        const law::FrictionUpdate& u, double largest, double from) {
  const double ds = length(law::motion_in(definition.slip, increment));
  const bool fixed = definition.stick.mode == law::StickStiffness::Mode::kStiffness;
  const double stick = definition.stick.value;
  // The way, with what the spring held, and the force that all of it would give.
  const double elastic = std::max(length(u.state.elastic_slip), fixed ? largest / stick : stick);
  const double way = ds + elastic + length(old.elastic_slip);
  double kappa = fixed ? stick : largest / stick;
  if (definition.formulation) {
    const auto* spring = std::get_if<law::StiffnessPenalty>(&definition.formulation->penalty);
    kappa = spring != nullptr ? spring->stiffness : 0.0;
  }
  const double reached = std::max(length(u.state.force), largest);
  // Behind a filter the spring may hold more than the old force.
  const double trial =
      reached + std::max(length(old.force), kappa * length(old.elastic_slip)) + kappa * ds;
  // Beside a shift the force is what a pull leaves of all of it.
  const auto* potential = std::get_if<law::Potential>(&definition.criterion);
  const bool shifted = potential != nullptr && !potential->homogeneous;
  // The force is put on the limit, which has the rounding of its slip, however steep it is; with an
  // elastic slip that is a difference of what is as long as the way.
  const double slope =
      way_of == Way::kExact ? u.tangent.radial : slope_of_limit(definition, increment, old, ds, u);
  const double by_slip = std::abs(slope) * (fixed ? u.slip_increment : way);
  const double y = std::max(shifted ? trial : reached, by_slip);
  const double both = y + length(old.force);
  const double s = shifted ? way * (1.0 + (u.limit > 0.0 ? by_slip / u.limit : 0.0))
                           : std::max(elastic, fixed ? y / stick : 0.0);
  PlainStep<double> step{{u.state.elastic_slip, u.state.force, u.state.accumulated_slip,
                          static_cast<int>(u.state.regime)},
                         {}};
  const auto tell = [&](const char* name, double value, double size) {
    step.results.push_back({name, value, std::max(size, std::abs(value))});
  };
  const double any = std::numeric_limits<double>::infinity();
  // Where a coefficient falls to nothing, both tell by their smallest number when it is there.
  const bool underflows =
      u.state.regime == law::Regime::kOpen && u.mu < std::numeric_limits<double>::min();
  for (std::size_t k = 0; k < 6; ++k) tell("force", u.state.force[k], y);
  for (std::size_t k = 0; k < 6; ++k) {
    tell("elastic slip", u.state.elastic_slip[k], underflows ? any : s);
  }
  // That of a potential is its gradient, which has corners wherever a term is 0, in stick; exactly
  // it is that of the last sub-increment, however long.
  const bool told = potential == nullptr ||
                    (way_of == Way::kBackwardEuler && u.state.regime == law::Regime::kSlip);
  const double held = told ? (shifted ? u.limit : length(u.state.force)) : 0.0;
  double known = held > 0.0 ? y / held : any;
  // On a corner it is the ratio of the parts that the return takes of each.
  if (potential != nullptr &&
      (potential->combine == law::PotentialOperator::kMax || potential->exponent == 1.0 ||
       potential->leaves > potential->parts)) {
    known = std::max(known, way / u.slip_increment);
  }
  for (std::size_t k = 0; k < 6; ++k) tell("direction", u.direction[k], known);
  const double gone = underflows ? any : way;
  tell("accumulated slip", u.state.accumulated_slip, gone);
  tell("slip increment", u.slip_increment, gone + from);
  // Beside a shift, contact is lost where the limit falls to P(0): that is told, and how exactly
  // depends on its slope to the slip.
  const bool lost = shifted && u.state.regime == law::Regime::kOpen && u.slip_increment > 0.0;
  tell("limit", u.limit, lost ? any : by_slip);
  tell("mu", u.mu, lost || !(u.normal_force > 0.0) ? any : by_slip / u.normal_force);
  tell("contact force", u.contact_force, u.normal_force);
  tell("normal force", u.normal_force, 0.0);
  // In a viscous joint the force says how fast it slips.
  const double stiff = std::max(u.tangent.rate, u.tangent.radial);
  const bool viscous = way_of == Way::kExact && fixed && stiff > 0.0;
  const double by_force = viscous ? u.limit / stiff : 0.0;
  tell("slip rate", u.slip_rate,
       increment.duration > 0.0 ? (gone + by_force) / increment.duration : 0.0);
  // Where the internal contact force is worn away, its rounding says whether it wears on.
  const double slipped = definition.accumulated_slip == law::AccumulatedSlipTiming::kEnd
                             ? u.state.accumulated_slip
                             : old.accumulated_slip;
  const double left =
      law::evaluate(definition.internal_contact_force, increment.end, slipped).value;
  const bool worn_away = left <= 1e-14 * std::abs(u.wear) * slipped;
  tell("wear", u.wear, worn_away && u.wear < 0.0 ? any : 0.0);
  tell("phi", u.phi, trial + std::abs(u.tangent.radial) * way + by_slip);
  tell("dissipation", u.dissipation, both * way);
  tell("stored energy", u.stored_energy, y * s);
  // Fourth powers of forces, which may underflow in double, say where a limit is met; and a limit
  // of nothing is met anywhere.
  const bool underflow =
      std::pow(std::min(trial, reached), 4.0) < std::numeric_limits<double>::min();
  const bool vanishes = underflow || u.limit < 1e-10 * length(old.force);
  tell("onset", u.onset,
       vanishes   ? any
       : ds > 0.0 ? (way + (kappa > 0.0 ? by_slip / kappa : 0.0)) / ds
                  : 1.0);
  tell("work", u.work, underflow ? any : both * way);
  // The steepest fall is looked for 1e-9 of a piece beside its ends, and a place in a piece has the
  // rounding of the accumulated slip.
  const bool wears = way_of == Way::kBackwardEuler && u.snap_back > 0.0;
  const double narrow = wears ? narrowest_piece(definition, increment, old, ds, u) : 0.0;
  tell("snap-back", u.snap_back,
       wears ? (1e5 + u.state.accumulated_slip / narrow) * u.snap_back : 1.0);
  tell("lost", u.lost, both * way);
  tell("jump onset", u.jump_onset, 1.0);
  const law::SlipTangent& t = u.tangent;
  const double steep = std::max({std::abs(t.transverse), std::abs(t.radial), std::abs(t.rate)}) +
                       (fixed ? 0.0 : by_slip / stick);
  // That one is of the force over the trial.
  tell("transverse", t.transverse,
       std::max(steep, reached > 0.0 ? std::abs(t.transverse) * (y / reached) : 0.0));
  tell("radial", t.radial, steep);
  tell("rate", t.rate, steep);
  tell("contact", t.contact, u.normal_force > 0.0 ? by_slip / u.normal_force : 0.0);
  tell("clip", t.clip, 1.0);
  tell("regime", static_cast<double>(u.state.regime), underflows ? any : 0.0);
  // In stick they are those of the gradient where the force would slip.
  const bool at_corner = potential != nullptr && u.state.regime == law::Regime::kStick;
  tell("multiple roots", u.multiple_roots ? 1.0 : 0.0, at_corner ? any : 0.0);
  tell("converged", u.converged ? 1.0 : 0.0, 0.0);
  tell("jumps", u.jumps, 0.0);
  return step;
}

}  // namespace

template <>
PlainStep<double> one_step<double>(Way way, std::span<const double> packed,
                                   const PlainIncrement<double>& from) {
  const auto definition = law::unpack(packed);
  if (!definition) return {};
  const law::ConnectorIncrement increment = law_increment(from);
  const law::FrictionState old{from.old.elastic_slip, from.old.force, from.old.accumulated_slip,
                               static_cast<law::Regime>(from.old.regime)};
  if (way == Way::kBackwardEuler) {
    const law::FrictionUpdate u = law::update(*definition, increment, old);
    PlainStep<double> step = plain(way, *definition, increment, old, u, u.limit, 0.0);
    if (definition->formulation) {
      law::PenaltyDetail detail;
      law::update_penalty(*definition, increment, old, &detail);
      // Rounding across an ellipse counts by as much as it is thin.
      const auto [thin, wide] = std::minmax(detail.mu[0], detail.mu[1]);
      const bool ellipse = definition->formulation->orthotropy && wide > thin;
      const double thinness = ellipse ? wide / std::max(thin, 1e-100 * wide) : 1.0;
      // A force before the filter whose square underflows has no direction.
      const bool underflows =
          length(detail.raw) * length(detail.raw) < std::numeric_limits<double>::min();
      const auto is_decision = [](std::string_view name) {
        return name == "regime" || name == "multiple roots" || name == "converged" ||
               name == "jumps";
      };
      for (PlainResult<double>& result : step.results) {
        if (!is_decision(result.name)) result.size *= thinness;
        if (underflows && std::string_view(result.name) == "direction") {
          result.size = std::numeric_limits<double>::infinity();
        }
      }
    }
    return step;
  }
  if (definition->formulation || law::no_continuous_solution(*definition)) return {};
  const law::PathSegment segment = law_segment(*definition, from);
  const double motion = length(law::motion_in(definition->slip, increment));
  const double fastest = increment.duration > 0.0 ? motion / increment.duration : 0.0;
  law::SegmentPoints points(*definition, segment, motion);
  double largest = 0.0;
  for (const double tau : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    for (const double rate : {double{0.0}, fastest}) {
      for (const double side : {-1.0, 1.0}) {
        largest = std::max(largest, points.limit(tau, old.accumulated_slip, rate, side).force);
      }
    }
  }
  // The fraction of the increment has no digit for where it sticks.
  const bool fixed = definition->stick.mode == law::StickStiffness::Mode::kStiffness;
  if (fixed && largest > 0.0 && largest < 1e-13 * definition->stick.value * motion) return {};
  PlainStep<double> step = plain(way, *definition, increment, old,
                                 law::continuous_update(*definition, segment, old, kExactness),
                                 largest, old.accumulated_slip);
  if (fixed && law::depends_on_slip_rate(definition->law)) {
    for (PlainResult<double>& result : step.results) result.size *= kViscousExactness / kExactness;
  }
  return step;
}

}  // namespace slipbench::test
