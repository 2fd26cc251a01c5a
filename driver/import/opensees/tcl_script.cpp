// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/import/opensees/script.hpp"

namespace slipbench::driver::opensees {
namespace {

constexpr auto kTcl = import::FormulaLanguage::kTcl;

/// Word of a command.
struct Word {
  std::string_view text;  ///< without the braces or quotes around it
  bool braced = false;
  bool expanded = false;  ///< {*} stands before it: it is any number of words
};

/// Returns whether a word has another text when it is used than where it stands.
bool is_computed(std::string_view text) { return text.find_first_of("$[\\") != text.npos; }

class TclReader {
 public:
  TclReader(Script& script, base::Diagnostics& out) : script_(script), out_(out) {}

  void read() { run(script_.texts[0].text(), false); }

 private:
  /// Reads the commands of a text. `open`: whether it is run at all is not known.
  void run(std::string_view text, bool open) {
    if (++depth_ > kDeepest) fault(text, "is nested too deeply");
    std::size_t at = 0;
    while (sound_ && !ended_ && at < text.size()) {
      const char c = text[at];
      if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ';') {
        ++at;
      } else if (const std::size_t end = continued(text, at); end > at) {
        at = end;
      } else if (c == '#') {
        skip_comment(text, at);
      } else {
        const std::size_t begin = at;
        const std::vector<Word> words = words_at(text, at);
        if (sound_ && !words.empty()) take(words, text.substr(begin, at - begin), open);
      }
    }
    --depth_;
  }

  /// The place behind a line end that a '\\' hides; the place itself if there is none.
  static std::size_t continued(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at);
    return at + (rest.starts_with("\\\n") ? 2 : rest.starts_with("\\\r\n") ? 3 : 0);
  }

  static void skip_comment(std::string_view text, std::size_t& at) {
    for (; at < text.size() && text[at] != '\n'; ++at) {
      if (text[at] == '\\') ++at;
    }
  }

  /// The line that a text begins in, without blanks around it.
  static std::string_view line_of(std::string_view text) {
    return without_blanks(text.substr(0, text.find('\n')));
  }

  /// Takes the words of a command, up to its end.
  std::vector<Word> words_at(std::string_view text, std::size_t& at) {
    std::vector<Word> words;
    while (sound_ && at < text.size()) {
      const char c = text[at];
      if (c == '\n' || c == ';') break;
      if (const std::size_t behind = continued(text, at); behind > at) {
        at = behind;
      } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
        ++at;
      } else if (c == '{') {
        const std::size_t end = closing(text, at);
        const std::string_view inner = text.substr(at + 1, end - std::min(end, at + 1));
        at = std::min(end + 1, text.size());
        const bool ends = at >= text.size() || text[at] == ';' || continued(text, at) > at ||
                          std::isspace(static_cast<unsigned char>(text[at])) != 0;
        words.push_back({inner, true, inner == "*" && !ends});
      } else if (c == '"') {
        const std::size_t begin = ++at;
        while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
        if (at >= text.size()) fault(text.substr(begin - 1, 1), "this quote is never closed");
        at = std::min(at, text.size());
        words.push_back({text.substr(begin, at - begin), false});
        ++at;
      } else {
        words.push_back({bare_at(text, at), false});
      }
    }
    return words;
  }

  /// Finds the brace that closes the one at a place, or tells that there is none.
  std::size_t closing(std::string_view text, std::size_t open) {
    const std::size_t end = closing_place(text, open);
    if (end == text.size()) fault(text.substr(open, 1), "this brace is never closed");
    return end;
  }

  std::string_view bare_at(std::string_view text, std::size_t& at) {
    const std::size_t begin = at;
    int brackets = 0;
    for (; at < text.size(); ++at) {
      const char c = text[at];
      if (c == '\\') {
        if (brackets == 0 && continued(text, at) > at) break;
        ++at;
      } else if (c == '[') {
        ++brackets;
      } else if (c == ']') {
        --brackets;
      } else if (brackets <= 0 && (c == ';' || std::isspace(static_cast<unsigned char>(c)) != 0)) {
        break;
      }
    }
    at = std::min(at, text.size());
    if (brackets > 0) fault(text.substr(begin, 1), "a bracket of this word is never closed");
    return text.substr(begin, at - begin);
  }

  void fault(std::string_view piece, const char* message) {
    if (!sound_) return;
    sound_ = false;
    out_.error(script_.texts.name(piece), script_.texts.position(piece), {}, message);
  }

  void warn(std::string_view statement, std::string message) {
    const std::string_view where = line_of(statement);
    out_.warning(script_.texts.name(where), script_.texts.position(where), {}, std::move(message));
  }

  /// Tells of friction models in a statement that is not followed.
  void tell(std::string_view statement) {
    if (!mentions(statement, "frictionModel")) return;
    warn(statement, "a frictionModel in a part of the script that is not followed: it is not read");
  }

  /// Takes a statement as one that may set any name.
  void give_up(std::string_view statement) {
    names_.forget_all();
    tell(statement);
  }

  /// Runs the commands in brackets of a word; what they set has no number.
  void substitute(std::string_view text) {
    if (++depth_ > kDeepest) fault(text, "is nested too deeply");
    for (std::size_t at = 0; sound_ && at < text.size(); ++at) {
      if (text[at] == '\\') {
        ++at;
      } else if (text[at] == '[') {
        const std::size_t end = closing_place(text, at);
        run(text.substr(at + 1, end - at - 1), true);
        at = end;
      }
    }
    --depth_;
  }

  void take(const std::vector<Word>& words, std::string_view statement, bool open) {
    const bool expanded =
        std::any_of(words.begin(), words.end(), [](const Word& one) { return one.expanded; });
    for (const Word& one : words) {
      if (!one.braced) substitute(one.text);
    }
    std::string_view command = words.front().text;
    if (command.starts_with("::")) command.remove_prefix(2);
    if (procedures_.contains(command)) {
      names_.lost = names_.lost || poisoned_;
      give_up(statement);
    } else if (is_wanted(command)) {
      record(words, line_of(statement));
    } else if (expanded || is_computed(command)) {
      give_up(statement);
    } else if (!take_setter(command, words, statement, open) &&
               !take_block(command, words, statement, open) && !take_any(command, statement)) {
      take_other(command, words, statement, open);
    }
  }

  /// Takes commands that set a name they are given.
  bool take_setter(std::string_view command, const std::vector<Word>& words,
                   std::string_view statement, bool open) {
    const std::size_t count = words.size();
    if (command == "set" || (command == "variable" && count == 3 && procedure_ == 0)) {
      if (count == 3) set_name(words[1], words[2], open);
      if (count == 3 && mentions(words[2].text, "frictionModel")) tell(statement);
      return true;
    }
    if (command == "incr" && count > 1) {
      const std::string by(count > 2 ? words[2].text : "1");
      const std::string sum = fmt::format("[expr {{${} + ({})}}]", words[1].text, by);
      set_name(words[1], {sum, false}, open);
      return true;
    }
    // The place of the name, of all names from there on where `all`.
    std::size_t first = 0;
    bool all = false;
    if (command == "append" || command == "lappend" || command == "lset") {
      first = 1;
    } else if (command == "gets" || command == "array" || command == "dict") {
      // dict for and its kin have a body.
      if (command == "dict" && count > 3 && words.back().braced) return false;
      first = 2;
    } else if (command == "unset" || command == "global" || command == "variable") {
      first = 1;
      all = true;
    } else {
      return false;
    }
    for (std::size_t i = first; i < count && (all || i == first); ++i) {
      forget_named(words[i].text, fmt::format("is changed by {}", command));
    }
    tell(statement);
    return true;
  }

  void set_name(const Word& name, const Word& value, bool open) {
    std::string_view text = name.text;
    // In a procedure or a namespace, ::mu is another one than mu.
    if (text.starts_with("::") && procedure_ == 0 && !open) text.remove_prefix(2);
    if (!is_name(text)) {
      forget_named(text, kNotFollowed);
    } else if (open) {
      names_.forget(std::string(text), kInBlock);
    } else if (value.braced && is_computed(value.text)) {
      names_.forget(std::string(text), fmt::format("is set to '{}', which is not read as a number",
                                                   base::shortened(value.text, 60)));
    } else {
      names_.assign(std::string(text), std::string(value.text), kTcl);
    }
  }

  /// Forgets the names in a word, or all where it is not known which they are.
  void forget_named(std::string_view text, const std::string& why) {
    if (is_computed(text)) {
      names_.forget_all();
      return;
    }
    for_each_word(text, [&](std::string_view name) { names_.forget(std::string(name), why); });
  }

  /// Takes commands that have others in their arguments.
  bool take_block(std::string_view command, const std::vector<Word>& words,
                  std::string_view statement, bool open) {
    const std::size_t count = words.size();
    if (command == "if") {
      take_if(words, statement, open);
    } else if (command == "proc" && count == 4) {
      take_procedure(words, statement);
    } else if ((command == "foreach" || command == "lmap") && count > 3) {
      names_.forget_words(statement);
      for (std::size_t i = 1; i + 1 < count; i += 2) {
        forget_named(words[i].text, "goes through a list");
      }
      body(words.back(), true);
    } else if (command == "for" || command == "while") {
      names_.forget_words(statement);
      const std::size_t condition = command == "for" ? 2 : 1;
      for (std::size_t i = 1; i < count; ++i) {
        if (i != condition) {
          body(words[i], true);
        } else if (words[i].braced) {
          substitute(words[i].text);
        }
      }
    } else if (command == "catch" || command == "time") {
      names_.forget_words(statement);
      for (std::size_t i = 2; i < count; ++i) forget_named(words[i].text, kNotFollowed);
      if (count > 1) body(words[1], true);
    } else if (command == "switch") {
      take_switch(words, statement);
    } else if (command == "try" || command == "pattern" || command == "section" ||
               command == "dict" || (command == "namespace" && count == 4)) {
      const bool last = command != "try";
      for (std::size_t i = last ? count - 1 : 1; i < count; ++i) {
        if (!words[i].braced) continue;
        names_.forget_words(statement);
        run(words[i].text, true);
      }
      if (command == "dict" || command == "namespace")
        forget_named(words[count - 2].text, kNotFollowed);
    } else {
      return false;
    }
    return true;
  }

  /// Runs a body, or takes it as one that may do anything.
  void body(const Word& word, bool open) {
    if (word.braced || !is_computed(word.text)) {
      run(word.text, open);
    } else {
      give_up(word.text);
    }
  }

  void take_switch(const std::vector<Word>& words, std::string_view statement) {
    names_.forget_words(statement);
    std::size_t value = 1;
    while (value < words.size() && words[value].text.starts_with('-')) ++value;
    if (value + 2 != words.size()) {
      for (std::size_t i = value + 1; i < words.size(); ++i) body(words[i], true);
      return;
    }
    const Word& list = words.back();
    if (!list.braced) {
      give_up(statement);
      return;
    }
    bool pattern = true;
    for (std::size_t at = 0; sound_ && at < list.text.size();) {
      for (const Word& one : words_at(list.text, at)) {
        if (!pattern && one.text != "-") run(one.text, true);
        pattern = !pattern;
      }
      ++at;  // the end of a line
    }
  }

  /// Reads a procedure: its names are its own, and those outside may have changed when it is run.
  void take_procedure(const std::vector<Word>& words, std::string_view statement) {
    constexpr std::array<std::string_view, 9> kLanguage{"set",   "expr", "if",   "for",   "foreach",
                                                        "while", "proc", "incr", "source"};
    std::string_view name = words[1].text;
    if (is_computed(name) || name.find("mathfunc") != name.npos) poison(statement);
    name.remove_prefix(name.rfind(':') + 1);
    if (is_in(kLanguage, name)) poison(statement);
    procedures_.emplace(name);
    if (!words[3].braced) {
      tell(statement);
      return;
    }
    names_.enter();
    names_.lost = false;
    std::size_t at = 0;
    for (const Word& one : words_at(words[2].text, at)) {
      for_each_word(one.text, [&](std::string_view argument) {
        names_.forget(std::string(argument), fmt::format("is an argument of {}", words[1].text));
      });
    }
    ++procedure_;
    run(words[3].text, false);
    --procedure_;
    names_.leave();
  }

  /// Takes a statement after which no name is certain.
  void poison(std::string_view statement) {
    poisoned_ = true;
    names_.lost = true;
    give_up(statement);
  }

  /// Takes commands that may set any name.
  bool take_any(std::string_view command, std::string_view statement) {
    constexpr std::array<std::string_view, 18> kAny{
        "eval",      "uplevel", "after",   "vwait", "update",   "subst",
        "apply",     "exec",    "thread",  "yield", "chan",     "coroutine",
        "fileevent", "socket",  "package", "load",  "tailcall", "namespace"};
    if (command == "source") {
      opened_ = true;
      names_.forget_all();
      warn(
          statement,
          "the file of source is not followed: its friction models are not read, and no name keeps "
          "its number here");
    } else if (command == "trace" || command == "rename" || command == "interp") {
      poison(statement);
    } else if (command == "upvar") {
      names_.lost = true;
      give_up(statement);
    } else if (is_in(kAny, command)) {
      opened_ = opened_ || command == "package" || command == "load";
      give_up(statement);
    } else {
      return false;
    }
    return true;
  }

  void take_other(std::string_view command, const std::vector<Word>& words,
                  std::string_view statement, bool open) {
    if (command == "expr") {
      for (const Word& one : words) {
        if (one.braced) substitute(one.text);
      }
    } else if (command == "info" && words.size() > 1 && words[1].text != "default") {
      return;
    } else if (sets_nothing(command)) {
      constexpr std::array<std::string_view, 3> kEnds{"exit", "return", "error"};
      if (!open && procedure_ == 0 && is_in(kEnds, command)) end_behind(statement);
    } else if (opened_ || is_computed(statement) || command.find(':') != command.npos) {
      // A command of a file or a package that was not read, or one of names that are computed.
      opened_ = opened_ || mentions(statement, "proc");
      give_up(statement);
    } else {
      names_.forget_words(statement);
      tell(statement);
    }
  }

  /// Ends the script, and tells of models that stand behind the end.
  void end_behind(std::string_view statement) {
    ended_ = true;
    const std::string_view all = script_.texts[0].text();
    const auto at = static_cast<std::size_t>(statement.data() + statement.size() - all.data());
    if (mentions(all.substr(std::min(at, all.size())), "frictionModel")) {
      warn(statement, "the script ends here: what stands below is not read");
    }
  }

  /// Runs the branch whose condition holds; where that is open, all from there on.
  void take_if(const std::vector<Word>& words, std::string_view statement, bool open) {
    bool decided = false;
    for (std::size_t i = 1; i < words.size() && !decided;) {
      bool known = true;
      bool holds = true;
      if (words[i].text == "else") {
        ++i;
      } else if (i == 1 || words[i].text == "elseif") {
        if (i > 1) ++i;
        if (i >= words.size()) return give_up(statement);
        if (words[i].braced) substitute(words[i].text);
        const auto value = names_.expression(words[i++].text);
        known = value.has_value();
        holds = known && value->value != 0.0;
        if (i < words.size() && words[i].text == "then") ++i;
      }
      if (i >= words.size()) return give_up(statement);
      if (holds || !known) body(words[i], open || !known);
      decided = holds;
      // An open branch leaves it open whether the others are run.
      open = open || !known;
      ++i;
    }
  }

  void record(const std::vector<Word>& words, std::string_view where) {
    ScriptCommand command{.words = {}, .where = where};
    for (const Word& word : words) {
      std::string text(without_blanks(word.text));
      if (word.expanded) {
        command.faults[command.words.size()] = "'{*}' is not followed: write the numbers";
      } else if (!word.braced && is_computed(text)) {
        if (const auto value = names_.value_of(text, kTcl)) {
          text = base::format_number(value->value);
        } else {
          command.faults[command.words.size()] = value.error();
        }
      }
      command.words.push_back(std::move(text));
    }
    command.words.front() = command.words.front().substr(command.words.front().rfind(':') + 1);
    script_.commands.push_back(std::move(command));
  }

  static constexpr int kDeepest = 100;
  static constexpr const char* kInBlock = "is set in a block that may not be run";
  Script& script_;
  base::Diagnostics& out_;
  ScriptNames names_;
  std::set<std::string, std::less<>> procedures_;  ///< of the script
  int procedure_ = 0;                              ///< how many procedures deep
  bool poisoned_ = false;                          ///< a procedure may leave a trace on a name
  bool opened_ = false;  ///< there may be commands of files that were not read
  bool ended_ = false;
  int depth_ = 0;
  bool sound_ = true;
};

}  // namespace

void read_tcl(Script& script, base::Diagnostics& out) { TclReader(script, out).read(); }

}  // namespace slipbench::driver::opensees
