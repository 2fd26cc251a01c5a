// SPDX-License-Identifier: Apache-2.0
// Parts of a friction definition that stand under `friction:` and under `change_friction:` alike.
#pragma once

#include <optional>

#include "driver/case/binding.hpp"
#include "driver/case/case_text.hpp"
#include "driver/history/units.hpp"
#include "law/friction_definition.hpp"

namespace slipbench::driver {

/// What a coefficient law may take from the rest of its case.
struct LawSurroundings {
  const At<double>& area;   ///< `connector: {area: ..}` [L^2]
  const UnitSystem& units;  ///< of the case
};

/// The law of a coefficient as written; nothing if it is not given or faulty, which is reported. A
/// law of the pressure without an area takes the connector's. `suit_to_slip` has to follow.
std::optional<law::FrictionLaw> coefficient_law(Binder& binder,
                                                const At<CoefficientText>& coefficient,
                                                const LawSurroundings& surroundings);
/// The same for one direction of an orthotropic coefficient, written at `node`.
std::optional<law::FrictionLaw> coefficient_law(Binder& binder, const CoefficientText& coefficient,
                                                const Node& node, const Path& path,
                                                const LawSurroundings& surroundings);

/// Suits a law to the slip space it acts in: gives one whose constants hide a unit of speed its
/// factor to the case's, and warns where what a law calls a pressure is a moment over an area.
/// \param coefficient where the law is written
/// \return false if there is no such factor, which is reported
bool suit_to_slip(Binder& binder, const At<CoefficientText>& coefficient,
                  const law::SlipSpace& slip, const UnitSystem& units, law::FrictionLaw& law);

/// The stick stiffness of a `stick:` map or of its absence, with a note where the length it refers
/// to is a default.
/// \param parent the definition, for the note where there is no map
/// \param parent_misspelt the definition has unknown keys, so `stick` may have been meant
law::StickStiffness stick_stiffness(Binder& binder, const At<StickText>& text, const Node& parent,
                                    const Path& parent_path, bool parent_misspelt,
                                    const UnitSystem& units);

/// A limit that falls faster with slip than the stick stiffness unloads snaps back: the force drops
/// at constant motion, and no increment can follow it (reference case W1, beta >= 1). The bound
/// takes the worst of the tables; where F_C may turn the sign it only warns.
void check_snap_back(Binder& binder, const law::FrictionDefinition& definition, const Node& node,
                     const Path& path);

}  // namespace slipbench::driver
