// SPDX-License-Identifier: Apache-2.0
// Exact derivatives of a friction history to the numbers of its definition.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/increment.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// d(number)/d(unknown) of one number of a definition.
struct NumberSlope {
  std::size_t number = 0;   ///< which one of its list
  std::size_t unknown = 0;  ///< column, from 0
  double slope = 0.0;
};

/// Slopes of the numbers of a definition to unknowns, by add_slopes; a number not listed has none.
struct DefinitionSlopes {
  std::size_t unknowns = 0;              ///< columns; may be set beforehand to more
  std::vector<NumberSlope> stick;        ///< of StickStiffness::value, number 0
  std::vector<NumberSlope> force_limit;  ///< number 0
  std::vector<NumberSlope> law;          ///< of its fields(), or of the rows of its table
  std::vector<NumberSlope> internal_contact_force;  ///< number 0, or the rows of its table
  /// Of the constant weights of a derived component: number kComponents * term + entry.
  std::vector<NumberSlope> contact_weights;
};

/// Differences between two definitions that differ in one unknown by `width`, added as column
/// `unknown` of `slopes`: (above - below)/width, exact but for rounding for numbers that follow
/// linearly from the unknown.
///
/// Covered: the stick stiffness or elastic slip, the numbers of the coefficient law, a constant or
/// tabulated internal contact force, the ordinates of a tabulated coefficient, the force limit, and
/// the constant weights of a derived component. Not covered is any other difference, and any
/// definition with a formulation, a change of friction in progress, or another criterion than the
/// Euclidean norm.
/// \param width above less below, in the unknown; not 0
/// \return false where the derivatives do not cover the difference; `slopes` is then unchanged
bool add_slopes(const FrictionDefinition& below, const FrictionDefinition& above, double width,
                std::size_t unknown, DefinitionSlopes* slopes);

/// Derivatives of the state of one definition to the unknowns, carried from increment to increment
/// beside law::update: forward sensitivities by the implicit function theorem, exact within a
/// regime and a cell of each table; at kinks they are one-sided, as the law's own slopes are
/// (docs/theory, section 17).
///
/// advance() allocates nothing and does not throw. Both arguments of the constructor must outlive
/// it; it starts at rest, where nothing depends on anything.
class StateSlopes {
 public:
  StateSlopes(const FrictionDefinition& definition, const DefinitionSlopes& slopes);

  /// Over one increment that `update` is the result of, from `old`.
  void advance(const ConnectorIncrement& increment, const FrictionState& old,
               const FrictionUpdate& update) noexcept;

  /// dy_entry/d(unknown) of all unknowns, y the force in the slip space [F].
  std::span<const double> force(int entry) const noexcept {
    const auto row = static_cast<std::size_t>(entry);
    return {(fixed_ ? carried_ : force_).data() + row * stride_, unknowns_};
  }
  /// d(accumulated slip)/d(unknown) of all unknowns [L].
  std::span<const double> accumulated_slip() const noexcept { return {slip_.data(), unknowns_}; }

 private:
  /// The slopes of the rows of a table, those of one row side by side.
  struct RowSlopes {
    struct Entry {
      std::size_t unknown = 0;
      double slope = 0.0;
    };
    std::vector<std::uint32_t> first;  ///< entries of row r: first[r] .. first[r+1]-1
    std::vector<Entry> entries;

    RowSlopes() = default;
    RowSlopes(const std::vector<NumberSlope>& slopes, std::size_t rows);
    bool empty() const { return entries.empty(); }
    /// Adds weight * slope of a row to `sum`.
    void add(std::size_t row, double weight, double* sum) const noexcept {
      for (std::uint32_t i = first[row]; i < first[row + 1]; ++i) {
        sum[entries[i].unknown] += weight * entries[i].slope;
      }
    }
  };

  template <int D>
  void advance_in(const ConnectorIncrement& increment, const FrictionState& old,
                  const FrictionUpdate& update) noexcept;
  /// Sets limit_ to dF_lim/d(unknown) at fixed slip of this increment, times `gain`.
  /// \param to_contact gain dF_lim/d(F_C + F_int)
  void take_limit(const ConnectorIncrement& increment, const FrictionState& old,
                  const FrictionUpdate& update, double gain, double to_contact) noexcept;
  /// Adds weight d(F_C + F_int)/d(unknown) at an accumulated slip, its own change left out.
  void add_contact(const ConnectorIncrement& increment, double accumulated_slip,
                   double weight) noexcept;
  void lose_grip(const ConnectorIncrement& increment, const FrictionState& old,
                 const FrictionUpdate& update) noexcept;

  const FrictionDefinition* definition_;
  const DefinitionSlopes* slopes_;
  bool fixed_;          ///< the stick stiffness is constant: the state is the force
  bool is_table_;       ///< the coefficient is a table
  RowSlopes law_;       ///< of a table
  RowSlopes internal_;  ///< of a table
  std::size_t unknowns_;
  std::size_t stride_;           ///< of the rows below: `unknowns_` rounded up to whole blocks
  std::vector<double> carried_;  ///< of the force or the elastic slip, one row an entry
  std::vector<double> force_;    ///< beside it where the elastic slip is carried
  std::vector<double> slip_;     ///< of the accumulated slip
  std::vector<double> limit_;    ///< of the limit in the current increment
};

}  // namespace slipbench::law
