// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
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
};

class TclReader {
 public:
  TclReader(Script& script, base::Diagnostics& out) : script_(script), out_(out) {}

  void read() { run(script_.texts[0].text(), false); }

 private:
  /// Reads the commands of a text. `open`: whether it is run at all is not known.
  void run(std::string_view text, bool open) {
    if (++depth_ > kDeepest) sound_ = false;
    std::size_t at = 0;
    while (sound_ && at < text.size()) {
      const char c = text[at];
      if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ';' || c == '\\') {
        ++at;
      } else if (c == '#') {
        skip_comment(text, at);
      } else {
        const std::string_view where = text.substr(at);
        const std::vector<Word> words = words_at(text, at);
        if (sound_ && !words.empty()) take(words, line_of(where), open);
      }
    }
    --depth_;
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
      if (c == '\\' && at + 1 < text.size()) {
        at += 2;  // and the end of the line, or its carriage return
      } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
        ++at;
      } else if (c == '#') {
        skip_comment(text, at);
      } else if (c == '{') {
        const std::size_t end = closing(text, at);
        words.push_back({text.substr(at + 1, end - std::min(end, at + 1)), true});
        at = std::min(end + 1, text.size());
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

  /// The brace that closes the one at a place.
  std::size_t closing(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
      if (text[i] == '\\') {
        ++i;
      } else if (text[i] == '{') {
        ++depth;
      } else if (text[i] == '}' && --depth == 0) {
        return i;
      }
    }
    fault(text.substr(open, 1), "this brace is never closed");
    return text.size();
  }

  std::string_view bare_at(std::string_view text, std::size_t& at) {
    const std::size_t begin = at;
    int brackets = 0;
    for (; at < text.size(); ++at) {
      const char c = text[at];
      if (c == '\\') {
        if (brackets == 0 && at + 1 < text.size() && (text[at + 1] == '\n' || text[at + 1] == '\r'))
          break;
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

  void take(const std::vector<Word>& words, std::string_view where, bool open) {
    const std::string_view command = words.front().text;
    const std::size_t count = words.size();
    const auto name = [&](std::size_t i) { return std::string(words[i].text); };
    if (is_wanted(command)) {
      record(words, where);
    } else if ((command == "set" || command == "variable") && count == 3) {
      if (open) {
        names_.forget(name(1), kInBlock);
      } else {
        names_.assign(name(1), name(2), kTcl);
      }
    } else if (command == "incr" && count > 1) {
      names_.assign(name(1), fmt::format("${} + ({})", name(1), count > 2 ? name(2) : "1"), kTcl);
      if (open) names_.forget(name(1), kInBlock);
    } else if ((command == "append" || command == "lappend" || command == "unset" ||
                command == "gets") &&
               count > 1) {
      names_.forget(name(count > 2 && command == "gets" ? 2 : 1), "is changed by " + name(0));
    } else if (command == "if") {
      take_if(words, open);
    } else if (command == "foreach" && count > 3) {
      names_.forget(name(1), "goes through a list");
      run(words.back().text, true);
    } else if (command == "for" || command == "while" || command == "catch") {
      for (std::size_t i = 1; i < count; ++i) {
        // The condition is no command.
        const bool condition = command == "while" ? i == 1 : command == "for" && i == 2;
        if (words[i].braced && !condition) run(words[i].text, true);
      }
    } else if (command == "proc" && count == 4) {
      // Names of a procedure are its own.
      const ScriptNames outside = names_;
      std::size_t at = 0;
      for (const Word& one : words_at(words[2].text, at)) {
        names_.forget(std::string(one.text), "is an argument of " + name(1));
      }
      run(words[3].text, open);
      names_ = outside;
    } else if (command == "namespace" && count == 4) {
      run(words[3].text, open);
    }
  }

  /// Runs the branch whose condition holds; where that is open, all from there on.
  void take_if(const std::vector<Word>& words, bool open) {
    bool decided = false;
    for (std::size_t i = 1; i < words.size() && !decided;) {
      std::optional<bool> holds = true;
      if (words[i].text == "else") {
        ++i;
      } else if (i == 1 || words[i].text == "elseif") {
        if (i > 1) ++i;
        if (i >= words.size()) return;
        const auto value = names_.value_of(words[i++].text, kTcl);
        holds = value ? std::optional(value->value != 0.0) : std::nullopt;
        if (i < words.size() && words[i].text == "then") ++i;
      }
      if (i >= words.size()) return;
      if (holds.value_or(true)) run(words[i].text, open || !holds);
      decided = holds.value_or(false);
      // An open branch leaves it open whether the others are run.
      open = open || !holds;
      ++i;
    }
  }

  void record(const std::vector<Word>& words, std::string_view where) {
    ScriptCommand command{.words = {}, .where = where};
    for (const Word& word : words) {
      std::string text(without_blanks(word.text));
      const bool formula = !word.braced && text.find_first_of("$[") != text.npos;
      if (formula) {
        if (const auto value = names_.value_of(text, kTcl)) {
          text = base::format_number(value->value);
        } else {
          command.faults[command.words.size()] = value.error();
        }
      }
      command.words.push_back(std::move(text));
    }
    script_.commands.push_back(std::move(command));
  }

  static constexpr int kDeepest = 100;
  static constexpr const char* kInBlock = "is set in a block that may not be run";
  Script& script_;
  base::Diagnostics& out_;
  ScriptNames names_;
  int depth_ = 0;
  bool sound_ = true;
};

}  // namespace

void read_tcl(Script& script, base::Diagnostics& out) { TclReader(script, out).read(); }

}  // namespace slipbench::driver::opensees
