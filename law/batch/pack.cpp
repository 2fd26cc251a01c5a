// SPDX-License-Identifier: Apache-2.0
#include "law/batch/pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/base/slip_vector.hpp"
#include "law/definition/known_limit.hpp"
#include "law/definition/motion.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {
namespace {

/// Tells whether two tables give the same for every argument.
bool same(const TableFunction& a, const TableFunction& b) noexcept {
  if (!std::ranges::equal(a.independents(), b.independents())) return false;
  if (!a.table().same_grid(b.table())) return false;
  for (std::size_t row = 0; row < a.table().rows(); ++row) {
    if (a.table().ordinate(row) != b.table().ordinate(row)) return false;
  }
  return true;
}

/// Tells whether two laws are seen at once to be the same.
bool same(const FrictionLaw& a, const FrictionLaw& b) noexcept {
  if (a.index() != b.index()) return false;
  if (const auto* table = std::get_if<TabularCoefficient>(&a)) {
    return same(table->table, std::get_if<TabularCoefficient>(&b)->table);
  }
  if (const auto* decay = std::get_if<ExponentialDecay>(&a)) {
    const auto* other = std::get_if<ExponentialDecay>(&b);
    return decay->mu_static == other->mu_static && decay->kinetic == other->kinetic &&
           decay->decay == other->decay;
  }
  const auto* constant = std::get_if<ConstantCoefficient>(&a);
  return constant != nullptr && constant->mu == std::get_if<ConstantCoefficient>(&b)->mu;
}

bool same(const DerivedTerm& a, const DerivedTerm& b) noexcept {
  return a.combine == b.combine && a.sign == b.sign && a.count == b.count &&
         a.component == b.component && a.weight == b.weight && !a.weight_table && !b.weight_table;
}

/// Tells whether two contact forces are seen at once to be the same.
bool same(const ContactForce& a, const ContactForce& b) noexcept {
  if (a.index() != b.index()) return false;
  if (const auto* one = std::get_if<ComponentContactForce>(&a)) {
    return one->component == std::get_if<ComponentContactForce>(&b)->component;
  }
  if (const auto* terms = std::get_if<DerivedComponent>(&a)) {
    return std::ranges::equal(
        *terms, *std::get_if<DerivedComponent>(&b),
        [](const DerivedTerm& x, const DerivedTerm& y) { return same(x, y); });
  }
  return std::holds_alternative<NoContactForce>(a);
}

/// Tells whether a contact force depends on forces alone.
bool is_of_forces(const ContactForce& contact) noexcept {
  if (std::holds_alternative<UniversalJointContact>(contact)) return false;
  const auto* terms = std::get_if<DerivedComponent>(&contact);
  return terms == nullptr || std::ranges::none_of(*terms, [](const DerivedTerm& term) {
           return term.weight_table.has_value();
         });
}

constexpr LaneColumn kOnes = [] {
  LaneColumn ones{};
  ones.fill(1.0);
  return ones;
}();

/// Tells whether two definitions of one form have the same coefficient under the same motion.
bool same_coefficient(const FrictionDefinition& a, const FrictionDefinition& b) noexcept {
  return a.slip_rate == b.slip_rate && a.slip.scale == b.slip.scale &&
         a.blend.start == b.blend.start && a.blend.weight == b.blend.weight && same(a.law, b.law);
}

/// Tells whether the coefficients of two definitions of one form come from the same rows of their
/// tables under the same motion.
bool same_cells(const FrictionDefinition& a, const FrictionDefinition& b) noexcept {
  const auto* one = std::get_if<TabularCoefficient>(&a.law);
  const auto* other = std::get_if<TabularCoefficient>(&b.law);
  return one != nullptr && other != nullptr && a.slip_rate == b.slip_rate &&
         a.slip.scale == b.slip.scale && a.blend.weight == 1.0 && b.blend.weight == 1.0 &&
         one->table.independents().size() <= 2 &&
         std::ranges::equal(one->table.independents(), other->table.independents()) &&
         one->table.table().same_grid(other->table.table());
}

/// Tells whether F_int is a number, or a table over the accumulated slip alone.
bool is_simple(const InternalContactForce& internal) noexcept {
  if (const auto* number = std::get_if<double>(&internal)) return *number >= 0.0;
  const auto independents = std::get_if<TableFunction>(&internal)->independents();
  return independents.size() == 1 && independents[0].kind == IndependentKind::kAccumulatedSlip;
}

/// Returns |ds| [L].
double motion_of(const FrictionDefinition& definition,
                 const ConnectorIncrement& increment) noexcept {
  return in_dimension(definition.slip.dimension, [&](auto d) {
    Slip<d> ds;
    for (int k = 0; k < d; ++k) {
      ds[k] = motion_along(definition.slip, increment, static_cast<std::size_t>(k));
    }
    return norm<d>(ds);
  });
}

/// Returns the slip rate that the coefficient of a definition that has a form sees.
double slip_rate(const FrictionDefinition& definition,
                 const ConnectorIncrement& increment) noexcept {
  return definition.slip_rate == SlipRateMeasure::kRelativeMotion
             ? motion_of(definition, increment) * inverse_duration(increment.duration)
             : 0.0;
}

/// Returns the coefficient of a definition that has a form.
double coefficient(const FrictionDefinition& definition,
                   const ConnectorIncrement& increment) noexcept {
  const double rate = slip_rate(definition, increment);
  return blended(definition.blend, evaluate(definition.law, increment.end, {.slip_rate = rate})).mu;
}

}  // namespace

std::optional<BatchForm> batch_form(const FrictionDefinition& definition) noexcept {
  const auto dimension = static_cast<std::size_t>(definition.slip.dimension);
  if (definition.formulation || !std::holds_alternative<EuclideanPotential>(definition.criterion) ||
      dimension > kLaneEntries || !has_known_limit(definition) ||
      depends_on_contact_force(definition.law) || !is_simple(definition.internal_contact_force)) {
    return std::nullopt;
  }
  BatchForm form{.fixed = definition.stick.mode == StickStiffness::Mode::kStiffness,
                 .dimension = definition.slip.dimension};
  for (std::size_t k = 0; k < dimension; ++k) form.component[k] = definition.slip.component[k];
  return form;
}

LaneExtreme::LaneExtreme(LaneNumber of, std::size_t of_entry, LaneKept what) noexcept
    : number(of), entry(of_entry), kept(what) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  so_far.fill(kept == LaneKept::kMagnitude ? -1.0
              : kept == LaneKept::kMinimum ? kInfinity
                                           : -kInfinity);
}

Pack::Pack(std::span<const FrictionDefinition> definitions,
           std::span<const FrictionState> begin) noexcept
    : definitions_(definitions) {
  for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
    const FrictionState state = begin.empty() ? FrictionState{} : begin[lane];
    const auto form = batch_form(definitions_[lane]);
    if (!form_ && form) {
      form_ = form;
      first_ = lane;
    }
    if (form && *form == *form_) {
      enter(lane, state);
    } else {
      alone_[lane].state = state;
    }
  }
}

/// Puts a definition and its state on the common path.
void Pack::enter(std::size_t lane, const FrictionState& begin) noexcept {
  const FrictionDefinition& definition = definitions_[lane];
  const FrictionDefinition& first = definitions_[first_];
  common_[lane] = true;
  is_constant_ = is_constant_ && std::holds_alternative<ConstantCoefficient>(definition.law);
  shares_coefficient_ = shares_coefficient_ && same_coefficient(first, definition);
  shares_cells_ = shares_cells_ && same_cells(first, definition);
  shares_contact_ = shares_contact_ && same(first.contact_force, definition.contact_force);
  contact_follows_ = contact_follows_ || !is_of_forces(definition.contact_force);
  for (std::size_t k = 0; k < static_cast<std::size_t>(form_->dimension); ++k) {
    lanes_.scale[k][lane] = definition.slip.scale[k];
    lanes_.force[k][lane] = begin.force[k];
    lanes_.elastic_slip[k][lane] = begin.elastic_slip[k];
  }
  lanes_.stick[lane] = definition.stick.value;
  lanes_.force_limit[lane] = definition.force_limit;
  lanes_.mu[lane] = is_constant_ ? coefficient(definition, {}) : 0.0;
  lanes_.accumulated_slip[lane] = begin.accumulated_slip;
  lanes_.slip_left_out[lane] = begin.accumulated_slip.left_out();
  lanes_.regime[lane] = static_cast<double>(begin.regime);
  if (const auto* number = std::get_if<double>(&definition.internal_contact_force)) {
    lanes_.segment_low[lane] = *number;
  } else {
    wears_ = true;
    enter_segment(lane);
  }
}

/// Finds the segment of F_int's table that the accumulated slip of a lane has come to; as
/// Table::value has it, right-hand at a knot. It only ever grows: each segment is found once.
void Pack::enter_segment(std::size_t lane) noexcept {
  const auto* function = std::get_if<TableFunction>(&definitions_[lane].internal_contact_force);
  const Table& table = function->table();
  const std::span<const double> knots = table.knots(0);
  const double slip = lanes_.accumulated_slip[lane];
  const auto above = std::ranges::upper_bound(knots, slip);
  const auto passed = static_cast<std::size_t>(above - knots.begin());
  const bool holds = table.extrapolation() == Extrapolation::kConstant || knots.size() == 1;
  const std::size_t last = knots.size() - 1;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (holds && (passed == 0 || passed > last)) {
    lanes_.segment_low[lane] = table.ordinate(passed == 0 ? 0 : last);
    lanes_.segment_rise[lane] = 0.0;
    lanes_.segment_begin[lane] = 0.0;
    lanes_.segment_width[lane] = 1.0;
    lanes_.segment_end[lane] = passed == 0 ? knots[0] : kNever;
    return;
  }
  const std::size_t i = std::clamp<std::size_t>(passed, 1, last) - 1;
  lanes_.segment_low[lane] = table.ordinate(i);
  lanes_.segment_rise[lane] = table.ordinate(i + 1) - table.ordinate(i);
  lanes_.segment_begin[lane] = knots[i];
  lanes_.segment_width[lane] = knots[i + 1] - knots[i];
  lanes_.segment_end[lane] = holds || i + 1 < last ? knots[i + 1] : kNever;
}

void Pack::follow(std::span<LaneExtreme> extremes, std::span<LaneChanges> changes) noexcept {
  extremes_ = extremes;
  changes_ = changes;
}

void Pack::press(std::span<const LaneForce> forces) noexcept {
  own_forces_ = forces;
  pressed_.reset();
}

ConnectorForce Pack::force_of(std::size_t lane,
                              const ConnectorIncrement& increment) const noexcept {
  ConnectorForce force = increment.force;
  for (const LaneForce& own : own_forces_) force[own.component] = own.of_lane[lane];
  return force;
}

double Pack::contact_of(std::size_t lane, const ConnectorIncrement& increment) const noexcept {
  return evaluate(definitions_[lane].contact_force, force_of(lane, increment), increment.end);
}

void Pack::take_contact(const ConnectorIncrement& increment) noexcept {
  if (pressed_ && !contact_follows_ && pressed_->values == increment.force.values) return;
  pressed_ = increment.force;
  if (shares_contact_ && own_forces_.empty()) {
    lanes_.contact.fill(contact_of(first_, increment));
    return;
  }
  for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
    if (common_[lane]) lanes_.contact[lane] = contact_of(lane, increment);
  }
}

/// Interpolates in all tables at once: they differ in their ordinates only.
void Pack::mix_coefficients(const ConnectorIncrement& increment, InstructionSet set) noexcept {
  const FrictionDefinition& first = definitions_[first_];
  const TableFunction& function = std::get_if<TabularCoefficient>(&first.law)->table;
  const auto arguments =
      function.arguments(increment.end, {.slip_rate = slip_rate(first, increment)});
  const TableMix mix =
      function.table().mix(std::span(arguments).first(function.independents().size()));
  if (!has_corners_ || mix.row != rows_) {
    rows_ = mix.row;
    has_corners_ = true;
    for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
      if (!common_[lane]) continue;
      const auto* law = std::get_if<TabularCoefficient>(&definitions_[lane].law);
      const Table& table = law->table.table();
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        corners_[i][lane] = table.ordinate(rows_[i]);
      }
    }
  }
  lane_mix(set)(corners_, mix.fraction, &lanes_.mu);
}

void Pack::take_coefficient(const ConnectorIncrement& increment, InstructionSet set) noexcept {
  if (is_constant_) return;
  if (shares_coefficient_) {
    lanes_.mu.fill(coefficient(definitions_[first_], increment));
    return;
  }
  if (shares_cells_) {
    mix_coefficients(increment, set);
    return;
  }
  for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
    if (common_[lane]) lanes_.mu[lane] = coefficient(definitions_[lane], increment);
  }
}

void Pack::advance_common(std::span<const ConnectorIncrement> increments,
                          InstructionSet set) noexcept {
  const LaneStep step = lane_step(form_->dimension, form_->fixed, wears_, set);
  const LaneCount count = lane_count(set);
  const auto dimension = static_cast<std::size_t>(form_->dimension);
  for (const ConnectorIncrement& increment : increments) {
    take_contact(increment);
    take_coefficient(increment, set);
    LaneMotion motion{};
    for (std::size_t k = 0; k < dimension; ++k) {
      const int c = form_->component[k];
      motion[k] = increment.end.position[c] - increment.begin_position[c];
    }
    const bool passed = step(&lanes_, motion);
    for (LaneExtreme& one : extremes_) {
      const bool scaled = one.number == LaneNumber::kForce;
      lane_keep(one.kept, set)(column(one.number, one.entry),
                               scaled ? lanes_.scale[one.entry] : kOnes, &one.so_far);
    }
    for (LaneChanges& one : changes_) {
      count(lanes_.regime, static_cast<double>(one.from), static_cast<double>(one.to), &one.before,
            &one.count);
    }
    if (!passed) continue;
    for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
      if (lanes_.accumulated_slip[lane] >= lanes_.segment_end[lane]) enter_segment(lane);
    }
  }
  // A constant kappa keeps no elastic slip of its own.
  if (!form_->fixed || increments.empty()) return;
  for (std::size_t k = 0; k < dimension; ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes_.elastic_slip[k][lane] = lanes_.force[k][lane] / lanes_.stick[lane];
    }
  }
}

void Pack::advance_alone(std::size_t lane,
                         std::span<const ConnectorIncrement> increments) noexcept {
  const FrictionDefinition& definition = definitions_[lane];
  auto& [state, summary] = alone_[lane];
  for (const ConnectorIncrement& shared : increments) {
    ConnectorIncrement increment = shared;
    increment.force = force_of(lane, shared);
    const FrictionUpdate next = update(definition, increment, state);
    state = next.state;
    summary.peak_force = std::max(summary.peak_force, equivalent_force(definition, state));
    summary.dissipation += next.dissipation;
    summary.limit = next.limit;
    summary.slipping += state.regime == Regime::kSlip ? 1 : 0;
    summary.open += state.regime == Regime::kOpen ? 1 : 0;
    summary.doubtful += next.multiple_roots || next.jumps > 0 || !next.converged ? 1 : 0;
  }
}

void Pack::advance(std::span<const ConnectorIncrement> increments, InstructionSet set) noexcept {
  if (form_) advance_common(increments, set);
  for (std::size_t lane = 0; lane < definitions_.size(); ++lane) {
    if (!common_[lane]) advance_alone(lane, increments);
  }
}

const LaneColumn& Pack::column(LaneNumber number, std::size_t entry) const noexcept {
  switch (number) {
    case LaneNumber::kForce:
      return lanes_.force[entry];
    case LaneNumber::kLimit:
      return lanes_.limit;
    case LaneNumber::kCoefficient:
      return lanes_.mu;
    case LaneNumber::kRegime:
      return lanes_.regime;
    case LaneNumber::kAccumulatedSlip:
      return lanes_.accumulated_slip;
    case LaneNumber::kDissipation:
      break;
  }
  return lanes_.dissipation;
}

double Pack::last(LaneNumber number, std::size_t entry, std::size_t lane) const noexcept {
  const double value = column(number, entry)[lane];
  return number == LaneNumber::kForce ? lanes_.scale[entry][lane] * value : value;
}

FrictionState Pack::state(std::size_t lane) const noexcept {
  if (!common_[lane]) return alone_[lane].state;
  FrictionState state;
  for (std::size_t k = 0; k < kLaneEntries; ++k) {
    state.force[k] = lanes_.force[k][lane];
    state.elastic_slip[k] = lanes_.elastic_slip[k][lane];
  }
  state.accumulated_slip = {lanes_.accumulated_slip[lane], lanes_.slip_left_out[lane]};
  state.regime = static_cast<Regime>(lanes_.regime[lane]);
  return state;
}

LaneSummary Pack::summary(std::size_t lane) const noexcept {
  if (!common_[lane]) return alone_[lane].summary;
  // The root of the largest square is the largest root: it is rounded monotonically.
  const bool square = form_->dimension == 2;
  return {.peak_force = square ? std::sqrt(lanes_.peak[lane]) : lanes_.peak[lane],
          .dissipation = {lanes_.dissipation[lane], lanes_.energy_left_out[lane]},
          .limit = lanes_.limit[lane],
          .slipping = static_cast<std::int64_t>(lanes_.slipping[lane]),
          .open = static_cast<std::int64_t>(lanes_.open[lane])};
}

}  // namespace slipbench::law
