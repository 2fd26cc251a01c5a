// SPDX-License-Identifier: Apache-2.0
// The friction of a case as programs state that of a contact: without the connector's geometry.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/export/loss.hpp"
#include "driver/export/run_range.hpp"
#include "driver/read/keys/case_text.hpp"

namespace slipbench::driver::exports {

/// Friction between two sides, or of the whole contact.
struct StatedFriction {
  law::FrictionLaw law;
  std::optional<law::FrictionLaw> second = {};  ///< along direction 2
  double visf = 0.0;                            ///< VISF of a viscous penalty [1]; 0: none given
  double force_limit = law::kNoForceLimit;      ///< [F]
};

/// A record of a table of part pairs.
struct StatedPair {
  std::array<read::PartOrGroup, 2> sides;
  StatedFriction friction;
};

/// Group of parts with the number that a deck knows it by.
struct StatedGroup {
  int id = 0;
  std::string name;
  std::vector<int> parts;
};

struct FrictionStatement {
  std::string title;
  base::UnitSystem units;
  double area = 0.0;  ///< of the contact [L^2]; 0: not given
  StatedFriction otherwise = {};
  std::vector<StatedPair> pairs = {};
  std::vector<StatedGroup> groups = {};
  std::map<std::string, int> id_of_group = {};  ///< of these, by their names
  std::optional<law::Formulation> formulation = {};
  law::StickStiffness stick = {};
  RunRange run = {};  ///< of the case's own run

  /// The number of a side's group, or of its part.
  int id_of(const read::PartOrGroup& side) const;
};

/// Takes the friction of a case apart; what no contact states is noted. Throws NotExported where
/// its definitions have not one friction.
FrictionStatement stated_friction(const cases::Case& problem, const read::CaseText& written,
                                  std::vector<Loss>& losses);

/// mu = fast + (at_rest - fast) exp(-decay v), of which either may be larger.
struct Transition {
  double at_rest = 0.0;
  double fast = 0.0;
  double decay = 0.0;  ///< [T/L]
};

/// The area of a case's contact [L^2]: the law's own, else the connector's; 0 where none is given.
double contact_area(const cases::Case& problem, const read::CaseText& written);

/// The transition that a law is, the constant among them; nothing for other laws.
std::optional<Transition> transition_of(const law::FrictionLaw& law);

}  // namespace slipbench::driver::exports
