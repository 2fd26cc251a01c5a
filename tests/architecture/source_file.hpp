// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::architecture {

/// A text file of the repository: `path` relative to its root, with '/' as separator.
struct SourceFile {
  std::string path;
  std::string text;
};

/// A broken rule and where; `line` is 1-based, 0 stands for the whole file.
struct Violation {
  std::string path;
  int line = 0;
  std::string message;
};

/// "path:line: message", as a compiler writes it.
std::string to_string(const Violation& violation);

/// All violations, one a line; empty when there is none. Meant for a test's message.
std::string to_string(const std::vector<Violation>& violations);

/// The text files of the project's rooms and the named files of its root, sorted by path. Build
/// folders, links, binary files and anything else that lies beside the rooms is not looked at.
std::vector<SourceFile> read_repository(const std::filesystem::path& root);

enum class Strings { kKeep, kBlank };

/// C++ text with comments, and on request the contents of string and character literals, replaced
/// by blanks; line breaks stay, so positions keep their line.
std::string without_comments(std::string_view text, Strings strings);

/// The lines of a text without their line breaks.
std::vector<std::string> lines(std::string_view text);

bool is_header(std::string_view path);  ///< .hpp
bool is_cpp(std::string_view path);     ///< .hpp or .cpp

}  // namespace slipbench::architecture
