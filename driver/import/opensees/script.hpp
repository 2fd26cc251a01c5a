// SPDX-License-Identifier: Apache-2.0
// An OpenSees script as its commands on friction, with their numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
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

/// Reason of a name that a statement may have set which the readers do not follow.
inline constexpr const char* kNotFollowed =
    "is set in a way that is not followed here: write its number";

/// Values of names where a script is being read.
struct ScriptNames {
  import::ScriptNumbers numbers = {};  ///< of `set name value`, or `name = value`
  /// Why the others are no number, by name.
  std::map<std::string, std::string, std::less<>> unread = {};
  bool lost = false;  ///< no name is certain from here on
  /// Those outside of the procedure that these are of; they may have changed when it is called.
  std::unique_ptr<ScriptNames> outside = nullptr;

  /// Begins the names of a procedure.
  void enter();
  /// Ends them: those outside are as they were.
  void leave();
  /// Evaluates a word: a literal, $name, [expr ..], or arithmetic of Python. Error: a sentence.
  tl::expected<import::ScriptNumber, std::string> value_of(std::string_view word,
                                                           import::FormulaLanguage language) const;
  /// Evaluates what expr of Tcl takes, in braces, quotes or neither.
  tl::expected<import::ScriptNumber, std::string> expression(std::string_view shown) const;
  /// Gives a name the number that a word is, or notes that it has none.
  void assign(const std::string& name, const std::string& word, import::FormulaLanguage language);
  /// Notes that a name may have any value from here on.
  void forget(const std::string& name, std::string why);
  /// Forgets all names that occur in a text.
  void forget_words(std::string_view text);
  void forget_all();

 private:
  /// Returns why a name is no number; nothing if it is one, or not known.
  std::string_view reason_of(std::string_view name) const;
  tl::expected<import::ScriptNumber, std::string> formula(std::string_view word,
                                                          const std::string& text,
                                                          import::FormulaLanguage language) const;
};

struct Script {
  import::DeckTexts texts;
  std::vector<ScriptCommand> commands = {};
};

/// Takes the commands frictionModel and element out of a script in Tcl or Python. Names and
/// arithmetic are evaluated where they stand. A branch whose condition is a number is taken or
/// left; where the condition is open, in loops and in procedures that are never called, commands
/// are read, and names set there have no number. Whatever else may set a name takes its number from
/// it. Other files are not followed; they, and models in what is not followed, are told.
Script read_script(const base::SourceText& source, base::Diagnostics& out);

/// Reads a script in Tcl; a brace that is never closed is reported.
void read_tcl(Script& script, base::Diagnostics& out);

/// Reads a script in Python; a bracket or a quote that is never closed is reported.
void read_python(Script& script, base::Diagnostics& out);

/// The number that a word of a command is. Error: a sentence.
tl::expected<double, std::string> number_of(const ScriptCommand& command, std::size_t index);

/// Returns whether a command is taken out of a script.
bool is_wanted(std::string_view name);

/// Returns whether a character may stand in a name.
bool is_in_name(char c);

/// Returns whether a list has a word.
template <std::size_t count>
bool is_in(const std::array<std::string_view, count>& list, std::string_view wanted) {
  return std::find(list.begin(), list.end(), wanted) != list.end();
}

/// Returns whether a command of Tcl, Python or OpenSees sets no name of the script.
bool sets_nothing(std::string_view command);

/// Calls a function with each word of letters, digits and '_' in a text.
void for_each_word(std::string_view text, const std::function<void(std::string_view)>& take);

/// Returns whether a name occurs in a text as a word.
bool mentions(std::string_view text, std::string_view name);

/// Finds what closes the bracket or brace at a place, by Tcl's rules; the end of the text if
/// nothing does.
std::size_t closing_place(std::string_view text, std::size_t open);

/// Takes blanks off both ends.
std::string_view without_blanks(std::string_view text);

/// Returns whether a text may name a variable.
bool is_name(std::string_view text);

}  // namespace slipbench::driver::opensees
