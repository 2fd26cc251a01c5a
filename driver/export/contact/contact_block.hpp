// SPDX-License-Identifier: Apache-2.0
// The friction of a case in the words of programs that state it for contacts.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/export/contact/friction_statement.hpp"

namespace slipbench::driver::exports {

/// Writes /FRICTION, with groups of parts where it has pairs: Ifric 0 for a constant coefficient, 4
/// for an exponential decay, 1 to 3 for the program's own laws. Fields have 20 columns. Radioss has
/// no tables, which is refused, and no cap of the force.
std::string to_radioss(const FrictionStatement& statement, const ExportOptions& options,
                       ExportedDeck& deck);

/// Writes the cards of a contact with FS, FD, DC and VC; with pairs *DEFINE_FRICTION and FS -2; of
/// laws that are no exponential decay *DEFINE_TABLE over pressure and velocity and FS 2. Where 10
/// columns would lose digits the long format is taken.
std::string to_lsdyna(const FrictionStatement& statement, const ExportOptions& options,
                      ExportedDeck& deck);

/// Writes a frictionModel, Coulomb, VelDependent or VelDepMultiLinear, and the bearing it belongs
/// to with the stick stiffness as kInit.
std::string to_opensees(const FrictionStatement& statement, const ExportOptions& options,
                        ExportedDeck& deck);

/// Writes the coefficient over slip rate and contact force as CSV, which a case takes as
/// `coefficient: {columns: .., csv: ..}`.
std::string to_table(const FrictionStatement& statement, const ExportOptions& options,
                     ExportedDeck& deck);

/// Returns the coefficient that a table of to_table is.
law::FrictionLaw law_of_table(const std::string& csv);

/// Writes a case in the words of a program: radioss, lsdyna, opensees or table.
/// \return a sentence where the program has no such friction
tl::expected<ExportedDeck, std::string> to_contact(std::string_view program,
                                                   const cases::Case& problem,
                                                   const read::CaseText& written,
                                                   const ExportOptions& options);

}  // namespace slipbench::driver::exports
