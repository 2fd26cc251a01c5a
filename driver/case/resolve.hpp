// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "driver/case/binding.hpp"
#include "driver/case/case.hpp"
#include "driver/case/case_text.hpp"

namespace slipbench::driver {

/// Turns the text of a case into a case: applies the rules that hold between keys (connection and
/// friction, tables and their use, histories and what they drive, checks and columns). All errors
/// are reported to the binder; the result is only complete if it reported none.
void resolve_connector(Binder& binder, const CaseText& text, Case& out);
void resolve_friction(Binder& binder, const CaseText& text, Case& out);
void resolve_history(Binder& binder, const CaseText& text, Case& out);
void resolve_output_and_checks(Binder& binder, const CaseText& text, Case& out);

/// "a CYLINDRICAL connector", or "this connector" for a pair of types without a name.
std::string connector_words(const law::Connection& connection);
/// "CP1, CPR1" or "f2, f3": the names of a set of components; "none" if it is empty.
std::string motion_names(law::ComponentSet set);
std::string force_names(law::ComponentSet set);

}  // namespace slipbench::driver
