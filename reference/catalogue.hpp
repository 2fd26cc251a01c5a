// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "reference/bouc_wen.hpp"
#include "reference/closed_form.hpp"
#include "reference/contact_force.hpp"
#include "reference/contact_force_ujoint.hpp"
#include "reference/coulomb_slider.hpp"
#include "reference/coulomb_vibration.hpp"
#include "reference/dahl.hpp"
#include "reference/exponential_decay.hpp"
#include "reference/harmonic_balance.hpp"
#include "reference/iwan_uniform.hpp"
#include "reference/lift_off.hpp"
#include "reference/lugre.hpp"
#include "reference/parallel_sliders.hpp"
#include "reference/planar_slider.hpp"
#include "reference/segalman_iwan.hpp"
#include "reference/static_kinetic_sawtooth.hpp"
#include "reference/stick_slip_oscillator.hpp"
#include "reference/tanh_friction.hpp"
#include "reference/varying_normal_force.hpp"
#include "reference/wear.hpp"
#include "reference/wear_table.hpp"

namespace slipbench::reference {

inline constexpr std::array kCatalogue{
    // One direction
    coulomb_slider::kForm, harmonic_balance::kForm, harmonic_balance::kFirstHarmonic,
    parallel_sliders::kForm, iwan_uniform::kForm, segalman_iwan::kForm, varying_normal_force::kForm,
    varying_normal_force::kQuadratureForm, lift_off::kForm,
    // Two directions
    planar_slider::kForm,
    // Contact force, wear, coefficient
    contact_force::kComponent, contact_force::kSlot, contact_force::kSlidePlane,
    contact_force::kCylindrical, contact_force::kTranslator, contact_force::kHinge,
    contact_force::kPlanarSliding, contact_force::kPlanarSpinning, contact_force_ujoint::kAxis1,
    contact_force_ujoint::kAxis3, wear::kLinearForm, wear::kExponentialForm, wear_table::kForm,
    exponential_decay::kForm, exponential_decay::kTestDataForm, static_kinetic_sawtooth::kForm,
    // Dynamics
    stick_slip_oscillator::kForm, coulomb_vibration::kForm,
    // Laws that people compare with
    dahl::kForm, bouc_wen::kForm, lugre::kForm, tanh_friction::kForm, tanh_friction::kCreepForm};

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
