// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "reference/closed_form.hpp"
#include "reference/contact_force.hpp"
#include "reference/contact_force_ujoint.hpp"
#include "reference/coulomb_slider.hpp"
#include "reference/parallel_sliders.hpp"
#include "reference/planar_slider.hpp"
#include "reference/varying_normal_force.hpp"

namespace slipbench::reference {

inline constexpr std::array kCatalogue{
    coulomb_slider::kForm,         parallel_sliders::kForm,        varying_normal_force::kForm,
    planar_slider::kForm,          contact_force::kSlot,           contact_force::kSlidePlane,
    contact_force::kCylindrical,   contact_force::kTranslator,     contact_force::kHinge,
    contact_force::kPlanarSliding, contact_force::kPlanarSpinning, contact_force_ujoint::kAxis1,
    contact_force_ujoint::kAxis3};

/// All closed forms a check can name, in the order they are listed to the user.
inline std::span<const ClosedForm> catalogue() { return kCatalogue; }

/// The closed form of that name, or null.
inline const ClosedForm* find(std::string_view name) {
  for (const ClosedForm& form : kCatalogue) {
    if (form.name == name) return &form;
  }
  return nullptr;
}

}  // namespace slipbench::reference
