// SPDX-License-Identifier: Apache-2.0
// Friction between parts, as a starter deck states it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/units.hpp"
#include "driver/import/radioss/deck_line.hpp"
#include "driver/import/radioss/starter_deck.hpp"

namespace slipbench::driver::radioss {

/// One parameter set of /FRICTION; what C1 .. C6 and Fric mean depends on Ifric.
struct DeckCoefficients {
  std::array<double, 6> c{};    ///< C1 .. C6; the page labels the sixth C0
  double fric = 0.0;            ///< Fric [1]
  double visf = 0.0;            ///< VISF [1] of a viscous penalty, 0 means 1
  std::string_view where = {};  ///< its first line in the deck, of C1 .. C5
  std::string_view rest = {};   ///< its second line, of C6, Fric and VISF
};

/// One side of a record; a group wins over a part.
struct DeckSide {
  int group = 0;  ///< id, 0: none
  int part = 0;   ///< id, 0: none
};

/// A record of /FRICTION: the friction between two sides.
struct DeckPair {
  std::array<DeckSide, 2> sides;
  DeckCoefficients first;
  std::optional<DeckCoefficients> second;  ///< along direction 2, of an orthotropic record
  std::string_view where = {};             ///< its line in the deck
  int line = 0;                            ///< its number
};

/// A /FRICTION block. Ifric, Ifiltr, Xfreq and Iform hold for all its records.
struct DeckFriction {
  int id = 0;
  int unit_id = 0;         ///< of a local system of units, 0: the deck's
  int interface_type = 0;  ///< of the interface whose own friction it is; 0: a /FRICTION
  std::string title;
  int law = 0;                 ///< Ifric, 0 .. 4
  int filter = 0;              ///< Ifiltr, 0 .. 3
  double xfreq = 0.0;          ///< Xfreq, as Ifiltr wants it
  int formulation = 1;         ///< Iform: 1 viscous, 2 stiffness
  DeckCoefficients otherwise;  ///< of the parts that no record joins
  std::vector<DeckPair> pairs;
  std::string_view where;  ///< the keyword
};

/// A group of parts. Only /GRPART/PART says which they are.
struct DeckGroup {
  int id = 0;
  std::string title;
  std::vector<int> parts;      ///< ascending, each once
  std::vector<int> not_there;  ///< that it lists and a deck with all its parts does not have
};

/// An entry of /FRIC_ORIENT: direction 1 of an orthotropic part or group.
struct DeckOrientation {
  DeckSide of;
  std::array<double, 3> vector{1.0, 0.0, 0.0};
  int skew = 0;                 ///< id of the frame the vector is given in, 0: global
  double phi = 0.0;             ///< turn about the contact's normal
  std::string_view where = {};  ///< its first line in the deck
  int line = 0;                 ///< the number of it
};

/// Tells whether a set gives no friction at any speed and pressure, because the constants that its
/// law (Ifric) uses are 0. Constants of other laws do not count.
bool is_empty(int law, const DeckCoefficients& set);

/// Tells whether a set of Ifric 4 falls from Fric to C1 (or stays) without becoming negative.
bool falls(const DeckCoefficients& set);

/// Tells whether some record of a friction is orthotropic.
bool is_orthotropic(const DeckFriction& friction);

/// Contents of a deck on friction.
struct DeckContents {
  std::vector<DeckFriction> frictions;
  std::vector<DeckOrientation> orientations;
  std::vector<DeckGroup> groups;     ///< by id; of one id in the order of the deck
  std::vector<int> parts;            ///< ids of /PART, ascending
  std::vector<int> interface_types;  ///< of /INTER/TYPE.., ascending
  bool has_includes = false;
  std::optional<base::UnitSystem>
      units;  ///< of /BEGIN, if they make a system of force, length and time
  std::vector<DeckFault> unit_faults;           ///< why they make none
  std::map<int, base::UnitSystem> local_units;  ///< of /UNIT, by id, where they make a system
};

/// Returns what a friction is called: "/FRICTION/7", "/INTER/TYPE25/3".
std::string name_of(const DeckFriction& friction);

/// Reads the blocks of a deck. Faults of their lines are reported with their place; a block that
/// has some is left out. They are errors where they concern the friction `chosen` (all of them, if
/// none is), and warnings in other /FRICTION blocks, or in directions if it is not orthotropic.
DeckContents read_contents(const StarterDeck& deck, std::optional<int> chosen,
                           base::Diagnostics& out);

/// Tells whether the parts of a deck are all there are: none can stand in another file or have an
/// id that an offset of a submodel changes.
bool has_all_parts(const DeckContents& deck);

/// The group with an id; null if the deck has none.
const DeckGroup* find_group(const DeckContents& deck, int id);

/// The directions that matter for a friction: of what its orthotropic records join, or may join, by
/// a group whose parts the deck does not list.
std::vector<DeckOrientation> used_orientations(const DeckContents& deck,
                                               const DeckFriction& friction);

/// Judges one friction of a deck by the rules of its law, filter and parts: errors FRIC001 to
/// FRIC008, warnings, and remarks on what the interfaces of the deck do with it.
void judge(const DeckContents& deck, const DeckFriction& friction, const import::DeckTexts& texts,
           base::Diagnostics& out);

/// Direction 1 of an entry before its turn by phi: the unit vector along the projection of its
/// vector on the plane at right angles to `normal`. Nothing if the vector is parallel to the
/// normal.
std::optional<std::array<double, 3>> direction_in_plane(const DeckOrientation& entry,
                                                        const std::array<double, 3>& normal);

/// Tells whether the coefficients of a set see the pressure.
bool sees_pressure(const DeckFriction& friction, const DeckCoefficients& set);

/// The rules that a Renard set breaks, each as the rule itself: "C1 <= C3".
struct RenardFaults {
  std::vector<std::string> fatal;    ///< mu would have a pole, or a piece no meaning
  std::vector<std::string> lenient;  ///< the curve has not the shape the law is meant for
};
RenardFaults renard_faults(const DeckCoefficients& set);

}  // namespace slipbench::driver::radioss
