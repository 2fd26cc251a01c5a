// SPDX-License-Identifier: Apache-2.0
// The case of a contact whose friction is that of a deck, whatever program the deck is of.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/import/loss.hpp"

namespace slipbench::driver::import {

/// Comment in a case whose deck names a group and has it in another file.
inline constexpr std::string_view kPartsToFillIn =
    "the deck does not list its parts: fill in their ids";

/// So many records of part pairs, their groups' parts and rows of tables have the contacts that are
/// taken over at once, at most: all of them may name one table.
inline constexpr std::size_t kMostRecords = 100'000;

/// Friction between two sides, or of all parts that no other record joins.
struct ContactRecord {
  std::array<std::string, 2> sides = {};  ///< each the id of a part, or the name of a group
  std::string coefficient;                ///< a value in YAML
  std::string second = {};                ///< that along direction 2; empty: one for all directions
  double visf = 0.0;         ///< VISF [1] of a viscous penalty; 0: that of the formulation
  double shear_limit = 0.0;  ///< stress that the friction does not exceed; 0: none
  std::string remark = {};   ///< where it stands in the deck
};

/// Named group of parts.
struct ContactGroup {
  std::string name;
  std::string title;
  std::vector<int> parts;  ///< empty: the deck does not list them
};

/// Friction of a contact as a deck states it.
struct ContactFriction {
  std::string name;                            ///< "/FRICTION/7"
  std::string title = {};                      ///< as a person wrote it
  std::string deck = {};                       ///< name of its file, for the heading
  std::vector<std::string> notes = {};         ///< sentences for the heading
  std::vector<Loss> losses = {};               ///< what is not taken over as it is
  std::optional<base::UnitSystem> units = {};  ///< that its numbers are in
  bool needs_units = false;                    ///< a law does not run without
  bool sees_pressure = false;                  ///< some law or limit needs the contact's area
  std::vector<int> parts = {};                 ///< all there are; empty: not known
  std::vector<std::shared_ptr<const ContactGroup>> groups = {};  ///< of a deck, whoever names them
  std::vector<ContactRecord> pairs = {};  ///< the last one that joins both parts holds
  ContactRecord otherwise = {};
  bool viscous = false;   ///< penalty; else a stiffness
  bool as_coded = false;  ///< convention of a viscous penalty; else as documented
  std::optional<double> tangential_stiffness = {};  ///< of a stiffness penalty, where it is known
  std::vector<std::string> remarks = {};            ///< comments above the formulation
  std::string filter = {};                          ///< a value in YAML; empty: none
  std::vector<std::string> orientation = {};        ///< comments on direction 1
  std::string checks = {};                          ///< `checks:` in YAML; empty: none
};

/// Writes a case with the friction of a deck: a contact point that is pressed and slid. What a deck
/// has no numbers for (stiffness and mass of the contact, area, load, speed, time step, which parts
/// meet) are parameters without a value, so that a run before they are given is refused.
WrittenCase contact_case(const ContactFriction& friction);

}  // namespace slipbench::driver::import
