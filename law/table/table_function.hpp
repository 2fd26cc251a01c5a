// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "law/base/component.hpp"
#include "law/table/table.hpp"

namespace slipbench::law {

/// Meaning of a column of independents in a table.
enum class IndependentKind : std::uint8_t {
  kSlipRate,           ///< equivalent slip rate [L/T]
  kContactForce,       ///< F_N [F]
  kAccumulatedSlip,    ///< of this definition [L]
  kTemperature,        ///< [Θ]
  kField,              ///< field variable `index`
  kPosition,           ///< CP of component `index`
  kConstitutiveMotion  ///< CCU of component `index`
};

struct Independent {
  IndependentKind kind = IndependentKind::kSlipRate;
  int index = 0;  ///< component 0..5 or field 0..; unused otherwise
  friend constexpr bool operator==(const Independent&, const Independent&) = default;
};

/// State of the connector: everything a table may depend on besides the slip itself.
struct Ambient {
  RelativePosition position;            ///< CP at the end of the increment
  ConstitutiveMotion motion;            ///< CCU at the end of the increment
  double temperature = 0.0;             ///< [Θ]
  std::span<const double> fields = {};  ///< as many as the tables name
};

/// The slip quantities a table may depend on.
struct SlipArguments {
  double slip_rate = 0.0;         ///< [L/T]
  double contact_force = 0.0;     ///< F_N [F]
  double accumulated_slip = 0.0;  ///< [L]
};

/// Returns what a motion or a field is at a place, in its own unit.
inline double place_argument(const Independent& independent, const Ambient& ambient) noexcept {
  if (independent.kind == IndependentKind::kField) {
    return ambient.fields[static_cast<std::size_t>(independent.index)];
  }
  return independent.kind == IndependentKind::kPosition ? ambient.position[independent.index]
                                                        : ambient.motion[independent.index];
}

/// Returns what an independent is at a place and a slip, in its own unit.
inline double argument(const Independent& independent, const Ambient& ambient,
                       const SlipArguments& slip) noexcept {
  // Few cases are compared; more would be a jump by way of a table.
  switch (independent.kind) {
    case IndependentKind::kSlipRate:
      return slip.slip_rate;
    case IndependentKind::kContactForce:
      return slip.contact_force;
    case IndependentKind::kAccumulatedSlip:
      return slip.accumulated_slip;
    case IndependentKind::kTemperature:
      return ambient.temperature;
    default:
      return place_argument(independent, ambient);
  }
}

/// A table whose independents are connector quantities.
class TableFunction {
 public:
  TableFunction() = default;
  TableFunction(Table table, std::vector<Independent> independents);

  const Table& table() const { return table_; }
  Table& table() { return table_; }
  std::span<const Independent> independents() const { return independents_; }
  /// Position of an independent among the columns, -1 if the table does not depend on it.
  int column_of(IndependentKind kind) const;
  bool depends_on_motion() const { return depends_on_motion_; }

  double value(const Ambient& ambient, const SlipArguments& slip, int column = 0) const noexcept {
    Arguments x;
    return table_.value(gather(ambient, slip, &x), column);
  }

  /// Value with the slopes to slip rate, contact force and accumulated slip in `slopes`.
  double value_and_slopes(const Ambient& ambient, const SlipArguments& slip, SlipArguments* slopes,
                          int column = 0) const noexcept;

  /// Adds `weight` times the slope to the position of every component to `gradient`. CP and CCU
  /// differ by a constant, so both count.
  void add_motion_slopes(const Ambient& ambient, const SlipArguments& slip, double weight,
                         RelativePosition* gradient, int column = 0) const noexcept;

  /// Calls visit(row, weight) for every row that has a part in the value: Table::for_each_weight.
  template <class Visit>
  void for_each_weight(const Ambient& ambient, const SlipArguments& slip, Visit visit) const {
    Arguments x;
    table_.for_each_weight(gather(ambient, slip, &x), visit);
  }

  /// Returns what the table is asked for: as many numbers as it has independents, in their order.
  std::array<double, kMaxIndependents> arguments(const Ambient& ambient,
                                                 const SlipArguments& slip) const noexcept;
  /// The cell a value is taken from.
  TableCell cell(const Ambient& ambient, const SlipArguments& slip) const noexcept;

  /// Tells whether an argument lies outside the table.
  bool outside(const Ambient& ambient, const SlipArguments& slip) const noexcept;

 private:
  using Arguments = std::array<double, kMaxIndependents>;
  std::span<const double> gather(const Ambient& ambient, const SlipArguments& slip,
                                 Arguments* x) const noexcept {
    for (std::size_t k = 0; k < independents_.size(); ++k) {
      (*x)[k] = argument(independents_[k], ambient, slip);
    }
    return {x->data(), independents_.size()};
  }

  Table table_;
  std::vector<Independent> independents_;
  bool depends_on_motion_ = false;
};

}  // namespace slipbench::law
