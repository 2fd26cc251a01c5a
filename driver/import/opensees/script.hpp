// SPDX-License-Identifier: Apache-2.0
// An OpenSees script as its commands on friction, with their numbers.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/import/deck_texts.hpp"
#include "driver/import/script_formula.hpp"

namespace slipbench::driver::opensees {

/// Command of a script, "frictionModel" or "element", and its words.
struct ScriptCommand {
  std::vector<std::string> words;  ///< the command's name first; formulas as their numbers
  std::string_view where;          ///< its line
  std::map<std::size_t, std::string> faults = {};  ///< of words that have no number, by index
};

/// Values of names where a script is being read.
struct ScriptNames {
  import::ScriptNumbers numbers = {};              ///< of `set name value`, or `name = value`
  std::map<std::string, std::string> unread = {};  ///< why the others are no number, by name

  /// Evaluates a word: a literal, $name, [expr ..], or arithmetic of Python. Error: a sentence.
  tl::expected<import::ScriptNumber, std::string> value_of(std::string_view word,
                                                           import::FormulaLanguage language) const;
  /// Gives a name the number that a word is, or notes that it has none.
  void assign(const std::string& name, const std::string& word, import::FormulaLanguage language);
  /// Notes that a name may have any value from here on.
  void forget(const std::string& name, std::string why);
};

struct Script {
  import::DeckTexts texts;
  std::vector<ScriptCommand> commands = {};
};

/// Takes the commands frictionModel and element out of a script in Tcl or Python. Names and
/// arithmetic are evaluated where they stand. A branch whose condition is a number is taken or
/// left; where the condition is open, in loops and in procedures that are never called, commands
/// are read, and names set there have no number. Other files are not followed.
Script read_script(const base::SourceText& source, base::Diagnostics& out);

/// Reads a script in Tcl; a brace that is never closed is reported.
void read_tcl(Script& script, base::Diagnostics& out);

/// Reads a script in Python.
void read_python(Script& script);

/// The number that a word of a command is. Error: a sentence.
tl::expected<double, std::string> number_of(const ScriptCommand& command, std::size_t index);

/// Returns whether a command is taken out of a script.
bool is_wanted(std::string_view name);

/// Takes blanks off both ends.
std::string_view without_blanks(std::string_view text);

/// Returns whether a text may name a variable.
bool is_name(std::string_view text);

}  // namespace slipbench::driver::opensees
