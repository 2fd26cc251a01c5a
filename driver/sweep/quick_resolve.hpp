// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/base/units/expression.hpp"
#include "driver/sweep/sweep.hpp"
#include "law/definition/friction_definition.hpp"

namespace slipbench::driver::sweep {

/// Numbers of this magnitude and more are left to the reader and the scalar run.
inline constexpr double kTame = 1e30;

/// A constant force of one step that depends on the varied parameters.
struct VariedForce {
  std::size_t step = 0;  ///< in Case::steps
  int component = 0;     ///< index 0..5
};

/// Numbers of a case with one friction definition that depend on the varied parameters, computed
/// without its text. Known are numbers that the reader takes over as they are:
///   - coefficient, a constant or the ordinates of a table,
///   - internal contact force, a constant or the ordinates of a table,
///   - stick stiffness, or elastic slip,
///   - force limit,
///   - constant forces of steps.
/// They go through the expressions of the reader, so that they have its bits. What is read is
/// written down by the reader itself: where a parameter is used elsewhere, there is no quick way.
class QuickResolve {
 public:
  /// Returns nothing where something else depends on the varied parameters.
  static std::optional<QuickResolve> make(const Sweep& sweep);

  const std::vector<VariedForce>& forces() const { return forces_; }

  /// Writes the numbers of a sample into the definition of the base case, or of another sample.
  /// \param values of the varied parameters
  /// \param forces as many as forces()
  /// \return false where a number may not be admissible: only the reader can say so
  bool resolve(std::span<const double> values, law::FrictionDefinition& definition,
               std::span<double> forces);

 private:
  /// A number as a function of the varied parameters and of those that depend on them.
  struct Number {
    std::optional<std::size_t> name;  ///< of the names, where it is nothing but that
    std::optional<base::Expression> expression;
  };
  enum class Place : std::uint8_t {
    kCoefficient,
    kCoefficientRow,
    kInternalForce,
    kInternalForceRow,
    kStickStiffness,
    kElasticSlip,
    kForceLimit,
    kForce
  };
  struct Target {
    Place place = Place::kCoefficient;
    std::size_t index = 0;  ///< row of a table, or force
    Number number = {};
  };

  class Slot;

  bool name_dependents(const Sweep& sweep);
  bool is_independent(const std::string& text, const base::NamedNumbers& fixed) const;
  std::optional<Number> number_of(const std::string& text, const base::NamedNumbers& fixed) const;
  /// Finds the place of a path in the case, and adds the force that it may be.
  std::optional<Target> target_at(const std::string& path, const cases::Case& base);
  static bool is_admissible(Place place, double value);
  std::optional<double> value_of(const Number& number) const;
  bool take_names(std::span<const double> values);

  std::vector<std::string> names_;  ///< the varied parameters, then those that depend on them
  std::vector<Number> dependents_;  ///< in the order of their names
  std::vector<double> numbers_;     ///< of the names, for one sample
  std::vector<VariedForce> forces_;
  std::vector<Target> targets_;
};

}  // namespace slipbench::driver::sweep
