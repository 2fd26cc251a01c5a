// SPDX-License-Identifier: Apache-2.0
// Formulas of scripts and decks, in which whole numbers divide as those of the program do.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace slipbench::driver::import {

/// Number of a formula.
struct ScriptNumber {
  double value = 0.0;
  bool whole = false;  ///< an integer of the program
};

using ScriptNumbers = std::map<std::string, ScriptNumber, std::less<>>;

/// Language of a formula: what 1/4 is, whether -2**2 is 4, and what 2**-1 is.
enum class FormulaLanguage {
  kTcl,     ///< 0, as 1/4 is rounded down; 4; 0
  kPython,  ///< 0.25; -4; 0.5
  kFortran  ///< 0, as 1/4 is cut off; -4; 0
};

/// Reason why a formula has no value.
struct FormulaFault {
  std::string message;
  std::size_t offset = 0;         ///< in the formula
  std::string unknown_name = {};  ///< that is not defined
};

/// Evaluates a formula: + - * / // % **, comparisons, !, &&, ||, c ? a : b, parentheses, names
/// (in Tcl as $name), and the usual functions, each if the language has it; math.sqrt is sqrt. A
/// '$' alone, a division by zero, a result that is no finite number, and whatever the programs of
/// the language may take otherwise (010, max(1, 1.), integers beyond 2^53) are faults.
tl::expected<ScriptNumber, FormulaFault> evaluate_formula(std::string_view text,
                                                          const ScriptNumbers& numbers,
                                                          FormulaLanguage language);

/// Returns whether a number is written as an integer: digits and a sign alone.
bool is_whole_literal(std::string_view text);

}  // namespace slipbench::driver::import
