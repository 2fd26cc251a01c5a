// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "law/table/table_function.hpp"

namespace slipbench::law {

/// A force along a component and its slope to the motion or velocity it follows: [F] and [F/L] or
/// [F T/L]; of a rotation [F L] and [F L] or [F L T].
struct ForcePoint {
  double force = 0.0;
  double slope = 0.0;
};

/// Connector elasticity of one component, in parallel with its friction: CEF = k u, or a table of
/// the force over the displacement u (CCU, of a belt its strain), temperature and fields
/// (docs/theory, sections 9.1 and 13.4).
///
/// In a table the independent kConstitutiveMotion stands for u whatever its index: the value is
/// asked for at a displacement, not at a position of the connector.
class Elasticity {
 public:
  Elasticity() = default;
  /// \param stiffness k [F/L], [F L] for a rotation
  explicit Elasticity(double stiffness) : force_(stiffness) {}
  /// \param force one dependent [F], [F L]
  explicit Elasticity(TableFunction force) : force_(std::move(force)) {
    const TableFunction& table = *std::get_if<TableFunction>(&force_);
    if (table.independents().size() != 1 || table.column_of(kDisplacement) < 0) return;
    const std::span<const double> knots = table.table().knots(0);
    energies_.resize(knots.size());
    const std::size_t zero = first_from_zero(knots);
    const Ambient nowhere;  // such a table does not see it
    Path up(table, nowhere);
    for (std::size_t i = zero; i < knots.size(); ++i) energies_[i] = up.go_to(knots[i]);
    Path down(table, nowhere);
    for (std::size_t i = zero; i-- > 0;) energies_[i] = down.go_to(knots[i]);
  }

  /// CEF and its slope dCEF/du at a displacement [L], [1]. Of `ambient` only temperature and fields
  /// count. At a knot of the table the slope is the right-hand one.
  ForcePoint value(double displacement, const Ambient& ambient) const noexcept {
    if (const double* stiffness = std::get_if<double>(&force_)) {
      return {*stiffness * displacement, *stiffness};
    }
    const TableFunction& table = *std::get_if<TableFunction>(&force_);
    const Ambient here = at(displacement, ambient);
    RelativePosition slopes;
    table.add_motion_slopes(here, {}, 1.0, &slopes);
    double slope = 0.0;
    for (const double s : slopes.values) slope += s;
    return {table.value(here, {}), slope};
  }

  /// The energy it holds, the integral of CEF from 0 to the displacement at the present temperature
  /// and fields [F L]; exact for a table, whose force is linear between its knots.
  double energy(double displacement, const Ambient& ambient) const noexcept {
    if (const double* stiffness = std::get_if<double>(&force_)) {
      return 0.5 * *stiffness * displacement * displacement;
    }
    const TableFunction& table = *std::get_if<TableFunction>(&force_);
    Path path(table, ambient);
    // The knots on the way, in either sense; where their energies are known, the last one alone.
    if (const int column = table.column_of(kDisplacement); column >= 0) {
      const std::span<const double> knots = table.table().knots(column);
      const std::size_t zero = first_from_zero(knots);
      const auto index = [&](auto knot) { return static_cast<std::size_t>(knot - knots.begin()); };
      if (displacement > 0.0) {
        const auto past = index(std::lower_bound(knots.begin(), knots.end(), displacement));
        if (!energies_.empty() && past > zero) path.begin_at(knots[past - 1], energies_[past - 1]);
        for (std::size_t i = zero; energies_.empty() && i < past; ++i) path.go_to(knots[i]);
      } else {
        const auto last = index(std::upper_bound(knots.begin(), knots.end(), displacement));
        if (!energies_.empty() && last < zero) path.begin_at(knots[last], energies_[last]);
        for (std::size_t i = zero; energies_.empty() && i-- > last;) path.go_to(knots[i]);
      }
    }
    return path.go_to(displacement);
  }

  /// The table; null for a linear spring.
  const TableFunction* table() const { return std::get_if<TableFunction>(&force_); }

 private:
  static constexpr IndependentKind kDisplacement = IndependentKind::kConstitutiveMotion;

  /// A way from displacement 0 on, from knot to knot, and the energy along it.
  class Path {
   public:
    Path(const TableFunction& table, const Ambient& ambient)
        : table_(table), ambient_(ambient), force_(force_at(0.0)) {}
    /// Puts the way behind a knot whose energy is known.
    void begin_at(double knot, double energy) {
      displacement_ = knot;
      energy_ = energy;
      force_ = force_at(knot);
    }
    /// Returns the energy at a displacement without a knot between it and the last one.
    double go_to(double displacement) {
      const double force = force_at(displacement);
      energy_ += 0.5 * (force_ + force) * (displacement - displacement_);
      displacement_ = displacement;
      force_ = force;
      return energy_;
    }

   private:
    double force_at(double displacement) const {
      return table_.value(at(displacement, ambient_), {});
    }
    const TableFunction& table_;
    const Ambient& ambient_;
    double displacement_ = 0.0;
    double energy_ = 0.0;
    double force_;
  };

  static std::size_t first_from_zero(std::span<const double> knots) {
    return static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), 0.0) -
                                    knots.begin());
  }
  static Ambient at(double displacement, const Ambient& ambient) {
    Ambient here = ambient;
    here.motion.values.fill(displacement);
    return here;
  }

  std::variant<double, TableFunction> force_ = 0.0;
  std::vector<double> energies_;  ///< at the knots of a table over the displacement alone
};

}  // namespace slipbench::law
