// SPDX-License-Identifier: Apache-2.0
#include "law/sensitivity/sensitivity.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"
#include "law/definition/motion.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::law {
namespace {

// --- How two definitions differ -------------------------------------------------------------

/// Collects the differences of one list of numbers.
struct Differences {
  double width;
  std::size_t unknown;
  std::vector<NumberSlope> found{};

  void take(std::size_t number, double below, double above) {
    if (below == above) return;
    found.push_back({number, unknown, (above - below) / width});
  }
};

bool same_function(const TableFunction& a, const TableFunction& b) {
  return std::equal(a.independents().begin(), a.independents().end(), b.independents().begin(),
                    b.independents().end()) &&
         a.table().same_grid(b.table());
}

/// \return false if more than the ordinates differ
bool compare(const TableFunction& below, const TableFunction& above, Differences* rows) {
  if (!same_function(below, above)) return false;
  for (std::size_t r = 0; r < below.table().rows(); ++r) {
    rows->take(r, below.table().ordinate(r), above.table().ordinate(r));
  }
  return true;
}

bool same_ordinates(const Table& a, const Table& b) {
  for (std::size_t r = 0; r < a.rows(); ++r) {
    for (int c = 0; c < a.dependents(); ++c) {
      if (a.ordinate(r, c) != b.ordinate(r, c)) return false;
    }
  }
  return true;
}

bool same_value(const UnitName& a, const UnitName& b) { return a.name() == b.name(); }
template <class T>
bool same_value(const T& a, const T& b) {
  return a == b;
}

/// The numbers of a law are its fields, in their order.
/// \return false if something that is no number differs
template <class Law>
bool compare(const Law& below, const Law& above, Differences* numbers) {
  bool covered = true;
  std::size_t index = 0;
  const auto one = [&](const auto& field) {
    const auto& a = below.*(field.member);
    const auto& b = above.*(field.member);
    using Member = std::remove_cvref_t<decltype(a)>;
    if constexpr (std::is_same_v<Member, double>) {
      numbers->take(index, a, b);
    } else if constexpr (std::is_same_v<Member, std::optional<double>>) {
      if (a && b) {
        numbers->take(index, *a, *b);
      } else {
        covered = covered && a == b;
      }
    } else {
      covered = covered && same_value(a, b);
    }
    ++index;
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, Law::fields());
  if constexpr (requires { below.speed_factor; }) {
    covered = covered && below.speed_factor == above.speed_factor;
  }
  return covered;
}
bool compare(const TabularCoefficient& below, const TabularCoefficient& above, Differences* rows) {
  return compare(below.table, above.table, rows);
}

bool compare(const FrictionLaw& below, const FrictionLaw& above, Differences* numbers) {
  return visit_law(
      [&]<class Law>(const Law& a) {
        const Law* b = get_law_if<Law>(above);
        return b != nullptr && compare(a, *b, numbers);
      },
      below);
}

bool compare(const InternalContactForce& below, const InternalContactForce& above,
             Differences* numbers) {
  if (below.index() != above.index()) return false;
  if (const double* number = std::get_if<double>(&below)) {
    numbers->take(0, *number, *std::get_if<double>(&above));
    return true;
  }
  return compare(*std::get_if<TableFunction>(&below), *std::get_if<TableFunction>(&above), numbers);
}

bool compare(const DerivedComponent& below, const DerivedComponent& above, Differences* weights) {
  if (below.size() != above.size()) return false;
  for (std::size_t t = 0; t < below.size(); ++t) {
    const DerivedTerm& a = below[t];
    const DerivedTerm& b = above[t];
    if (a.combine != b.combine || a.sign != b.sign || a.count != b.count ||
        a.component != b.component || a.weight_table.has_value() != b.weight_table.has_value()) {
      return false;
    }
    if (a.weight_table) {
      if (!same_function(*a.weight_table, *b.weight_table) ||
          !same_ordinates(a.weight_table->table(), b.weight_table->table())) {
        return false;
      }
      continue;
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(a.count); ++j) {
      weights->take(t * kComponents + j, a.weight[j], b.weight[j]);
    }
  }
  return true;
}

bool same(const UniversalJointContact& a, const UniversalJointContact& b) {
  const auto tie = [](const UniversalJointContact& c) {
    return std::tie(c.axis, c.R_p, c.R_a, c.L_s, c.L_a, c.shares.k_ax, c.shares.t_ax, c.shares.k_tw,
                    c.shares.t_tw);
  };
  return tie(a) == tie(b);
}

bool compare(const ContactForce& below, const ContactForce& above, Differences* weights) {
  if (below.index() != above.index()) return false;
  if (const auto* component = std::get_if<ComponentContactForce>(&below)) {
    return component->component == std::get_if<ComponentContactForce>(&above)->component;
  }
  if (const auto* derived = std::get_if<DerivedComponent>(&below)) {
    return compare(*derived, *std::get_if<DerivedComponent>(&above), weights);
  }
  if (const auto* joint = std::get_if<UniversalJointContact>(&below)) {
    return same(*joint, *std::get_if<UniversalJointContact>(&above));
  }
  return true;
}

bool is_covered(const FrictionDefinition& definition) {
  return !definition.formulation && definition.blend.weight == 1.0 &&
         std::holds_alternative<EuclideanPotential>(definition.criterion);
}

bool same_setting(const FrictionDefinition& a, const FrictionDefinition& b) {
  const auto count = static_cast<std::size_t>(a.slip.dimension);
  return a.slip.dimension == b.slip.dimension &&
         std::equal(a.slip.component.begin(), a.slip.component.begin() + count,
                    b.slip.component.begin()) &&
         std::equal(a.slip.scale.begin(), a.slip.scale.begin() + count, b.slip.scale.begin()) &&
         a.stick.mode == b.stick.mode && a.accumulated_slip == b.accumulated_slip &&
         a.slip_rate == b.slip_rate;
}

void append(const Differences& from, std::vector<NumberSlope>* to) {
  to->insert(to->end(), from.found.begin(), from.found.end());
}

}  // namespace

bool add_slopes(const FrictionDefinition& below, const FrictionDefinition& above, double width,
                std::size_t unknown, DefinitionSlopes* slopes) {
  if (!is_covered(below) || !is_covered(above) || !same_setting(below, above)) return false;
  const Differences none{width, unknown};
  Differences stick = none, force_limit = none, law = none, internal = none, weights = none;
  stick.take(0, below.stick.value, above.stick.value);
  force_limit.take(0, below.force_limit, above.force_limit);
  // A limit that comes or goes is no number that changes.
  if (!force_limit.found.empty() && !std::isfinite(force_limit.found[0].slope)) return false;
  if (!compare(below.law, above.law, &law) ||
      !compare(below.internal_contact_force, above.internal_contact_force, &internal) ||
      !compare(below.contact_force, above.contact_force, &weights)) {
    return false;
  }
  slopes->unknowns = std::max(slopes->unknowns, unknown + 1);
  append(stick, &slopes->stick);
  append(force_limit, &slopes->force_limit);
  append(law, &slopes->law);
  append(internal, &slopes->internal_contact_force);
  append(weights, &slopes->contact_weights);
  return true;
}

namespace {

// --- The history ----------------------------------------------------------------------------

/// Unknowns are worked on in blocks of so many.
constexpr std::size_t kLanes = 4;
using Lanes = Eigen::Array<double, kLanes, 1>;

Lanes at(const double* row) { return Lanes::Map(row); }
void put(const Lanes& lanes, double* row) { Lanes::Map(row) = lanes; }

/// dg/d(weight) of one constant weight; at a corner the one-sided slope taken is 0.
double weight_slope(const DerivedComponent& component, std::size_t number,
                    const ConnectorForce& force) noexcept {
  const DerivedTerm& term = component[number / kComponents];
  const std::size_t entry = number % kComponents;
  const double f = force[term.component[entry]];
  switch (term.combine) {
    case TermOperator::kNorm: {
      double square = 0.0;
      for (std::size_t j = 0; j < static_cast<std::size_t>(term.count); ++j) {
        const double x = term.weight[j] * force[term.component[j]];
        square += x * x;
      }
      return square > 0.0 ? term.sign * term.weight[entry] * f * f / std::sqrt(square) : 0.0;
    }
    case TermOperator::kSum:
      return term.sign * f;
    case TermOperator::kMacauleySum:
      return term.weight[entry] * f > 0.0 ? term.sign * f : 0.0;
  }
  return 0.0;
}

const TableFunction* table_of(const InternalContactForce& internal) {
  return std::get_if<TableFunction>(&internal);
}

}  // namespace

StateSlopes::RowSlopes::RowSlopes(const std::vector<NumberSlope>& slopes, std::size_t rows)
    : first(rows + 1, 0) {
  for (std::size_t r = 0; r < rows; ++r) {
    for (const NumberSlope& slope : slopes) {
      if (slope.number == r) entries.push_back({slope.unknown, slope.slope});
    }
    first[r + 1] = static_cast<std::uint32_t>(entries.size());
  }
}

StateSlopes::StateSlopes(const FrictionDefinition& definition, const DefinitionSlopes& slopes)
    : definition_(&definition),
      slopes_(&slopes),
      fixed_(definition.stick.mode == StickStiffness::Mode::kStiffness),
      is_table_(std::holds_alternative<TabularCoefficient>(definition.law)),
      unknowns_(slopes.unknowns),
      stride_((slopes.unknowns + kLanes - 1) / kLanes * kLanes) {
  if (const auto* law = std::get_if<TabularCoefficient>(&definition.law)) {
    law_ = RowSlopes(slopes.law, law->table.table().rows());
  }
  if (const TableFunction* internal = table_of(definition.internal_contact_force)) {
    internal_ = RowSlopes(slopes.internal_contact_force, internal->table().rows());
  }
  const auto entries = static_cast<std::size_t>(definition.slip.dimension);
  carried_.assign(entries * stride_, 0.0);
  if (!fixed_) force_.assign(entries * stride_, 0.0);
  slip_.assign(stride_, 0.0);
  limit_.assign(stride_, 0.0);
}

void StateSlopes::add_contact(const ConnectorIncrement& increment, double accumulated_slip,
                              double weight) noexcept {
  for (const NumberSlope& s : slopes_->contact_weights) {
    limit_[s.unknown] += weight * s.slope *
                         weight_slope(*std::get_if<DerivedComponent>(&definition_->contact_force),
                                      s.number, increment.force);
  }
  if (const TableFunction* table = table_of(definition_->internal_contact_force)) {
    if (internal_.empty()) return;
    const SlipArguments slip{.accumulated_slip = accumulated_slip};
    // A prolonged table that has fallen below 0 does not follow its ordinates.
    if (table->table().extrapolation() == Extrapolation::kLinear &&
        table->value(increment.end, slip) < 0.0) {
      return;
    }
    table->for_each_weight(increment.end, slip, [&](std::size_t row, double share) {
      internal_.add(row, weight * share, limit_.data());
    });
    return;
  }
  for (const NumberSlope& s : slopes_->internal_contact_force) {
    limit_[s.unknown] += weight * s.slope;
  }
}

void StateSlopes::take_limit(const ConnectorIncrement& increment, const FrictionState& old,
                             const FrictionUpdate& update, double gain,
                             double to_contact) noexcept {
  double* const limit = limit_.data();
  std::fill_n(limit, stride_, 0.0);
  if (update.limit == definition_->force_limit) {
    // The cap is a plateau: nothing else matters.
    for (const NumberSlope& s : slopes_->force_limit) limit[s.unknown] += gain * s.slope;
    return;
  }
  const SlipArguments slip{.slip_rate = update.slip_rate, .contact_force = update.normal_force};
  const double to_mu = gain * update.normal_force;
  if (is_table_) {
    const TableFunction& table = std::get_if<TabularCoefficient>(&definition_->law)->table;
    // A prolonged table that has fallen below 0 does not follow its ordinates.
    if (!law_.empty() && (update.mu > 0.0 || table.value(increment.end, slip) >= 0.0)) {
      table.for_each_weight(increment.end, slip, [&](std::size_t row, double weight) {
        law_.add(row, to_mu * weight, limit);
      });
    }
  } else if (!slopes_->law.empty()) {
    const auto add = [&]<class Law>(const Law& law) {
      if constexpr (!std::is_same_v<Law, TabularCoefficient>) {
        const auto slopes = to_numbers(law, increment.end, slip);
        for (const NumberSlope& s : slopes_->law) {
          limit[s.unknown] += to_mu * slopes[s.number] * s.slope;
        }
      }
    };
    visit_law(add, definition_->law);
  }
  if (to_contact == 0.0) return;
  const bool at_end = definition_->accumulated_slip == AccumulatedSlipTiming::kEnd;
  const double accumulated = old.accumulated_slip + (at_end ? update.slip_increment : 0.0);
  if (const double to_slip = to_contact * update.wear; to_slip != 0.0) {
    for (std::size_t j = 0; j < stride_; j += kLanes) {
      put(at(limit + j) + to_slip * at(slip_.data() + j), limit + j);
    }
  }
  add_contact(increment, accumulated, to_contact);
}

/// The force is 0. A grip that is lost in slip was lost where the limit came to 0, and how far the
/// slip has grown there follows from the limit.
void StateSlopes::lose_grip(const ConnectorIncrement& increment, const FrictionState& old,
                            const FrictionUpdate& update) noexcept {
  std::fill(carried_.begin(), carried_.end(), 0.0);
  std::fill(force_.begin(), force_.end(), 0.0);
  if (!(update.slip_increment > 0.0)) return;
  const SlipVector ds = motion_in(definition_->slip, increment);
  const LimitFunction limit(*definition_, increment, old, std::sqrt(dot(ds, ds)));
  // Just before that place: behind it the limit has another slope.
  const double before = 1e-9 * update.slip_increment;
  FrictionUpdate there;
  there.slip_increment = update.slip_increment - before;
  const Limit last = limit(there.slip_increment);
  const double slope = limit.slope(last);
  if (!(last.force <= -10.0 * before * slope)) return;
  there.slip_rate = last.slip_rate;
  there.normal_force = last.normal_force;
  there.mu = last.mu;
  there.wear = last.wear;
  there.limit = last.force;
  take_limit(increment, old, there, 1.0, last.to_contact);
  for (std::size_t j = 0; j < unknowns_; ++j) slip_[j] -= limit_[j] / slope;
}

template <int D>
void StateSlopes::advance_in(const ConnectorIncrement& increment, const FrictionState& old,
                             const FrictionUpdate& update) noexcept {
  constexpr auto kD = static_cast<std::size_t>(D);
  const SlipTangent& t = update.tangent;
  const bool slips = update.state.regime == Regime::kSlip;
  const double stick = definition_->stick.value;
  const double slip_increment = update.slip_increment;
  double* const carried = carried_.data();
  double* const slip = slip_.data();
  const double* const limit = limit_.data();
  const std::size_t stride = stride_;
  std::array<double, kD> n{};
  std::copy_n(update.direction.begin(), kD, n.begin());

  if (fixed_) {
    for (const NumberSlope& s : slopes_->stick) {
      for (std::size_t i = 0; i < kD; ++i) {
        carried[i * stride + s.unknown] += s.slope * motion_along(definition_->slip, increment, i);
      }
    }
    if (!slips) return;
    const double radial = t.radial / stick;
    take_limit(increment, old, update, 1.0 - radial, t.contact);
    for (const NumberSlope& s : slopes_->stick) {
      limit_[s.unknown] -= radial * slip_increment * s.slope;
    }
    const double transverse = t.transverse / stick;
    const double compliance = 1.0 / stick;
    for (std::size_t j = 0; j < stride; j += kLanes) {
      std::array<Lanes, kD> y;
      Lanes trial = Lanes::Zero();
      for (std::size_t i = 0; i < kD; ++i) {
        y[i] = at(carried + i * stride + j);
        trial += n[i] * y[i];
      }
      const Lanes force = at(limit + j) + radial * trial;
      const Lanes across = force - transverse * trial;
      for (std::size_t i = 0; i < kD; ++i) {
        put(n[i] * across + transverse * y[i], carried + i * stride + j);
      }
      put(at(slip + j) + compliance * (trial - force), slip + j);
    }
    for (const NumberSlope& s : slopes_->stick) {
      slip_[s.unknown] -= compliance * slip_increment * s.slope;
    }
    return;
  }

  double* const force = force_.data();
  const double secant = update.limit / stick;  // y = (F_lim/g_c) s_el
  if (!slips) {
    std::array<double, kD> share{};
    double square = 0.0;
    for (std::size_t i = 0; i < kD; ++i) {
      share[i] = update.state.elastic_slip[i] / stick;
      square += share[i] * share[i];
    }
    // The tangent has the part |y|/F_lim of the limit's slope.
    take_limit(increment, old, update, 1.0, square > 0.0 ? t.contact / std::sqrt(square) : 0.0);
    for (std::size_t j = 0; j < stride; j += kLanes) {
      const Lanes by_limit = at(limit + j);
      for (std::size_t i = 0; i < kD; ++i) {
        put(share[i] * by_limit + secant * at(carried + i * stride + j), force + i * stride + j);
      }
    }
    for (const NumberSlope& s : slopes_->stick) {
      for (std::size_t i = 0; i < kD; ++i) {
        force[i * stride + s.unknown] -= update.state.force[i] / stick * s.slope;
      }
    }
    return;
  }

  take_limit(increment, old, update, 1.0, t.contact);
  for (const NumberSlope& s : slopes_->stick) limit_[s.unknown] -= t.radial * s.slope;
  const double kept = stick / (stick + slip_increment);
  for (std::size_t j = 0; j < stride; j += kLanes) {
    std::array<Lanes, kD> s_trial;
    Lanes trial = Lanes::Zero();
    for (std::size_t i = 0; i < kD; ++i) {
      s_trial[i] = at(carried + i * stride + j);
      trial += n[i] * s_trial[i];
    }
    const Lanes by_limit = at(limit + j) + t.radial * trial;
    for (std::size_t i = 0; i < kD; ++i) {
      const Lanes turned = kept * (s_trial[i] - n[i] * trial);
      put(turned, carried + i * stride + j);
      put(n[i] * by_limit + secant * turned, force + i * stride + j);
    }
    put(at(slip + j) + trial, slip + j);
  }
  for (const NumberSlope& s : slopes_->stick) {
    for (std::size_t i = 0; i < kD; ++i) carried[i * stride + s.unknown] += n[i] * s.slope;
    slip_[s.unknown] -= s.slope;
  }
}

void StateSlopes::advance(const ConnectorIncrement& increment, const FrictionState& old,
                          const FrictionUpdate& update) noexcept {
  if (update.state.regime == Regime::kOpen) {
    lose_grip(increment, old, update);
    return;
  }
  in_dimension(definition_->slip.dimension, [&](auto d) { advance_in<d>(increment, old, update); });
}

}  // namespace slipbench::law
