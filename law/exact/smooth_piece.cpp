// SPDX-License-Identifier: Apache-2.0
#include "law/exact/smooth_piece.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::law {
namespace {

/// Part of a quantity's size that is rounding.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
/// A rate of the slip stands on a corner from this part of the corner's own rate on.
constexpr double kSlowSlack = 1e-3;

const TableFunction* table_of(const InternalContactForce& internal) {
  return std::get_if<TableFunction>(&internal);
}
const TableFunction* table_of(const FrictionLaw& law) {
  const auto* tabular = std::get_if<TabularCoefficient>(&law);
  return tabular != nullptr ? &tabular->table : nullptr;
}

/// An independent as a quantity of the segment: a spring's displacement is that of its component.
Independent of_component(Independent independent, int displacement) {
  if (displacement >= 0 && independent.kind == IndependentKind::kConstitutiveMotion) {
    independent.index = displacement;
  }
  return independent;
}

}  // namespace

/// Calls visit(table, displacement) for every table that the limit may come from; `displacement` is
/// the component that stands for the constitutive motion in a spring's, else -1.
template <class Visit>
void SmoothPiece::for_each_table(Visit visit) const noexcept {
  if (const auto* derived = std::get_if<DerivedComponent>(&definition_.contact_force)) {
    for (const DerivedTerm& term : *derived) {
      if (term.weight_table) visit(*term.weight_table, -1);
    }
  }
  if (const auto* table = table_of(definition_.internal_contact_force)) visit(*table, -1);
  if (const auto* table = table_of(definition_.law)) visit(*table, -1);
  if (segment_.kinetic == nullptr) return;
  for (int c = 0; c < kComponents; ++c) {
    const auto& spring = segment_.kinetic->elasticity[static_cast<std::size_t>(c)];
    if (!segment_.kinetic->pressing.contains(c) || !spring) continue;
    if (const TableFunction* table = spring->table()) visit(*table, c);
  }
}

SmoothPiece::SmoothPiece(const FrictionDefinition& definition, const PathSegment& segment,
                         SegmentPoints& points, double begin_slip, double most_slip,
                         double contact_size) noexcept
    : definition_(definition), segment_(segment), points_(points) {
  for_each_table([&](const TableFunction& table, int displacement) {
    for (const Independent& independent : table.independents()) {
      add(Kind::kArgument, of_component(independent, displacement));
    }
  });
  for (int c = 0; c < kComponents; ++c) add(Kind::kForce, {IndependentKind::kContactForce, c});
  if (const auto* derived = std::get_if<DerivedComponent>(&definition.contact_force)) {
    for (std::size_t t = 0; t < derived->size(); ++t) {
      const DerivedTerm& term = (*derived)[t];
      if (!term.weight_table || term.combine == TermOperator::kSum) continue;
      const int first = static_cast<int>(t) * kComponents;
      for (int j = 0; j < term.count; ++j) {
        add(Kind::kWeight, {IndependentKind::kContactForce, first + j});
      }
    }
  }
  if (std::holds_alternative<UniversalJointContact>(definition.contact_force)) {
    add(Kind::kPin);
  }
  add(Kind::kContact);
  if (definition.force_limit < kNoForceLimit) add(Kind::kUncapped);
  if (has_floor(definition.law) || table_of(definition.law) != nullptr) add(Kind::kCoefficient);
  if (table_of(definition.internal_contact_force) != nullptr) add(Kind::kInternal);

  // What its rounding is measured by, and whether it moves at all.
  const double largest_slip = begin_slip + most_slip;
  std::array<bool, kMost> moves{};
  Values first{};
  for (const double tau : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    for (const double slip : {double{0.0}, largest_slip}) {
      const Values here = values({tau, slip, 0.0, 1.0});
      if (tau == 0.0) first = here;
      for (std::size_t i = 0; i < count_; ++i) {
        moves[i] = moves[i] || here[i] != first[i];
        quantities_[i].size = std::max(quantities_[i].size, std::abs(here[i]));
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Quantity quantity = quantities_[i];
    bool fixed = quantity.kind == Kind::kForce || quantity.kind == Kind::kWeight;
    if (quantity.kind == Kind::kArgument) {
      const IndependentKind kind = quantity.independent.kind;
      const bool slides = kind == IndependentKind::kAccumulatedSlip;
      if (slides) quantity.size = largest_slip;
      if (kind == IndependentKind::kContactForce) quantity.size = contact_size;
      if (kind == IndependentKind::kSlipRate && segment.increment.duration > 0.0) {
        quantity.size = std::max(quantity.size, most_slip / segment.increment.duration);
      }
      fixed =
          !slides && kind != IndependentKind::kContactForce && kind != IndependentKind::kSlipRate;
    }
    if (quantity.kind == Kind::kContact) quantity.size = contact_size;
    if (quantity.kind == Kind::kUncapped) quantity.size = definition.force_limit;
    if (fixed && !moves[i]) continue;
    quantities_[kept++] = quantity;
  }
  count_ = kept;
}

void SmoothPiece::add(Kind kind, Independent independent) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (quantities_[i].kind == kind && quantities_[i].independent == independent) return;
  }
  if (count_ < kMost) quantities_[count_++] = {.kind = kind, .independent = independent};
}

double SmoothPiece::value(const Quantity& quantity, const LimitPoint& point,
                          const Limit& limit) noexcept {
  const ConnectorIncrement& at = points_.increment(point.tau);
  const SlipArguments slip{.slip_rate = limit.slip_rate,
                           .contact_force = limit.normal_force,
                           .accumulated_slip = point.accumulated_slip};
  switch (quantity.kind) {
    case Kind::kArgument:
      return argument(quantity.independent, at.end, slip);
    case Kind::kForce:
      return at.force[quantity.independent.index];
    case Kind::kWeight: {
      const auto i = static_cast<std::size_t>(quantity.independent.index);
      const DerivedTerm& term =
          (*std::get_if<DerivedComponent>(&definition_.contact_force))[i / kComponents];
      return term.weight_table->value(at.end, {}, static_cast<int>(i % kComponents));
    }
    case Kind::kPin:
      return pin_force(*std::get_if<UniversalJointContact>(&definition_.contact_force), at.force,
                       at.end.position);
    case Kind::kContact:
      return limit.contact_force;
    case Kind::kUncapped:
      return points_.uncapped(limit, point.tau, point.sense);
    case Kind::kCoefficient: {
      const TableFunction* table = table_of(definition_.law);
      return table != nullptr ? table->value(at.end, slip)
                              : raw_coefficient(definition_.law, at.end, slip);
    }
    case Kind::kInternal:
      break;
  }
  return table_of(definition_.internal_contact_force)->value(at.end, slip);
}

SmoothPiece::Values SmoothPiece::values(const LimitPoint& point) noexcept {
  Values values{};
  const Limit limit =
      points_.limit(point.tau, point.accumulated_slip, point.slip_rate, point.sense);
  for (std::size_t i = 0; i < count_; ++i) values[i] = value(quantities_[i], point, limit);
  return values;
}

template <class Visit>
void SmoothPiece::for_each_corner(const Quantity& quantity, double value,
                                  Visit visit) const noexcept {
  switch (quantity.kind) {
    case Kind::kArgument:
      for_each_table([&](const TableFunction& table, int displacement) {
        const auto independents = table.independents();
        for (std::size_t k = 0; k < independents.size(); ++k) {
          if (!(of_component(independents[k], displacement) == quantity.independent)) continue;
          const auto knots = table.table().knots(static_cast<int>(k));
          // Rounding may have put the value on the wrong side of one of them.
          const auto above = std::lower_bound(knots.begin(), knots.end(), value) - knots.begin();
          for (auto n = above - 2; n < above + 2; ++n) {
            if (n >= 0 && n < static_cast<std::ptrdiff_t>(knots.size())) {
              visit(knots[static_cast<std::size_t>(n)]);
            }
          }
        }
      });
      return;
    case Kind::kUncapped:
      return visit(definition_.force_limit);
    case Kind::kCoefficient:
      return visit(has_floor(definition_.law) ? kCoefficientFloor : 0.0);
    default:
      return visit(0.0);
  }
}

double SmoothPiece::slack(const Quantity& quantity, double corner, double rate_slack) noexcept {
  const double rounding = kRounding * quantity.size;
  const bool is_rate =
      quantity.kind == Kind::kArgument && quantity.independent.kind == IndependentKind::kSlipRate;
  if (!is_rate && quantity.kind != Kind::kUncapped && quantity.kind != Kind::kCoefficient) {
    return rounding;
  }
  const double most = rate_slack * quantity.size;
  // The slack of a fast slip would hide the corners of a slow one.
  return std::max(is_rate && corner > 0.0 ? std::min(most, kSlowSlack * corner) : most, rounding);
}

bool SmoothPiece::keeps(const Values& values, double rate_slack) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const Quantity& quantity = quantities_[i];
    if (values[i] < quantity.low - slack(quantity, quantity.low, rate_slack) ||
        values[i] > quantity.high + slack(quantity, quantity.high, rate_slack)) {
      return false;
    }
  }
  return true;
}

void SmoothPiece::enter(const Values& here, const Values& ahead, double rate_slack) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    Quantity& quantity = quantities_[i];
    quantity.low = -std::numeric_limits<double>::infinity();
    quantity.high = std::numeric_limits<double>::infinity();
    for_each_corner(quantity, here[i], [&](double corner) {
      const bool on_it = std::abs(here[i] - corner) <= slack(quantity, corner, rate_slack);
      const bool above = on_it && ahead[i] != corner ? ahead[i] > corner : here[i] >= corner;
      double& edge = above ? quantity.low : quantity.high;
      edge = above ? std::max(edge, corner) : std::min(edge, corner);
    });
  }
}

double SmoothPiece::reserve(std::size_t i, double value) const noexcept {
  const Quantity& quantity = quantities_[i];
  const double least = std::min(value - quantity.low, quantity.high - value);
  return quantity.size > 0.0 ? std::min(least / quantity.size + kRounding, 1.0) : 1.0;
}

double SmoothPiece::reserve(const Values& values) const noexcept {
  double least = 1.0;
  for (std::size_t i = 0; i < count_; ++i) least = std::min(least, reserve(i, values[i]));
  return least;
}

bool SmoothPiece::may_turn_beyond(std::size_t i, double before, double value,
                                  double after) const noexcept {
  const Quantity& quantity = quantities_[i];
  const bool up = value >= before && value > after;
  const bool down = value <= before && value < after;
  if (!up && !down) return false;
  // A parabola goes at most an eighth of its span beyond the sample; allow for the whole.
  const double beyond = std::max(std::abs(value - before), std::abs(value - after));
  return up ? value + beyond > quantity.high : value - beyond < quantity.low;
}

}  // namespace slipbench::law
