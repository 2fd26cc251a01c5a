// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// Turns the text of a case into a case: applies the rules that hold between keys (connection and
/// friction, tables and their use, histories and what they drive, checks and columns). All errors
/// are reported to the binder; the result is only complete if it reported none. What the text lacks
/// because it was faulty is not reported again.
void resolve_connector(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// The belt of a SLIPRING: wrap angles or nodes, initial strain. Goes before the friction, which
/// needs the angles.
void resolve_belt(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// Finishes what of a belt can only be judged with its history: tensions, and whether its length is
/// known.
void finish_belt(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// Coordinates of a belt's nodes behind the steps so far, where the text alone tells them.
struct NodePlaces {
  std::vector<std::optional<double>> coordinates;  ///< x, y and z of a, b and c
  std::size_t steps = 0;                           ///< behind which they are there
};
/// The drives of `nodes:` in a step.
/// \param places of the calls before; at first empty
/// \param drive is called with each coordinate that is driven
void drive_nodes(yaml::Binder& binder, const StepText& text, const cases::Case& problem,
                 NodePlaces& places,
                 const std::function<void(int quantity, const yaml::At<ProfileText>&)>& drive);
/// Picks the record of `friction_pairs:` that joins the connector's parts. Goes before friction.
/// \param table_known false: the table may be missing because its key is misspelt
/// \return the text with the record's coefficient (and VISF) in every friction definition
CaseText with_friction_of_parts(yaml::Binder& binder, CaseText text, bool table_known,
                                cases::Case& out);
/// \param derived_known false: derived components may be missing
/// \return whether it is known which components slip and what their laws bring with them, and so
///         which result columns there are
bool resolve_friction(yaml::Binder& binder, const CaseText& text, bool derived_known,
                      cases::Case& out);
/// Springs, dampers, stops and the mass of a dynamic case; goes after the friction.
void resolve_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// Finishes what of them can only be judged with the history: components driven by force and by
/// motion.
void finish_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// The free components whose kinetic force some contact force sees (docs/theory, section 6), and
/// what is to be said of contact forces that nothing or only a load drives; goes after
/// finish_forces().
void finish_contact_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// Notes the natural frequency of a mass on its spring, and warns if no row shows it; goes after
/// the history.
void tell_oscillator(yaml::Binder& binder, const CaseText& text, const cases::Case& problem);
void resolve_history(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// Dead zones, and the rules of a coefficient for each direction; goes after the history.
void resolve_bench_options(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// The changes of friction of every step; goes after the friction and the history.
/// \param definitions_known false: names of definitions are not judged
void resolve_friction_changes(yaml::Binder& binder, const CaseText& text, bool definitions_known,
                              cases::Case& out);
/// The method of integration, and whether the case allows it; goes after all but the checks.
void resolve_integration(yaml::Binder& binder, const CaseText& text, cases::Case& out);
/// \param columns_known false: names of result columns are not judged
/// \param history_known false: any temperature and field may be driven
/// \param curves_may_be_missing reference curves need not be there: they are about to be made
void resolve_output_and_checks(yaml::Binder& binder, const CaseText& text, cases::Case& out,
                               bool columns_known, bool history_known, bool curves_may_be_missing);

/// Says what a table sees that its reader may not expect: a temperature or field that the history
/// never gives (0), a constitutive motion that is not the displacement from the initial position.
void explain_table_arguments(yaml::Binder& binder, const CaseText& text,
                             const cases::Case& problem);

/// The hint for a component's name written in the wrong case ("did you mean 'CP1'?"), or
/// `otherwise`.
std::string nearest_component(std::string_view name, law::ComponentSet set,
                              std::string (*name_of_component)(int), std::string otherwise);

/// Returns what a case has while its connection type is faulty: all components, held and free at
/// once, so that nothing else in the case looks wrong because of it. No real connection does that.
law::Connection any_connection();
bool is_any_connection(const law::Connection& connection);

/// "'CP2' cannot be: a CYLINDRICAL connector holds component 2": reports each independent of a
/// table that is a motion the connection does not have free. `node` is the table's.
bool independents_available(yaml::Binder& binder, const law::Connection& connection,
                            const law::TableFunction& function, const yaml::Node& node,
                            const yaml::Path& path);

/// "a CYLINDRICAL connector", or "this connector" for a pair of types without a name.
std::string connector_words(const law::Connection& connection);
/// "component 3", counted from 1 as a user does; `component` counts from 0.
std::string component_words(int component);
/// "CP1, CPR1" or "f2, f3": the names of a set of components; "none" if it is empty.
std::string motion_names(law::ComponentSet set);
std::string force_names(law::ComponentSet set);

}  // namespace slipbench::driver::read
