// SPDX-License-Identifier: Apache-2.0
// Parts of a friction definition that stand under `friction:` and under `change_friction:` alike.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "driver/base/units/units.hpp"
#include "driver/case/case.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/yaml/binding.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/update/uniqueness.hpp"

namespace slipbench::driver::read {

/// Numbers that a coefficient law may take from the rest of its case.
struct LawSurroundings {
  const yaml::At<double>& area;   ///< `connector: {area: ..}` [L^2]
  const base::UnitSystem& units;  ///< of the case
};

/// The law of a coefficient as written; nothing if it is not given or faulty, which is reported. A
/// law of the pressure without an area takes the connector's. `suit_to_slip` has to follow.
std::optional<law::FrictionLaw> coefficient_law(yaml::Binder& binder,
                                                const yaml::At<CoefficientText>& coefficient,
                                                const LawSurroundings& surroundings);
/// The same for one direction of an orthotropic coefficient, written at `node`.
std::optional<law::FrictionLaw> coefficient_law(yaml::Binder& binder,
                                                const CoefficientText& coefficient,
                                                const yaml::Node& node, const yaml::Path& path,
                                                const LawSurroundings& surroundings);

/// Suits a law to the slip space it acts in: gives one whose constants hide a unit of speed its
/// factor to the case's, and warns where what a law calls a pressure is a moment over an area.
/// \param coefficient where the law is written
/// \param radius of a rotation that shares its law with a translation: where the law sees it rub
/// \return false if there is no such factor, which is reported
bool suit_to_slip(yaml::Binder& binder, const yaml::At<CoefficientText>& coefficient,
                  const law::SlipSpace& slip, const base::UnitSystem& units,
                  std::optional<double> radius, law::FrictionLaw& law);

/// Returns whether some of these definitions slip along lengths and others about angles.
/// \param group indices in Case::definitions
bool slip_in_two_units(const cases::Case& problem, std::span<const std::size_t> group);

/// Warns of a coefficient that definitions of both kinds share, or that one definition sees with
/// lengths and angles mixed, if it depends on the slip rate or on the contact force: without a
/// radius its numbers mean two things.
/// \param law before it is suited to a slip space
/// \param arm typical radius of the contact [L]; 0 if there is none
/// \return whether it warned
bool warn_of_two_units(yaml::Binder& binder, const yaml::At<CoefficientText>& coefficient,
                       const law::FrictionLaw& law, const base::UnitSystem& units, double arm);

/// The stick stiffness of a `stick:` map or of its absence, with a note where the length it refers
/// to is a default.
/// \param parent the definition, for the note where there is no map
/// \param parent_misspelt the definition has unknown keys, so `stick` may have been meant
law::StickStiffness stick_stiffness(yaml::Binder& binder, const yaml::At<StickText>& text,
                                    const yaml::Node& parent, const yaml::Path& parent_path,
                                    bool parent_misspelt, const base::UnitSystem& units);

/// Warns where the worst of the tables gives a limit that may fall faster with slip than the stick
/// stiffness unloads (reference case W1, beta >= 1). What the run meets is judged there; a case
/// that asks for jumps knows.
void warn_of_snap_back(yaml::Binder& binder, const law::FrictionDefinition& definition,
                       const CaseText& text, const yaml::Node& node, const yaml::Path& path);
/// The same where it is known already, of a definition with this law and stick stiffness.
void warn_of_snap_back(yaml::Binder& binder, const law::SnapBack& snap, const law::FrictionLaw& law,
                       double stiffness, const CaseText& text, const yaml::Node& node,
                       const yaml::Path& path);

}  // namespace slipbench::driver::read
