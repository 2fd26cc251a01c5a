// SPDX-License-Identifier: Apache-2.0
#include "driver/import/opensees/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/units/expression.hpp"

namespace slipbench::driver::opensees {
namespace {

/// Replaces all of one text by another.
void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The variable that a word of Tcl is the value of: $mu, ${mu}, $::mu; empty if it is none.
std::string_view variable_of(std::string_view word) {
  if (!word.starts_with('$')) return {};
  word.remove_prefix(1);
  if (word.starts_with('{') && word.ends_with('}')) word = word.substr(1, word.size() - 2);
  if (word.starts_with("::")) word.remove_prefix(2);
  return is_name(word) ? word : std::string_view{};
}

/// Commands that set no name of the script: of Tcl and Python first, those of OpenSees behind them.
constexpr std::array<std::string_view, 165> kSettingNothing{"puts",
                                                            "format",
                                                            "string",
                                                            "list",
                                                            "llength",
                                                            "lindex",
                                                            "lrange",
                                                            "lsearch",
                                                            "lsort",
                                                            "lreverse",
                                                            "lrepeat",
                                                            "linsert",
                                                            "lreplace",
                                                            "concat",
                                                            "join",
                                                            "split",
                                                            "open",
                                                            "close",
                                                            "flush",
                                                            "clock",
                                                            "return",
                                                            "break",
                                                            "continue",
                                                            "exit",
                                                            "error",
                                                            "pwd",
                                                            "file",
                                                            "print",
                                                            "len",
                                                            "range",
                                                            "str",
                                                            "int",
                                                            "float",
                                                            "abs",
                                                            "round",
                                                            "min",
                                                            "max",
                                                            "sum",
                                                            "sqrt",
                                                            "exp",
                                                            "log",
                                                            "log10",
                                                            "sin",
                                                            "cos",
                                                            "tan",
                                                            "asin",
                                                            "acos",
                                                            "atan",
                                                            "atan2",
                                                            "pow",
                                                            "sorted",
                                                            "enumerate",
                                                            "zip",
                                                            "bool",
                                                            "isinstance",
                                                            "wipe",
                                                            "wipeAnalysis",
                                                            "model",
                                                            "node",
                                                            "fix",
                                                            "fixX",
                                                            "fixY",
                                                            "fixZ",
                                                            "mass",
                                                            "equalDOF",
                                                            "equalDOF_Mixed",
                                                            "rigidLink",
                                                            "rigidDiaphragm",
                                                            "region",
                                                            "uniaxialMaterial",
                                                            "nDMaterial",
                                                            "section",
                                                            "layer",
                                                            "patch",
                                                            "fiber",
                                                            "geomTransf",
                                                            "beamIntegration",
                                                            "element",
                                                            "frictionModel",
                                                            "timeSeries",
                                                            "pattern",
                                                            "load",
                                                            "eleLoad",
                                                            "sp",
                                                            "imposedMotion",
                                                            "groundMotion",
                                                            "recorder",
                                                            "record",
                                                            "constraints",
                                                            "numberer",
                                                            "system",
                                                            "test",
                                                            "algorithm",
                                                            "integrator",
                                                            "analysis",
                                                            "analyze",
                                                            "eigen",
                                                            "loadConst",
                                                            "setTime",
                                                            "getTime",
                                                            "remove",
                                                            "reset",
                                                            "initialize",
                                                            "rayleigh",
                                                            "modalDamping",
                                                            "damping",
                                                            "reactions",
                                                            "nodeDisp",
                                                            "nodeVel",
                                                            "nodeAccel",
                                                            "nodeReaction",
                                                            "nodeCoord",
                                                            "nodeEigenvector",
                                                            "nodeUnbalance",
                                                            "nodeMass",
                                                            "eleResponse",
                                                            "eleForce",
                                                            "eleNodes",
                                                            "basicForce",
                                                            "basicDeformation",
                                                            "sectionForce",
                                                            "sectionDeformation",
                                                            "getEleTags",
                                                            "getNodeTags",
                                                            "getTag",
                                                            "printModel",
                                                            "printA",
                                                            "printB",
                                                            "testIter",
                                                            "testNorm",
                                                            "testNorms",
                                                            "numIter",
                                                            "updateElementDomain",
                                                            "updateMaterialStage",
                                                            "setParameter",
                                                            "parameter",
                                                            "updateParameter",
                                                            "addToParameter",
                                                            "setNodeDisp",
                                                            "setNodeVel",
                                                            "setNodeAccel",
                                                            "setNodeCoord",
                                                            "setElementRayleighDampingFactors",
                                                            "hystereticBackbone",
                                                            "stiffnessDegradation",
                                                            "block2D",
                                                            "block3D",
                                                            "frictionForce",
                                                            "limitCurve",
                                                            "getNP",
                                                            "getPID",
                                                            "barrier",
                                                            "logFile",
                                                            "defaultUnits",
                                                            "nodeBounds",
                                                            "start",
                                                            "stop",
                                                            "partition",
                                                            "domainChange",
                                                            "setPrecision",
                                                            "version",
                                                            "localForce",
                                                            "modalProperties",
                                                            "responseSpectrum",
                                                            "wipeReliability"};

/// Tells a script in Python by its imports and calls.
bool is_python(const base::SourceText& source) {
  if (source.name().ends_with(".py")) return true;
  if (source.name().ends_with(".tcl")) return false;
  for (int number = 1; number <= source.line_count(); ++number) {
    const std::string_view line = without_blanks(source.line(number));
    if (line.starts_with("import ") || line.starts_with("from ")) return true;
    for (const std::string_view call : {"frictionModel", "element"}) {
      const std::size_t at = line.starts_with('#') ? line.npos : line.find(call);
      if (at != line.npos && without_blanks(line.substr(at + call.size())).starts_with('(')) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool is_wanted(std::string_view name) { return name == "frictionModel" || name == "element"; }

bool is_in_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool sets_nothing(std::string_view command) { return is_in(kSettingNothing, command); }

bool mentions(std::string_view text, std::string_view name) {
  bool found = false;
  for_each_word(text, [&](std::string_view word) { found = found || word == name; });
  return found;
}

std::size_t closing_place(std::string_view text, std::size_t open) {
  const char begin = text[open];
  const char end = begin == '{' ? '}' : ']';
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == begin) {
      ++depth;
    } else if (text[i] == end && --depth == 0) {
      return i;
    }
  }
  return text.size();
}

void for_each_word(std::string_view text, const std::function<void(std::string_view)>& take) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_in_name(text[end])) ++end;
    if (end > i) take(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == text.npos) return text.substr(text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool is_name(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

tl::expected<import::ScriptNumber, std::string> ScriptNames::value_of(
    std::string_view word, import::FormulaLanguage language) const {
  word = without_blanks(word);
  if (const auto number = base::parse_number(word)) {
    return import::ScriptNumber{*number, import::is_whole_literal(word)};
  }
  if (language == import::FormulaLanguage::kPython)
    return formula(word, std::string(word), language);
  // Outside of expr, Tcl does no arithmetic: a word is a value, or it is text.
  const std::string_view name = variable_of(word);
  if (!name.empty()) return formula(word, "$" + std::string(name), language);
  constexpr std::string_view kExpr = "[expr";
  const std::string_view inner =
      word.size() > kExpr.size() + 1 ? word.substr(kExpr.size()) : std::string_view{};
  if (word.starts_with(kExpr) && std::string_view(" \t\r\n{\"").find(inner[0]) != inner.npos &&
      closing_place(word, 0) == word.size() - 1) {
    return expression(inner.substr(0, inner.size() - 1));
  }
  return tl::unexpected(fmt::format("'{}' is not read as a number", base::shortened(word, 60)));
}

tl::expected<import::ScriptNumber, std::string> ScriptNames::expression(
    std::string_view shown) const {
  std::string text(shown);
  if (text.size() > base::kLongestFormula) {
    return formula(shown, text, import::FormulaLanguage::kTcl);
  }
  replace_all(text, "\\\r\n", " ");
  replace_all(text, "\\\n", " ");
  for (const std::string_view blank : {" ", "\t", "\n", "{", "\""}) {
    replace_all(text, "[expr" + std::string(blank), "(" + std::string(blank));
  }
  if (text.find('[') == text.npos) replace_all(text, "]", ")");
  replace_all(text, "${", "$");
  // Braces and quotes group what is evaluated.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '{' || c == '}' || c == '"'; }, ' ');
  return formula(shown, text, import::FormulaLanguage::kTcl);
}

tl::expected<import::ScriptNumber, std::string> ScriptNames::formula(
    std::string_view word, const std::string& text, import::FormulaLanguage language) const {
  const std::string shown = base::shortened(word, 60);
  // A function or a constant that the script has otherwise is not the known one.
  std::string reason;
  for_each_word(text, [&](std::string_view name) {
    const std::string_view why = reason.empty() ? reason_of(name) : std::string_view();
    if (!why.empty()) reason = fmt::format("'{}': {} {}", shown, name, why);
  });
  if (!reason.empty()) return tl::unexpected(std::move(reason));
  const auto value = import::evaluate_formula(text, numbers, language);
  if (value) return *value;
  return tl::unexpected(fmt::format("'{}': {}", shown, value.error().message));
}

void ScriptNames::enter() {
  auto around = std::make_unique<ScriptNames>(std::move(*this));
  *this = {.lost = around->lost};
  outside = std::move(around);
}

void ScriptNames::leave() {
  const auto around = std::move(outside);
  *this = std::move(*around);
}

std::string_view ScriptNames::reason_of(std::string_view name) const {
  for (const ScriptNames* at = this; at != nullptr; at = at->outside.get()) {
    if (const auto found = at->unread.find(name); found != at->unread.end()) return found->second;
    if (at->numbers.contains(name)) return at == this ? std::string_view() : kNotFollowed;
  }
  return {};
}

void ScriptNames::assign(const std::string& name, const std::string& word,
                         import::FormulaLanguage language) {
  if (!is_name(name)) return;
  if (lost) {
    forget(name, kNotFollowed);
  } else if (const auto number = value_of(word, language)) {
    numbers[name] = *number;
    unread.erase(name);
  } else {
    forget(name,
           fmt::format("is set to '{}', which is not read as a number", base::shortened(word, 60)));
  }
}

void ScriptNames::forget(const std::string& name, std::string why) {
  if (!is_name(name)) return;
  numbers.erase(name);
  unread[name] = std::move(why);
}

void ScriptNames::forget_words(std::string_view text) {
  for_each_word(text, [&](std::string_view word) {
    if (numbers.contains(word)) forget(std::string(word), kNotFollowed);
  });
}

void ScriptNames::forget_all() {
  for (const auto& [name, number] : numbers) unread[name] = kNotFollowed;
  numbers.clear();
}

Script read_script(const base::SourceText& source, base::Diagnostics& out) {
  Script script{.texts = import::DeckTexts(source)};
  if (is_python(source)) {
    read_python(script, out);
  } else {
    read_tcl(script, out);
  }
  return script;
}

tl::expected<double, std::string> number_of(const ScriptCommand& command, std::size_t index) {
  if (const auto fault = command.faults.find(index); fault != command.faults.end()) {
    return tl::unexpected(fault->second);
  }
  const std::string& word = command.words[index];
  if (const auto number = base::parse_number(word)) return *number;
  return tl::unexpected(fmt::format("'{}' is no number", base::shortened(word, 60)));
}

}  // namespace slipbench::driver::opensees
