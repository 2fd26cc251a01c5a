// SPDX-License-Identifier: Apache-2.0
// Contact interfaces of a starter deck, with the friction that stands in themselves.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/import/radioss/deck_friction.hpp"
#include "driver/import/radioss/starter_deck.hpp"

namespace slipbench::driver::radioss {

/// /INTER/TYPEn/id.
struct DeckInterface {
  int id = 0;
  int type = 0;
  std::string_view where;        ///< the keyword
  int friction_id = 0;           ///< fric_ID: the /FRICTION in its place, or 0
  DeckFriction own;              ///< its own friction; not used where it has a friction_id
  double shear_limit = 0.0;      ///< Ptlim of TYPE3 and 5, a stress; 0: none
  int temperature_function = 0;  ///< fct_IDF: scales the friction, which no case does; or 0
  std::optional<std::string> unread = std::nullopt;  ///< why its friction cannot be read
};

/// Reads the interfaces of types that have friction: 3, 5, 7, 11, 19, 20, 21, 24 and 25, in the
/// layouts of versions from 41 on. The number of their first cards follows from type, version and
/// Icurv; behind them stand, everywhere alike, the card with Fric, that of the boundary conditions
/// (IBC) with VISF, and the one with Ifric, Ifiltr, Xfreq, Iform and fric_ID, before C1 .. C6. An
/// interface whose card of IBC is not in its place is told as unread. Faults are reported; an
/// interface that has some is left out. Source: OpenRadioss's reader configuration, 41 to 2026.
std::vector<DeckInterface> read_interfaces(const StarterDeck& deck, base::Diagnostics& out);

/// Returns whether an interface has friction: its own, or that of a /FRICTION.
bool has_friction(const DeckInterface& interface);

}  // namespace slipbench::driver::radioss
