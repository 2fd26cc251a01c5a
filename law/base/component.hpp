// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "law/base/notation.hpp"

namespace slipbench::law {

/// Six numbers, one a connector component (index 0..5 for components 1..6), of one quantity.
/// The tag keeps positions, constitutive motions and forces apart: mixing them does not compile.
template <class Tag>
struct ComponentVector {
  std::array<double, kComponents> values{};

  constexpr double& operator[](int component) {
    return values[static_cast<std::size_t>(component)];
  }
  constexpr double operator[](int component) const {
    return values[static_cast<std::size_t>(component)];
  }
  friend constexpr bool operator==(const ComponentVector&, const ComponentVector&) = default;
};

using RelativePosition = ComponentVector<struct RelativePositionTag>;      ///< CP: [L], [1]
using ConstitutiveMotion = ComponentVector<struct ConstitutiveMotionTag>;  ///< CCU: [L], [1]
using ConnectorForce = ComponentVector<struct ConnectorForceTag>;          ///< f: [F], [F L]

/// CCU = CP - reference, component by component.
constexpr ConstitutiveMotion constitutive_motion(const RelativePosition& position,
                                                 const RelativePosition& reference) {
  ConstitutiveMotion motion;
  for (int c = 0; c < kComponents; ++c) motion[c] = position[c] - reference[c];
  return motion;
}

/// A set of connector components, written with the users' numbers 1..6.
class ComponentSet {
 public:
  constexpr ComponentSet() = default;
  template <class... Number>
  static constexpr ComponentSet of(Number... number) {
    ComponentSet set;
    (set.insert(static_cast<int>(number) - 1), ...);
    return set;
  }

  /// \param component index 0..5
  constexpr void insert(int component) {
    bits_ = static_cast<std::uint8_t>(bits_ | (1U << component));
  }
  constexpr bool contains(int component) const { return ((bits_ >> component) & 1U) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr int size() const {
    int count = 0;
    for (int c = 0; c < kComponents; ++c) count += contains(c) ? 1 : 0;
    return count;
  }
  friend constexpr ComponentSet operator|(ComponentSet a, ComponentSet b) {
    a.bits_ = static_cast<std::uint8_t>(a.bits_ | b.bits_);
    return a;
  }
  friend constexpr ComponentSet operator&(ComponentSet a, ComponentSet b) {
    a.bits_ = static_cast<std::uint8_t>(a.bits_ & b.bits_);
    return a;
  }
  friend constexpr bool operator==(const ComponentSet&, const ComponentSet&) = default;

 private:
  std::uint8_t bits_ = 0;
};

constexpr bool is_rotation(int component) { return component >= 3; }

}  // namespace slipbench::law
