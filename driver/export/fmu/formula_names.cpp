// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/formula_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace slipbench::driver::exports {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_of_name(char c) { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The formula behind the '=' that marks it.
std::string_view without_mark(std::string_view formula) {
  const std::size_t begin = formula.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && formula[begin] == '=') formula.remove_prefix(begin + 1);
  return formula;
}

/// Calls visit(name, at) for each name, functions among them, and other(character) for what stands
/// between; numbers are left out.
template <class Visit, class Other>
void for_each_name(std::string_view formula, Visit visit, Other other) {
  for (std::size_t at = 0; at < formula.size();) {
    const std::size_t begin = at;
    const char c = formula[at];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') {
      // 1e5 is no name; the sign of an exponent is none of a name either.
      while (at < formula.size() && (is_of_name(formula[at]) || formula[at] == '.')) ++at;
    } else if (is_letter(c)) {
      while (at < formula.size() && is_of_name(formula[at])) ++at;
      const std::size_t next = formula.find_first_not_of(" \t\r\n", at);
      const bool is_call = next != std::string_view::npos && formula[next] == '(';
      visit(formula.substr(begin, at - begin), is_call);
    } else {
      other(c);
      ++at;
    }
  }
}

}  // namespace

std::set<std::string> names_in(std::string_view formula) {
  std::set<std::string> names;
  for_each_name(
      without_mark(formula),
      [&](std::string_view name, bool is_call) {
        if (!is_call) names.emplace(name);
      },
      [](char) {});
  return names;
}

std::set<std::string> names_in_pieces(std::string_view formula) {
  constexpr std::array<std::string_view, 5> kPieces{"abs", "max", "min", "rint", "sign"};
  formula = without_mark(formula);
  const bool compares = formula.find_first_of("<>=!?&|") != std::string_view::npos;
  std::vector<bool> inside{compares};  // of each parenthesis that is open
  bool opens = false;                  // whether the next one belongs to such a function
  std::set<std::string> found;
  for_each_name(
      formula,
      [&](std::string_view name, bool is_call) {
        if (is_call)
          opens = std::find(kPieces.begin(), kPieces.end(), name) != kPieces.end();
        else if (inside.back())
          found.emplace(name);
      },
      [&](char c) {
        if (c == '(') {
          inside.push_back(inside.back() || opens);
          opens = false;
        } else if (c == ')' && inside.size() > 1) {
          inside.pop_back();
        }
      });
  return found;
}

}  // namespace slipbench::driver::exports
