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

/// Language of a formula: what 1/4 is, and whether -2**2 is 4.
enum class FormulaLanguage {
  kTcl,     ///< 0, as 1/4 is rounded down; 4
  kPython,  ///< 0.25; -4
  kFortran  ///< 0, as 1/4 is cut off; -4
};

/// Reason why a formula has no value.
struct FormulaFault {
  std::string message;
  std::size_t offset = 0;         ///< in the formula
  std::string unknown_name = {};  ///< that is not defined
};

/// Evaluates a formula: + - * / // % **, comparisons, !, &&, ||, c ? a : b, parentheses, names
/// (also as $name), pi, and the usual functions; math.sqrt is sqrt. A '$' alone, a division by
/// zero and a result that is no finite number are faults.
tl::expected<ScriptNumber, FormulaFault> evaluate_formula(std::string_view text,
                                                          const ScriptNumbers& numbers,
                                                          FormulaLanguage language);

/// Returns whether a number is written as an integer: digits and a sign alone.
bool is_whole_literal(std::string_view text);

}  // namespace slipbench::driver::import
