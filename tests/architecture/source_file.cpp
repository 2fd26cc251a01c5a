// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/source_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace slipbench::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::array kRooms{".ci",   ".github", "bench",     "c",       "cases",
                            "cmake", "docs",    "driver",    "law",     "packaging",
                            "plots", "python",  "reference", "scripts", "tests"};
constexpr std::array kRootFiles{".clang-format",   ".clang-tidy",  ".gitignore",
                                "CHANGELOG.md",    "CITATION.cff", "CMakeLists.txt",
                                "LICENSE",         "NOTICE",       "CMakePresets.json",
                                "CONTRIBUTING.md", "README.md"};

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// End of the raw string literal whose R stands at `begin`, or npos if it is none.
std::size_t raw_string_end(std::string_view text, std::size_t begin) {
  if (text.substr(begin, 2) != "R\"") return std::string_view::npos;
  const std::size_t open = text.find('(', begin);
  if (open == std::string_view::npos) return std::string_view::npos;
  const std::string close = ")" + std::string(text.substr(begin + 2, open - begin - 2)) + "\"";
  const std::size_t end = text.find(close, open);
  return end == std::string_view::npos ? text.size() : end + close.size();
}

/// End of the literal in quotes that begins at `begin`.
std::size_t literal_end(std::string_view text, std::size_t begin) {
  std::size_t i = begin + 1;
  while (i < text.size() && text[i] != text[begin] && text[i] != '\n') {
    i += text[i] == '\\' ? 2 : 1;
  }
  return std::min(i + 1, text.size());
}

}  // namespace

std::string to_string(const Violation& violation) {
  return violation.path + ":" + std::to_string(violation.line) + ": " + violation.message;
}

std::string to_string(const std::vector<Violation>& violations) {
  std::string text;
  for (const Violation& violation : violations) text += to_string(violation) + "\n";
  return text;
}

std::vector<SourceFile> read_repository(const fs::path& root) {
  std::vector<SourceFile> files;
  const auto add = [&](const fs::path& path) {
    if (fs::is_symlink(path) || !fs::is_regular_file(path)) return;
    std::string text = read(path);
    if (text.find('\0') != std::string::npos) return;
    files.push_back({path.lexically_relative(root).generic_string(), std::move(text)});
  };
  for (const char* name : kRootFiles) add(root / name);
  for (const char* room : kRooms) {
    if (!fs::is_directory(root / room)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) add(entry.path());
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string without_comments(std::string_view text, Strings strings) {
  std::string result(text);
  const auto blank = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (result[i] != '\n') result[i] = ' ';
    }
  };
  std::size_t i = 0;
  while (i < text.size()) {
    std::size_t end = i + 1;
    if (text.substr(i, 2) == "//") {
      end = std::min(text.find('\n', i), text.size());
      blank(i, end);
    } else if (text.substr(i, 2) == "/*") {
      const std::size_t close = text.find("*/", i + 2);
      end = close == std::string_view::npos ? text.size() : close + 2;
      blank(i, end);
    } else if (const std::size_t raw = raw_string_end(text, i); raw != std::string_view::npos) {
      end = raw;
      if (strings == Strings::kBlank) blank(i + 2, end - 1);
    } else if (text[i] == '"' || text[i] == '\'') {
      // A quote after a digit or letter parts the digits of a number: 1'000.
      const bool separator =
          text[i] == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
      if (!separator) {
        end = literal_end(text, i);
        if (strings == Strings::kBlank) blank(i + 1, end - 1);
      }
    }
    i = end;
  }
  return result;
}

std::vector<std::string> lines(std::string_view text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

bool is_header(std::string_view path) { return path.ends_with(".hpp"); }

bool is_cpp(std::string_view path) { return is_header(path) || path.ends_with(".cpp"); }

}  // namespace slipbench::architecture
