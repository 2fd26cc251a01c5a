// SPDX-License-Identifier: Apache-2.0
// Friction of the contacts of an LS-DYNA keyword deck.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/import/contact/contact_case.hpp"
#include "driver/import/lsdyna/keyword_deck.hpp"

namespace slipbench::driver::lsdyna {

/// Contact, or a *DEFINE_FRICTION that none names, with the friction it has.
struct Found {
  int id = 0;
  bool is_table = false;  ///< a *DEFINE_FRICTION itself
  import::ContactFriction friction;
  std::optional<std::string> passed_over = std::nullopt;  ///< why no case can be made of it
};

/// Reads the friction of a deck:
///   mu = FSF (FD + (FS - FD) exp(-DC v)),  limited to VSF VC A,
/// with FS, FD, DC and VC of the second card of a contact, or where FS is -2 those of
/// *DEFINE_FRICTION, which has them for pairs of parts; or where FS is 2 a *DEFINE_TABLE of mu over
/// the relative velocity for several pressures. Faults are reported, and what has some left out.
/// Source: LS-DYNA keyword manual, *CONTACT and *DEFINE_FRICTION.
/// \param contact the id of the only one whose tables are wanted, or no id of a contact: of none
std::vector<Found> read_frictions(const KeywordDeck& deck, base::Diagnostics& out,
                                  std::optional<int> contact = std::nullopt);

}  // namespace slipbench::driver::lsdyna
