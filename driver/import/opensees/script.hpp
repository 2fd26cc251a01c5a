// SPDX-License-Identifier: Apache-2.0
// An OpenSees script as its commands on friction, with their numbers.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/import/deck_texts.hpp"

namespace slipbench::driver::opensees {

/// Command of a script, "frictionModel" or "element", and its words.
struct ScriptCommand {
  std::vector<std::string> words;  ///< the command's name first; quotes and braces taken off
  std::string_view where;          ///< its line
};

struct Script {
  import::DeckTexts texts;
  std::vector<ScriptCommand> commands = {};
  base::NamedNumbers numbers = {};                 ///< of `set name value`, or `name = value`
  std::map<std::string, std::string> unread = {};  ///< what was set and is no number, by name
};

/// Takes the commands frictionModel and element out of a script in Tcl or Python. Names that were
/// set before, and arithmetic, are evaluated; loops, procedures and other files are not followed.
Script read_script(const base::SourceText& source);

/// The number that a word is: a literal, $name, [expr ..], or arithmetic of Python.
tl::expected<double, std::string> number_of(const Script& script, std::string_view word);

}  // namespace slipbench::driver::opensees
