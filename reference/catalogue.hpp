// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "reference/backlash_slider.hpp"
#include "reference/belt_segment.hpp"
#include "reference/bouc_wen.hpp"
#include "reference/capstan.hpp"
#include "reference/capstan_chain.hpp"
#include "reference/cattaneo_mindlin.hpp"
#include "reference/closed_form.hpp"
#include "reference/clutch_engagement.hpp"
#include "reference/contact_force.hpp"
#include "reference/contact_force_ujoint.hpp"
#include "reference/coulomb_slider.hpp"
#include "reference/coulomb_vibration.hpp"
#include "reference/dahl.hpp"
#include "reference/elastic_belt.hpp"
#include "reference/ellipse_point.hpp"
#include "reference/exponential_decay.hpp"
#include "reference/first_order_filter.hpp"
#include "reference/generalized_viscous.hpp"
#include "reference/harmonic_balance.hpp"
#include "reference/helical_capstan.hpp"
#include "reference/helical_slip.hpp"
#include "reference/iwan_uniform.hpp"
#include "reference/lift_off.hpp"
#include "reference/lugre.hpp"
#include "reference/modified_darmstad.hpp"
#include "reference/moving_belt.hpp"
#include "reference/orthotropic_sliding.hpp"
#include "reference/p_norm.hpp"
#include "reference/parallel_sliders.hpp"
#include "reference/planar_slider.hpp"
#include "reference/planar_slider_circle.hpp"
#include "reference/power_law_capstan.hpp"
#include "reference/renard.hpp"
#include "reference/segalman_iwan.hpp"
#include "reference/static_kinetic_sawtooth.hpp"
#include "reference/stick_slip_oscillator.hpp"
#include "reference/stiffness_penalty.hpp"
#include "reference/stribeck.hpp"
#include "reference/tanh_friction.hpp"
#include "reference/v_groove_capstan.hpp"
#include "reference/varying_normal_force.hpp"
#include "reference/varying_overlap.hpp"
#include "reference/viscous_penalty.hpp"
#include "reference/wear.hpp"
#include "reference/wear_table.hpp"

namespace slipbench::reference {

inline constexpr std::array kCatalogue{
    // One direction
    coulomb_slider::kForm, backlash_slider::kForm, harmonic_balance::kForm,
    harmonic_balance::kFirstHarmonic, parallel_sliders::kForm, iwan_uniform::kForm,
    segalman_iwan::kForm, varying_normal_force::kForm, varying_normal_force::kQuadratureForm,
    lift_off::kForm,
    // Two directions
    planar_slider::kForm, planar_slider_circle::kForm, planar_slider_circle::kIncrementsForm,
    helical_slip::kForm, p_norm::kNormForm, p_norm::kSliderForm, p_norm::kBoxForm,
    // Contact force, wear, coefficient
    contact_force::kComponent, contact_force::kSlot, contact_force::kSlidePlane,
    contact_force::kCylindrical, contact_force::kTranslator, contact_force::kHinge,
    contact_force::kPlanarSliding, contact_force::kPlanarSpinning, contact_force_ujoint::kAxis1,
    contact_force_ujoint::kAxis3, varying_overlap::kForm, wear::kLinearForm, wear::kExponentialForm,
    wear_table::kForm, exponential_decay::kForm, exponential_decay::kTestDataForm, stribeck::kForm,
    static_kinetic_sawtooth::kForm,
    // Belts
    capstan::kForm, capstan::kBandForm, capstan::kStatusForm, capstan::kWrapAngleForm,
    capstan_chain::kForm, belt_segment::kForm, elastic_belt::kForm, power_law_capstan::kForm,
    v_groove_capstan::kForm, moving_belt::kForm, helical_capstan::kForm,
    // Radioss-type friction
    generalized_viscous::kForm, modified_darmstad::kForm, renard::kForm,
    first_order_filter::kStepForm, first_order_filter::kHarmonicForm,
    first_order_filter::kSignalForm, viscous_penalty::kForm, viscous_penalty::kPlaneForm,
    viscous_penalty::kCreepForm, viscous_penalty::kDampingForm, stiffness_penalty::kRampForm,
    stiffness_penalty::kIncrementsForm, orthotropic_sliding::kForm, ellipse_point::kClosestForm,
    ellipse_point::kRatioForm,
    // Spheres in contact
    cattaneo_mindlin::kForm, cattaneo_mindlin::kLoopForm, cattaneo_mindlin::kHertzForm,
    // Dynamics
    stick_slip_oscillator::kForm, coulomb_vibration::kForm, clutch_engagement::kForm,
    // Laws that people compare with
    dahl::kForm, bouc_wen::kForm, lugre::kForm, tanh_friction::kForm, tanh_friction::kCreepForm};

// With its undefined-behaviour sanitizer g++ 12 takes no address of a function for a constant.
#ifndef __SANITIZE_ADDRESS__
static_assert(std::all_of(kCatalogue.begin(), kCatalogue.end(),
                          [](const ClosedForm& form) {
                            return form.make != nullptr && form.violation != nullptr;
                          }),
              "a closed form lacks its make, or its violation: no_violation where its parameters "
              "have no rules between them");
#endif

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
