// SPDX-License-Identifier: Apache-2.0
#include "driver/read/foreign_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace slipbench::driver::read {
namespace {

/// The next line with something in it that is no comment of YAML, and its number; empty at the end.
std::string_view next_line(std::string_view& text, int& line) {
  while (!text.empty()) {
    const std::string_view here = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(here.size() + 1, text.size()));
    ++line;
    if (here.find_first_not_of(" \t\r") != std::string_view::npos && here.front() != '#') {
      return here;
    }
  }
  return {};
}

bool is_capital(std::string_view text, std::size_t at) {
  return at < text.size() && std::isupper(static_cast<unsigned char>(text[at])) != 0;
}

/// Returns whether a line has numbers only, in columns.
bool has_numbers_only(std::string_view line) {
  return line.find_first_of(",;\t") != std::string_view::npos &&
         line.find_first_of("0123456789") != std::string_view::npos &&
         line.find_first_not_of("0123456789.,;+-eE \t\r\"nainf") == std::string_view::npos;
}

}  // namespace

std::optional<base::Diagnostic> foreign_file(const base::SourceText& source) {
  std::string_view text = source.text();
  int line = 0;
  const bool starter = text.starts_with("#RADIOSS");
  const std::string_view first = next_line(text, line);
  const std::string name = base::printable(source.name());
  base::Diagnostic found{.file = std::string(source.name()), .where = {line, 1, 1}};
  if (first.empty()) {
    found.where = {1, 1, 1};
    found.message = "the file is empty";
    found.hint =
        "a case begins with 'slipbench: 1'; 'slipbench describe SLOT' tells the keys of a "
        "connection";
  } else if (starter || (first.starts_with("/") && is_capital(first, 1))) {
    found.message = "this is a Radioss deck, not a case";
    found.hint = "'slipbench import " + name + "' makes cases of its friction";
  } else if (first.starts_with("**") || (first.starts_with("*") && is_capital(first, 1))) {
    found.message = "this is an Abaqus input file, not a case";
    found.hint = "a case is YAML; 'slipbench describe SLOT' tells the keys of a connection";
  } else if (first.find(": ") == std::string_view::npos && !first.ends_with(':') &&
             (has_numbers_only(first) || has_numbers_only(next_line(text, line)))) {
    found.message = "these are numbers in columns, not a case";
    found.hint = "a case names such a file as 'csv:' or 'curve:'; 'slipbench plot' draws a result";
  } else {
    return std::nullopt;
  }
  return found;
}

}  // namespace slipbench::driver::read
